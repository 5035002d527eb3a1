//! The papers: their texts as data, with the amendments to them. Nothing here runs by itself.
//!
//! Each paper's file has its [`Paper`]; [`stage`] has what their methods share.

pub mod bavoil_2008;
pub mod carr_2008;
pub mod everitt_2001;
mod index;
pub mod lindholm_2015;
mod paper;
pub mod stage;
pub mod vasilakis_2013;
pub mod vtk;

pub use index::{papers, texts};
pub use paper::Paper;
