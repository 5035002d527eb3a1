//! `onionskin errata`: what is wrong or missing in the papers' print.

use std::process::ExitCode;

use clap::Args;
use onionskin::Result;
use onionskin::low_level::papers::{Erratum, Fault, Paper};
use serde::Serialize;

use super::ledger::{Ledger, run};

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
pub(super) struct Record {
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
        run::<Erratum>(self.name.as_deref(), self.json)
    }
}

impl Ledger for Erratum {
    const CALLED: [&'static str; 2] = ["erratum", "errata"];
    type Word = Fault;
    const WORDS: &'static [Fault] = &Fault::ALL;
    type Record = Record;

    fn of(paper: &Paper) -> &'static [Self] {
        paper.errata
    }

    fn key(&self) -> &'static str {
        self.key
    }

    fn word(&self) -> Fault {
        self.kind
    }

    fn text(&self) -> String {
        format!(
            "Printed ({}): {}\nExecuted: {}\nChange: {}\n",
            self.place, self.printed, self.executed, self.change
        )
    }

    fn tests(&self) -> &'static [&'static str] {
        self.tests
    }

    fn record(&self, paper: &'static str) -> Record {
        Record {
            key: self.key,
            paper,
            place: self.place,
            kind: self.kind.to_string(),
            printed: self.printed,
            executed: self.executed,
            change: self.change,
            tests: self.tests,
        }
    }
}
