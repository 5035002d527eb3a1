//! The data of a paper.

use crate::steps::{Resources, Text};

/// A paper and its texts.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// The name on the command line.
    pub key: &'static str,
    /// Authors, year and title.
    pub citation: &'static str,
    /// The paper's printed texts, each with its name on the command line.
    pub texts: &'static [(&'static str, Text)],
    /// The resources that its listings take for granted.
    pub resources: &'static [&'static Resources],
}
