//! The options of methods by name, with values as text, for the command line and for other callers without types.

use crate::error::{Error, Result};

/// An option of a method, as it is described to people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The option's name, in small letters and hyphens: `occlusion-ratio`.
    pub name: &'static str,
    /// The values that it takes.
    pub takes: Takes,
    /// Its effect, and its default.
    pub help: &'static str,
}

/// The values of an option.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// No value: the option is given or not.
    Nothing,
    /// A value with this name, such as `N`.
    Value(&'static str),
    /// One of these words, each with its meaning.
    Word(&'static [(&'static str, &'static str)]),
}

/// An option, and the function that sets it in a method's options.
pub(super) struct Setter<O: 'static> {
    pub(super) choice: Choice,
    pub(super) set: fn(&mut O, &str) -> Result<()>,
}

impl Choice {
    pub(super) const fn sets<O>(self, set: fn(&mut O, &str) -> Result<()>) -> Setter<O> {
        Setter { choice: self, set }
    }
}

/// Several methods have this option.
pub(super) const AS_PRINTED: Choice = Choice {
    name: "as-printed",
    takes: Takes::Nothing,
    help: "Run the paper's text without amendments. Everitt's needs a number of peels, because it cannot find out when to stop. \
           Loops that would never end are given up",
};

/// A number.
///
/// # Errors
/// If the text is not a number, or out of the type's range.
pub(super) fn number<T: std::str::FromStr>(text: &str) -> Result<T> {
    text.parse().map_err(|_| {
        Error::usage(
            format!("'{text}' is no number that fits"),
            "write a number such as 8, or 0.5 where a part is meant",
        )
    })
}

/// The value of a word.
///
/// # Errors
/// If the word is unknown.
pub(super) fn word<T: Copy>(text: &str, words: &[(&str, T)]) -> Result<T> {
    let found = words.iter().find(|(word, _)| *word == text);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let known: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        Error::usage(
            format!("'{text}' is not among its words"),
            format!("write {}", known.join(" or ")),
        )
    })
}

/// Stores a value, or returns its error.
pub(super) fn set<T>(place: &mut T, value: Result<T>) -> Result<()> {
    *place = value?;
    Ok(())
}
