//! A visit: from its beginning to its end a context is current and may be changed, and is then as it was.

use glow::HasContext;

use super::super::context::{Away, Context};
use super::super::making::{expect_no_error, take_errors};
use super::bindings::Bindings;
use super::fixed::{Fixed, out_of_reach};
use super::per_buffer::PerBuffer;
use crate::error::{Error, Result};

/// Keeps the host's state while onionskin works in its context, and puts it back when dropped. Made by
/// [`Context::visit`].
#[must_use = "the state comes back when it is dropped"]
#[derive(Debug)]
pub struct Visit<'c> {
    context: &'c Context,
    /// Nothing in a visit within a visit.
    host: Option<Box<Host>>,
    /// What was current before. Dropped after the state has come back.
    _away: Away,
}

#[derive(Debug)]
struct Host {
    fixed: Fixed,
    per_buffer: PerBuffer,
    bindings: Bindings,
    /// Transform feedback was active, and is paused.
    feedback: bool,
}

/// The queries that count samples. Of these only one can be active, and none can be interrupted.
const OCCLUSION_QUERIES: [(u32, &str); 3] = [
    (glow::SAMPLES_PASSED, "GL_SAMPLES_PASSED"),
    (glow::ANY_SAMPLES_PASSED, "GL_ANY_SAMPLES_PASSED"),
    (
        glow::ANY_SAMPLES_PASSED_CONSERVATIVE,
        "GL_ANY_SAMPLES_PASSED_CONSERVATIVE",
    ),
];

impl Context {
    /// Makes the context current and keeps its state. Both are restored when the visit is dropped.
    ///
    /// A [`Renderer`](crate::Renderer) begins a visit by itself. A caller of a [`GlMachine`](crate::gl::GlMachine) in
    /// someone else's context has to begin one: a machine's calls, like GL's, leave the state as they set it.
    ///
    /// Errors that OpenGL had pending are taken, and kept for [`foreign_errors`](Self::foreign_errors): they are of calls that
    /// were made before.
    ///
    /// # Errors
    /// If the context cannot be made current, or is in the middle of something that cannot be interrupted: a query that
    /// counts samples, a conditional render, or, if it is someone else's, a program in use that has been deleted.
    pub fn visit(&self) -> Result<Visit<'_>> {
        let away = self.enter()?;
        if !self.begin_visit() {
            return Ok(Visit {
                context: self,
                host: None,
                _away: away,
            });
        }
        // From here on dropping it ends the visit.
        let mut visit = Visit {
            context: self,
            host: None,
            _away: away,
        };
        self.note_foreign_errors();
        expect_interruptible(self)?;
        let mut bindings = Bindings::read(self);
        if bindings.doomed_program(self).is_some() && self.is_own() {
            // A machine's that has been dropped.
            // SAFETY: the context is current.
            unsafe { self.glow().use_program(None) };
            bindings = Bindings::read(self);
        }
        if bindings.doomed_program(self).is_some() {
            return Err(Error::host(
                "the context uses a program that has been deleted, which could not be put back",
                "call glUseProgram(0) before the frame",
            ));
        }
        visit.host = Some(Box::new(Host {
            fixed: Fixed::read(self),
            per_buffer: PerBuffer::read(self),
            bindings,
            feedback: pause_feedback(self),
        }));
        expect_no_error(self.glow(), "when its state is asked for")?;
        Ok(visit)
    }
}

impl Drop for Visit<'_> {
    fn drop(&mut self) {
        let context = self.context;
        if let Some(host) = self.host.take() {
            host.per_buffer.set(context);
            host.fixed.set(context);
            host.bindings.set(context);
            if host.feedback {
                // SAFETY: it was paused by this visit, and its program is in use again.
                unsafe { context.glow().resume_transform_feedback() };
            }
            // The caller has been told of the frame's errors. The host would take them for its own.
            take_errors(context.glow());
        }
        context.end_visit();
    }
}

/// # Errors
/// See [`Context::visit`].
fn expect_interruptible(context: &Context) -> Result<()> {
    let more = context.more();
    for (target, name) in OCCLUSION_QUERIES {
        let query = more.current_query(target);
        if query != 0 {
            return Err(Error::host(
                format!(
                    "the context is in the middle of the query {query} ({name}), and OpenGL counts for one at a time"
                ),
                format!("call glEndQuery({name}) before the frame"),
            ));
        }
    }
    if let Some(call) = out_of_reach(context) {
        return Err(Error::host(
            "the context has a state that is not OpenGL's initial one, and that cannot be changed from here",
            format!("call {call} before the frame"),
        ));
    }
    if is_conditional(context) {
        return Err(Error::host(
            "the context is in the middle of a conditional render, which may leave out any draw",
            "call glEndConditionalRender() before the frame",
        ));
    }
    Ok(())
}

/// Whether a conditional render is going on: there is no state that says so, but none can begin within another.
fn is_conditional(context: &Context) -> bool {
    let gl = context.glow();
    // SAFETY: the context is current, and no query is active.
    unsafe {
        let flags = gl.get_parameter_i32(glow::CONTEXT_FLAGS) as u32;
        // Such a context does not say what is wrong.
        if flags & glow::CONTEXT_FLAG_NO_ERROR_BIT != 0 {
            return false;
        }
        let Ok(query) = gl.create_query() else {
            return false;
        };
        gl.begin_query(glow::SAMPLES_PASSED, query);
        gl.end_query(glow::SAMPLES_PASSED);
        const QUERY_WAIT: u32 = 0x8E13;
        let more = context.more();
        let asked = more.begin_conditional_render(query.0.get(), QUERY_WAIT);
        let refused = asked && gl.get_error() == glow::INVALID_OPERATION;
        if asked && !refused {
            more.end_conditional_render();
        }
        gl.delete_query(query);
        refused
    }
}

/// Pauses the host's transform feedback, if it is active. Returns whether it was.
fn pause_feedback(context: &Context) -> bool {
    let gl = context.glow();
    // SAFETY: the context is current; both are single numbers, and only what is active is paused.
    unsafe {
        let is = |name| gl.get_parameter_i32(name) != 0;
        let active = is(glow::TRANSFORM_FEEDBACK_ACTIVE) && !is(glow::TRANSFORM_FEEDBACK_PAUSED);
        if active {
            gl.pause_transform_feedback();
        }
        active
    }
}
