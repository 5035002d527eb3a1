//! Pages for a browser. Each is one file that needs no network.

mod axis;
pub mod history_json;
mod inspector;

pub use inspector::history_page;
