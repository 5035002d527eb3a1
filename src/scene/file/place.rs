//! The place of a value in a scene file.

use std::ops::Range;
use std::path::Path;

use crate::error::Place;
use crate::memory::MemoryLimit;

/// The path and the text of a scene file, which turn the parser's byte offsets into lines and words.
#[derive(Clone, Copy)]
pub(super) struct Document<'a> {
    pub(super) path: &'a Path,
    pub(super) text: &'a str,
    /// The byte offsets at which lines begin.
    pub(super) lines: &'a Lines,
    /// The memory that the file's scene may take.
    pub(super) memory: &'a MemoryLimit,
}

/// The byte offsets at which the lines of a text begin. A file may have a notice for each of its lines, so they are
/// found once.
pub(super) struct Lines(Vec<usize>);

impl Lines {
    pub(super) fn of(text: &str) -> Self {
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        Self([0].into_iter().chain(ends.map(|(at, _)| at + 1)).collect())
    }

    /// The number of the line that has this byte, from 1.
    fn at(&self, byte: usize) -> usize {
        self.0.partition_point(|&begin| begin <= byte)
    }
}

impl Document<'_> {
    /// The number of the line in which a span starts, and the first line of the span's text.
    pub(super) fn place(&self, span: Range<usize>) -> Place {
        let place = Place::line(self.path, self.line(span.start));
        let token = self.text.get(span).unwrap_or_default();
        match token.lines().next().map(str::trim) {
            None | Some("") => place,
            Some(token) => place.token(token),
        }
    }

    /// The number of the line that has this byte, from 1.
    pub(super) fn line(&self, byte: usize) -> usize {
        self.lines.at(byte)
    }
}
