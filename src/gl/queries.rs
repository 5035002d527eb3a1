//! Occlusion queries by name.

use std::collections::HashMap;

use glow::HasContext;

use super::making::named;
use crate::error::{Error, Result};
use crate::steps::Query;

#[derive(Debug, Default)]
pub(super) struct Queries {
    made: HashMap<Query, glow::Query>,
    /// One has begun and not ended.
    counting: bool,
}

impl Queries {
    /// Begins a query, which is made when it is first named. The context is current.
    pub(super) fn begin(&mut self, gl: &glow::Context, query: Query) -> Result<()> {
        let raw = match self.made.get(&query) {
            Some(&raw) => raw,
            None => {
                // SAFETY: the context is current.
                let raw = named("query", unsafe { gl.create_query() })?;
                self.made.insert(query, raw);
                raw
            }
        };
        // SAFETY: the query is the machine's own.
        unsafe { gl.begin_query(glow::SAMPLES_PASSED, raw) };
        self.counting = true;
        Ok(())
    }

    /// Ends the query that has begun. The context is current.
    pub(super) fn end(&mut self, gl: &glow::Context) {
        // SAFETY: the context is current.
        unsafe { gl.end_query(glow::SAMPLES_PASSED) };
        self.counting = false;
    }

    /// Ends a query that a listing has begun and, because a step of it failed, not ended.
    pub(super) fn end_counting(&mut self, gl: &glow::Context) {
        if self.counting {
            self.end(gl);
        }
    }

    pub(super) fn samples(&self, gl: &glow::Context, query: Query) -> Result<u64> {
        let raw = self.made.get(&query).copied().ok_or_else(|| {
            let what = format!("the listing asks the query '{}' before it is made", query.0);
            Error::out_of_order(what, "glBeginQuery and glEndQuery come first")
        })?;
        // SAFETY: the query has begun and ended.
        Ok(unsafe { gl.get_query_parameter_u64(raw, glow::QUERY_RESULT) })
    }

    pub(super) fn delete(&mut self, gl: &glow::Context) {
        for (_, query) in self.made.drain() {
            // SAFETY: the query is the machine's own and leaves its table here.
            unsafe { gl.delete_query(query) };
        }
    }
}
