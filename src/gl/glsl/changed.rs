//! Shaders with one changed word, for tests that have to notice it.

use std::cell::RefCell;

/// In a file of `glsl/`, what stands there, and what is to stand there instead.
pub(crate) type Change = [&'static str; 3];

thread_local! {
    static CHANGE: RefCell<Option<Change>> = const { RefCell::new(None) };
}

/// Does something while a shader is another one. Programs that were linked before stay as they are.
pub(crate) fn changing<T>(change: Change, then: impl FnOnce() -> T) -> T {
    CHANGE.set(Some(change));
    let result = then();
    CHANGE.set(None);
    result
}

/// The file's text.
///
/// # Panics
/// What is to be changed does not stand in it, or more than once.
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
