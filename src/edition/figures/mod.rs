//! The figures of the papers, made anew.
//!
//! A [`Figure`] is a constant with a function that draws it. The function gets a [`Studio`], which has OpenGL, the bundled
//! scenes and the size of the edition, and returns what is [`Drawn`]: pictures, drawings, charts and tables, with a caption.
//! In the quick edition it draws the same bytes every time it is called on the same machine. Only the whole edition has
//! times, as ratios of one run.
//!
//! A paper has a folder here. Its `mod.rs` lists its figures in their order, and [`every`] lists the papers.

mod buffers;
pub mod carr;
mod chart;
mod drawn;
mod everitt;
mod figure;
mod fragments;
pub mod lindholm;
mod methods;
mod plots;
mod printed;
mod scenes;
mod studio;
mod vtk;

pub use chart::{Chart, Line};
pub use drawn::{Drawn, Picture, Table};
pub use figure::Figure;
pub use fragments::{deepest_column, fragments};
pub(super) use methods::file as method_file;
pub use studio::Studio;

/// Every figure, by paper, and last that of the methods, which takes longest.
pub fn every() -> impl Iterator<Item = &'static Figure> {
    let papers = [
        everitt::FIGURES,
        vtk::FIGURES,
        carr::FIGURES,
        lindholm::FIGURES,
        methods::FIGURES,
    ];
    papers.into_iter().flatten()
}
