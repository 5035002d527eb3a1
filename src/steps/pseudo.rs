//! Algorithms that a paper prints as pseudocode rather than as calls, line by line.
//!
//! Where a [`Listing`](super::Listing) sets a pipeline's state, a [`Pseudocode`] says what happens at each pixel and to
//! each fragment: Carr et al.'s Algorithms 1 and 2. The emulator runs it as it stands. OpenGL runs a listing that
//! stands beside it in `papers/`, and tests compare the two.
//!
//! Algorithms on finished lists of fragments are written in the statements of [`list`].
//!
//! Every pixel has its own variables, except `gChanged`, which all pixels share. Flags are numbers: `true` is 1,
//! `false` is 0.

pub mod list;
mod macros;

use std::fmt;

use super::amend::{Met, Scope, Statement};
use super::constants::{Compare, Objects};
use super::lines::{Lines, TextLine, text};
use super::listing::Amendment;
use super::origin::Margin;

/// An algorithm as its paper prints it, in statements that are [`Line`]s, or another paper's [`list::ListLine`]s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pseudocode<L: 'static = Line> {
    /// Its name.
    pub title: &'static str,
    /// Where it is printed.
    pub source: &'static str,
    /// The lines.
    pub lines: &'static [L],
}

/// One statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Line {
    /// `for all pixel sample locations do`
    Pixels(&'static [Line]),
    /// `for all ... geometry ... do`: once per fragment, in the order of submission.
    Fragments {
        /// The objects.
        of: Objects,
        /// The paper's words for them.
        phrase: &'static str,
        /// The lines for each fragment.
        body: &'static [Line],
    },
    /// `while flag = true do`
    While {
        /// The flag.
        flag: &'static str,
        /// The repeated lines.
        body: &'static [Line],
    },
    /// `if ... then ... else ...`
    If {
        /// The condition.
        test: Test,
        /// The lines if it holds.
        then: &'static [Line],
        /// The lines if it does not.
        otherwise: &'static [Line],
    },
    /// `variable <- value`
    Set {
        /// The variable.
        variable: &'static str,
        /// Its new value.
        value: Value,
    },
    /// `swap(a, b)`
    Swap(&'static str, &'static str),
    /// `Composite fragment into color buffer`
    Composite,
    /// Says where the lines that follow come from, or how the paper spells them. It is no statement itself.
    Margin(Margin),
}

impl Statement for Line {
    fn margin(&self) -> Option<Margin> {
        match *self {
            Self::Margin(margin) => Some(margin),
            _ => None,
        }
    }

    fn bodies(&self) -> [&'static [Self]; 2] {
        match *self {
            Self::Pixels(body) | Self::Fragments { body, .. } | Self::While { body, .. } => {
                [body, &[]]
            }
            Self::If {
                then, otherwise, ..
            } => [then, otherwise],
            Self::Set { .. } | Self::Swap(..) | Self::Composite | Self::Margin(_) => [&[], &[]],
        }
    }
}

/// The value of an assignment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// Another variable's value.
    Of(&'static str),
    /// `true` or `false`.
    Flag(bool),
    /// A depth nearer than any fragment's.
    BeforeEverything,
    /// The first value if the flag is set, or else the second.
    Either(&'static str, &'static str, &'static str),
}

/// The condition of an `if`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Test {
    /// `a < b`, or another comparison.
    One(&'static str, Compare, &'static str),
    /// `a < b < c`, or with other comparisons.
    Two(&'static str, Compare, &'static str, Compare, &'static str),
    /// `a = b and c < d`
    Both(
        (&'static str, Compare, &'static str),
        (&'static str, Compare, &'static str),
    ),
    /// `flag = true`
    Set(&'static str),
}

/// The algorithm as its paper prints it, with numbered lines and with `amendments` applied. Without any amendment, it
/// is as it stands here.
pub fn print(algorithm: &Pseudocode, amendments: &[Amendment<Line>]) -> String {
    text(&lines(algorithm, amendments))
}

/// The lines of the algorithm, with `amendments` applied.
pub fn lines(algorithm: &Pseudocode, amendments: &[Amendment<Line>]) -> Vec<TextLine> {
    let mut printer = Printer {
        number: 0,
        lines: Lines::of(algorithm.source),
    };
    printer.lines(algorithm.lines, Scope::of(amendments), 0);
    printer.lines.done()
}

struct Printer {
    number: usize,
    lines: Lines,
}

impl Printer {
    /// The first line of a statement.
    fn line(&mut self, indent: usize, line: impl fmt::Display, scope: Scope<'_, Line>) {
        let lead = self.lead(indent);
        self.lines.statement(&lead, line, scope);
    }

    /// A further line of a statement.
    fn rest(&mut self, indent: usize, line: impl fmt::Display, scope: Scope<'_, Line>) {
        let lead = self.lead(indent);
        self.lines.rest(&lead, line, scope);
    }

    /// The next line's number, and its indentation.
    fn lead(&mut self, indent: usize) -> String {
        self.number += 1;
        format!("{:>2}: {}", self.number, "  ".repeat(indent))
    }

    fn lines(&mut self, lines: &'static [Line], scope: Scope<'_, Line>, indent: usize) {
        for met in scope.walk(lines) {
            match met {
                Met::Amendment(it) => self.lines.amendment("    ", it),
                Met::Statement(line, scope) => self.statement(line, scope, indent),
                Met::Line(line, scope) => self.rest(indent, line, scope),
            }
        }
    }

    fn statement(&mut self, line: &Line, scope: Scope<'_, Line>, indent: usize) {
        if let Line::Margin(_) = line {
            return;
        }
        self.line(indent, line, scope);
        let [body, otherwise] = line.bodies();
        self.lines(body, scope, indent + 1);
        self.otherwise(otherwise, scope, indent);
        let end = match line {
            Line::Pixels(_) | Line::Fragments { .. } => "end for",
            Line::While { .. } => "end while",
            Line::If { .. } => "end if",
            _ => return,
        };
        self.rest(indent, end, scope);
    }

    /// An `if` that is the only statement of an `else` continues the chain.
    fn otherwise(&mut self, lines: &'static [Line], scope: Scope<'_, Line>, indent: usize) {
        let statement = |met| match met {
            Met::Amendment(_) | Met::Line(..) => None,
            Met::Statement(line, scope) => Some((line, scope)),
        };
        let all: Vec<_> = scope.walk(lines).filter_map(statement).collect();
        match all[..] {
            [] => {}
            [
                (
                    &Line::If {
                        test,
                        then,
                        otherwise,
                    },
                    scope,
                ),
            ] => {
                self.line(indent, format_args!("else if {test} then"), scope);
                self.lines(then, scope, indent + 1);
                self.otherwise(otherwise, scope, indent);
            }
            _ => {
                self.rest(indent, "else", scope);
                self.lines(lines, scope, indent + 1);
            }
        }
    }
}

/// The statement's own line, without the statements inside of it.
impl fmt::Display for Line {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Pixels(_) => f.write_str("for all pixel sample locations do"),
            Self::Fragments { phrase, .. } => write!(f, "for all {phrase} do"),
            Self::While { flag, .. } => write!(f, "while {flag} = true do"),
            Self::If { test, .. } => write!(f, "if {test} then"),
            Self::Set { variable, value } => write!(f, "{variable} ← {value}"),
            Self::Swap(a, b) => write!(f, "swap({a}, {b})"),
            Self::Composite => f.write_str("Composite fragment into color buffer"),
            Self::Margin(_) => Ok(()),
        }
    }
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Of(variable) => f.write_str(variable),
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::BeforeEverything => f.write_str("before zNear"),
            Self::Either(flag, a, b) => write!(f, "{a} if {flag} else {b}"),
        }
    }
}

impl fmt::Display for Test {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::One(a, ab, b) => write!(f, "{a} {} {b}", sign(*ab)),
            Self::Two(a, ab, b, bc, c) => write!(f, "{a} {} {b} {} {c}", sign(*ab), sign(*bc)),
            Self::Both((a, ab, b), (c, cd, d)) => {
                write!(f, "{a} {} {b} and {c} {} {d}", sign(*ab), sign(*cd))
            }
            Self::Set(flag) => write!(f, "{flag} = true"),
        }
    }
}

/// The comparison as pseudocode writes it, with a single `=`.
fn sign(compare: Compare) -> &'static str {
    match compare {
        Compare::Equal => "=",
        other => other.operator(),
    }
}
