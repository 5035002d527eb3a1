//! The page of a pixel's history.

use minijinja::value::{Serde, Value as PageValue};
use minijinja::{AutoEscape, Environment, UndefinedBehavior, context};
use serde_json::{Value, json};

use super::axis;
use super::history_json::object;
use crate::error::{Error, Result};
use crate::inspect::History;
use crate::steps::Origin;

const PAGE: &str = include_str!("web/inspector.html");
const STYLE: &str = include_str!("web/inspector.css");
const SCRIPT: &str = include_str!("web/inspector.js");

/// The page of a history: HTML that steps through the passes with the keyboard. It contains the JSON object of
/// [`history_json`](super::history_json).
///
/// # Errors
/// None but a fault of the page itself.
pub fn history_page(history: &History) -> Result<String> {
    let mut pages = Environment::new();
    pages.set_undefined_behavior(UndefinedBehavior::Strict);
    pages.set_auto_escape_callback(|_| AutoEscape::Html);
    let fault = |error: minijinja::Error| {
        Error::usage(
            format!("the page cannot be made: {error:#}"),
            "this is a fault of onionskin; the history as JSON has the same data",
        )
    };
    pages.add_template("inspector.html", PAGE).map_err(fault)?;
    let page = pages.get_template("inspector.html").map_err(fault)?;
    let whole = context! {
        history => Serde(object(history)),
        shown => Serde(shown(history)),
        axis => PageValue::from_safe_string(axis::svg(&history.fragments)),
        style => PageValue::from_safe_string(STYLE.into()),
        script => PageValue::from_safe_string(SCRIPT.into()),
        legend => Origin::LEGEND.map(|(letter, meaning)| (letter.to_string(), meaning)).to_vec(),
        version => env!("CARGO_PKG_VERSION"),
    };
    page.render(whole).map_err(fault)
}

/// What the page says besides the data.
fn shown(history: &History) -> Value {
    let layers = history.composited.as_ref().map_or(0, |it| it.layers.len());
    let first = history.differences().next().map(|(pass, _)| pass + 1);
    let followed = history.passes.iter().filter(|pass| pass.emulated.is_some());
    json!({
        "error": format!("{:.1e}", history.error),
        "layers": history.exact.layers.len().max(layers),
        "first_difference": first,
        "followed": followed.count(),
    })
}
