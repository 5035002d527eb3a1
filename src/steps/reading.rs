//! Readings of a text.

use super::amend::{Amendment, Statement};
use super::origin::Kind;

/// How far a text is read as it stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Reading {
    /// What the paper prints and says, and nothing where it is silent.
    Literal,
    /// And what fills its silence, so that only its errors are left.
    AsPrinted,
    /// And with its errors amended.
    #[default]
    Amended,
}

impl Reading {
    /// All readings.
    pub const ALL: [Self; 3] = [Self::Literal, Self::AsPrinted, Self::Amended];

    /// Its name on the command line and in data.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Literal => "literal",
            Self::AsPrinted => "as-printed",
            Self::Amended => "amended",
        }
    }

    /// The amendments that are shown in this reading: those that hold, and in the literal one, where there is none, the
    /// places that the others fill.
    pub fn shown<S: Statement>(self, amendments: &[Amendment<S>]) -> Vec<Amendment<S>> {
        let silence = |amendment: &Amendment<S>| match amendment.kind {
            Kind::Filling(rests_on) => Some(Amendment {
                kind: Kind::Silence(rests_on),
                amended: amendment.printed,
                ..*amendment
            }),
            _ => None,
        };
        match self {
            Self::Literal => amendments.iter().filter_map(silence).collect(),
            Self::AsPrinted | Self::Amended => self.of(amendments),
        }
    }

    /// The amendments that hold in this reading.
    pub fn of<S: Statement>(self, amendments: &[Amendment<S>]) -> Vec<Amendment<S>> {
        let holds = |amendment: &&Amendment<S>| match self {
            Self::Literal => false,
            Self::AsPrinted => matches!(amendment.kind, Kind::Filling(_)),
            Self::Amended => true,
        };
        amendments.iter().filter(holds).copied().collect()
    }
}
