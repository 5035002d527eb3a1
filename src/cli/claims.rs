//! `onionskin claims`: what the papers claim, and what running them has shown.

use std::process::ExitCode;

use clap::Args;
use onionskin::Result;
use onionskin::low_level::papers::{Claim, Paper, Verdict};
use serde::Serialize;

use super::ledger::{Ledger, run};

/// Say what the papers claim, and whether it is true
///
/// Every claim that a program can check has a verdict. `reproduced`: it holds as it is printed. `in kind`: what it says
/// holds, with other figures, on other scenes or in a part only. `contradicted`: it does not hold. `amended`: it does
/// not hold as it is printed, and it does with corrections or additions. `open`: nothing here decides it, such as times on
/// a paper's GPUs. With a key, the tests that show it are named. Needs no OpenGL.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Claims {
    /// A paper (everitt, vtk, carr or lindholm), or the key of one claim, such as E01
    #[arg(value_name = "PAPER|KEY")]
    name: Option<String>,
    /// Print one JSON object per claim and nothing else: key, paper, place, claim, verdict, figures (each with of, paper,
    /// which may be null, and here), evidence and tests
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin claims                                      every claim of the papers
  onionskin claims carr                                 those of one paper
  onionskin claims E13                                  one claim, with the tests that show it";

#[derive(Serialize)]
pub(super) struct Record {
    key: &'static str,
    paper: &'static str,
    place: &'static str,
    claim: &'static str,
    verdict: String,
    figures: Vec<FigureRecord>,
    evidence: &'static str,
    tests: &'static [&'static str],
}

#[derive(Serialize)]
struct FigureRecord {
    of: &'static str,
    paper: Option<&'static str>,
    here: &'static str,
}

impl Claims {
    pub(super) fn run(self) -> Result<ExitCode> {
        run::<Claim>(self.name.as_deref(), self.json)
    }
}

impl Ledger for Claim {
    const CALLED: [&'static str; 2] = ["claim", "claims"];
    type Word = Verdict;
    const WORDS: &'static [Verdict] = &Verdict::ALL;
    type Record = Record;

    fn of(paper: &Paper) -> &'static [Self] {
        paper.claims
    }

    fn key(&self) -> &'static str {
        self.key
    }

    fn word(&self) -> Verdict {
        self.verdict
    }

    fn text(&self) -> String {
        let figures = self.figures.iter().map(|figure| {
            let paper = figure.paper.map(|paper| format!("paper {paper}, "));
            let paper = paper.unwrap_or_default();
            format!("{}: {paper}here {}\n", figure.of, figure.here)
        });
        let figures: String = figures.collect();
        format!(
            "{} ({})\n{}\n{figures}",
            self.claim, self.place, self.evidence
        )
    }

    fn tests(&self) -> &'static [&'static str] {
        self.tests
    }

    fn record(&self, paper: &'static str) -> Record {
        let figures = self.figures.iter().map(|figure| FigureRecord {
            of: figure.of,
            paper: figure.paper,
            here: figure.here,
        });
        Record {
            key: self.key,
            paper,
            place: self.place,
            claim: self.claim,
            verdict: self.verdict.to_string(),
            figures: figures.collect(),
            evidence: self.evidence,
            tests: self.tests,
        }
    }
}
