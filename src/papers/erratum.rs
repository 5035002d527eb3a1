//! What is wrong or missing in a paper's print.

use std::fmt;

/// A place where the print does not do what it says, says it twice in two ways, or leaves open what a program needs.
#[derive(Clone, Copy, Debug)]
pub struct Erratum {
    /// A letter for the paper, an X and a number, such as `CX01`. No claim has such a key.
    pub key: &'static str,
    /// Where it is printed: a section, a figure, a line.
    pub place: &'static str,
    /// What kind of fault it is.
    pub kind: Fault,
    /// What is printed there.
    pub printed: &'static str,
    /// What happens if that is executed, or what follows from it.
    pub executed: &'static str,
    /// The smallest change that cures it.
    pub change: &'static str,
    /// The tests that show it, as paths of functions. The first word is the test binary, as in
    /// `cargo test --test papers x16_`.
    pub tests: &'static [&'static str],
}

/// The kinds of errata.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// The print, executed, does something else than its own prose says.
    Error,
    /// The print leaves open what a program has to know.
    Gap,
    /// Two places of the print contradict each other.
    Contradiction,
    /// A wrong or ambiguous name, letter or reference.
    Name,
    /// A wrong or doubtful number or unit.
    Number,
    /// The print is sound, but the program that its publisher wrote behaves otherwise.
    Program,
}

impl Fault {
    /// Every kind.
    pub const ALL: [Self; 6] = [
        Self::Error,
        Self::Gap,
        Self::Contradiction,
        Self::Name,
        Self::Number,
        Self::Program,
    ];
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Error => "error",
            Self::Gap => "gap",
            Self::Contradiction => "contradiction",
            Self::Name => "name",
            Self::Number => "number",
            Self::Program => "program",
        })
    }
}

/// A paper's errata, a row each, with tests as in `claims!`.
macro_rules! errata {
    ($($key:ident ($place:literal) $kind:ident {
        printed: $printed:literal,
        executed: $executed:literal,
        change: $change:literal,
        tests: [$($binary:ident $(:: $name:ident)+),+ $(,)?],
    })*) => {
        /// What is wrong or missing in the paper's print.
        pub const ERRATA: &[$crate::low_level::papers::Erratum] = &[$($crate::low_level::papers::Erratum {
            key: stringify!($key),
            place: $place,
            kind: $crate::low_level::papers::Fault::$kind,
            printed: $printed,
            executed: $executed,
            change: $change,
            tests: &[$(concat!(stringify!($binary) $(, "::", stringify!($name))+)),+],
        }),*];
    };
}
