//! `onionskin licences`: under what the program and what is embedded in it may be passed on.

use std::process::ExitCode;

use clap::Args;
use onionskin::Result;

use super::output::say;

/// Print the licences of the program and of the font that is embedded in it
///
/// Whoever passes the binary on passes these texts on with it; the binary has them, so that they are never apart.
#[derive(Args)]
pub(super) struct Licences {}

/// The font of plots as its own name table has it, and its licence, which must go with every copy.
const FONT: &str = include_str!("licences/ubuntu_font_licence.txt");

impl Licences {
    pub(super) fn run(self) -> Result<ExitCode> {
        say(format_args!(
            "onionskin\n\n{}\n\nThe font of plots: Ubuntu Light\nCopyright 2011 Canonical Ltd.  Licensed under the Ubuntu Font \
             Licence 1.0\n\n{}",
            include_str!("../../LICENSE").trim_end(),
            FONT.trim_end()
        ))?;
        Ok(ExitCode::SUCCESS)
    }
}
