//! Where each line of a text comes from.
//!
//! A text says it in [`Margin`]s between its statements: what follows a mark in the same block has the mark's origin, and so
//! has everything inside of it, unless it says otherwise. An [`Amendment`](super::Amendment) gives its statements the
//! origin of its [`Kind`]. Statements that it only repeats keep theirs.

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
    /// Nothing: here the paper leaves something open, and the reading leaves it open, too.
    Silence {
        /// The key of the filling that other readings have here.
        key: &'static str,
        /// The filling's reason.
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
    pub const LEGEND: [(char, &'static str); 6] = [
        ('p', "printed in the paper"),
        (
            's',
            "said in prose, the paper's or that of one that builds on it",
        ),
        ('?', "the paper does not say, and nothing is done"),
        ('f', "fills what the paper leaves open"),
        ('a', "amends what is wrong in the paper"),
        ('e', "this edition's own"),
    ];

    /// The letter that stands for it in the margin.
    pub const fn letter(self) -> char {
        match self {
            Self::Printed => 'p',
            Self::Prose { .. } => 's',
            Self::Silence { .. } => '?',
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
            Self::Silence { .. } => "silence",
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
    /// It changes nothing, and stands where a filling would. This is what the filling rests on.
    Silence(&'static str),
    /// A sentence says it, of this paper or of another that builds on it.
    Prose(&'static str),
    /// This edition has it for a reason of its own. What it replaces is not wrong.
    Edition,
}
