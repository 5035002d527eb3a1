//! The command line: one file per subcommand. This file has what they share.

mod animate;
mod arguments;
mod bench;
mod check;
mod chosen;
mod claims;
mod compare;
mod complexity;
mod doctor;
mod driver_report;
mod edition;
mod encoding;
mod errata;
mod flags;
mod frame_folder;
mod frame_row;
mod inspect;
mod ledger;
mod licences;
mod listing;
mod loss;
mod memory;
mod method_options;
mod methods;
mod output;
mod probe;
mod progress;
mod record;
mod render;
mod setup;
mod slices;
mod stages;
mod words;

use std::process::ExitCode;

use clap::{Parser, Subcommand};

/// Correct transparency as it was published, run headless.
///
/// Renders scenes of transparent surfaces by the methods of four publications, compares the images with an exact one,
/// counts layers, and prints the listings that it runs. Needs OpenGL 4.3, but neither a display nor a GPU: Mesa's
/// software renderer will do.
#[derive(Parser)]
#[command(version, after_help = EXAMPLES)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

const EXAMPLES: &str = "\
Examples:
  onionskin doctor                                     is a suitable OpenGL there?
  onionskin render model.obj -o model.png              the exact image of a model
  onionskin compare examples/scenes/teapot.toml        how wrong and how slow each method is
  onionskin bench examples/scenes/teapot.toml          what each method costs, relative to plain blending
  onionskin check examples/scenes/teapot.toml my.png   is my renderer's image right?
  onionskin complexity examples/scenes/teapot.toml     how many layers each pixel has
  onionskin inspect scene.toml --worst -m painter      what happened to each fragment of a pixel
  onionskin animate scene.toml -o frames               a camera path as pictures and a table
  onionskin listing everitt/listing-1                  what depth peeling does, as the paper has it
  onionskin claims everitt                             what a paper claims, and whether it is true
  onionskin edition -o site                            the papers as pages that run

`onionskin COMMAND --help` explains the arguments, `onionskin render --help` also scene files.
Results go to standard output; notes and errors go to standard error.
Exit codes: 0 done, 1 `check` found a difference, 2 the command failed.";

#[derive(Subcommand)]
enum Command {
    Render(render::Render),
    Compare(compare::Compare),
    Bench(bench::Bench),
    Check(check::Check),
    Complexity(complexity::Complexities),
    Inspect(inspect::Inspect),
    Animate(animate::Animate),
    Listing(listing::Listing),
    Claims(claims::Claims),
    Errata(errata::Errata),
    Edition(edition::Edition),
    Methods(methods::Methods),
    Doctor(doctor::Doctor),
    Licences(licences::Licences),
    /// For the program itself
    #[command(hide = true)]
    Probe(probe::Probe),
}

/// Runs the command line.
pub(crate) fn run() -> ExitCode {
    let command = match arguments::parse::<Cli>() {
        Ok(cli) => cli.command,
        Err(code) => return code,
    };
    let done = match command {
        Command::Render(render) => render.run(),
        Command::Compare(compare) => compare.run(),
        Command::Bench(bench) => bench.run(),
        Command::Check(check) => check.run(),
        Command::Complexity(complexity) => complexity.run(),
        Command::Inspect(inspect) => inspect.run(),
        Command::Animate(animate) => animate.run(),
        Command::Listing(listing) => listing.run(),
        Command::Claims(claims) => claims.run(),
        Command::Errata(errata) => errata.run(),
        Command::Edition(edition) => edition.run(),
        Command::Methods(methods) => methods.run(),
        Command::Doctor(doctor) => doctor.run(),
        Command::Licences(licences) => licences.run(),
        Command::Probe(probe) => probe.run(),
    };
    done.unwrap_or_else(|error| {
        output::fail(&error);
        ExitCode::from(2)
    })
}
