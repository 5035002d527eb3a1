//! Amendments: what stands beside a listing where it is wrong, or where a later text builds on it.

use super::listing::Step;

/// The smallest change that makes a printed listing right, or that adds what another text adds. Of a listing by default,
/// of an algorithm in pseudocode if its statements are [`Line`](super::pseudo::Line)s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amendment<S: 'static = Step> {
    /// A short name: the claim's or the erratum's key.
    pub key: &'static str,
    /// Where the change is made, in the paper's words.
    pub place: &'static str,
    /// The steps as printed, consecutive; replaced wherever the listing has them.
    pub printed: &'static [S],
    /// What stands there instead.
    pub amended: &'static [S],
    /// Why.
    pub why: &'static str,
    /// The test that fails without it.
    pub test: &'static str,
}

impl<S: PartialEq> Amendment<S> {
    /// The amendment that applies at the head of `statements`, if there is one.
    pub fn at<'a>(amendments: &'a [Self], statements: &[S]) -> Option<&'a Self> {
        let printed_here = |amendment: &&Self| {
            !amendment.printed.is_empty() && statements.starts_with(amendment.printed)
        };
        amendments.iter().find(printed_here)
    }
}

/// A statement that may have others inside.
pub trait Statement: PartialEq + Sized + 'static {
    /// What is inside: nothing, a body, or two branches.
    fn bodies(&self) -> [&'static [Self]; 2];
}

impl<S: Statement> Amendment<S> {
    /// How often `statements` have what this amendment replaces, nested ones included. An amendment that is found nowhere
    /// changes nothing, so tests ask.
    pub fn occurrences(&self, statements: &[S]) -> usize {
        let here = statements
            .windows(self.printed.len().max(1))
            .filter(|w| *w == self.printed)
            .count();
        let bodies = statements.iter().flat_map(Statement::bodies);
        here + bodies.map(|body| self.occurrences(body)).sum::<usize>()
    }
}

/// The amendments in force: those of the listing that runs, then those of the listing that runs it, and so on.
pub(super) struct Scope<'a> {
    pub(super) amendments: &'a [Amendment],
    pub(super) outer: Option<&'a Scope<'a>>,
}

impl<'a> Scope<'a> {
    pub(super) const NOTHING: Self = Self {
        amendments: &[],
        outer: None,
    };

    /// The innermost amendment at the head of `steps`, and the scope outside of its list.
    pub(super) fn at(&'a self, steps: &[Step]) -> Option<(&'a Amendment, Option<&'a Self>)> {
        match Amendment::at(self.amendments, steps) {
            Some(amendment) => Some((amendment, self.outer)),
            None => self.outer?.at(steps),
        }
    }
}
