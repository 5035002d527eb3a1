//! Numbers as tables have them: what papers print, as the rows of their claims say, and errors.

use crate::papers::Paper;

/// The paper's own figure, the `number`-th of a claim. Empty if the paper has none.
pub(super) fn printed(paper: &Paper, key: &str, number: usize) -> &'static str {
    let claim = paper.claims.iter().find(|claim| claim.key == key);
    let figure = claim.and_then(|claim| claim.figures.get(number));
    figure.and_then(|figure| figure.paper).unwrap_or_default()
}

/// An error, 0 to 1: as a power of ten if it is too small to be seen.
pub(super) fn error(value: f64) -> String {
    match value >= 0.001 {
        true => format!("{value:.3}"),
        false => format!("{value:.1e}"),
    }
}
