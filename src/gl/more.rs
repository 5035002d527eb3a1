//! Functions of OpenGL that glow does not have, looked up by name.

use std::ffi::{c_double, c_int, c_uint, c_void};

use super::driver::Driver;

type Enum = unsafe extern "system" fn(c_uint);
type Enums = unsafe extern "system" fn(c_uint, c_uint);
type Nothing = unsafe extern "system" fn();
type GetQuery = unsafe extern "system" fn(c_uint, c_uint, *mut c_int);
type GetIndexed = unsafe extern "system" fn(c_uint, c_uint, *mut c_int);
type GetDouble = unsafe extern "system" fn(c_uint, *mut c_double);
type BindRange = unsafe extern "system" fn(c_uint, c_uint, c_uint, isize, isize);

/// Each function may be missing: of someone else's context, perhaps only glow's functions are known.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct More {
    clip_control: Option<Enums>,
    provoking_vertex: Option<Enum>,
    clamp_color: Option<Enums>,
    begin_conditional_render: Option<Enums>,
    end_conditional_render: Option<Nothing>,
    get_query: Option<GetQuery>,
    get_indexed: Option<GetIndexed>,
    get_double: Option<GetDouble>,
    bind_range: Option<BindRange>,
}

impl More {
    /// Looks the functions up in the current context.
    pub(super) fn load(driver: &Driver, look_up: impl Fn(&str) -> *const c_void) -> Self {
        macro_rules! look_up {
            ($name:literal as $kind:ty) => {{
                let function = look_up($name);
                if function.is_null() {
                    None
                } else {
                    // SAFETY: the OpenGL specification gives the function of that name this signature.
                    Some(unsafe { std::mem::transmute::<*const c_void, $kind>(function) })
                }
            }};
        }
        let clips = driver.version >= (4, 5) || driver.has("GL_ARB_clip_control");
        Self {
            clip_control: look_up!("glClipControl" as Enums).filter(|_| clips),
            provoking_vertex: look_up!("glProvokingVertex" as Enum),
            clamp_color: look_up!("glClampColor" as Enums),
            begin_conditional_render: look_up!("glBeginConditionalRender" as Enums),
            end_conditional_render: look_up!("glEndConditionalRender" as Nothing),
            get_query: look_up!("glGetQueryiv" as GetQuery),
            get_indexed: look_up!("glGetIntegeri_v" as GetIndexed),
            get_double: look_up!("glGetDoublev" as GetDouble),
            bind_range: look_up!("glBindBufferRange" as BindRange),
        }
    }

    pub(super) fn has_clip_control(&self) -> bool {
        self.clip_control.is_some()
    }

    /// Calls `glClipControl` if it exists.
    pub(super) fn clip_control(&self, [origin, depth]: [u32; 2]) {
        if let Some(call) = self.clip_control {
            // SAFETY: the context is current, here and below, and the constants are OpenGL's own.
            unsafe { call(origin, depth) };
        }
    }

    pub(super) fn has_provoking_vertex(&self) -> bool {
        self.provoking_vertex.is_some()
    }

    /// Calls `glProvokingVertex` if it exists.
    pub(super) fn provoking_vertex(&self, mode: u32) {
        if let Some(call) = self.provoking_vertex {
            // SAFETY: as above.
            unsafe { call(mode) };
        }
    }

    /// Calls `glClampColor` if it exists.
    pub(super) fn clamp_color(&self, target: u32, clamp: u32) {
        if let Some(call) = self.clamp_color {
            // SAFETY: as above.
            unsafe { call(target, clamp) };
        }
    }

    /// Calls `glBeginConditionalRender`. Returns false if it does not exist.
    pub(super) fn begin_conditional_render(&self, query: u32, mode: u32) -> bool {
        // SAFETY: as above.
        self.begin_conditional_render
            .map(|call| unsafe { call(query, mode) })
            .is_some()
    }

    /// Calls `glEndConditionalRender` if it exists.
    pub(super) fn end_conditional_render(&self) {
        if let Some(call) = self.end_conditional_render {
            // SAFETY: as above.
            unsafe { call() };
        }
    }

    /// The query that is active on a target, or 0 if there is none or it is not known.
    pub(super) fn current_query(&self, target: u32) -> u32 {
        let mut query = 0;
        if let Some(call) = self.get_query {
            // SAFETY: as above; the answer is a single number.
            unsafe { call(target, glow::CURRENT_QUERY, &raw mut query) };
        }
        query as u32
    }

    /// Four numbers of indexed state, or `None` if they cannot be asked for.
    pub(super) fn four(&self, name: u32, index: u32) -> Option<[i32; 4]> {
        let mut numbers = [0; 4];
        // SAFETY: as above; no indexed state has more numbers than four.
        self.get_indexed.map(|call| unsafe {
            call(name, index, numbers.as_mut_ptr());
            numbers
        })
    }

    /// `N` doubles, or `None` if they cannot be asked for.
    pub(super) fn doubles<const N: usize>(&self, name: u32) -> Option<[f64; N]> {
        let mut numbers = [0.0; N];
        // SAFETY: as above; the callers know how many numbers the state has.
        self.get_double.map(|call| unsafe {
            call(name, numbers.as_mut_ptr());
            numbers
        })
    }

    /// Calls `glBindBufferRange` with offsets of 64 bits. Returns false if it does not exist.
    pub(super) fn bind_range(&self, target: u32, index: u32, buffer: u32, range: [i64; 2]) -> bool {
        let [start, size] = range.map(|number| number as isize);
        // SAFETY: as above.
        self.bind_range
            .map(|call| unsafe { call(target, index, buffer, start, size) })
            .is_some()
    }
}
