//! OpenGL without a window, by EGL or by OSMesa.
//!
//! Neither library is linked. They are loaded when a context is asked for. So building, and everything that needs no
//! GL, works on a machine without Mesa.

mod current;
mod egl;
mod guest;
mod headless;
mod native;
mod osmesa;
mod variables;

use std::cell::{Cell, OnceCell, RefCell};
use std::fmt;
use std::marker::PhantomData;
use std::rc::Rc;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use self::headless::Current;
use self::native::Native;
use crate::error::{Attempt, Error, Result};
use crate::gl::driver::Driver;
use crate::gl::more::More;
use crate::words::{Words, words};

pub(in crate::low_level::gl) use self::current::Away;
pub use self::headless::Profile;
pub use self::variables::suspect_variables;

/// The lowest version that is enough for the methods: shader storage buffers and image atomics are in its core.
const LOWEST_VERSION: (u32, u32) = (4, 3);

/// The lowest version of the shading language.
const LOWEST_SHADING_LANGUAGE: (u32, u32) = (4, 30);

/// The name of the environment variable that chooses the backend.
const BACKEND_VARIABLE: &str = "ONIONSKIN_BACKEND";

/// A backend, by which OpenGL is reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Backend {
    /// libEGL, surfaceless platform first, then each EGL device.
    Egl,
    /// libOSMesa.
    OsMesa,
}

words! { Backend, "backend",
    Egl "egl" "EGL, which needs no display",
    OsMesa "osmesa" "OSMesa, which Mesa has up to 25.0",
}

/// The wanted kind of context.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ContextOptions {
    /// The only backend to try. With `None` it is the one that `ONIONSKIN_BACKEND` names, or else EGL, then OSMesa.
    pub backend: Option<Backend>,
    /// The profile of OpenGL.
    pub profile: Profile,
}

/// An OpenGL context of one thread; it cannot be sent to another.
///
/// A thread may have several. What works in a context makes it current first, if it is onionskin's own: a
/// [`Renderer`](crate::Renderer) gives back what was current before, even a context that a host has made current by EGL; the
/// calls of a [`GlMachine`](crate::gl::GlMachine) leave theirs current. Of someone else's context see [`Context::from_glow`].
pub struct Context {
    gl: Arc<glow::Context>,
    driver: Driver,
    /// Nothing of someone else's.
    current: Option<Rc<dyn Current>>,
    backend: Option<Backend>,
    /// Someone else's, as far as it can be known.
    native: Option<Native>,
    more: OnceCell<More>,
    /// How many visits are going on, one within the other.
    visits: Cell<u32>,
    /// How many buffers and textures were filled with parts of scenes.
    uploads: Cell<u64>,
    /// OpenGL's errors of calls that were not onionskin's.
    foreign: RefCell<Vec<String>>,
    _not_send: PhantomData<*const ()>,
}

impl Context {
    /// A context of the default kind: OpenGL 4.5 core, or the nearest that the driver has down to 4.3.
    ///
    /// # Errors
    /// [`Error::NoContext`] says what was tried, what each answered, and what to install.
    pub fn headless() -> Result<Self> {
        Self::new(ContextOptions::default())
    }

    /// A context of the wanted kind.
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
        tried.extend(suspect_variables());
        Err(Error::NoContext { tried })
    }

    /// The backend that made it, or `None` for someone else's context.
    pub fn backend(&self) -> Option<Backend> {
        self.backend
    }

    /// The driver's description of itself.
    pub fn driver(&self) -> &Driver {
        &self.driver
    }

    /// A function by its name, for those that glow does not have; null if there is none, or if the context is someone
    /// else's and it is not known whose.
    pub(in crate::low_level::gl) fn function(&self, name: &str) -> *const std::ffi::c_void {
        match (&self.current, &self.native) {
            (Some(current), _) => current.function(name),
            (None, Some(native)) => native.function(name),
            (None, None) => std::ptr::null(),
        }
    }

    /// The functions that glow does not have.
    pub(in crate::low_level::gl) fn more(&self) -> &More {
        self.more
            .get_or_init(|| More::load(&self.driver, |name| self.function(name)))
    }

    /// The functions. The context is made current, if it is onionskin's own.
    pub fn glow(&self) -> &glow::Context {
        if let Some(current) = &self.current
            && !current::is_current(current)
        {
            // Left as it is: the caller works with it from now on. A context of one's own thread can always be made
            // current; where the driver is lost, its next answers say so.
            std::mem::forget(current::enter(current));
        }
        &self.gl
    }

    /// Whether objects of the one are objects of the other.
    pub(in crate::low_level::gl) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.gl, &other.gl)
    }
}

impl Drop for Context {
    fn drop(&mut self) {
        let _one_at_a_time = one_at_a_time();
        // This ends the context, and releases it if it is current.
        self.current = None;
    }
}

fn from_environment() -> Result<Option<Backend>> {
    match std::env::var(BACKEND_VARIABLE) {
        Ok(name) if !name.is_empty() => name.parse().map(Some).map_err(|_| {
            let known = Backend::VALUES
                .iter()
                .map(|backend| backend.word())
                .collect::<Vec<_>>()
                .join(" or ");
            Error::option(
                "backend",
                format!(
                    "the environment variable {BACKEND_VARIABLE} names no backend, but '{name}'"
                ),
                format!("set it to {known}, or unset it"),
            )
        }),
        _ => Ok(None),
    }
}

/// Tries the wanted versions one by one. Earlier failures go into `tried`, and the last failure is returned.
fn open(backend: Backend, profile: Profile, tried: &mut Vec<Attempt>) -> Result<Context, Attempt> {
    let _one_at_a_time = one_at_a_time();
    let before = current::set_aside();
    let current = match backend {
        Backend::Egl => egl::open(profile, tried)?,
        Backend::OsMesa => osmesa::open(profile)?,
    };
    // SAFETY: the context was just made current on this thread, so its functions may be looked up and called.
    let gl = unsafe { glow::Context::from_loader_function(|name| current.function(name)) };
    let driver = Driver::read(&gl);
    if let Some(answer) = too_low(&driver) {
        return Err(Attempt {
            what: backend.to_string(),
            answer,
        });
    }
    before.forget();
    current::remember(&current);
    let mut context = Context::around(Arc::new(gl), driver);
    (context.backend, context.current) = (Some(backend), Some(current));
    Ok(context)
}

/// The fault of a driver that offers too little.
fn too_low(driver: &Driver) -> Option<String> {
    let Driver {
        version,
        version_text,
        shading_language,
        ..
    } = driver;
    if *version < LOWEST_VERSION || driver.embedded {
        let hides = variables::hides(variables::VERSION);
        Some(format!(
            "the driver offers only OpenGL {version_text}; onionskin needs 4.3{hides}"
        ))
    } else if *shading_language < LOWEST_SHADING_LANGUAGE {
        let (major, minor) = shading_language;
        let hides = variables::hides(variables::SHADING_LANGUAGE);
        Some(format!(
            "the driver offers only version {major}.{minor:02} of the shading language; onionskin needs 4.30{hides}"
        ))
    } else {
        None
    }
}

/// It is held while a context is made or ended. Drivers promise that contexts of several threads may exist side by
/// side. But making and ending them touches Mesa's shared state (displays, screens, shader types).
fn one_at_a_time() -> MutexGuard<'static, ()> {
    static LIFETIMES: Mutex<()> = Mutex::new(());
    // It guards no data, so a panic while it was held leaves nothing half done.
    LIFETIMES.lock().unwrap_or_else(PoisonError::into_inner)
}

impl fmt::Debug for Context {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Context")
            .field("backend", &self.backend)
            .field("driver", &self.driver)
            .finish()
    }
}
