//! Reading the command line.

use std::ffi::OsString;
use std::process::ExitCode;

use clap::Parser;
use onionskin::low_level::error::printable;

use super::output::complain;

/// The parsed arguments. If they ask for help or are wrong, this prints the help or the error, and returns the exit
/// code.
pub(super) fn parse<T: Parser>() -> Result<T, ExitCode> {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    T::try_parse_from(&arguments).map_err(|error| {
        if error.use_stderr() {
            complain(message(&error, &arguments).trim_end());
            return ExitCode::from(2);
        }
        // Help contains no text of the arguments. Its reader may stop before the end.
        let _ = error.print();
        ExitCode::SUCCESS
    })
}

/// The message without colours, because their sequences could not be told from sequences in the arguments.
fn message(error: &clap::Error, arguments: &[OsString]) -> String {
    let text = error.render().to_string();
    // A line end within an argument is not a line end of the message.
    let words = arguments.iter().map(|argument| argument.to_string_lossy());
    let words = words.filter(|word| word.contains(char::is_control));
    words.fold(text, |text, word| {
        let value = word.split_once('=').map_or(&*word, |(_, value)| value);
        let text = text.replace(&*word, &printable(&word));
        text.replace(value, &printable(value))
    })
}
