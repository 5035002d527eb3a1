//! OpenGL's functions by name, for tests that play the host of a context: the same library that made the context is
//! asked.

#![allow(unsafe_code)] // functions are looked up in a library

use std::ffi::{CString, c_char, c_void};

use onionskin::{Backend, Context};

/// A function of the current context; null if there is none of that name.
pub fn function(backend: Backend, name: &str) -> *const c_void {
    type GetProcAddress = unsafe extern "C" fn(*const c_char) -> *const c_void;
    let (libraries, look_up) = match backend {
        Backend::Egl => (["libEGL.so.1", "libEGL.so"], "eglGetProcAddress"),
        Backend::OsMesa => (["libOSMesa.so.8", "libOSMesa.so"], "OSMesaGetProcAddress"),
        _ => panic!("no library is known for {backend}"),
    };
    let name = CString::new(name).expect("a name without zeros");
    // SAFETY: the library is loaded already, and stays; both look-ups have this signature.
    unsafe {
        let library = libraries
            .iter()
            .find_map(|library| libloading::Library::new(*library).ok())
            .expect("the library that made the context");
        let look_up: GetProcAddress = *library.get(look_up.as_bytes()).expect("its look-up");
        let function = look_up(name.as_ptr());
        std::mem::forget(library);
        function
    }
}

/// The functions of a headless context once more, as a host has them that made it.
#[allow(dead_code)]
pub fn functions(context: &Context) -> glow::Context {
    let backend = context.backend().expect("a headless context");
    // SAFETY: the context is current.
    unsafe { glow::Context::from_loader_function(|name| function(backend, name)) }
}
