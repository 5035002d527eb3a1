//! What can be chosen about a method, by name and in words: for the command line, and for whoever else has no types.

use crate::error::{Error, Result};

/// One thing that can be chosen about a method, as it is told to people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// Its name, in small letters and hyphens: `occlusion-ratio`.
    pub name: &'static str,
    /// What it takes.
    pub takes: Takes,
    /// What it does, and what is the default.
    pub help: &'static str,
}

/// What a choice takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// Nothing: it is chosen or not.
    Nothing,
    /// A value, which is called so: `N`.
    Value(&'static str),
    /// One of these words, each with its meaning.
    Word(&'static [(&'static str, &'static str)]),
}

/// A choice, and how it is put into a method's options.
pub(super) struct Setter<O: 'static> {
    pub(super) choice: Choice,
    pub(super) set: fn(&mut O, &str) -> Result<()>,
}

impl Choice {
    pub(super) const fn sets<O>(self, set: fn(&mut O, &str) -> Result<()>) -> Setter<O> {
        Setter { choice: self, set }
    }
}

/// Several methods have it.
pub(super) const AS_PRINTED: Choice = Choice {
    name: "as-printed",
    takes: Takes::Nothing,
    help: "Run the paper's text with nothing amended. Everitt's needs --peels, because it has no way to find out when to \
           stop; loops that would never end are given up",
};

/// A number.
///
/// # Errors
/// If the text is none, or out of the type's range.
pub(super) fn number<T: std::str::FromStr>(text: &str) -> Result<T> {
    text.parse().map_err(|_| {
        Error::usage(
            format!("'{text}' is no number that fits"),
            "write a number such as 8, or 0.5 where a part is meant",
        )
    })
}

/// What a word stands for.
///
/// # Errors
/// If it stands for nothing.
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

/// Puts a value into its place, if it is one.
pub(super) fn set<T>(place: &mut T, value: Result<T>) -> Result<()> {
    *place = value?;
    Ok(())
}
