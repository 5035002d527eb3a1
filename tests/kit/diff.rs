//! Holding a printed listing against a transcript of the paper.

use similar::{ChangeTag, TextDiff};

/// The lines in which `listing` departs from `transcript`, `-` what only the transcript has, `+` what only the listing
/// has; empty if they agree. White space at the ends of lines, and the width of what stands between words, do not count:
/// they are the typesetter's.
pub fn diff(transcript: &str, listing: &str) -> String {
    let (transcript, listing) = (normal(transcript), normal(listing));
    TextDiff::from_lines(&transcript, &listing)
        .iter_all_changes()
        .filter(|change| change.tag() != ChangeTag::Equal)
        .map(|change| format!("{}{change}", change.tag()))
        .collect()
}

fn normal(text: &str) -> String {
    text.lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ") + "\n")
        .filter(|line| line != "\n")
        .collect()
}
