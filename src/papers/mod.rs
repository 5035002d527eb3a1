//! The papers: their texts as data, with the amendments to them. Nothing here runs by itself.
//!
//! Each paper's file has its [`Paper`]; [`stage`] has what their methods share.

#[macro_use]
mod index;

macro_rules! declare {
    ($($paper:ident,)*) => {
        $(pub mod $paper;)*
    };
}

every_paper!(declare);

mod paper;
pub mod stage;

pub use index::{papers, texts};
pub use paper::Paper;
