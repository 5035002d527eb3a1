//! What `claims` and `errata` share: the rows that a name chooses, and how they are laid out.

use std::fmt::Display;
use std::process::ExitCode;

use comfy_table::{ColumnConstraint, ContentArrangement, Table, Width, presets};
use onionskin::low_level::error::nearest;
use onionskin::low_level::papers::{Paper, papers};
use onionskin::{Error, Result};
use serde::Serialize;

use super::output::{print_json, say};

/// As wide as the narrowest terminals are, so that a pager shows what a terminal does.
const COLUMNS: u16 = 80;
/// Columns for the key and for the word beside it.
const NARROW: [u16; 2] = [6, 15];

/// A claim or an erratum, and what is shown of it.
pub(super) trait Ledger: Sized + 'static {
    /// What one row is called, and what all are.
    const CALLED: [&'static str; 2];
    /// The word beside the key.
    type Word: Copy + PartialEq + Display + 'static;
    /// All of these words.
    const WORDS: &'static [Self::Word];
    /// The row in JSON.
    type Record: Serialize;

    fn of(paper: &Paper) -> &'static [Self];
    fn key(&self) -> &'static str;
    fn word(&self) -> Self::Word;
    fn text(&self) -> String;
    fn tests(&self) -> &'static [&'static str];
    fn record(&self, paper: &'static str) -> Self::Record;
}

/// A row and its paper.
type Row<R> = (&'static Paper, &'static R);

/// Prints the rows that `name` chooses.
pub(super) fn run<R: Ledger>(name: Option<&str>, json: bool) -> Result<ExitCode> {
    let rows = chosen::<R>(name)?;
    if json {
        for (paper, row) in rows {
            print_json(&row.record(paper.key))?;
        }
    } else {
        show(&rows)?;
        count(&rows)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The rows of all papers, of a paper, or of one key, in any case.
fn chosen<R: Ledger>(name: Option<&str>) -> Result<Vec<Row<R>>> {
    let rows = |paper: &'static Paper| R::of(paper).iter().map(move |row| (paper, row));
    let mut chosen: Vec<_> = papers().iter().flat_map(rows).collect();
    let Some(name) = name else {
        return Ok(chosen);
    };
    chosen.retain(|(paper, row)| {
        [paper.key, row.key()]
            .iter()
            .any(|key| key.eq_ignore_ascii_case(name))
    });
    match chosen.is_empty() {
        true => Err(unknown::<R>(name)),
        false => Ok(chosen),
    }
}

/// The error for a name that is no paper's and no row's: what was probably meant, and the papers with the keys of their
/// rows, from the first to the last.
fn unknown<R: Ledger>(name: &str) -> Error {
    let papers = papers().iter().filter(|paper| !R::of(paper).is_empty());
    let (mut known, mut listed) = (Vec::new(), Vec::new());
    for paper in papers {
        let keys = R::of(paper).iter().map(Ledger::key);
        known.push(paper.key);
        known.extend(keys);
        if let [first, .., last] = R::of(paper) {
            listed.push(format!("{} ({} to {})", paper.key, first.key(), last.key()));
        }
    }
    let meant = nearest(name, &known).map(|meant| format!("Did you mean '{meant}'? "));
    Error::usage(
        format!("there is no {} and no paper '{name}'", R::CALLED[0]),
        format!(
            "{}Known are: {}.",
            meant.unwrap_or_default(),
            listed.join(", ")
        ),
    )
}

/// Prints the rows of each paper under its name. A single row comes with its tests.
fn show<R: Ledger>(rows: &[Row<R>]) -> Result<()> {
    for of_paper in rows.chunk_by(|(a, _), (b, _)| a.key == b.key) {
        let mut head = table();
        head.add_row([of_paper[0].0.citation]);
        let mut table = table();
        for (_, row) in of_paper {
            table.add_row([row.key().to_owned(), row.word().to_string(), row.text()]);
        }
        for (column, width) in NARROW.into_iter().enumerate() {
            let width = ColumnConstraint::Absolute(Width::Fixed(width));
            let column = table.column_mut(column).expect("there are three");
            column.set_constraint(width);
        }
        let text = table.trim_fmt();
        say(format_args!("{}\n\n{}\n", head.trim_fmt(), text.trim_end()))?;
    }
    if let [(_, row)] = rows {
        say("Shown by, each with `cargo test --test BINARY NAME`:")?;
        for test in row.tests() {
            say(format_args!("  {test}"))?;
        }
    }
    Ok(())
}

fn table() -> Table {
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_content_arrangement(ContentArrangement::Dynamic)
        .set_width(COLUMNS);
    table
}

/// How many there are, and how many with each word.
fn count<R: Ledger>(rows: &[Row<R>]) -> Result<()> {
    if rows.len() < 2 {
        return Ok(());
    }
    let of = |word: &R::Word| {
        let with = rows.iter().filter(|(_, row)| row.word() == *word);
        (with.count(), word.to_string())
    };
    let counts = R::WORDS.iter().map(of).filter(|(count, _)| *count > 0);
    let counts: Vec<_> = counts
        .map(|(count, word)| format!("{count} {word}"))
        .collect();
    let called = R::CALLED[1];
    say(format_args!(
        "{} {called}: {}",
        rows.len(),
        counts.join(", ")
    ))
}
