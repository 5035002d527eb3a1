//! The OpenGL context that is current on this thread by the system's account, whoever has made it current, and its
//! functions.
//!
//! Of someone else's context onionskin is only given the functions that glow has. Its window system's library is in the
//! process already, so it can be asked for the rest.

use std::ffi::{CStr, CString, c_char, c_void};

type GetCurrent = unsafe extern "C" fn() -> *mut c_void;
type GetProcAddress = unsafe extern "C" fn(*const c_char) -> *const c_void;

/// A context as its window system's library knows it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Native {
    get_current: GetCurrent,
    get_proc_address: GetProcAddress,
    handle: usize,
}

/// The libraries' names on Linux, and the names of two functions of each.
const SYSTEMS: [([&str; 2], &CStr, &CStr); 3] = [
    (
        ["libEGL.so.1", "libEGL.so"],
        c"eglGetCurrentContext",
        c"eglGetProcAddress",
    ),
    (
        ["libGLX.so.0", "libGL.so.1"],
        c"glXGetCurrentContext",
        c"glXGetProcAddressARB",
    ),
    (
        ["libOSMesa.so.8", "libOSMesa.so.6"],
        c"OSMesaGetCurrentContext",
        c"OSMesaGetProcAddress",
    ),
];

impl Native {
    /// The context that is current on this thread. `None` if no known library has one, or if more than one library
    /// believes that it has.
    pub(super) fn current() -> Option<Self> {
        let mut known = SYSTEMS.iter().filter_map(|(libraries, current, function)| {
            let native = libraries
                .iter()
                .find_map(|library| Self::of(library, current, function))?;
            (native.handle != 0).then_some(native)
        });
        let native = known.next()?;
        known.next().is_none().then_some(native)
    }

    /// Whether its context is still the one that its library has current on this thread.
    pub(super) fn is_current(&self) -> bool {
        // SAFETY: the library stays loaded for as long as the context that it made lives.
        (unsafe { (self.get_current)() }) as usize == self.handle
    }

    /// A function of OpenGL's; null if there is none of that name.
    pub(super) fn function(&self, name: &str) -> *const c_void {
        let Ok(name) = CString::new(name) else {
            return std::ptr::null();
        };
        // SAFETY: the name is a C string; the library as above.
        unsafe { (self.get_proc_address)(name.as_ptr()) }
    }

    #[cfg(target_os = "linux")]
    fn of(library: &str, current: &CStr, function: &CStr) -> Option<Self> {
        use libloading::os::unix::{Library, RTLD_LAZY};
        /// This opens a library only if it is loaded already. The number is the same in glibc and musl.
        const RTLD_NOLOAD: i32 = 4;
        // SAFETY: nothing is loaded, so no initialiser runs; the functions have these signatures in every version of their
        // libraries, and live as long as the library, which those keep loaded who have loaded it.
        unsafe {
            let library = Library::open(Some(library), RTLD_LAZY | RTLD_NOLOAD).ok()?;
            let get_current: GetCurrent = *library.get(current.to_bytes_with_nul()).ok()?;
            let get_proc_address: GetProcAddress =
                *library.get(function.to_bytes_with_nul()).ok()?;
            Some(Self {
                get_current,
                get_proc_address,
                handle: get_current() as usize,
            })
        }
    }

    /// On other systems the libraries' names are not known.
    #[cfg(not(target_os = "linux"))]
    fn of(_: &str, _: &CStr, _: &CStr) -> Option<Self> {
        None
    }
}
