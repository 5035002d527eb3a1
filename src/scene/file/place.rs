//! Where in a scene file a value stands.

use std::ops::Range;
use std::path::Path;

use crate::error::Place;
use crate::memory::MemoryLimit;

/// A scene file's path and text: enough to turn the parser's byte offsets into lines and words.
#[derive(Clone, Copy)]
pub(super) struct Document<'a> {
    pub(super) path: &'a Path,
    pub(super) text: &'a str,
    /// Where its lines begin.
    pub(super) lines: &'a Lines,
    /// How much memory may be taken for what the file asks for.
    pub(super) memory: &'a MemoryLimit,
}

/// Where the lines of a text begin, in bytes. A file may have a notice for each of its lines, so the text is gone
/// through once.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self([0].into_iter().chain(ends.map(|(at, _)| at + 1)).collect())
    }

    /// The line of a byte, from 1.
    fn at(&self, byte: usize) -> usize {
        self.0.partition_point(|&begin| begin <= byte)
    }
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
        self.lines.at(byte)
    }
}
