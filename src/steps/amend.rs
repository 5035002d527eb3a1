//! Amendments: changes to a listing that is wrong, or on which a later text builds.

/// The smallest change that corrects a printed listing, or that adds what another text adds. It amends a listing by
/// default, and an algorithm in pseudocode if its statements are [`Line`](super::pseudo::Line)s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Amendment<S: 'static> {
    /// A short name: the claim's or the erratum's key.
    pub key: &'static str,
    /// Where the change is made, in the paper's words.
    pub place: &'static str,
    /// The printed steps, which are consecutive. They are replaced wherever the listing has them.
    pub printed: &'static [S],
    /// The steps that replace them.
    pub amended: &'static [S],
    /// The reason.
    pub why: &'static str,
    /// The test that fails without it.
    pub test: &'static str,
}

/// A statement that may contain others.
pub trait Statement: PartialEq + Sized + 'static {
    /// The statements inside: none, a body, or two branches.
    fn bodies(&self) -> [&'static [Self]; 2];

    /// The statements of another text, and how they are amended, if this one runs it.
    fn runs(&self) -> Option<Ran<Self>> {
        None
    }
}

/// The statements of a text that another one runs, and how they are amended there.
pub type Ran<S> = (&'static [S], &'static [Amendment<S>]);

impl<S: Statement> Amendment<S> {
    /// How often `statements`, nested ones included, have the steps that this amendment replaces. An amendment that is
    /// found nowhere changes nothing, so tests check this.
    pub fn occurrences(&self, statements: &[S]) -> usize {
        let here = statements
            .windows(self.printed.len().max(1))
            .filter(|w| *w == self.printed)
            .count();
        let bodies = statements.iter().flat_map(Statement::bodies);
        here + bodies.map(|body| self.occurrences(body)).sum::<usize>()
    }
}

/// The amendments in force: those of the text that is walked, then those of the text that runs it, and so on.
#[derive(Debug)]
pub struct Scope<'a, S: 'static> {
    amendments: &'a [Amendment<S>],
    outer: Option<&'a Scope<'a, S>>,
}

impl<S> Clone for Scope<'_, S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Scope<'_, S> {}

/// An element of a walk: an amendment or a statement.
#[derive(Debug)]
pub enum Met<'a, S: 'static> {
    /// An amendment: the statements that follow are its own.
    Amendment(&'a Amendment<S>),
    /// A statement, and the amendments in force inside of it.
    Statement(&'static S, Scope<'a, S>),
}

impl<'a, S: PartialEq> Scope<'a, S> {
    /// These amendments alone.
    pub const fn of(amendments: &'a [Amendment<S>]) -> Self {
        Self {
            amendments,
            outer: None,
        }
    }

    /// These amendments, and around them those of this scope.
    pub const fn around(&'a self, amendments: &'a [Amendment<S>]) -> Self {
        Self {
            amendments,
            outer: Some(self),
        }
    }

    /// The statements in their order, with amendments applied. The caller walks the statements inside of a statement,
    /// because only the caller knows how often.
    ///
    /// The statements of an amendment are not amended again by the amendment's own list, because they usually contain
    /// the statements that they replace.
    pub fn walk(self, statements: &'static [S]) -> impl Iterator<Item = Met<'a, S>> {
        let mut ahead = vec![(statements, self)];
        std::iter::from_fn(move || {
            loop {
                let (statements, scope) = ahead.last_mut()?;
                let Some((statement, rest)) = statements.split_first() else {
                    ahead.pop();
                    continue;
                };
                let Some((amendment, outer)) = scope.at(statements) else {
                    *statements = rest;
                    return Some(Met::Statement(statement, *scope));
                };
                *statements = &statements[amendment.printed.len()..];
                ahead.push((amendment.amended, outer));
                return Some(Met::Amendment(amendment));
            }
        })
    }

    /// The innermost amendment at the head of `statements`, and the scope outside of its list.
    fn at(self, statements: &[S]) -> Option<(&'a Amendment<S>, Self)> {
        let printed_here = |amendment: &&Amendment<S>| {
            !amendment.printed.is_empty() && statements.starts_with(amendment.printed)
        };
        let outer = self.outer.copied();
        match self.amendments.iter().find(printed_here) {
            Some(amendment) => Some((amendment, outer.unwrap_or(Self::of(&[])))),
            None => outer?.at(statements),
        }
    }
}
