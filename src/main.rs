//! The command line. Exit codes: 0, done; 1, `check` found a difference; 2, it could not be done, and why.

mod cli;

use std::process::ExitCode;

fn main() -> ExitCode {
    cli::run()
}
