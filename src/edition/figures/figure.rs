//! What can be made.

use super::drawn::Drawn;
use super::studio::Studio;
use crate::error::Result;

/// A figure that can be made.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Its name in templates and in names of files, such as `everitt-3`.
    pub key: &'static str,
    /// Where the paper has it, such as `Everitt 2001, figure 3`.
    pub source: &'static str,
    /// What it shows.
    pub title: &'static str,
    /// Draws it.
    pub make: fn(&Studio) -> Result<Drawn>,
}
