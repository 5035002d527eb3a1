//! How long the steps of a listing take, each by itself.
//!
//! OpenGL's calls return before their work is done, and software renderers put most of it off until a frame is wanted. So a
//! step is timed from one `glFinish` to the next. What a driver would have done at the same time is then done one after the
//! other. A timer query runs inside of each step, too. On some drivers it has only a part of the step's work; whoever reads
//! both can tell.

use std::time::Instant;

use glow::HasContext;

use super::making::named;
use crate::error::Result;

/// The time of a step, in a frame in which each step has been waited for.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct StepTime {
    /// The step: the call, after the name of its program if it draws.
    pub step: String,
    /// How often it was performed.
    pub times: u32,
    /// The milliseconds between the `glFinish` before it and the one after it, of all times together.
    pub ms: f64,
    /// The milliseconds that timer queries (`GL_TIME_ELAPSED`) give for the same.
    pub query_ms: f64,
}

/// The steps of a frame so far, if they are timed.
#[derive(Debug, Default)]
pub(super) struct StepTimes {
    timed: Option<Vec<(StepTime, glow::Query)>>,
}

/// A step that has begun.
pub(super) struct Begun {
    start: Instant,
    query: glow::Query,
}

impl StepTimes {
    /// Has steps timed from now on.
    pub(super) fn begin(&mut self) {
        self.timed.get_or_insert_default();
    }

    pub(super) fn are_timed(&self) -> bool {
        self.timed.is_some()
    }

    /// Begins a step. The context is current.
    pub(super) fn begin_step(&self, gl: &glow::Context) -> Result<Begun> {
        // SAFETY: the context is current.
        let query = named("query", unsafe { gl.create_query() })?;
        // SAFETY: as above, and the query is new.
        unsafe { gl.finish() };
        let start = Instant::now();
        // SAFETY: as above. Steps do not nest, so that no other query of this kind is going on.
        unsafe { gl.begin_query(glow::TIME_ELAPSED, query) };
        Ok(Begun { start, query })
    }

    /// Ends the step that has begun. The context is current.
    pub(super) fn end_step(&mut self, gl: &glow::Context, begun: Begun, step: String) {
        // SAFETY: the context is current, and the query has begun.
        unsafe {
            gl.end_query(glow::TIME_ELAPSED);
            gl.finish();
        }
        let time = StepTime {
            step,
            times: 1,
            ms: begun.start.elapsed().as_secs_f64() * 1e3,
            query_ms: 0.0,
        };
        self.timed.get_or_insert_default().push((time, begun.query));
    }

    /// The steps since it began, equal ones together, in the order in which they were first performed. No further ones are
    /// timed. The context is current.
    pub(super) fn take(&mut self, gl: &glow::Context) -> Vec<StepTime> {
        let mut steps: Vec<StepTime> = Vec::new();
        for (mut time, query) in self.timed.take().unwrap_or_default() {
            // SAFETY: the query has begun and ended, and is not used again.
            time.query_ms = unsafe {
                let nanoseconds = gl.get_query_parameter_u64(query, glow::QUERY_RESULT);
                gl.delete_query(query);
                nanoseconds as f64 / 1e6
            };
            match steps.iter_mut().find(|known| known.step == time.step) {
                Some(known) => {
                    known.times += 1;
                    known.ms += time.ms;
                    known.query_ms += time.query_ms;
                }
                None => steps.push(time),
            }
        }
        steps
    }
}
