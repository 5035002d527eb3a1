//! Someone else's context, and onionskin's knowledge of it.

use super::*;
use crate::gl::making::take_errors;

impl Context {
    /// Someone else's context, as egui_glow or three-d have it. It must offer OpenGL 4.3.
    ///
    /// A [`Renderer`](crate::Renderer) gives the context back as it found it, and says in
    /// [`Frame::notices`](crate::Frame::notices) which errors OpenGL had pending before. What it cannot put back it refuses
    /// to begin with; see [`Context::visit`]. Who calls a [`GlMachine`](crate::gl::GlMachine) makes a visit of it.
    ///
    /// ```no_run
    /// use std::sync::Arc;
    ///
    /// use onionskin::{Context, Method, Renderer, Scene};
    ///
    /// fn exact_image(host: Arc<glow::Context>, scene: &Scene) -> onionskin::Result<onionskin::Image> {
    ///     // SAFETY: the host's context is current on this thread until the function ends.
    ///     let context = unsafe { Context::from_glow(host) }?;
    ///     let [width, height] = scene.size;
    ///     let frame = Renderer::new(&context, width, height)?.render(scene, &Method::Exact)?;
    ///     Ok(frame.image)
    /// }
    /// ```
    ///
    /// # Errors
    /// If its version is too low.
    ///
    /// # Safety
    /// The functions are those of an OpenGL context that is current on this thread. It is current, too, whenever something
    /// of onionskin's is used or dropped that was made with the returned value, and it ends after the last of that. Where
    /// EGL, GLX or OSMesa can be asked, onionskin asks whether it is, and answers with an error if not; but a context
    /// that ended and one that began in its place look alike.
    pub unsafe fn from_glow(gl: Arc<glow::Context>) -> Result<Self> {
        let driver = Driver::read(&gl);
        if let Some(what) = too_low(&driver) {
            return Err(Error::Driver {
                what,
                remedy: "create the context with OpenGL 4.3 core or later".into(),
            });
        }
        let mut context = Self::around(gl, driver);
        context.native = Native::current();
        Ok(context)
    }

    pub(super) fn around(gl: Arc<glow::Context>, driver: Driver) -> Self {
        Self {
            gl,
            driver,
            current: None,
            backend: None,
            native: None,
            more: OnceCell::new(),
            visits: Cell::new(0),
            uploads: Cell::new(0),
            foreign: RefCell::default(),
            _not_send: PhantomData,
        }
    }

    /// Makes the context current until the answer is dropped; or makes sure that it is, if it is someone else's.
    ///
    /// # Errors
    /// If it is not.
    pub(in crate::low_level::gl) fn enter(&self) -> Result<Away> {
        if let Some(current) = &self.current {
            return current::enter(current).map_err(|answer| Error::Lost {
                doing: "make the context current".into(),
                answer: answer.to_string(),
            });
        }
        self.expect_current()?;
        Ok(Away::default())
    }

    /// # Errors
    /// If it is someone else's, and known not to be current.
    pub(in crate::low_level::gl) fn expect_current(&self) -> Result<()> {
        if self.native.is_none_or(|native| native.is_current()) {
            return Ok(());
        }
        Err(Error::host(
            "another OpenGL context is current than the one that was handed over, or none",
            "make that one current on this thread before the call",
        ))
    }

    /// How many buffers and textures have been filled with parts of scenes so far: one for a mesh's vertices, one for its
    /// triangles in the order in which they are drawn, one for a volume's samples.
    pub fn uploads(&self) -> u64 {
        self.uploads.get()
    }

    pub(in crate::low_level::gl) fn count_upload(&self) {
        self.uploads.set(self.uploads.get() + 1);
    }

    /// Errors that OpenGL had pending when onionskin began to work in the context, by their names, since they were last
    /// asked for. They are of calls that were made before, and in no image.
    pub fn foreign_errors(&self) -> Vec<String> {
        self.foreign.take()
    }

    /// Takes pending errors as someone else's.
    pub(in crate::low_level::gl) fn note_foreign_errors(&self) {
        let errors = take_errors(&self.gl);
        let mut foreign = self.foreign.borrow_mut();
        // A host that never asks, and makes an error in each frame, is told of the last errors.
        const MOST: usize = 64;
        foreign.extend(errors.into_iter().map(str::to_owned));
        let surplus = foreign.len().saturating_sub(MOST);
        foreign.drain(..surplus);
    }

    /// The same, unless a visit is going on, in which all errors are onionskin's own.
    pub(in crate::low_level::gl) fn note_errors_outside_of_visits(&self) {
        if self.visits.get() == 0 {
            self.note_foreign_errors();
        }
    }

    /// Something is to be made in the context from now on.
    ///
    /// # Errors
    /// If it is someone else's, and not current.
    pub(in crate::low_level::gl) fn begin_making(&self) -> Result<()> {
        self.expect_current()?;
        // Makes it current, if it is onionskin's own.
        self.glow();
        self.note_errors_outside_of_visits();
        Ok(())
    }

    /// Whether onionskin has made the context.
    pub(in crate::low_level::gl) fn is_own(&self) -> bool {
        self.current.is_some()
    }

    /// Returns whether it is the first one.
    pub(in crate::low_level::gl) fn begin_visit(&self) -> bool {
        self.visits.set(self.visits.get() + 1);
        self.visits.get() == 1
    }

    pub(in crate::low_level::gl) fn end_visit(&self) {
        self.visits.set(self.visits.get() - 1);
    }
}
