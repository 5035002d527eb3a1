//! A method with its options, published or of a caller's own, as the renderer takes it.

use std::fmt;

use super::algorithm::{Algorithm, Setup};
use super::choice::Setter;
use super::entry::Entry;
use crate::error::Result;

/// A method with its options: its facts, and its algorithm.
///
/// [`Method`](super::Method) is a technique for every published method. Each type of options is one, too.
pub trait Technique: fmt::Debug {
    /// The facts that are known before it runs.
    fn entry(&self) -> &'static Entry;

    /// The algorithm that draws its frames.
    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm>;

    /// Checks the options, as far as that is possible without a scene. This is done before each frame; a caller may do
    /// it earlier.
    ///
    /// # Errors
    /// If an option is out of its range, or two options exclude each other.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// The reason for which it cannot draw by 1/w ([`Renderer::with_inverse_w`](super::Renderer::with_inverse_w)), or
    /// `None` if it can.
    fn needs_window_depth(&self) -> Option<&'static str> {
        None
    }
}

/// A published method, which the registry lists.
pub(super) trait Published: Technique + Default + Copy + 'static {
    /// Its options.
    const CHOICES: &'static [Setter<Self>] = &[];

    /// The method under each of its names, with its default options.
    fn variants() -> Vec<Self> {
        vec![Self::default()]
    }
}
