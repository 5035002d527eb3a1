//! The options of methods by name, with values as text, for the command line and for other callers without types.

use std::fmt;

use crate::error::{Error, Result};
use crate::steps::Reading;
use crate::words::{self, Words};

/// An option of a method, as it is described to people.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Choice {
    /// The option's name, in small letters and hyphens: `occlusion-ratio`.
    pub name: &'static str,
    /// The values that it takes.
    pub takes: Takes,
    /// Its effect.
    pub help: &'static str,
}

/// The values of an option. Who offers options handles every kind, so a new kind is meant to break the match.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Takes {
    /// No value: the option is given or not.
    Nothing,
    /// A value with this name, such as `N`.
    Value(&'static str),
    /// One of these words, each with its meaning.
    Word(&'static [(&'static str, &'static str)]),
}

/// An option, and the value in a method's options that it sets.
pub(super) struct Setter<O: 'static> {
    pub(super) choice: Choice,
    value: Reach<O>,
}

enum Reach<O: 'static> {
    /// A field.
    Field(fn(&mut O) -> &mut dyn Value),
    /// Whatever the function does with the text.
    By(fn(&mut O, &str) -> Result<()>),
}

impl Choice {
    /// The option sets a field.
    pub(super) const fn of<O>(self, field: fn(&mut O) -> &mut dyn Value) -> Setter<O> {
        Setter {
            choice: self,
            value: Reach::Field(field),
        }
    }

    /// The option is set by a function.
    pub(super) const fn by<O>(self, set: fn(&mut O, &str) -> Result<()>) -> Setter<O> {
        Setter {
            choice: self,
            value: Reach::By(set),
        }
    }
}

impl<O: Copy> Setter<O> {
    /// Sets the value.
    ///
    /// # Errors
    /// If the text is no value of the option.
    pub(super) fn set(&self, options: &mut O, text: &str) -> Result<()> {
        match self.value {
            Reach::Field(field) => field(options).set(text),
            Reach::By(set) => set(options, text),
        }
    }

    /// The value as text, or `None` if it is not a field, or a flag.
    pub(super) fn text(&self, mut options: O) -> Option<String> {
        match self.value {
            Reach::Field(field) => field(&mut options).text(),
            Reach::By(_) => None,
        }
    }
}

/// A value that can be set by text.
pub(super) trait Value {
    /// Sets it.
    ///
    /// # Errors
    /// If the text is no such value.
    fn set(&mut self, text: &str) -> Result<()>;

    /// Its text, or `None` for a flag, which has none.
    fn text(&self) -> Option<String>;
}

impl<T: Words + fmt::Display> Value for T {
    fn set(&mut self, text: &str) -> Result<()> {
        *self = words::parse(text)?;
        Ok(())
    }

    fn text(&self) -> Option<String> {
        Some(self.to_string())
    }
}

/// A flag.
impl Value for bool {
    fn set(&mut self, _: &str) -> Result<()> {
        *self = true;
        Ok(())
    }

    fn text(&self) -> Option<String> {
        None
    }
}

macro_rules! numbers {
    ($($number:ty)*) => {
        $(impl Value for $number {
            fn set(&mut self, text: &str) -> Result<()> {
                *self = number(text)?;
                Ok(())
            }

            fn text(&self) -> Option<String> {
                Some(self.to_string())
            }
        })*
    };
}

numbers! { u32 f32 f64 }

/// Several methods have this option.
pub(super) const AS_PRINTED: Choice = Choice {
    name: "as-printed",
    takes: Takes::Nothing,
    help: "Run the paper's text without amendments; what fills its silence stays. Everitt's needs a number of peels, because \
           it cannot find out when to stop. Loops that would never end are given up",
};

/// The same methods have this one.
pub(super) const LITERAL: Choice = Choice {
    name: "literal",
    takes: Takes::Nothing,
    help: "Run the paper's text without what fills its silence, too",
};

/// Those of a paper's improvements that it only points at, and this edition's own.
pub(super) const IMPROVE: Choice = Choice {
    name: "improve",
    takes: Takes::Value("LIST"),
    help: "Improvements that the paper only points at, or that are this edition's own, separated by commas. Depth peeling has \
           late-query, alive and cull; coherent layer peeling A and B have tie-friendly, early-stop, cull and batches=N; the ideal \
           GPU has tight-bound",
};

/// # Errors
/// If both are chosen.
pub(super) fn one_of_both(reading: Reading, improved: bool) -> Result<()> {
    if reading != Reading::Amended && improved {
        return Err(Error::option(
            "improve",
            "the paper without amendments has none of the improvements",
            "leave them out, or let the paper be amended",
        ));
    }
    Ok(())
}

/// Reads the paper's text like this.
///
/// # Errors
/// If it is read in another way already.
pub(super) fn read(place: &mut Reading, reading: Reading) -> Result<()> {
    if ![Reading::Amended, reading].contains(place) {
        return Err(Error::usage(
            format!(
                "the text cannot be read {} and {}",
                place.name(),
                reading.name()
            ),
            "choose one of the two",
        ));
    }
    *place = reading;
    Ok(())
}

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
