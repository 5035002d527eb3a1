//! Listings, and the statements that papers write around calls.

use super::amend::{self, Ran, Statement};
use super::call::Call;
use super::expr::{Condition, Expr};
use super::origin::Margin;

/// An amendment: of a listing, unless it says of what.
pub type Amendment<S = Step> = amend::Amendment<S>;

/// A listing as its paper prints it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Listing {
    /// A title that says what it does.
    pub title: &'static str,
    /// Where it is printed: paper, section, listing.
    pub source: &'static str,
    /// The paper's way of writing.
    pub dialect: Dialect,
    /// The steps.
    pub steps: &'static [Step],
}

/// A paper's way of writing listings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialect {
    /// Everitt's: C's loops around English.
    Phrases,
    /// OpenGL calls, one per line.
    Calls,
    /// Everitt's Listing 2: C source, constants with their `GL_`.
    Source,
}

/// One statement of a listing.
///
/// A further kind of statement is a change for every program that prints or walks listings, and each should learn of it from
/// its compiler. So this is not `non_exhaustive`, as [`Call`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A call.
    Call(Call),
    /// `depth unit 0:` and the calls for this unit.
    DepthUnit {
        /// The unit's number.
        unit: u8,
        /// The calls.
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
        /// The condition.
        condition: Condition,
        /// The steps if it holds.
        then: &'static [Step],
        /// The steps if it does not.
        otherwise: &'static [Step],
    },
    /// `for (i=0; i<n; i++)`: up from `from`, while below `to`.
    For {
        /// The variable.
        variable: &'static str,
        /// Its first value.
        from: Expr,
        /// The first value that it does not take. It may be infinite.
        to: Expr,
        /// The repeated steps.
        body: &'static [Step],
    },
    /// `for (i=n-1; i>=0; i--)`: the same numbers from the last to the first.
    ForDown {
        /// The variable.
        variable: &'static str,
        /// One more than its first value.
        from: Expr,
        /// The repeated steps.
        body: &'static [Step],
    },
    /// Leaves the innermost loop if the condition holds, and says why.
    Stop {
        /// When.
        when: Condition,
        /// Why.
        why: Reason,
    },
    /// Runs another listing, as amended here.
    Run {
        /// The listing.
        listing: &'static Listing,
        /// The amendments to it.
        amendments: &'static [Amendment],
    },
    /// Says where the steps that follow come from, or how the paper spells them. It is no step itself.
    Margin(Margin),
}

impl Statement for Step {
    fn margin(&self) -> Option<Margin> {
        match *self {
            Self::Margin(margin) => Some(margin),
            _ => None,
        }
    }

    fn bodies(&self) -> [&'static [Self]; 2] {
        match *self {
            Self::DepthUnit { body, .. } | Self::For { body, .. } | Self::ForDown { body, .. } => {
                [body, &[]]
            }
            Self::If {
                then, otherwise, ..
            } => [then, otherwise],
            Self::Call(_)
            | Self::Let { .. }
            | Self::Stop { .. }
            | Self::Run { .. }
            | Self::Margin(_) => [&[], &[]],
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

/// The reason for which a loop was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Reason {
    /// The last peel found nothing: everything has been peeled.
    EmptyLayer,
    /// The last peel changed fewer pixels than the occlusion ratio allows to ignore.
    OcclusionRatio,
    /// The maximum number of peels was reached.
    PeelLimit,
    /// It had more iterations than a right algorithm can need, so it would never have ended.
    NoEnd,
    /// The Local Array was full, and the fragments that did not fit were dropped.
    ArrayFull,
    /// A fixed buffer was full, and the fragments that did not fit were dropped.
    BufferFull,
    /// Rays ended because too little light came through.
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
            Self::BufferFull => "fixed buffer full",
            Self::EarlyTermination => "early ray termination",
        })
    }
}
