//! The names in listings: maps, framebuffers, programs, buffers, queries and variables. Resources have names and not
//! numbers, and a machine keeps the tables of names.

use std::fmt;

use crate::error::{Error, Result};

/// A texture by its name in the text, with a number if there is a row of textures (`layer 3`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Map {
    /// The text's name.
    pub name: &'static str,
    /// Which one of a row.
    pub index: Index,
}

/// The number of a map in a row of maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Index {
    /// There is only one.
    Only,
    /// The map with this number.
    Number(u32),
    /// The map whose number is a variable's value. [`run`](crate::steps::run) resolves it before a machine sees it.
    Variable(&'static str),
}

/// A framebuffer by name. The maps to which it draws are state, set by [`Call::AttachColor`](super::Call::AttachColor)
/// and [`Call::AttachDepth`](super::Call::AttachDepth).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Target(pub &'static str);

/// A program by the name of its fragment shader's file in `glsl/`, without the ending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shader(pub &'static str);

/// A shader storage buffer by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Storage(pub &'static str);

/// An occlusion query by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Query(pub &'static str);

/// A number of a call, or the variable whose value it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number<T> {
    /// This number.
    Known(T),
    /// The variable's value. [`run`](crate::steps::run) resolves it before a machine sees it.
    Variable(&'static str),
}

/// Something that a call names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Name {
    /// A map. The variable that gives its number in a row is named separately.
    Map(Map),
    /// A framebuffer.
    Target(Target),
    /// A program.
    Shader(Shader),
    /// A shader storage buffer.
    Storage(Storage),
    /// An occlusion query.
    Query(Query),
    /// A variable of the listing.
    Variable(&'static str),
}

impl Map {
    /// The only resource of this name.
    pub const fn named(name: &'static str) -> Self {
        Self {
            name,
            index: Index::Only,
        }
    }

    /// One of a row.
    pub const fn numbered(name: &'static str, number: u32) -> Self {
        Self {
            name,
            index: Index::Number(number),
        }
    }

    /// The one of a row that `variable` says.
    pub const fn at(name: &'static str, variable: &'static str) -> Self {
        Self {
            name,
            index: Index::Variable(variable),
        }
    }
}

impl fmt::Display for Map {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            Index::Only => write!(f, "{}", self.name),
            Index::Number(number) => write!(f, "{} {number}", self.name),
            Index::Variable(variable) => write!(f, "{} {variable}", self.name),
        }
    }
}

impl<T: Copy> Number<T> {
    /// The number.
    ///
    /// # Errors
    /// If it is still a variable, because the call was not resolved.
    pub fn known(self) -> Result<T> {
        match self {
            Self::Known(number) => Ok(number),
            Self::Variable(variable) => Err(Error::usage(
                format!("a call has the variable {variable} where a machine needs its value"),
                "run the listing with steps::run, which puts values in the place of variables",
            )),
        }
    }
}
