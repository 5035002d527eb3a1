//! Where in a file something is wrong.

use std::path::{Path, PathBuf};

use super::printable::printable;

/// Where in a file something is wrong. Prints as `file:line: 'token'`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// The file.
    pub file: PathBuf,
    /// The line, from 1.
    pub line: Option<usize>,
    /// The offending word of that line.
    pub token: Option<String>,
}

impl Place {
    /// The file as a whole.
    pub fn file(file: impl AsRef<Path>) -> Self {
        Self {
            file: file.as_ref().to_owned(),
            line: None,
            token: None,
        }
    }

    /// A line of the file, from 1.
    pub fn line(file: impl AsRef<Path>, line: usize) -> Self {
        Self {
            line: Some(line),
            ..Self::file(file)
        }
    }

    /// The word of the line that is wrong. Cut at 40 characters: a binary file's 'word' may be a megabyte.
    #[must_use]
    pub fn token(mut self, token: &str) -> Self {
        let mut shown: String = token.chars().take(40).collect();
        if shown.len() < token.len() {
            shown.push('…');
        }
        self.token = Some(shown);
        self
    }
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}", shown(&self.file))?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        if let Some(token) = &self.token {
            write!(f, ": '{}'", printable(token))?;
        }
        Ok(())
    }
}

/// A path as it is shown: whatever its name does to a terminal, it does not do it there.
pub(super) fn shown(path: &Path) -> String {
    printable(&path.to_string_lossy()).into_owned()
}
