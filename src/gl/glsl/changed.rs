//! Shaders with one changed word, which tests must notice.

use std::cell::RefCell;

/// A file of `glsl/`, a text in it, and the text that replaces it.
pub(crate) type Change = [&'static str; 3];

thread_local! {
    static CHANGE: RefCell<Option<Change>> = const { RefCell::new(None) };
}

/// Runs `work` with a changed shader. Programs that were linked before do not change.
pub(crate) fn changing<T>(change: Change, then: impl FnOnce() -> T) -> T {
    CHANGE.set(Some(change));
    let result = then();
    CHANGE.set(None);
    result
}

/// The file's text.
///
/// # Panics
/// If the text to be replaced is missing, or occurs more than once.
pub(super) fn text(file: &str, text: &'static str) -> &'static str {
    CHANGE.with_borrow(|change| match *change {
        Some([wanted, from, to]) if wanted == file => {
            assert_eq!(text.matches(from).count(), 1, "'{from}' in glsl/{file}");
            // A test can spare it.
            text.replace(from, to).leak()
        }
        _ => text,
    })
}
