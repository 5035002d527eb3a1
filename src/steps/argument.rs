//! The arguments of calls: how they are printed, and what they name.

use super::names::{Index, Map, Name, Number, Query, Shader, Storage, Target};
use crate::error::Result;

/// The values of a listing's variables, at the time of a call.
pub(super) type Values<'a> = &'a dyn Fn(&'static str) -> Result<f64>;

/// A type that the table of calls may use for an argument.
pub(super) trait Argument: Clone {
    /// The argument as a trace prints it.
    fn text(&self) -> String;

    /// Adds what the argument names to `found`. Plain values name nothing.
    fn names(&self, _found: &mut Vec<Name>) {}

    /// The argument with its variables replaced by their values. Plain values have none.
    ///
    /// # Errors
    /// The errors of `values`.
    fn resolved(&self, _values: Values<'_>) -> Result<Self> {
        Ok(self.clone())
    }
}

impl Argument for bool {
    fn text(&self) -> String {
        if *self { "GL_TRUE" } else { "GL_FALSE" }.into()
    }
}

impl Argument for i32 {
    fn text(&self) -> String {
        self.to_string()
    }
}

impl Argument for u8 {
    fn text(&self) -> String {
        self.to_string()
    }
}

impl Argument for u32 {
    fn text(&self) -> String {
        self.to_string()
    }
}

impl Argument for f32 {
    fn text(&self) -> String {
        format!("{self:?}")
    }
}

impl Argument for f64 {
    fn text(&self) -> String {
        format!("{self:?}")
    }
}

impl Argument for &'static str {
    fn text(&self) -> String {
        (*self).into()
    }
}

impl Argument for String {
    fn text(&self) -> String {
        self.clone()
    }
}

impl Argument for [f32; 4] {
    fn text(&self) -> String {
        let [r, g, b, a] = self;
        format!("{{{r:?}, {g:?}, {b:?}, {a:?}}}")
    }
}

impl Argument for [[f32; 4]; 4] {
    fn text(&self) -> String {
        format!("{self:?}")
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
