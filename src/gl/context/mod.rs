//! OpenGL without a window: through EGL or through OSMesa, whichever is there.
//!
//! Neither library is linked; both are loaded when a context is asked for, so that building, and everything that needs
//! no GL, works on a machine without Mesa.

mod egl;
mod osmesa;

use std::fmt;
use std::marker::PhantomData;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::error::{Attempt, Error, Result};
use crate::gl::driver::Driver;

/// The lowest version the methods can do with: shader storage buffers and image atomics are core from here.
const LOWEST_VERSION: (u32, u32) = (4, 3);

/// Names the environment variable that chooses the backend.
const BACKEND_VARIABLE: &str = "ONIONSKIN_BACKEND";

/// How to get at OpenGL.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backend {
    /// libEGL, surfaceless platform first, then each EGL device.
    Egl,
    /// libOSMesa.
    OsMesa,
}

/// Which OpenGL.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// Without what OpenGL 3.1 removed.
    #[default]
    Core,
    /// With the fixed functions of old.
    Compatibility,
}

/// What kind of context is wanted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContextOptions {
    /// Only this one; otherwise the one that `ONIONSKIN_BACKEND` names, otherwise EGL, then OSMesa.
    pub backend: Option<Backend>,
    /// Which OpenGL.
    pub profile: Profile,
}

/// An OpenGL context, current on this thread for as long as it lives.
///
/// It cannot be sent to another thread. Of several contexts of one thread the last one made is current; let go of one
/// before using another.
pub struct Context {
    gl: Arc<glow::Context>,
    driver: Driver,
    current: Option<Box<dyn Current>>,
    backend: Option<Backend>,
    _not_send: PhantomData<*const ()>,
}

/// What keeps a context alive and current; ends it when dropped.
trait Current {
    /// Where the functions are.
    fn function(&self, name: &str) -> *const std::ffi::c_void;
}

impl Context {
    /// A context of the default kind: OpenGL 4.5 core, or the nearest that the driver has down to 4.3.
    ///
    /// # Errors
    /// [`Error::NoContext`] says what was tried, what each answered, and what to install.
    pub fn headless() -> Result<Self> {
        Self::new(ContextOptions::default())
    }

    /// A context as asked for.
    ///
    /// # Errors
    /// As [`Context::headless`], and if `ONIONSKIN_BACKEND` names no backend.
    pub fn new(options: ContextOptions) -> Result<Self> {
        let backends = match options
            .backend
            .map_or_else(from_environment, |backend| Ok(Some(backend)))?
        {
            Some(backend) => vec![backend],
            None => vec![Backend::Egl, Backend::OsMesa],
        };
        let mut tried = Vec::new();
        for backend in backends {
            match open(backend, options.profile, &mut tried) {
                Ok(context) => return Ok(context),
                Err(attempt) => tried.push(attempt),
            }
        }
        Err(Error::NoContext { tried })
    }

    /// Someone else's context, as egui_glow or three-d have it. It must be current on this thread, stay so while the
    /// returned value is used, and offer OpenGL 4.3.
    ///
    /// # Errors
    /// If its version is too low.
    pub fn from_glow(gl: Arc<glow::Context>) -> Result<Self> {
        let driver = Driver::read(&gl);
        if driver.version < LOWEST_VERSION || driver.embedded {
            let what = format!(
                "this context is {}; onionskin needs OpenGL 4.3",
                driver.version_text
            );
            return Err(Error::usage(
                what,
                "create the context with OpenGL 4.3 core or later",
            ));
        }
        Ok(Self {
            gl,
            driver,
            current: None,
            backend: None,
            _not_send: PhantomData,
        })
    }

    /// How it was made; nothing for someone else's.
    pub fn backend(&self) -> Option<Backend> {
        self.backend
    }

    /// What the driver says of itself.
    pub fn driver(&self) -> &Driver {
        &self.driver
    }

    /// A function by its name, for those that glow does not have; null if there is none, or if the context is someone
    /// else's.
    pub(in crate::gl) fn function(&self, name: &str) -> *const std::ffi::c_void {
        let current = self.current.as_ref();
        current.map_or(std::ptr::null(), |current| current.function(name))
    }

    /// The functions.
    pub fn glow(&self) -> &glow::Context {
        &self.gl
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        let _one_at_a_time = one_at_a_time();
        self.current = None;
    }
}

fn from_environment() -> Result<Option<Backend>> {
    match std::env::var(BACKEND_VARIABLE) {
        Ok(name) if !name.is_empty() => name.parse().map(Some),
        _ => Ok(None),
    }
}

/// Tries the wanted versions one by one. What failed on the way to a context goes into `tried`, the last failure is
/// returned.
fn open(backend: Backend, profile: Profile, tried: &mut Vec<Attempt>) -> Result<Context, Attempt> {
    let _one_at_a_time = one_at_a_time();
    let current = match backend {
        Backend::Egl => egl::open(profile, tried)?,
        Backend::OsMesa => osmesa::open(profile)?,
    };
    // SAFETY: the context was just made current on this thread, so its functions may be looked up and called.
    let gl = unsafe { glow::Context::from_loader_function(|name| current.function(name)) };
    let driver = Driver::read(&gl);
    if driver.version < LOWEST_VERSION {
        return Err(Attempt {
            what: backend.to_string(),
            answer: format!(
                "the driver offers only OpenGL {}; onionskin needs 4.3",
                driver.version_text
            ),
        });
    }
    Ok(Context {
        gl: Arc::new(gl),
        driver,
        current: Some(current),
        backend: Some(backend),
        _not_send: PhantomData,
    })
}

/// Held while a context is made or ended. Drivers promise that contexts of several threads may live side by side; that
/// they may come and go at the same moment is where Mesa's shared state (displays, screens, shader types) is touched.
fn one_at_a_time() -> MutexGuard<'static, ()> {
    static LIFETIMES: Mutex<()> = Mutex::new(());
    // It guards no data, so a panic while it was held has left nothing half done.
    LIFETIMES.lock().unwrap_or_else(PoisonError::into_inner)
}

/// An error with its reasons, for libloading says only 'dlopen failed' by itself. A reason that the error has named
/// is not repeated.
fn with_reasons(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    for reason in std::iter::successors(error.source(), |reason| reason.source()) {
        let reason = reason.to_string();
        if !text.ends_with(&reason) {
            text = format!("{text}: {reason}");
        }
    }
    text
}

impl fmt::Display for Backend {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Egl => "egl",
            Self::OsMesa => "osmesa",
        })
    }
}

impl std::str::FromStr for Backend {
    type Err = Error;

    fn from_str(name: &str) -> Result<Self> {
        match name {
            "egl" => Ok(Self::Egl),
            "osmesa" => Ok(Self::OsMesa),
            _ => Err(Error::usage(
                format!("there is no backend '{name}'"),
                format!(
                    "use egl or osmesa (argument --backend, or environment variable {BACKEND_VARIABLE})"
                ),
            )),
        }
    }
}

impl fmt::Debug for Context {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Context")
            .field("backend", &self.backend)
            .field("driver", &self.driver)
            .finish()
    }
}
