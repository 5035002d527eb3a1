//! Making other people's text fit for a terminal.
//!
//! File names, names of meshes and words of files may hold anything: sequences that colour, move or clear a terminal,
//! marks that turn the direction of writing, line ends that make a message look like two. If they were printed raw,
//! they would have these effects.

use std::borrow::Cow;
use std::fmt::Write;

/// The text with every character escaped, as in `\u{1b}`, that affects a terminal or is invisible: control characters
/// including line ends, marks of the direction of writing, and characters without width.
pub fn printable(text: &str) -> Cow<'_, str> {
    escaped(text, is_harmless)
}

/// The same for text of our own that contains other people's words. Line ends and tabs stay.
pub fn printable_lines(text: &str) -> Cow<'_, str> {
    escaped(text, |c| matches!(c, '\n' | '\t') || is_harmless(c))
}

/// The same for JSON. The result is the same JSON, because such characters only occur in its strings.
pub fn printable_json(json: &str) -> Cow<'_, str> {
    if json.chars().all(is_harmless) {
        return Cow::Borrowed(json);
    }
    let mut shown = String::with_capacity(json.len() + 16);
    for c in json.chars() {
        if is_harmless(c) {
            shown.push(c);
        } else {
            for unit in c.encode_utf16(&mut [0; 2]) {
                // Writing to a string does not fail.
                _ = write!(shown, "\\u{unit:04x}");
            }
        }
    }
    Cow::Owned(shown)
}

fn escaped(text: &str, is_left: impl Fn(char) -> bool) -> Cow<'_, str> {
    if text.chars().all(&is_left) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        match c {
            c if is_left(c) => shown.push(c),
            '\n' => shown.push_str("\\n"),
            '\r' => shown.push_str("\\r"),
            '\t' => shown.push_str("\\t"),
            // Writing to a string does not fail.
            c => _ = write!(shown, "{}", c.escape_unicode()),
        }
    }
    Cow::Owned(shown)
}

/// Whether a character is visible and has no other effect. `is_control` covers C0, DEL and C1.
fn is_harmless(c: char) -> bool {
    !c.is_control()
        && !matches!(
            c,
            // Soft hyphen, the Arabic letter mark, the Mongolian vowel separator.
            '\u{ad}' | '\u{61c}' | '\u{180e}'
            // Zero width, and marks of direction.
            | '\u{200b}'..='\u{200f}'
            // Line and paragraph separators, embeddings and overrides of direction.
            | '\u{2028}'..='\u{202e}'
            // Invisible operators, isolates of direction, deprecated controls.
            | '\u{2060}'..='\u{206f}'
            // The byte order mark, and annotations.
            | '\u{feff}' | '\u{fff9}'..='\u{fffb}'
            // Tags.
            | '\u{e0000}'..='\u{e007f}'
        )
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn text_that_can_be_seen_is_left_alone() {
        for text in [
            "",
            "teapot.obj",
            "Müller's \"model\" \\ 1",
            "模型 модель",
            "é e\u{301} 😀",
        ] {
            assert!(matches!(printable(text), Cow::Borrowed(same) if same == text));
        }
    }

    #[test]
    fn what_would_move_a_terminal_or_mislead_a_reader_is_spelt_out() {
        assert_eq!(printable("\u{1b}[2Jx"), "\\u{1b}[2Jx");
        assert_eq!(printable("a\nb\r\tc"), "a\\nb\\r\\tc");
        assert_eq!(printable("\u{9b}31m\u{7f}"), "\\u{9b}31m\\u{7f}");
        assert_eq!(printable("gpj.\u{202e}exe"), "gpj.\\u{202e}exe");
        assert_eq!(printable("a\u{200b}b\u{2066}"), "a\\u{200b}b\\u{2066}");
        assert_eq!(printable_lines("a\n\u{7}\tb"), "a\n\\u{7}\tb");
    }

    proptest! {
        #[test]
        fn of_any_text_nothing_is_left_that_does_something(text in any::<String>()) {
            prop_assert!(printable(&text).chars().all(is_harmless));
            let lines = printable_lines(&text);
            prop_assert!(lines.chars().all(|c| c == '\n' || c == '\t' || is_harmless(c)));
            prop_assert_eq!(lines.lines().count(), text.lines().count());
            let json = serde_json::to_string(&text).unwrap();
            let shown = printable_json(&json);
            prop_assert!(shown.chars().all(is_harmless));
            prop_assert_eq!(serde_json::from_str::<String>(&shown).unwrap(), text);
        }
    }
}
