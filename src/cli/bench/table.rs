//! The table of a scene, for people.

use comfy_table::{CellAlignment, Table, presets};

use super::row::{By, Row, Rows};
use super::statistics::Times;

/// A column: its name, and its text for a row. It is shown if any row has a text.
type Column<'r> = (&'static str, Box<dyn Fn(&Row) -> Option<String> + 'r>);

pub(super) fn table(rows: &Rows<'_>) -> Table {
    let columns: Vec<Column<'_>> = columns(rows)
        .into_iter()
        .filter(|(_, text)| rows.rows.iter().any(|row| text(row).is_some()))
        .collect();
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_header(columns.iter().map(|(name, _)| *name));
    for row in &rows.rows {
        let cells = columns
            .iter()
            .map(|(_, text)| text(row).unwrap_or_default());
        table.add_row(cells);
    }
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

fn columns<'r>(rows: &'r Rows<'_>) -> Vec<Column<'r>> {
    let time = |of: fn(&Times) -> f64| {
        move |row: &Row| {
            row.times
                .as_ref()
                .ok()
                .map(|times| format!("{:.1}", of(times)))
        }
    };
    let ratio = |base: Option<f64>, only_ours: bool| {
        move |row: &Row| {
            let median = row.times.as_ref().ok()?.median();
            let shown = !only_ours || row.by == By::Onionskin;
            base.filter(|_| shown).map(|base| digits(median / base))
        }
    };
    vec![
        ("method", Box::new(|row| Some(row.name()))),
        (
            "ms",
            Box::new(move |row| time(Times::median)(row).or_else(|| Some("-".into()))),
        ),
        ("min", Box::new(time(Times::min))),
        ("max", Box::new(time(Times::max))),
        (
            "frames",
            Box::new(|row| Some(row.times.as_ref().ok()?.count().to_string())),
        ),
        ("/ blend", Box::new(ratio(rows.base(), false))),
        (
            "/ VTK alpha",
            Box::new(ratio(rows.median(By::Vtk, "alpha"), true)),
        ),
        (
            "/ peel",
            Box::new(ratio(rows.median(By::Vtk, "peel"), true)),
        ),
        (
            "/ dual",
            Box::new(ratio(rows.median(By::Vtk, "dual"), true)),
        ),
        (
            "passes",
            Box::new(|row| row.counts.geometry_passes.map(|passes| passes.to_string())),
        ),
        (
            "marked",
            Box::new(|row| row.counts.marked_pixels.map(|count| count.to_string())),
        ),
        (
            "in lists",
            Box::new(|row| row.counts.list_fragments.map(|count| count.to_string())),
        ),
        ("MiB", Box::new(|row| row.counts.bytes.map(mebibytes))),
    ]
}

/// Three digits, or all before the point.
fn digits(ratio: f64) -> String {
    match ratio {
        ratio if ratio < 10.0 => format!("{ratio:.2}"),
        ratio if ratio < 100.0 => format!("{ratio:.1}"),
        ratio => format!("{ratio:.0}"),
    }
}

fn mebibytes(bytes: u64) -> String {
    format!("{:.1}", bytes as f64 / f64::from(1 << 20))
}

/// A line for each who has no times.
pub(super) fn left_out(rows: &Rows<'_>) -> Vec<String> {
    let why = |row: &Row| Some(format!("{}: {}", row.name(), row.times.as_ref().err()?));
    rows.rows.iter().filter_map(why).collect()
}
