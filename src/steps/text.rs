//! A printed text in any of the papers' ways of writing, with its amendments.

use super::amend::Statement;
use super::lines::{self, TextLine};
use super::listing::{Amendment, Listing};
use super::print;
use super::pseudo::{self, Pseudocode, list};
use super::reading::Reading;

/// A text that a paper prints under one title, with the amendments that correct it.
#[derive(Clone, Copy, Debug)]
pub enum Text {
    /// A listing of calls.
    Listing(Listing, &'static [Amendment]),
    /// Pseudocode on fragments as they are rasterised.
    Pseudocode(Pseudocode, &'static [Amendment<pseudo::Line>]),
    /// Pseudocode on lists of fragments.
    Lists(
        Pseudocode<list::ListLine>,
        &'static [Amendment<list::ListLine>],
    ),
}

impl Text {
    /// A title that says what it does.
    pub const fn title(&self) -> &'static str {
        match self {
            Self::Listing(listing, _) => listing.title,
            Self::Pseudocode(algorithm, _) => algorithm.title,
            Self::Lists(algorithm, _) => algorithm.title,
        }
    }

    /// Where it is printed: paper, section, listing.
    pub const fn source(&self) -> &'static str {
        match self {
            Self::Listing(listing, _) => listing.source,
            Self::Pseudocode(algorithm, _) => algorithm.source,
            Self::Lists(algorithm, _) => algorithm.source,
        }
    }

    /// The text the way its paper writes it, read like this.
    pub fn print(&self, reading: Reading) -> String {
        lines::text(&self.lines(reading))
    }

    /// The lines of the text, read like this.
    pub fn lines(&self, reading: Reading) -> Vec<TextLine> {
        match self {
            Self::Listing(listing, amendments) => print::lines(listing, &reading.shown(amendments)),
            Self::Pseudocode(algorithm, amendments) => {
                pseudo::lines(algorithm, &reading.shown(amendments))
            }
            Self::Lists(algorithm, amendments) => {
                list::lines(algorithm, &reading.shown(amendments))
            }
        }
    }

    /// For each of its amendments, and for each amendment with which it runs other texts, the test that fails without it.
    pub fn tests(&self) -> Vec<&'static str> {
        match self {
            Self::Listing(listing, amendments) => tests(listing.steps, amendments),
            Self::Pseudocode(algorithm, amendments) => tests(algorithm.lines, amendments),
            Self::Lists(algorithm, amendments) => tests(algorithm.lines, amendments),
        }
    }
}

fn tests<S: Statement>(statements: &[S], amendments: &[Amendment<S>]) -> Vec<&'static str> {
    let mut found = Vec::new();
    for amendment in amendments {
        found.push(amendment.test);
        found.extend(tests(amendment.amended, &[]));
    }
    for statement in statements {
        if let Some((statements, amendments)) = statement.runs() {
            found.extend(tests(statements, amendments));
        }
        for body in statement.bodies() {
            found.extend(tests(body, &[]));
        }
    }
    found
}
