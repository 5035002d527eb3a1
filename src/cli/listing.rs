//! `onionskin listing`: the papers' listings, printed from the data that runs.

use std::process::ExitCode;

use clap::Args;
use onionskin::papers::papers;
use onionskin::steps::{Amendment, Recorder, Variables, print, run};
use onionskin::{Error, Result};

use super::output::say;

/// Print the papers' listings
///
/// They are printed from the data that runs: by default as amended, each amendment with its reason; with --as-printed
/// as the paper has them. Without an argument, says which there are. Needs no OpenGL.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Listing {
    /// A paper, for all of its listings, or one listing, such as everitt/listing-1
    #[arg(value_name = "PAPER[/LISTING]")]
    name: Option<String>,
    /// As the paper has it, with nothing amended
    #[arg(long)]
    as_printed: bool,
    /// The flat trace of N rounds of its loop instead, 1 to 1000: a line a call, every argument named
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1000))]
    unroll: Option<u32>,
}

const EXAMPLES: &str = "\
Examples:
  onionskin listing                                     which there are
  onionskin listing everitt/listing-1 --as-printed
  onionskin listing everitt/listing-1 --unroll 2        two peels, call by call";

impl Listing {
    pub(super) fn run(self) -> Result<ExitCode> {
        let Some(name) = &self.name else {
            for paper in papers() {
                say(paper.citation)?;
                for (key, listing, _) in paper.listings {
                    let name = format!("{}/{key}", paper.key);
                    say(format_args!("  {name:<24} {}", listing.title))?;
                }
            }
            return Ok(ExitCode::SUCCESS);
        };
        let (paper_key, listing_key) = name
            .split_once('/')
            .map_or((name.as_str(), None), |(p, l)| (p, Some(l)));
        let mut found = false;
        for paper in papers().iter().filter(|paper| paper.key == paper_key) {
            for (_, listing, amendments) in paper
                .listings
                .iter()
                .filter(|(key, ..)| listing_key.is_none_or(|k| k == *key))
            {
                if found {
                    say("")?;
                }
                found = true;
                say(format_args!("// {}: {}", listing.source, listing.title))?;
                let amendments = if self.as_printed { &[] } else { *amendments };
                let text = match self.unroll {
                    Some(rounds) => unroll(listing, amendments, rounds)?,
                    None => print::listing(listing, amendments),
                };
                say(text.trim_end_matches('\n'))?;
            }
        }
        if found {
            return Ok(ExitCode::SUCCESS);
        }
        let all = papers().iter().flat_map(|p| {
            p.listings
                .iter()
                .map(move |(key, ..)| format!("{}/{key}", p.key))
        });
        Err(Error::usage(
            format!("there is no listing '{name}'"),
            format!("the listings are {}", all.collect::<Vec<_>>().join(", ")),
        ))
    }
}

/// Every query is answered as if each peel had found one fragment.
fn unroll(
    listing: &onionskin::steps::Listing,
    amendments: &[Amendment],
    rounds: u32,
) -> Result<String> {
    let variables = ["num_passes", "num_layers"]
        .into_iter()
        .fold(Variables::new(), |variables, name| {
            variables.with(name, f64::from(rounds))
        })
        .with("occlusion_ratio", 0.0)
        .with("window_area", 1.0)
        .with("composited", 0.0);
    let mut recorder = Recorder::new().answering_every_query(1);
    run(listing, amendments, variables, &mut recorder)?;
    Ok(recorder.trace())
}
