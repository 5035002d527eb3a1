//! Errors for people: what is wrong, where, and what to do about it.

mod nearest;
mod printable;

use std::path::{Path, PathBuf};

pub use nearest::{did_you_mean, nearest, with_slashes};
pub use printable::{printable, printable_json, printable_lines};

/// The crate's result.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Everything that can go wrong, each with what its reader needs to put it right.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that cannot be used as it is.
    #[error("{place}: {}\n  {}", printable(.what), printable(.remedy))]
    Input {
        /// The file, and as far as known the line and the token.
        place: Place,
        /// What is wrong with it.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// A result that could not be written. Nothing is left at `path`.
    #[error("cannot write {}: {}\n  {}", shown(.path), printable(.what), printable(.remedy))]
    Output {
        /// Where it should have gone.
        path: PathBuf,
        /// What the system said.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// No way to OpenGL was found.
    #[error("no OpenGL 4.3 driver was found:\n{}\n  {INSTALL}", list(.tried))]
    NoContext {
        /// What was tried, in order.
        tried: Vec<Attempt>,
    },
    /// The driver cannot do what is needed.
    #[error("{what}\n  {remedy}")]
    Driver {
        /// What it lacks.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// A shader that the driver does not take, or whose includes are wrong.
    #[error("glsl/{file} does not compile:\n{log}")]
    Shader {
        /// The shader's file in `glsl/`.
        file: String,
        /// What the driver says, with the files named.
        log: String,
    },
    /// OpenGL reported an error after a step.
    #[error("OpenGL says {error} after the step {step}")]
    Step {
        /// The step, its arguments named.
        step: String,
        /// GL's name for the error.
        error: String,
    },
    /// A request that makes no sense, whatever the files say.
    #[error("{}\n  {}", printable(.what), printable(.remedy))]
    Usage {
        /// What was asked for.
        what: String,
        /// What to ask for instead.
        remedy: String,
    },
}

/// A way to OpenGL that did not lead there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attempt {
    /// What was tried.
    pub what: String,
    /// What it answered.
    pub answer: String,
}

const INSTALL: &str =
    "install or update Mesa's software renderer, then try again (`onionskin doctor` shows what is there):
    Debian, Ubuntu: apt install libegl1 libgl1-mesa-dri (and libosmesa6, where there is one)
    Fedora:         dnf install mesa-libEGL mesa-dri-drivers
    Arch:           pacman -S mesa";

/// A path as it is shown: whatever its name does to a terminal, it does not do it there.
fn shown(path: &Path) -> String {
    printable(&path.to_string_lossy()).into_owned()
}

fn list(tried: &[Attempt]) -> String {
    tried
        .iter()
        .map(|Attempt { what, answer }| format!("  {what}: {answer}"))
        .collect::<Vec<_>>()
        .join("\n")
}

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

impl Error {
    /// A file that cannot be used as it is.
    pub fn input(place: Place, what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Input {
            place,
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// A request that makes no sense.
    pub fn usage(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Usage {
            what: what.into(),
            remedy: remedy.into(),
        }
    }
}
