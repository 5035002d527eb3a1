//! `onionskin doctor`: which OpenGL is there, and what will not work with it.

use std::process::ExitCode;

use clap::Args;
use onionskin::{Backend, Error, Result};

use super::driver_report::{Form, Report};
use super::output::say;
use super::probe;

/// Report which OpenGL is there and what will not work with it
///
/// Tries every backend. For each, it prints the renderer, its version, its limits, the extensions that methods need,
/// and the driver's known traps. One backend is enough. OSMesa is optional, and Mesa 25.1 and later do not have it. If
/// no backend works, it exits with 2 and says what to install.
#[derive(Args)]
pub(super) struct Doctor {
    /// Print one JSON object per backend and nothing else
    #[arg(long)]
    json: bool,
}

impl Doctor {
    pub(super) fn run(self) -> Result<ExitCode> {
        let mut errors = Vec::new();
        let mut works = false;
        let form = if self.json { Form::Json } else { Form::Text };
        for backend in [Backend::Egl, Backend::OsMesa] {
            match probe::report(backend, form) {
                Ok(report) => {
                    works = true;
                    say(report.trim_end())?;
                }
                Err(Error::NoContext { mut tried }) => {
                    tried.retain(|attempt| !errors.contains(attempt));
                    let answers = tried
                        .iter()
                        .map(|attempt| format!("{}: {}", attempt.what, attempt.answer));
                    let answer = answers.collect::<Vec<_>>().join("; ");
                    errors.extend(tried);
                    // If EGL works, nothing is missing.
                    Report::failed(backend, answer, works).print(form)?;
                }
                Err(error) => return Err(error),
            }
        }
        if works {
            Ok(ExitCode::SUCCESS)
        } else {
            Err(Error::NoContext { tried: errors })
        }
    }
}
