//! Where each line of a text comes from, and the readings that follow from it.
//!
//! A text says it in [`Margin`]s between its statements: what follows a mark in the same block has the mark's origin, and so
//! has everything inside of it, unless it says otherwise. An [`Amendment`] gives its statements the origin of its
//! [`Kind`]; statements that it only repeats keep theirs.

use super::amend::{Amendment, Statement};

/// The origin of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// The paper prints it.
    Printed,
    /// The paper says it in a sentence.
    Prose {
        /// The sentence, or as much of it as says it.
        quote: &'static str,
    },
    /// The paper leaves it open.
    Filling {
        /// The filling's key.
        key: &'static str,
        /// The reason.
        why: &'static str,
        /// The sentence or the figure that the filling rests on.
        rests_on: &'static str,
    },
    /// It replaces what is wrong in the paper.
    Amendment {
        /// The erratum's key.
        key: &'static str,
        /// The reason.
        why: &'static str,
        /// The test that fails without it.
        test: &'static str,
    },
    /// It is this edition's own.
    Edition {
        /// The reason.
        why: &'static str,
    },
}

impl Origin {
    /// The letters of all origins, each with its meaning.
    pub const LEGEND: [(char, &'static str); 5] = [
        ('p', "printed in the paper"),
        ('s', "said in the paper's prose"),
        ('f', "fills what the paper leaves open"),
        ('a', "amends what is wrong in the paper"),
        ('e', "this edition's own"),
    ];

    /// The letter that stands for it in the margin.
    pub const fn letter(self) -> char {
        match self {
            Self::Printed => 'p',
            Self::Prose { .. } => 's',
            Self::Filling { .. } => 'f',
            Self::Amendment { .. } => 'a',
            Self::Edition { .. } => 'e',
        }
    }

    /// Its name, as data has it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Printed => "printed",
            Self::Prose { .. } => "prose",
            Self::Filling { .. } => "filling",
            Self::Amendment { .. } => "amendment",
            Self::Edition { .. } => "edition",
        }
    }
}

/// A mark in the margin between statements. It does nothing when it is run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Margin {
    /// The origin of what follows in the same block.
    From(Origin),
    /// The paper's spelling of the next statement, to the letter.
    Spelt {
        /// The line of the paper.
        text: &'static str,
        /// The right word, where the paper has one that does not exist.
        meaning: Option<&'static str>,
    },
    /// A line of the paper that does nothing: a comment, a declaration, an empty line.
    Line(&'static str),
}

/// Why an amendment stands where it stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// It corrects what is wrong in the paper.
    #[default]
    Correction,
    /// It fills what the paper leaves open. This is the sentence or the figure that it rests on.
    Filling(&'static str),
    /// A sentence says it, of this paper or of another that builds on it.
    Prose(&'static str),
    /// This edition has it for a reason of its own. What it replaces is not wrong.
    Edition,
}

impl<S> Amendment<S> {
    /// The origin of its statements.
    pub const fn origin(&self) -> Origin {
        let (key, why) = (self.key, self.why);
        match self.kind {
            Kind::Correction => Origin::Amendment {
                key,
                why,
                test: self.test,
            },
            Kind::Filling(rests_on) => Origin::Filling { key, why, rests_on },
            Kind::Prose(quote) => Origin::Prose { quote },
            Kind::Edition => Origin::Edition { why },
        }
    }
}

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
