//! Where in a scene file a value stands.

use std::ops::Range;
use std::path::Path;

use crate::error::Place;

/// A scene file's path and text: enough to turn the parser's byte offsets into lines and words.
#[derive(Clone, Copy)]
pub(super) struct Document<'a> {
    pub(super) path: &'a Path,
    pub(super) text: &'a str,
}

impl Document<'_> {
    /// The line that a span starts in, and the first line of its text.
    pub(super) fn place(&self, span: Range<usize>) -> Place {
        let place = Place::line(self.path, self.line(span.start));
        let token = self.text.get(span).unwrap_or_default();
        match token.lines().next().map(str::trim) {
            None | Some("") => place,
            Some(token) => place.token(token),
        }
    }

    /// The line of a byte, from 1.
    pub(super) fn line(&self, byte: usize) -> usize {
        let before = &self.text.as_bytes()[..byte.min(self.text.len())];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }
}
