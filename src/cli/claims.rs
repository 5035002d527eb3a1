//! `onionskin claims`: what the papers claim, and what running them has shown.

use std::process::ExitCode;

use clap::Args;
use onionskin::Result;
use onionskin::low_level::papers::{Claim, Verdict};
use serde::Serialize;

use super::ledger::{chosen, count, show};
use super::output::print_json;

/// Say what the papers claim, and whether it is true
///
/// Every claim that a program can check has a verdict. `reproduced`: it holds as it is printed. `in kind`: what it says
/// holds, with other figures, on other scenes or in a part only. `contradicted`: it does not hold. `amended`: it does
/// not hold as it is printed, and it does with corrections or additions. With a key, the tests that show it are named.
/// Needs no OpenGL.
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
struct Record {
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
        let rows = chosen(
            "claim",
            |paper| paper.claims,
            |claim| claim.key,
            self.name.as_deref(),
        )?;
        if self.json {
            for row in &rows {
                print_json(&record(row.paper.key, row.row))?;
            }
            return Ok(ExitCode::SUCCESS);
        }
        show(&rows, cells, |claim| claim.tests)?;
        let verdicts: Vec<_> = rows.iter().map(|row| row.row.verdict).collect();
        count("claims", &verdicts, &Verdict::ALL)?;
        Ok(ExitCode::SUCCESS)
    }
}

fn cells(claim: &Claim) -> [String; 3] {
    let figures = claim.figures.iter().map(|figure| {
        let paper = figure.paper.map(|paper| format!("paper {paper}, "));
        format!(
            "{}: {}here {}\n",
            figure.of,
            paper.unwrap_or_default(),
            figure.here
        )
    });
    let text = format!(
        "{} ({})\n{}\n{}",
        claim.claim,
        claim.place,
        claim.evidence,
        figures.collect::<String>()
    );
    [claim.key.into(), claim.verdict.to_string(), text]
}

fn record(paper: &'static str, claim: &Claim) -> Record {
    let figures = claim.figures.iter().map(|figure| FigureRecord {
        of: figure.of,
        paper: figure.paper,
        here: figure.here,
    });
    Record {
        key: claim.key,
        paper,
        place: claim.place,
        claim: claim.claim,
        verdict: claim.verdict.to_string(),
        figures: figures.collect(),
        evidence: claim.evidence,
        tests: claim.tests,
    }
}
