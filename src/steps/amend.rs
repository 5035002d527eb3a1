//! Amendments: changes to a listing that is wrong or silent, or on which a later text builds.

use super::origin::{Kind, Margin, Origin};

/// The smallest change that corrects a printed listing, or that adds what another text adds. It amends a listing by
/// default, and an algorithm in pseudocode if its statements are [`Line`](super::pseudo::Line)s.
#[derive(Debug, PartialEq)]
pub struct Amendment<S: 'static> {
    /// A short name: the claim's or the erratum's key.
    pub key: &'static str,
    /// Why it stands here: a correction, a filling, another text's addition.
    pub kind: Kind,
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

impl<S> Clone for Amendment<S> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S> Copy for Amendment<S> {}

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
            Kind::Silence(rests_on) => Origin::Silence { key, why, rests_on },
            Kind::Prose(quote) => Origin::Prose { quote },
            Kind::Edition => Origin::Edition { why },
        }
    }
}

/// A statement that may contain others.
pub trait Statement: PartialEq + Sized + 'static {
    /// The mark, if it is one and no statement to be run.
    fn margin(&self) -> Option<Margin>;

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
        let here = (0..statements.len()).filter(|&at| self.covers(&statements[at..]).is_some());
        let here = here.count();
        let bodies = statements.iter().flat_map(Statement::bodies);
        here + bodies.map(|body| self.occurrences(body)).sum::<usize>()
    }

    /// With how many statements `statements` begin that are the ones this amendment replaces, marks between them
    /// included. Its own marks count for nothing.
    fn covers(&self, statements: &[S]) -> Option<usize> {
        let mut covered = 0;
        for printed in self.printed.iter().filter(|it| it.margin().is_none()) {
            let statement = |it: &S| it.margin().is_none();
            let margins = statements[covered..].iter().position(statement)?;
            // The first statement is where it begins.
            if statements[covered + margins] != *printed || (covered == 0 && margins > 0) {
                return None;
            }
            covered += margins + 1;
        }
        (covered > 0).then_some(covered)
    }
}

/// The amendments in force: those of the text that is walked, then those of the text that runs it, and so on. And where the
/// statement comes from that this is the scope of.
#[derive(Debug)]
pub struct Scope<'a, S: 'static> {
    amendments: &'a [Amendment<S>],
    outer: Option<&'a Scope<'a, S>>,
    origin: Option<Origin>,
    spelling: Option<Spelling>,
}

/// The paper's own spelling of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spelling {
    /// The line, to the letter.
    pub text: &'static str,
    /// The right word, where the paper has one that does not exist.
    pub meaning: Option<&'static str>,
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
    /// A line of the paper that does nothing.
    Line(&'static str, Scope<'a, S>),
}

impl<'a, S: Statement> Scope<'a, S> {
    /// These amendments alone.
    pub const fn of(amendments: &'a [Amendment<S>]) -> Self {
        Self {
            amendments,
            outer: None,
            origin: None,
            spelling: None,
        }
    }

    /// These amendments, and around them those of this scope.
    pub const fn around(&'a self, amendments: &'a [Amendment<S>]) -> Self {
        Self {
            amendments,
            outer: Some(self),
            origin: self.origin,
            spelling: None,
        }
    }

    /// Where the statement comes from that this is the scope of, or `None` if nothing says so.
    pub const fn origin(&self) -> Option<Origin> {
        self.origin
    }

    /// The paper's own spelling of this statement, if it is not how listings are printed anyway.
    pub const fn spelling(&self) -> Option<Spelling> {
        self.spelling
    }

    /// The statements in their order, with amendments applied. The caller walks the statements inside of a statement,
    /// because only the caller knows how often.
    ///
    /// The statements of an amendment are not amended again by the amendment's own list, because they usually contain
    /// the statements that they replace.
    pub fn walk(self, statements: &'static [S]) -> impl Iterator<Item = Met<'a, S>> {
        let mut ahead = vec![Ahead {
            statements,
            scope: Scope {
                spelling: None,
                ..self
            },
        }];
        std::iter::from_fn(move || {
            loop {
                let here = ahead.last_mut()?;
                let Some((statement, rest)) = here.statements.split_first() else {
                    ahead.pop();
                    continue;
                };
                let scope = here.scope;
                if let Some(margin) = statement.margin() {
                    here.statements = rest;
                    match here.note(margin) {
                        Some(line) => return Some(Met::Line(line, scope)),
                        None => continue,
                    }
                }
                here.scope.spelling = None;
                let Some((amendment, outer)) = scope.at(here.statements) else {
                    here.statements = rest;
                    return Some(Met::Statement(statement, scope));
                };
                let covered = amendment.covers(here.statements).unwrap_or_default();
                let (covered, rest) = here.statements.split_at(covered);
                here.statements = rest;
                let margins = covered.iter().filter_map(Statement::margin);
                margins.for_each(|margin| _ = here.note(margin));
                ahead.extend(Ahead::of(amendment, outer, covered, scope));
                return Some(Met::Amendment(amendment));
            }
        })
    }

    /// The innermost amendment at the head of `statements`, and the scope outside of its list.
    fn at(self, statements: &[S]) -> Option<(&'a Amendment<S>, Self)> {
        let printed_here = |amendment: &&Amendment<S>| amendment.covers(statements).is_some();
        let outer = self.outer.copied();
        match self.amendments.iter().find(printed_here) {
            Some(amendment) => Some((amendment, outer.unwrap_or(Self::of(&[])))),
            None => outer?.at(statements),
        }
    }
}

/// Statements to be walked.
struct Ahead<'a, S: 'static> {
    statements: &'static [S],
    scope: Scope<'a, S>,
}

impl<'a, S: Statement> Ahead<'a, S> {
    /// An amendment's statements, the last first. Those that it only repeats come from where they came from before:
    /// these are `covered`, whose scope is `scope`.
    fn of(
        amendment: &Amendment<S>,
        outer: Scope<'a, S>,
        covered: &'static [S],
        scope: Scope<'a, S>,
    ) -> Vec<Self> {
        let (printed, amended) = (amendment.printed, amendment.amended);
        let ours = |statements| Self {
            statements,
            scope: Scope {
                origin: Some(amendment.origin()),
                spelling: None,
                ..outer
            },
        };
        let repeated = amended.windows(printed.len()).position(|it| it == printed);
        // What an amendment from outside replaces stays in one piece.
        let crosses = |at: usize| {
            let ends = [at, at + printed.len()];
            (0..amended.len()).any(|from| {
                let covered = outer.at(&amended[from..]);
                let covered = covered.and_then(|(outer, _)| outer.covers(&amended[from..]));
                let to = from + covered.unwrap_or_default();
                ends.iter().any(|&end| from < end && end < to)
            })
        };
        let Some(at) = repeated.filter(|&at| !crosses(at)) else {
            return vec![ours(amended)];
        };
        let kept = Self {
            statements: covered,
            scope: Scope {
                origin: scope.origin,
                spelling: scope.spelling,
                ..outer
            },
        };
        vec![
            ours(&amended[at + printed.len()..]),
            kept,
            ours(&amended[..at]),
        ]
    }

    /// Takes a mark of the margin to heart, and returns its line if it has one.
    fn note(&mut self, margin: Margin) -> Option<&'static str> {
        match margin {
            Margin::From(origin) => self.scope.origin = Some(origin),
            Margin::Spelt { text, meaning } => {
                self.scope.spelling = Some(Spelling { text, meaning });
            }
            Margin::Line(line) => return Some(line),
        }
        None
    }
}
