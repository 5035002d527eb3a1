//! Standard output has results and nothing else; standard error has notes and errors.
//!
//! Everything is printed from here. No character of a file or of an argument that affects a terminal gets through.

use std::fmt::Display;
use std::io::{ErrorKind, Write, stderr, stdout};

use clap::builder::styling::Style;
use onionskin::low_level::error::{printable, printable_json, printable_lines};
use onionskin::{Error, Result};
use serde::Serialize;

use super::flags::explained;

/// Prints a result. Its reader may stop before the end (`| head`), which is not an error.
pub(super) fn say(text: impl Display) -> Result<()> {
    print(&printable_lines(&text.to_string()))
}

/// Prints a result's lines in their styles, which only a terminal gets that wants colours (`NO_COLOR`).
pub(super) fn say_styled(lines: &[(Style, String)]) -> Result<()> {
    let styled = |(style, line): &(Style, String)| format!("{style}{}{style:#}", printable(line));
    let lines: Vec<_> = lines.iter().map(styled).collect();
    print_to(anstream::stdout(), &lines.join("\n"))
}

/// Prints one JSON object on a line of its own.
pub(super) fn print_json(record: &impl Serialize) -> Result<()> {
    let line = serde_json::to_string(record)
        .map_err(|e| Error::usage(format!("cannot write JSON: {e}"), "leave out --json"))?;
    print(&printable_json(&line))
}

/// Prints a note besides the result, in one line.
pub(super) fn note(text: impl Display) {
    complain(&format!("note: {}", printable(&text.to_string())));
}

/// Prints the error that there is instead of a result.
pub(super) fn fail(error: &Error) {
    complain(&format!("onionskin: {}", explained(error)));
}

/// If standard error is broken, nobody can be told, and the exit code says enough.
pub(super) fn complain(text: &str) {
    let _ = writeln!(stderr(), "{}", printable_lines(text));
}

fn print(text: &str) -> Result<()> {
    print_to(stdout(), text)
}

fn print_to(mut out: impl Write, text: &str) -> Result<()> {
    match writeln!(out, "{text}").and_then(|()| out.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(Error::Output {
            path: "standard output".into(),
            what: error.to_string(),
            remedy: "check where it is redirected to, and that the disk has room".into(),
            source: Some(error),
        }),
        _ => Ok(()),
    }
}
