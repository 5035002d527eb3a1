//! EGL: Mesa's surfaceless platform first, then each EGL device.

use std::ffi::c_void;
use std::rc::Rc;
use std::sync::OnceLock;

use khronos_egl as egl;

use super::headless::{Current, Profile, with_reasons};
use crate::error::Attempt;

type Instance = egl::DynamicInstance<egl::EGL1_5>;

const PLATFORM_SURFACELESS_MESA: egl::Enum = 0x31DD;
const PLATFORM_DEVICE_EXT: egl::Enum = 0x313F;

/// The versions that are asked for, best first. A driver that is too old for onionskin still gives the last one, so
/// that the error can say which version it has.
const VERSIONS: [(egl::Int, egl::Int); 3] = [(4, 5), (4, 3), (3, 1)];

/// libEGL, once it has been loaded. Mesa has thread-local state and worker threads, which do not survive an unloading,
/// so the library stays loaded as long as the process runs. So does the display that it has initialised.
static LIBRARY: OnceLock<Instance> = OnceLock::new();

struct EglContext {
    instance: &'static Instance,
    display: egl::Display,
    context: egl::Context,
}

/// Opens a context on the first display that gives one. Displays that did not are added to `tried`.
pub(super) fn open(profile: Profile, tried: &mut Vec<Attempt>) -> Result<Rc<dyn Current>, Attempt> {
    let attempt = |what: &str, answer: String| Attempt {
        what: format!("egl, {what}"),
        answer,
    };
    let instance = library().map_err(|answer| attempt("loading libEGL.so.1", answer))?;
    let mut failures = Vec::new();
    for (name, display) in displays(instance) {
        match display.and_then(|display| on_display(instance, display, profile)) {
            Ok((display, context)) => {
                tried.append(&mut failures);
                return Ok(Rc::new(EglContext {
                    instance,
                    display,
                    context,
                }));
            }
            Err(answer) => failures.push(attempt(&name, answer)),
        }
    }
    let last = failures
        .pop()
        .unwrap_or_else(|| attempt("displays", "there are none".into()));
    tried.append(&mut failures);
    Err(last)
}

fn library() -> Result<&'static Instance, String> {
    if let Some(instance) = LIBRARY.get() {
        return Ok(instance);
    }
    // SAFETY: libEGL.so.1 is the platform's EGL; loading it runs its initialisers and nothing else.
    let loaded = unsafe { Instance::load_required() }.map_err(|e| with_reasons(&e))?;
    Ok(LIBRARY.get_or_init(|| loaded))
}

/// Every display, with a name for messages.
fn displays(instance: &Instance) -> Vec<(String, Result<egl::Display, String>)> {
    let surfaceless = platform_display(instance, PLATFORM_SURFACELESS_MESA, egl::DEFAULT_DISPLAY);
    let mut displays = vec![("surfaceless".to_owned(), surfaceless)];
    for (number, device) in devices(instance).into_iter().enumerate() {
        displays.push((
            format!("device {number}"),
            platform_display(instance, PLATFORM_DEVICE_EXT, device),
        ));
    }
    displays
}

fn platform_display(
    instance: &Instance,
    platform: egl::Enum,
    native: *mut c_void,
) -> Result<egl::Display, String> {
    // SAFETY: `native` is EGL_DEFAULT_DISPLAY or a device that eglQueryDevicesEXT has just returned.
    unsafe { instance.get_platform_display(platform, native, &[egl::ATTRIB_NONE]) }
        .map_err(|e| e.to_string())
}

fn devices(instance: &Instance) -> Vec<*mut c_void> {
    type QueryDevices =
        extern "system" fn(egl::Int, *mut *mut c_void, *mut egl::Int) -> egl::Boolean;
    let Some(function) = instance.get_proc_address("eglQueryDevicesEXT") else {
        return Vec::new();
    };
    // SAFETY: EGL_EXT_device_enumeration gives eglQueryDevicesEXT this signature.
    let query = unsafe { std::mem::transmute::<extern "system" fn(), QueryDevices>(function) };
    let mut devices = vec![std::ptr::null_mut(); 16];
    let mut count = 0;
    if query(
        devices.len() as egl::Int,
        devices.as_mut_ptr(),
        &raw mut count,
    ) != egl::TRUE
    {
        return Vec::new();
    }
    devices.truncate(usize::try_from(count).unwrap_or(0));
    devices
}

/// A current context without any surface.
fn on_display(
    instance: &Instance,
    display: egl::Display,
    profile: Profile,
) -> Result<(egl::Display, egl::Context), String> {
    instance
        .initialize(display)
        .map_err(|e| format!("eglInitialize: {e}"))?;
    instance
        .bind_api(egl::OPENGL_API)
        .map_err(|e| format!("eglBindAPI: {e}"))?;
    let wanted = [
        egl::RENDERABLE_TYPE,
        egl::OPENGL_BIT,
        egl::SURFACE_TYPE,
        egl::PBUFFER_BIT,
        egl::NONE,
    ];
    let config = instance
        .choose_first_config(display, &wanted)
        .map_err(|e| format!("eglChooseConfig: {e}"))?
        .ok_or("eglChooseConfig: no configuration renders OpenGL")?;
    let mask = match profile {
        Profile::Core => egl::CONTEXT_OPENGL_CORE_PROFILE_BIT,
        Profile::Compatibility => egl::CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
    };
    let mut answer = String::new();
    for (major, minor) in VERSIONS {
        let attributes = [
            egl::CONTEXT_MAJOR_VERSION,
            major,
            egl::CONTEXT_MINOR_VERSION,
            minor,
            egl::CONTEXT_OPENGL_PROFILE_MASK,
            mask,
            egl::NONE,
        ];
        match instance.create_context(display, config, None, &attributes) {
            Ok(context) => {
                return match instance.make_current(display, None, None, Some(context)) {
                    Ok(()) => Ok((display, context)),
                    Err(e) => {
                        let _ = instance.destroy_context(display, context);
                        Err(format!("eglMakeCurrent: {e}"))
                    }
                };
            }
            Err(e) => answer = format!("eglCreateContext, OpenGL {major}.{minor}: {e}"),
        }
    }
    Err(answer)
}

impl Current for EglContext {
    fn function(&self, name: &str) -> *const c_void {
        self.instance
            .get_proc_address(name)
            .map_or(std::ptr::null(), |function| function as *const c_void)
    }

    fn is_current(&self) -> bool {
        self.instance.get_current_context() == Some(self.context)
    }

    fn make_current(&self) -> Result<(), String> {
        // The API is chosen for each thread, and a host may have chosen OpenGL ES.
        let bound = self.instance.bind_api(egl::OPENGL_API);
        bound.map_err(|e| format!("eglBindAPI: {e}"))?;
        self.instance
            .make_current(self.display, None, None, Some(self.context))
            .map_err(|e| format!("eglMakeCurrent: {e}"))
    }

    fn release(&self) {
        let _ = self.instance.make_current(self.display, None, None, None);
    }
}

/// A context that someone else has made current, and its surfaces.
pub(super) struct Binding {
    api: egl::Enum,
    display: egl::Display,
    surfaces: [Option<egl::Surface>; 2],
    context: egl::Context,
}

/// Leaves the context that EGL has current on this thread, if it has one.
pub(super) fn leave() -> Option<Binding> {
    let instance = LIBRARY.get()?;
    let context = instance.get_current_context()?;
    let display = instance.get_current_display()?;
    let surfaces = [egl::DRAW, egl::READ].map(|which| instance.get_current_surface(which));
    let api = instance.query_api();
    instance.make_current(display, None, None, None).ok()?;
    Some(Binding {
        api,
        display,
        surfaces,
        context,
    })
}

impl Binding {
    pub(super) fn come_back(self) {
        let Some(instance) = LIBRARY.get() else {
            return;
        };
        let [draw, read] = self.surfaces;
        // If the host's context cannot be restored, the host notices with its next call. Nobody can be told here.
        let _ = instance.bind_api(self.api);
        let _ = instance.make_current(self.display, draw, read, Some(self.context));
    }
}

impl Drop for EglContext {
    fn drop(&mut self) {
        // The display is shared by every context of the process and stays.
        if self.instance.get_current_context() == Some(self.context) {
            let _ = self.instance.make_current(self.display, None, None, None);
        }
        let _ = self.instance.destroy_context(self.display, self.context);
    }
}
