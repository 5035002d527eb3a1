//! What the renderer takes: a method with its options chosen, published or somebody's own.

use std::fmt;

use super::algorithm::{Algorithm, Setup};
use super::choice::Setter;
use super::entry::Entry;
use crate::error::Result;

/// A method, its options chosen: what there is to know about it, and what it does.
///
/// [`Method`](super::Method) is one for every published method, and each type of options is one, too.
pub trait Technique: fmt::Debug {
    /// What there is to know about it before it runs.
    fn entry(&self) -> &'static Entry;

    /// What draws its frames.
    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm>;

    /// Whether a frame can be rendered with the options that are chosen, as far as they alone tell. It is asked before each
    /// frame; asking earlier says earlier what is wrong.
    ///
    /// # Errors
    /// If one is out of its range, or two exclude each other.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// Why it cannot draw by 1/w ([`Renderer::with_inverse_w`](super::Renderer::with_inverse_w)), or `None` if it can.
    fn needs_window_depth(&self) -> Option<&'static str> {
        None
    }
}

/// A published method, which the registry lists.
pub(super) trait Published: Technique + Default + Copy + 'static {
    /// What can be chosen about it.
    const CHOICES: &'static [Setter<Self>] = &[];

    /// The method under each of its names, with the options' defaults.
    fn variants() -> Vec<Self> {
        vec![Self::default()]
    }
}
