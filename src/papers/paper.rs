//! The data of a paper.

use super::claim::Claim;
use super::erratum::Erratum;
use crate::steps::{Resources, Text};

/// A paper: its texts, what it claims, and what is wrong in its print.
#[derive(Clone, Copy, Debug)]
pub struct Paper {
    /// The name on the command line.
    pub key: &'static str,
    /// Authors, year and title.
    pub citation: &'static str,
    /// The paper's printed texts, each with its name on the command line.
    pub texts: &'static [(&'static str, Text)],
    /// The resources that its listings take for granted. Some say of which listings.
    pub resources: &'static [&'static Resources],
    /// What it claims, in its order.
    pub claims: &'static [Claim],
    /// What is wrong or missing in its print, in its order.
    pub errata: &'static [Erratum],
}

impl Paper {
    /// The resources that one of its listings takes for granted, by its key.
    pub fn resources_of(&self, key: &str) -> Vec<&'static Resources> {
        let all = self.resources.iter().copied();
        all.filter(|it| it.texts.is_empty() || it.texts.contains(&key))
            .collect()
    }
}
