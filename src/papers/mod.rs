//! The papers: their texts as data, with the amendments to them. Nothing here runs by itself.
//!
//! Each paper's file has its [`Paper`]; [`stage`] has what their methods share.

#[macro_use]
mod claim;
#[macro_use]
mod erratum;
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

pub use claim::{Claim, Figure, Verdict};
pub use erratum::{Erratum, Fault};
pub use index::{papers, texts};
pub use paper::Paper;
