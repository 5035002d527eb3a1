//! What the peeling loops of Carr et al. (2008) share: an end, and their results.

use super::algorithm::{Composited, Drawn};
use super::iteration_bound::iteration_bound;
use crate::error::Result;
use crate::gl::GlMachine;
use crate::steps::{Amendment, Outcome, Reading, Reason, Variables};

/// How a loop's text is read, and the number of iterations after which it is given up.
pub(super) struct LoopGuard {
    reading: Reading,
    guarded: bool,
    iteration_limit: f64,
}

impl LoopGuard {
    pub(super) fn new(reading: Reading) -> Self {
        Self {
            reading,
            guarded: reading != Reading::Amended,
            iteration_limit: f64::INFINITY,
        }
    }

    /// The guard of a loop with a user's own changes.
    pub(super) fn guarded(self) -> Self {
        Self {
            guarded: true,
            ..self
        }
    }

    /// Amended loops end by themselves. Some printed ones do not.
    pub(super) fn prepare(&mut self, machine: &mut GlMachine<'_>) -> Result<()> {
        if self.guarded {
            self.iteration_limit = iteration_bound(machine)?;
        }
        Ok(())
    }

    pub(super) fn variables(&self) -> Variables {
        Variables::new().with("iteration_limit", self.iteration_limit)
    }

    pub(super) fn amendments(&self, amendments: &[Amendment]) -> Vec<Amendment> {
        self.reading.of(amendments)
    }
}

/// The result of a loop.
pub(super) fn peeled(outcome: &Outcome) -> Drawn {
    let number = |name| outcome.variables.get(name).unwrap_or(0.0);
    Drawn {
        iterations: number("iterations") as u32,
        composited: Composited::Some(number("composited") as u64),
        stopped: Some(outcome.stopped.unwrap_or(Reason::NoEnd)),
        ..Drawn::default()
    }
}
