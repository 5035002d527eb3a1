//! Lines, their words, and numbers among them.

use std::borrow::Cow;
use std::path::Path;

use crate::error::{Error, Place, Result};

/// A line and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Line<'a> {
    pub(super) path: &'a Path,
    /// From 1. Of a line that was continued with a backslash, the first.
    pub(super) number: usize,
    /// Without the keyword and the space around it.
    pub(super) rest: &'a str,
}

impl Line<'_> {
    /// Something is wrong with this word of the line.
    pub(super) fn wrong(&self, token: &str, what: impl Into<String>, remedy: &str) -> Error {
        Error::input(
            Place::line(self.path, self.number).token(token),
            what,
            remedy,
        )
    }

    /// The words before a comment.
    pub(super) fn words(&self) -> impl Iterator<Item = &str> {
        self.plain().split_whitespace()
    }

    /// The line without a comment at its end.
    pub(super) fn plain(&self) -> &str {
        let end = self.rest.find('#').unwrap_or(self.rest.len());
        self.rest[..end].trim_end()
    }

    /// A finite 32-bit number.
    pub(super) fn number(&self, word: &str) -> Result<f32> {
        let number: f32 = word.parse().map_err(|_| {
            let remedy = "Write it with a point: 0.5, -3 or 1e-4.";
            self.wrong(word, "not a number", remedy)
        })?;
        if number.is_finite() {
            return Ok(number);
        }
        Err(self.wrong(
            word,
            "not a finite 32-bit number",
            "Give a finite one; something went wrong where the file was written.",
        ))
    }

    /// A number from 0 to 1.
    pub(super) fn fraction(&self, word: &str, of: &str) -> Result<f32> {
        let number = self.number(word)?;
        if (0.0..=1.0).contains(&number) {
            return Ok(number);
        }
        Err(self.wrong(
            word,
            format!("{of} of {number} is not between 0 and 1"),
            "Give a number from 0 to 1; divide by 255 what goes from 0 to 255.",
        ))
    }
}

/// The lines with their numbers, those that end in a backslash joined with the next. Without line ends.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut raw = bytes.split(|&byte| byte == b'\n').zip(1..);
    std::iter::from_fn(move || {
        let (line, number) = raw.next()?;
        let mut line = Cow::Borrowed(line.trim_ascii());
        while let Some(start) = line.strip_suffix(b"\\") {
            let Some((next, _)) = raw.next() else {
                line = Cow::Owned(start.to_vec());
                break;
            };
            // In place, so that a file of nothing but continued lines takes linear time.
            let end = start.len();
            let joined = line.to_mut();
            joined[end] = b' ';
            joined.extend_from_slice(next.trim_ascii());
        }
        Some((number, line))
    })
}

/// The keyword, and all that follows it.
pub(super) fn split(line: &[u8]) -> (&[u8], &[u8]) {
    let end = line
        .iter()
        .position(u8::is_ascii_whitespace)
        .unwrap_or(line.len());
    (&line[..end], line[end..].trim_ascii())
}

/// The part of a line after its keyword, as text.
pub(super) fn text<'a>(path: &'a Path, number: usize, rest: &'a [u8]) -> Result<Line<'a>> {
    match std::str::from_utf8(rest) {
        Ok(rest) => Ok(Line { path, number, rest }),
        Err(error) => {
            let valid = String::from_utf8_lossy(&rest[error.valid_up_to()..]);
            let word = valid.split_whitespace().next().unwrap_or_default();
            Err(Error::input(
                Place::line(path, number).token(word),
                "this is not UTF-8 text",
                "Save the file as UTF-8; if it is not a text file, give the right one.",
            ))
        }
    }
}
