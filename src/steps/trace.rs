//! The flat trace: a machine that only records calls.

use std::collections::{HashMap, VecDeque};

use super::call::Call;
use super::names::Query;
use super::walk::Machine;
use crate::error::{Error, Result};

/// A machine that records calls. Queries give the answers that the caller has set beforehand.
#[derive(Debug, Default)]
pub struct Recorder {
    /// The performed calls, in order.
    pub calls: Vec<Call>,
    answers: HashMap<Query, VecDeque<u64>>,
    otherwise: Option<u64>,
}

/// The longest trace. It is more than anybody reads, and more than a thousand rounds of any listing.
const MOST_CALLS: usize = 1 << 20;

impl Recorder {
    /// A recorder without calls, and without an answer to any query.
    pub fn new() -> Self {
        Self::default()
    }

    /// The recorder with answers of `query`, in order.
    #[must_use]
    pub fn answering(mut self, query: Query, samples: impl IntoIterator<Item = u64>) -> Self {
        self.answers.insert(query, samples.into_iter().collect());
        self
    }

    /// The recorder with an answer for every query that has no answers of its own.
    #[must_use]
    pub fn answering_every_query(mut self, samples: u64) -> Self {
        self.otherwise = Some(samples);
        self
    }

    /// The trace, with one line per call and named arguments: `glDepthFunc(func = GL_LESS)`.
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
            Error::out_of_order(
                format!("the recorder has no answer for query {}", query.0),
                "lay out one for each time it is asked: Recorder::answering",
            )
        })
    }
}
