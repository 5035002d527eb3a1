//! What listings name: maps, framebuffers, programs, buffers, queries and variables. Resources are named rather than
//! numbered, and a machine keeps the tables of names.

use std::fmt;

use super::argument::{Argument, Values};
use crate::error::{Error, Result};

/// A texture by the name that the text has for it, with a number where there is a row of them (`layer 3`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Map {
    /// The text's name.
    pub name: &'static str,
    /// Which of them.
    pub index: Index,
}

/// Which of a row of maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Index {
    /// There is only one.
    Only,
    /// This one.
    Number(u32),
    /// The one a variable says; [`run`](crate::steps::run) resolves it before a machine sees it.
    Variable(&'static str),
}

/// A framebuffer by name. Which maps it draws to is state, set by [`Call::AttachColor`](super::Call::AttachColor) and
/// [`Call::AttachDepth`](super::Call::AttachDepth).
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

/// A number that a call is given, or the variable that says it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Number<T> {
    /// This number.
    Known(T),
    /// The variable's value; [`run`](crate::steps::run) puts it in place before a machine sees it.
    Variable(&'static str),
}

/// Something that a call names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Name {
    /// A map; the variable that says which of a row is named besides.
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
    /// The only one of that name.
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

impl Argument for Map {
    fn text(&self) -> String {
        self.to_string()
    }

    fn names(&self, found: &mut Vec<Name>) {
        found.push(Name::Map(*self));
        if let Index::Variable(variable) = self.index {
            found.push(Name::Variable(variable));
        }
    }

    fn resolved(&self, values: Values<'_>) -> Result<Self> {
        match self.index {
            Index::Only | Index::Number(_) => Ok(*self),
            Index::Variable(variable) => Ok(Self::numbered(self.name, values(variable)? as u32)),
        }
    }
}

impl<T: Copy> Number<T> {
    /// The number.
    ///
    /// # Errors
    /// It is still a variable: the call was not resolved.
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

/// Numbers that OpenGL takes, made of a variable's value.
macro_rules! numbers {
    ($($kind:ident)*) => {$(
        impl Argument for Number<$kind> {
            fn text(&self) -> String {
                match self {
                    Self::Known(number) => number.to_string(),
                    Self::Variable(variable) => (*variable).into(),
                }
            }

            fn names(&self, found: &mut Vec<Name>) {
                if let Self::Variable(variable) = self {
                    found.push(Name::Variable(variable));
                }
            }

            fn resolved(&self, values: Values<'_>) -> Result<Self> {
                match *self {
                    Self::Known(_) => Ok(*self),
                    Self::Variable(variable) => Ok(Self::Known(values(variable)? as $kind)),
                }
            }
        }
    )*};
}
numbers! { i32 u32 f32 }

/// A resource prints as its name.
macro_rules! resources {
    ($($kind:ident)*) => {$(
        impl Argument for $kind {
            fn text(&self) -> String {
                self.0.into()
            }

            fn names(&self, found: &mut Vec<Name>) {
                found.push(Name::$kind(*self));
            }
        }
    )*};
}
resources! { Target Shader Storage Query }
