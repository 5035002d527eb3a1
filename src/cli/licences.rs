//! `onionskin licences`: the licences of the program and of the files that are embedded in it.

use std::process::ExitCode;

use clap::Args;
use onionskin::Result;

use super::output::say;

/// Print the licences of the program and of the font that is embedded in it
///
/// A copy of the binary must come with these texts. The binary contains them, so that it always does.
#[derive(Args)]
pub(super) struct Licences {}

/// The font of plots, as the font's name table describes it, and its licence, which must go with every copy.
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
