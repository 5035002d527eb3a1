//! Scripts as pages have them.

/// A script without the lines that are comments or empty, and without indentation. What is left are the same statements, in
/// the same order. No text of a script may go on behind the end of its line.
pub fn compact(script: &str) -> String {
    let mut kept = String::with_capacity(script.len());
    let mut in_comment = false;
    for line in script.lines().map(str::trim) {
        let begins = line.starts_with("/*");
        if !(in_comment || begins || line.is_empty() || line.starts_with("//")) {
            kept.push_str(line);
            kept.push('\n');
        }
        in_comment = (in_comment || begins) && !line.ends_with("*/");
    }
    kept
}

/// The machine that runs programs ([`program_json`](super::program_json)): a classic script with the one global `onionskin`.
pub fn machine() -> String {
    compact(include_str!("web/machine.js"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn comments_and_indentation_are_left_out() {
        let script = "/** A\n * b */\nlet a = 1; // kept\n\n  // c\n  /* d */\n  a += 1;\n";
        assert_eq!(compact(script), "let a = 1; // kept\na += 1;\n");
    }

    #[test]
    fn the_machine_leaves_room_for_what_shows_it() {
        let size = machine().len();
        assert!(size < 36 * 1024, "{size}");
    }
}
