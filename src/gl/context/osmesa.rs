//! OSMesa: Mesa that draws into main memory, without a window system and without EGL.

use std::cell::RefCell;
use std::ffi::{CString, c_int, c_uchar, c_uint, c_void};
use std::rc::Rc;

use libloading::Library;

use super::headless::{Current, Profile, with_reasons};
use super::variables;
use crate::error::Attempt;

const LIBRARIES: [&str; 3] = ["libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"];

const OSMESA_FORMAT: c_int = 0x22;
const OSMESA_RGBA: c_int = 0x1908;
const OSMESA_PROFILE: c_int = 0x33;
const OSMESA_CORE_PROFILE: c_int = 0x34;
const OSMESA_COMPAT_PROFILE: c_int = 0x35;
const OSMESA_CONTEXT_MAJOR_VERSION: c_int = 0x36;
const OSMESA_CONTEXT_MINOR_VERSION: c_int = 0x37;
const GL_UNSIGNED_BYTE: c_uint = 0x1401;

/// As for EGL, the last version is there for the error message.
const VERSIONS: [(c_int, c_int); 3] = [(4, 5), (4, 3), (3, 1)];

/// The size of OSMesa's colour buffer. Everything is drawn into framebuffer objects, so the smallest will do.
const SIDE: c_int = 16;

type CreateContextAttribs = unsafe extern "C" fn(*const c_int, *mut c_void) -> *mut c_void;
type MakeCurrent = unsafe extern "C" fn(*mut c_void, *mut c_void, c_uint, c_int, c_int) -> c_uchar;
type GetProcAddress = unsafe extern "C" fn(*const std::ffi::c_char) -> *const c_void;
type DestroyContext = unsafe extern "C" fn(*mut c_void);
type GetCurrentContext = unsafe extern "C" fn() -> *mut c_void;

struct OsMesaContext {
    context: *mut c_void,
    get_proc_address: GetProcAddress,
    get_current: GetCurrentContext,
    make_current: MakeCurrent,
    destroy: DestroyContext,
    /// The buffer into which OSMesa would draw. It keeps the address.
    buffer: RefCell<Vec<u8>>,
}

/// Opens a context.
pub(super) fn open(profile: Profile) -> Result<Rc<dyn Current>, Attempt> {
    let attempt = |what: &str, answer: String| Attempt {
        what: format!("osmesa, {what}"),
        answer,
    };
    if let Some(why) = variables::crashes_osmesa() {
        return Err(attempt("OSMesaCreateContextAttribs", why));
    }
    let library = load().map_err(|answer| attempt("loading libOSMesa.so.8", answer))?;
    let missing = |e: libloading::Error| attempt("looking up its functions", with_reasons(&e));
    // SAFETY: Mesa's osmesa.h gives these functions these signatures.
    let create: CreateContextAttribs = unsafe {
        *library
            .get(b"OSMesaCreateContextAttribs\0")
            .map_err(missing)?
    };
    // SAFETY: as above.
    let make_current: MakeCurrent =
        unsafe { *library.get(b"OSMesaMakeCurrent\0").map_err(missing)? };
    // SAFETY: as above.
    let get_proc_address: GetProcAddress =
        unsafe { *library.get(b"OSMesaGetProcAddress\0").map_err(missing)? };
    // SAFETY: as above.
    let get_current: GetCurrentContext =
        unsafe { *library.get(b"OSMesaGetCurrentContext\0").map_err(missing)? };
    // SAFETY: as above.
    let destroy: DestroyContext =
        unsafe { *library.get(b"OSMesaDestroyContext\0").map_err(missing)? };
    // Mesa keeps thread-local state and worker threads, which do not survive an unloading: the library stays.
    std::mem::forget(library);

    let profile = match profile {
        Profile::Core => OSMESA_CORE_PROFILE,
        Profile::Compatibility => OSMESA_COMPAT_PROFILE,
    };
    let context = VERSIONS
        .iter()
        .map(|&(major, minor)| {
            let attributes = [
                OSMESA_FORMAT,
                OSMESA_RGBA,
                OSMESA_PROFILE,
                profile,
                OSMESA_CONTEXT_MAJOR_VERSION,
                major,
                OSMESA_CONTEXT_MINOR_VERSION,
                minor,
                0,
            ];
            // SAFETY: the list is terminated by 0, and no context is shared.
            unsafe { create(attributes.as_ptr(), std::ptr::null_mut()) }
        })
        .find(|context| !context.is_null())
        .ok_or_else(|| {
            attempt(
                "OSMesaCreateContextAttribs",
                "it made no context, not even OpenGL 3.1".into(),
            )
        })?;

    let made = Rc::new(OsMesaContext {
        context,
        get_proc_address,
        get_current,
        make_current,
        destroy,
        buffer: RefCell::new(vec![0; (SIDE * SIDE * 4) as usize]),
    });
    let current = made.make_current();
    current.map_err(|answer| attempt("OSMesaMakeCurrent", answer))?;
    Ok(made)
}

fn load() -> Result<Library, String> {
    let mut answer = String::new();
    for name in LIBRARIES {
        // SAFETY: a library of that name is Mesa's; loading it runs its initialisers and nothing else.
        match unsafe { Library::new(name) } {
            Ok(library) => return Ok(library),
            Err(e) if answer.is_empty() => answer = with_reasons(&e),
            Err(_) => {}
        }
    }
    Err(answer)
}

impl Current for OsMesaContext {
    fn function(&self, name: &str) -> *const c_void {
        let Ok(name) = CString::new(name) else {
            return std::ptr::null();
        };
        // SAFETY: the name is a C string.
        unsafe { (self.get_proc_address)(name.as_ptr()) }
    }

    fn is_current(&self) -> bool {
        // SAFETY: it only reads what this thread has.
        (unsafe { (self.get_current)() }) == self.context
    }

    fn make_current(&self) -> Result<(), String> {
        let mut buffer = self.buffer.borrow_mut();
        // SAFETY: the context is ours, and the buffer holds SIDE x SIDE RGBA bytes and lives as long as it.
        let made = unsafe {
            (self.make_current)(
                self.context,
                buffer.as_mut_ptr().cast(),
                GL_UNSIGNED_BYTE,
                SIDE,
                SIDE,
            )
        };
        if made == 0 {
            return Err("it refused its own context".into());
        }
        Ok(())
    }

    fn release(&self) {
        // SAFETY: without a context and a buffer nothing is current afterwards.
        unsafe { (self.make_current)(std::ptr::null_mut(), std::ptr::null_mut(), 0, 0, 0) };
    }
}

impl Drop for OsMesaContext {
    fn drop(&mut self) {
        if self.is_current() {
            self.release();
        }
        // SAFETY: the context is ours, and nobody uses it after this.
        unsafe { (self.destroy)(self.context) };
    }
}
