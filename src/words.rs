//! Choices among a few words, as people write them: on the command line, in scene files, as options by name.

use crate::error::{Error, Result};

/// A type whose values have words, each with its meaning.
///
/// Such a type can be printed and parsed. A value without a word, which none of the words means, prints as `other`.
pub trait Words: Copy + PartialEq + 'static {
    /// The name of the choice for messages, without an article, such as `depth format`.
    const CHOICE: &'static str;

    /// The words, each with its meaning for people.
    const WORDS: &'static [(&'static str, &'static str)];

    /// The words' values, in the same order.
    const VALUES: &'static [Self];

    /// The value's word.
    fn word(self) -> &'static str {
        let place = Self::VALUES.iter().position(|&value| value == self);
        place.map_or("other", |place| Self::WORDS[place].0)
    }

    /// The meaning of the value's word, or nothing if it has none.
    fn meaning(self) -> &'static str {
        let place = Self::VALUES.iter().position(|&value| value == self);
        place.map_or("", |place| Self::WORDS[place].1)
    }
}

/// The value of a word.
///
/// # Errors
/// If the word is not one of the type's.
pub(crate) fn parse<T: Words>(text: &str) -> Result<T> {
    let place = T::WORDS.iter().position(|(word, _)| *word == text);
    place.map(|place| T::VALUES[place]).ok_or_else(|| {
        let known: Vec<_> = T::WORDS.iter().map(|(word, _)| word).collect();
        Error::unknown(T::CHOICE, text, &known)
    })
}

/// Gives a type its words: after its name and the choice's, a line for each value with its word and its meaning.
macro_rules! words {
    ($type:ident, $choice:literal, $($value:ident $word:literal $meaning:literal,)*) => {
        impl $crate::words::Words for $type {
            const CHOICE: &'static str = $choice;
            const WORDS: &'static [(&'static str, &'static str)] = &[$(($word, $meaning)),*];
            const VALUES: &'static [Self] = &[$(Self::$value),*];
        }

        impl std::fmt::Display for $type {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad($crate::words::Words::word(*self))
            }
        }

        impl std::str::FromStr for $type {
            type Err = $crate::error::Error;

            fn from_str(text: &str) -> $crate::error::Result<Self> {
                $crate::words::parse(text)
            }
        }
    };
}

pub(crate) use words;

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, PartialEq)]
    enum Side {
        Left,
        Right,
        Neither,
    }

    words! { Side, "side",
        Left "left" "Where the heart is",
        Right "right" "The other one",
    }

    #[test]
    fn words_lead_to_their_values_and_back() {
        for (&(word, _), &side) in Side::WORDS.iter().zip(Side::VALUES) {
            assert_eq!(word.parse::<Side>().unwrap(), side);
            assert_eq!(side.to_string(), word);
        }
        assert_eq!(Side::Neither.to_string(), "other");
    }

    #[test]
    fn an_unknown_word_is_refused_with_the_known_ones() {
        let error = "lefft".parse::<Side>().unwrap_err();
        assert_eq!(
            error.to_string(),
            "there is no side 'lefft'\n  Did you mean 'left'? Known are: left, right."
        );
        assert!(matches!(error, Error::Unknown { kind: "side", .. }));
    }
}
