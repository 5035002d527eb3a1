//! Pages for a browser. Each is one file that needs no network.

mod axis;
pub mod history_json;
mod inspector;
pub mod listing_json;
pub mod program_json;
pub mod programs;
mod pseudocode_json;
pub mod script;

pub use inspector::history_page;
