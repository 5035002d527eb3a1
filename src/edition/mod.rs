//! Pages for a browser, which need no network: the page of a pixel's history, and the whole edition as a site.

mod axis;
pub mod figures;
pub mod history_json;
mod inspector;
pub mod listing_json;
pub mod program_json;
pub mod programs;
mod pseudocode_json;
pub mod script;
pub mod site;

pub use inspector::history_page;
