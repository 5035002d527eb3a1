//! Variables, expressions and conditions of a listing.

use std::collections::HashMap;
use std::fmt;

use super::constants::Compare;
use super::names::Query;

/// An expression, which is computed while a listing runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Expr {
    /// A constant.
    Number(f64),
    /// A variable's value.
    Variable(&'static str),
    /// The number of samples that an occlusion query has counted (`glGetQueryObject`).
    Samples(Query),
    /// `a + b`
    Sum(&'static Expr, &'static Expr),
    /// `a - b`
    Difference(&'static Expr, &'static Expr),
    /// `a * b`
    Product(&'static Expr, &'static Expr),
    /// `a % b`
    Remainder(&'static Expr, &'static Expr),
}

/// A comparison of two numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Condition {
    /// Left side.
    pub left: Expr,
    /// The comparison. `NEVER` and `ALWAYS` look at neither side.
    pub compare: Compare,
    /// Right side.
    pub right: Expr,
}

/// The values of a listing's variables. Numbers are f64, so that a count may be infinite ('no limit').
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Variables(HashMap<&'static str, f64>);

impl Variables {
    /// No variables.
    pub fn new() -> Self {
        Self::default()
    }

    /// The same variables with one more, or with another value.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: f64) -> Self {
        self.set(name, value);
        self
    }

    /// Sets a variable.
    pub fn set(&mut self, name: &'static str, value: f64) {
        self.0.insert(name, value);
    }

    /// A variable's value.
    pub fn get(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }
}

impl Compare {
    /// Whether the comparison holds between `left` and `right`.
    pub fn holds<T: PartialOrd>(self, left: T, right: T) -> bool {
        match self {
            Self::Never => false,
            Self::Less => left < right,
            Self::Equal => left == right,
            Self::Lequal => left <= right,
            Self::Greater => left > right,
            Self::Notequal => left != right,
            Self::Gequal => left >= right,
            Self::Always => true,
        }
    }

    /// The comparison as C writes it.
    pub(super) fn operator(self) -> &'static str {
        match self {
            Self::Never => "never",
            Self::Less => "<",
            Self::Equal => "==",
            Self::Lequal => "<=",
            Self::Greater => ">",
            Self::Notequal => "!=",
            Self::Gequal => ">=",
            Self::Always => "always",
        }
    }
}

impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // An operand that is itself an operation stands in brackets, as in Listing 1's `(i+1) % 2`.
        struct Operand<'a>(&'a Expr);
        impl fmt::Display for Operand<'_> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self.0 {
                    Expr::Number(_) | Expr::Variable(_) | Expr::Samples(_) => {
                        write!(f, "{}", self.0)
                    }
                    // The inner operation is written without spaces.
                    operation => write!(f, "({operation:#})"),
                }
            }
        }
        let mut operation = |a, operator, b| {
            let space = if f.alternate() { "" } else { " " };
            write!(f, "{}{space}{operator}{space}{}", Operand(a), Operand(b))
        };
        match self {
            Self::Number(number) => write!(f, "{number}"),
            Self::Variable(name) => write!(f, "{name}"),
            Self::Samples(query) => write!(f, "glGetQueryObject({})", query.0),
            Self::Sum(a, b) => operation(a, "+", b),
            Self::Difference(a, b) => operation(a, "-", b),
            Self::Product(a, b) => operation(a, "*", b),
            Self::Remainder(a, b) => operation(a, "%", b),
        }
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} {} {}",
            self.left,
            self.compare.operator(),
            self.right
        )
    }
}
