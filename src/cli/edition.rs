//! `onionskin edition`: the papers as a site that runs.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use onionskin::Result;
use onionskin::low_level::edition::site::{Built, Site};
use serde::Serialize;

use super::output::{print_json, say};
use super::progress::Progress;
use super::setup::Gl;

/// Write the papers as a site: chapters, figures, methods, glossary
///
/// The pages need neither a server nor a network: open index.html in a browser. The folder is made if it is missing. It must
/// have nothing but files of the same edition. A figure that is whole is kept, so an interrupted command continues when it
/// is repeated.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Edition {
    /// The folder of the pages. It is made if it is missing
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Small pictures, and fewer of them: to try it, and for tests
    #[arg(long)]
    quick: bool,
    #[command(flatten)]
    gl: Gl,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin edition -o site           then open site/index.html
  onionskin edition -o site --quick   the same with small pictures, in about a minute";

/// The JSON object of an edition.
#[derive(Serialize)]
struct Done<'a> {
    pages: usize,
    figures_made: usize,
    figures_kept: usize,
    start: &'a Path,
}

impl Edition {
    pub(super) fn run(self) -> Result<ExitCode> {
        let context = self.gl.context()?;
        let site = Site::open(&self.output, &context, self.quick)?;
        let progress = Progress::new(site.parts() as u64, "");
        let mut begun = false;
        let built = site.write(&mut |part| {
            if begun {
                progress.part_done();
            }
            begun = true;
            progress.next(part);
        })?;
        drop(progress);
        self.report(built)?;
        Ok(ExitCode::SUCCESS)
    }

    fn report(&self, built: Built) -> Result<()> {
        let start = &self.output.join("index.html");
        let Built {
            pages, made, kept, ..
        } = built;
        if self.json {
            return print_json(&Done {
                pages,
                figures_made: made,
                figures_kept: kept,
                start,
            });
        }
        let start = start.display();
        say(format_args!(
            "{pages} pages, {made} figures made and {kept} kept: open {start}"
        ))
    }
}
