//! What `claims` and `errata` share: the rows that a name chooses, and how they are laid out.

use comfy_table::{ColumnConstraint, ContentArrangement, Table, Width, presets};
use onionskin::low_level::error::did_you_mean;
use onionskin::low_level::papers::{Paper, papers};
use onionskin::{Error, Result};

use super::output::say;

/// As wide as the narrowest terminals are, so that a pager shows what a terminal does.
const COLUMNS: u16 = 80;
/// Columns for the key and for the word beside it.
const NARROW: [u16; 2] = [6, 15];

/// A row with what is shown of it.
pub(super) struct Row<R: 'static> {
    pub paper: &'static Paper,
    pub row: &'static R,
}

/// The rows that `of` has, of all papers, of a paper, or of one key, in any case.
pub(super) fn chosen<R>(
    what: &str,
    of: fn(&Paper) -> &'static [R],
    key: fn(&R) -> &'static str,
    name: Option<&str>,
) -> Result<Vec<Row<R>>> {
    let rows = |paper: &'static Paper| of(paper).iter().map(move |row| Row { paper, row });
    let mut chosen: Vec<_> = papers().iter().flat_map(rows).collect();
    let Some(name) = name else {
        return Ok(chosen);
    };
    let having = papers().iter().filter(|paper| !of(paper).is_empty());
    let having: Vec<&str> = having.map(|paper| paper.key).collect();
    let keys: Vec<&str> = chosen.iter().map(|row| key(row.row)).collect();
    let known = [&having[..], &keys].concat();
    let wanted = |row: &Row<R>| row.paper.key == name || key(row.row).eq_ignore_ascii_case(name);
    chosen.retain(wanted);
    if chosen.is_empty() {
        return Err(Error::usage(
            format!("there is no {what} and no paper '{name}'"),
            did_you_mean(name, &known),
        ));
    }
    Ok(chosen)
}

/// Prints the rows of each paper under its name. A single row comes with its tests.
pub(super) fn show<R>(
    rows: &[Row<R>],
    cells: fn(&R) -> [String; 3],
    tests: fn(&R) -> &[&str],
) -> Result<()> {
    for of_paper in rows.chunk_by(|a, b| a.paper.key == b.paper.key) {
        let mut head = table();
        head.add_row([of_paper[0].paper.citation]);
        let mut table = table();
        for row in of_paper {
            table.add_row(cells(row.row));
        }
        for (column, width) in NARROW.into_iter().enumerate() {
            let width = ColumnConstraint::Absolute(Width::Fixed(width));
            let column = table.column_mut(column).expect("there are three");
            column.set_constraint(width);
        }
        let text = table.trim_fmt();
        say(format_args!("{}\n\n{}\n", head.trim_fmt(), text.trim_end()))?;
    }
    if let [row] = rows {
        say("Shown by, each with `cargo test --test BINARY NAME`:")?;
        for test in tests(row.row) {
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

/// How many there are, and how many of each kind.
pub(super) fn count<K: PartialEq + std::fmt::Display>(
    what: &str,
    all: &[K],
    kinds: &[K],
) -> Result<()> {
    if all.len() < 2 {
        return Ok(());
    }
    let of = |kind: &K| {
        (
            kind.to_string(),
            all.iter().filter(|other| *other == kind).count(),
        )
    };
    let counts = kinds.iter().map(of).filter(|(_, count)| *count > 0);
    let counts: Vec<_> = counts
        .map(|(kind, count)| format!("{count} {kind}"))
        .collect();
    say(format_args!("{} {what}: {}", all.len(), counts.join(", ")))
}
