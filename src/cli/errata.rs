//! `onionskin errata`: what is wrong or missing in the papers' print.

use std::process::ExitCode;

use clap::Args;
use onionskin::Result;
use onionskin::low_level::papers::{Erratum, Fault};
use serde::Serialize;

use super::ledger::{chosen, count, show};
use super::output::print_json;

/// Say what is wrong or missing in the papers' print
///
/// Each erratum says what is printed, what happens when that is executed, and the smallest change that cures it. It is
/// an `error` (the print does something else than its prose says), a `gap` (it leaves open what a program has to know),
/// a `contradiction` (of two places), a `name`, a `number`, or a matter of the `program`: the print is sound, and the
/// program that its publisher wrote behaves otherwise. With a key, the tests that show it are named. Needs no OpenGL.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Errata {
    /// A paper (everitt, vtk, carr or lindholm), or the key of one erratum, such as CX16
    #[arg(value_name = "PAPER|KEY")]
    name: Option<String>,
    /// Print one JSON object per erratum and nothing else: key, paper, place, kind, printed, executed, change and tests
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin errata                                      every erratum
  onionskin errata lindholm                             those of one paper
  onionskin errata CX16                                 one erratum, with the tests that show it";

#[derive(Serialize)]
struct Record {
    key: &'static str,
    paper: &'static str,
    place: &'static str,
    kind: String,
    printed: &'static str,
    executed: &'static str,
    change: &'static str,
    tests: &'static [&'static str],
}

impl Errata {
    pub(super) fn run(self) -> Result<ExitCode> {
        let rows = chosen(
            "erratum",
            |paper| paper.errata,
            |erratum| erratum.key,
            self.name.as_deref(),
        )?;
        if self.json {
            for row in &rows {
                print_json(&record(row.paper.key, row.row))?;
            }
            return Ok(ExitCode::SUCCESS);
        }
        show(&rows, cells, |erratum| erratum.tests)?;
        let kinds: Vec<_> = rows.iter().map(|row| row.row.kind).collect();
        count("errata", &kinds, &Fault::ALL)?;
        Ok(ExitCode::SUCCESS)
    }
}

fn cells(erratum: &Erratum) -> [String; 3] {
    let text = format!(
        "Printed ({}): {}\nExecuted: {}\nChange: {}\n",
        erratum.place, erratum.printed, erratum.executed, erratum.change
    );
    [erratum.key.into(), erratum.kind.to_string(), text]
}

fn record(paper: &'static str, erratum: &Erratum) -> Record {
    Record {
        key: erratum.key,
        paper,
        place: erratum.place,
        kind: erratum.kind.to_string(),
        printed: erratum.printed,
        executed: erratum.executed,
        change: erratum.change,
        tests: erratum.tests,
    }
}
