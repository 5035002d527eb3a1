//! The flat trace: a machine that does nothing but write down what it is told.

use std::collections::{HashMap, VecDeque};

use super::call::Call;
use super::names::Query;
use super::walk::Machine;
use crate::error::{Error, Result};

/// Records calls. Queries answer what the caller has laid out for them beforehand.
#[derive(Debug, Default)]
pub struct Recorder {
    /// What was performed, in order.
    pub calls: Vec<Call>,
    answers: HashMap<Query, VecDeque<u64>>,
    otherwise: Option<u64>,
}

/// The longest trace: more than anybody reads, and than any listing takes for a thousand rounds.
const MOST_CALLS: usize = 1 << 20;

impl Recorder {
    /// Nothing recorded, and no answer to any query.
    pub fn new() -> Self {
        Self::default()
    }

    /// With what `query` will answer, first time first.
    #[must_use]
    pub fn answering(mut self, query: Query, samples: impl IntoIterator<Item = u64>) -> Self {
        self.answers.insert(query, samples.into_iter().collect());
        self
    }

    /// With an answer to every query that has none of its own.
    #[must_use]
    pub fn answering_every_query(mut self, samples: u64) -> Self {
        self.otherwise = Some(samples);
        self
    }

    /// The trace, a line a call, arguments named: `glDepthFunc(func = GL_LESS)`.
    pub fn trace(&self) -> String {
        self.calls.iter().map(|call| format!("{call}\n")).collect()
    }
}

impl Machine for Recorder {
    fn perform(&mut self, call: &Call) -> Result<()> {
        if self.calls.len() >= MOST_CALLS {
            return Err(Error::usage(
                format!("the trace has more than {MOST_CALLS} calls"),
                "ask for fewer rounds",
            ));
        }
        self.calls.push(*call);
        Ok(())
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        let laid_out = self.answers.get_mut(&query).and_then(VecDeque::pop_front);
        laid_out.or(self.otherwise).ok_or_else(|| {
            Error::usage(
                format!("the recorder has no answer for query {}", query.0),
                "lay out one for each time it is asked: Recorder::answering",
            )
        })
    }
}
