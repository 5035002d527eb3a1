//! The library's errors, with the arguments that put them right. The library itself names none.

use onionskin::Error;

/// What is said about an error on the command line.
pub(super) fn explained(error: &Error) -> String {
    match error {
        Error::Option { option, .. } => format!("--{option}: {error}"),
        Error::Memory { .. } => format!("{error} (--max-memory)"),
        _ => error.to_string(),
    }
}
