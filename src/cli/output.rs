//! Standard output: for results, and for nothing else.

use std::fmt::Display;
use std::io::{ErrorKind, Write, stdout};

use onionskin::{Error, Result};
use serde::Serialize;

/// Prints a result. Whoever reads it may stop before the end (`| head`), and that is no error.
pub(super) fn say(text: impl Display) -> Result<()> {
    match writeln!(stdout(), "{text}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::Output {
            path: "standard output".into(),
            what: error.to_string(),
            remedy: "check where it is redirected to, and that the disk has room".into(),
        }),
        _ => Ok(()),
    }
}

/// Prints one JSON object on a line of its own.
pub(super) fn print_json(record: &impl Serialize) -> Result<()> {
    let line = serde_json::to_string(record)
        .map_err(|e| Error::usage(format!("cannot write JSON: {e}"), "leave out --json"))?;
    say(line)
}
