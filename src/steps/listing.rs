//! The branches of a listing: what the papers write around the calls.

use super::amend::{self, Ran, Statement};
use super::call::Call;
use super::expr::{Condition, Expr};

/// An amendment: of a listing, unless it says of what.
pub type Amendment<S = Step> = amend::Amendment<S>;

/// A listing as its paper prints it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listing {
    /// What it does, in a line.
    pub title: &'static str,
    /// Where it is printed: paper, section, listing.
    pub source: &'static str,
    /// How its paper writes.
    pub dialect: Dialect,
    /// What it says.
    pub steps: &'static [Step],
}

/// How a paper writes its listings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// Everitt's: C's loops around English.
    Phrases,
    /// OpenGL calls, one a line.
    Calls,
    /// Everitt's Listing 2: C source, constants with their `GL_`.
    Source,
}

/// One statement of a listing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A call.
    Call(Call),
    /// `depth unit 0:` and the calls that go to it.
    DepthUnit {
        /// Which.
        unit: u8,
        /// What it is told.
        body: &'static [Step],
    },
    /// `A = i % 2`
    Let {
        /// The variable.
        variable: &'static str,
        /// Its new value.
        value: Expr,
    },
    /// `if (...) ... else ...`
    If {
        /// Which way.
        condition: Condition,
        /// If it holds.
        then: &'static [Step],
        /// If it does not.
        otherwise: &'static [Step],
    },
    /// `for (i=0; i<n; i++)`: up from `from`, while below `to`.
    For {
        /// The variable.
        variable: &'static str,
        /// Its first value.
        from: Expr,
        /// The first value that it does not take; may be infinite.
        to: Expr,
        /// What is repeated.
        body: &'static [Step],
    },
    /// `for (i=n-1; i>=0; i--)`: the same numbers from the last to the first.
    ForDown {
        /// The variable.
        variable: &'static str,
        /// One more than its first value.
        from: Expr,
        /// What is repeated.
        body: &'static [Step],
    },
    /// Leaves the innermost loop if the condition holds, and says why.
    Stop {
        /// When.
        when: Condition,
        /// Why.
        why: Reason,
    },
    /// Another listing, as amended here.
    Run {
        /// Which.
        listing: &'static Listing,
        /// With what replaced in it.
        amendments: &'static [Amendment],
    },
}

impl Statement for Step {
    fn bodies(&self) -> [&'static [Self]; 2] {
        match *self {
            Self::DepthUnit { body, .. } | Self::For { body, .. } | Self::ForDown { body, .. } => {
                [body, &[]]
            }
            Self::If {
                then, otherwise, ..
            } => [then, otherwise],
            Self::Call(_) | Self::Let { .. } | Self::Stop { .. } | Self::Run { .. } => [&[], &[]],
        }
    }

    fn runs(&self) -> Option<Ran<Self>> {
        match *self {
            Self::Run {
                listing,
                amendments,
            } => Some((listing.steps, amendments)),
            _ => None,
        }
    }
}

/// Why a loop was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Reason {
    /// The last peel found nothing: everything has been peeled.
    EmptyLayer,
    /// The last peel changed fewer pixels than the occlusion ratio allows to ignore.
    OcclusionRatio,
    /// The maximum number of peels was reached.
    PeelLimit,
    /// It went on for more iterations than a right algorithm can need: it would never have ended.
    NoEnd,
    /// The local array was full, and what did not fit was dropped.
    ArrayFull,
    /// Rays ended where too little light came through.
    EarlyTermination,
}

impl std::fmt::Display for Reason {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::EmptyLayer => "empty layer",
            Self::OcclusionRatio => "occlusion ratio",
            Self::PeelLimit => "peel limit",
            Self::NoEnd => "no end: more iterations than surfaces at any pixel",
            Self::ArrayFull => "local array full",
            Self::EarlyTermination => "early ray termination",
        })
    }
}
