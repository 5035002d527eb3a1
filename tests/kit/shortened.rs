//! Amendments with one step less, to see whether that is noticed: the smallest change has no step that does nothing.

use std::fmt::Debug;

use onionskin::low_level::steps::pseudo::{Line, list::ListLine};
use onionskin::low_level::steps::{Amendment, Statement, Step};

/// A statement that can be written again with one of the statements inside of it left out.
pub trait Shortened: Statement + Copy + Debug {
    fn shortened(&self, kept: &[Self]) -> Vec<Self>;
}

/// A list of statements without any one of them, the innermost ones included, but for those that are kept. Where one
/// decides between two lists, either of them also takes its place. Marks in the margin run nothing, and stay.
pub fn without_one<S: Shortened>(statements: &[S], kept: &[S]) -> Vec<Vec<S>> {
    let at = |place: usize| {
        let with = |here: &[S]| [&statements[..place], here, &statements[place + 1..]].concat();
        let statement = statements[place];
        let [then, otherwise] = statement.bodies();
        let mut lists: Vec<_> = statement
            .shortened(kept)
            .iter()
            .map(|it| with(&[*it]))
            .collect();
        if !kept.contains(&statement) && statement.margin().is_none() {
            lists.extend(
                [then, otherwise]
                    .into_iter()
                    .filter(|body| !body.is_empty())
                    .map(with),
            );
            lists.push(with(&[]));
        }
        lists
    };
    (0..statements.len()).flat_map(at).collect()
}

/// The same of a branch, which keeps a statement: a choice between something and nothing is another thing.
fn branch_without_one<S: Shortened>(branch: &[S], kept: &[S]) -> Vec<Vec<S>> {
    let mut lists = without_one(branch, kept);
    lists.retain(|list| !list.is_empty());
    lists
}

/// A choice between two branches with either of them shorter.
fn of_branches<S: Shortened>(
    [then, otherwise]: [&'static [S]; 2],
    kept: &[S],
    of: impl Fn(&'static [S], &'static [S]) -> S,
) -> Vec<S> {
    let then_shorter = branch_without_one(then, kept);
    let otherwise_shorter = branch_without_one(otherwise, kept);
    let first = then_shorter
        .into_iter()
        .map(|shorter| of(shorter.leak(), otherwise));
    let second = otherwise_shorter
        .into_iter()
        .map(|shorter| of(then, shorter.leak()));
    first.chain(second).collect()
}

/// All statements, the innermost ones included.
pub fn all<S: Shortened>(statements: &[S]) -> Vec<S> {
    let inner = statements.iter().flat_map(|statement| statement.bodies());
    [statements.to_vec(), inner.flat_map(all).collect()].concat()
}

impl Shortened for Step {
    fn shortened(&self, kept: &[Self]) -> Vec<Self> {
        let Self::If {
            condition,
            then,
            otherwise,
        } = *self
        else {
            return Vec::new();
        };
        let of = |then, otherwise| Self::If {
            condition,
            then,
            otherwise,
        };
        of_branches([then, otherwise], kept, of)
    }
}

impl Shortened for Line {
    fn shortened(&self, _: &[Self]) -> Vec<Self> {
        Vec::new()
    }
}

impl Shortened for ListLine {
    fn shortened(&self, kept: &[Self]) -> Vec<Self> {
        let Self::If(test, then, otherwise) = *self else {
            return Vec::new();
        };
        let of = |then, otherwise| Self::If(test, then, otherwise);
        of_branches([then, otherwise], kept, of)
    }
}

/// The amendments without one of them, or without one step that one of them adds. Each has a name: the amendment's key, and
/// the number of the change.
pub fn with_less<S: Shortened>(amendments: &[Amendment<S>]) -> Vec<(String, Vec<Amendment<S>>)> {
    let mut less = Vec::new();
    for (place, amendment) in amendments.iter().enumerate() {
        let others = [&amendments[..place], &amendments[place + 1..]].concat();
        less.push((format!("{} {place}", amendment.key), others));
        let shorter = without_one(amendment.amended, &all(amendment.printed));
        for (number, shorter) in shorter.into_iter().enumerate() {
            let mut changed = amendments.to_vec();
            let name = format!("{} {place}.{number}", amendment.key);
            changed[place].amended = shorter.leak();
            less.push((name, changed));
        }
    }
    less
}

/// Those that nothing notices.
pub fn idle<S: Shortened>(
    amendments: &[Amendment<S>],
    same: impl Fn(&[Amendment<S>]) -> bool,
) -> Vec<String> {
    assert!(same(amendments), "compared with itself");
    let less = with_less(amendments);
    println!("{} changes", less.len());
    let idle = less.into_iter().filter(|(_, changed)| same(changed));
    idle.map(|(what, changed)| {
        println!("{what}: {changed:?}");
        what
    })
    .collect()
}
