//! What EGL's and OSMesa's contexts have in common.

use crate::words::words;

/// The profile of OpenGL.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Profile {
    /// The core profile, without the functions that OpenGL 3.1 removed.
    #[default]
    Core,
    /// The compatibility profile, with the old fixed functions.
    Compatibility,
}

words! { Profile, "profile of OpenGL",
    Core "core" "Without the functions that OpenGL 3.1 removed",
    Compatibility "compatibility" "With the old fixed functions",
}

/// A headless context. It ends when this is dropped.
pub(super) trait Current {
    /// The address of a function.
    fn function(&self, name: &str) -> *const std::ffi::c_void;

    /// Whether its library has it current on this thread.
    fn is_current(&self) -> bool;

    /// Makes it current on this thread, on which no other library may have a current context.
    fn make_current(&self) -> Result<(), String>;

    /// Releases it.
    fn release(&self);
}

/// An error with its reasons, because libloading by itself says only 'dlopen failed'. A reason that the error names
/// already is not repeated.
pub(super) fn with_reasons(error: &dyn std::error::Error) -> String {
    let mut text = error.to_string();
    for reason in std::iter::successors(error.source(), |reason| reason.source()) {
        let reason = reason.to_string();
        if !text.ends_with(&reason) {
            text = format!("{text}: {reason}");
        }
    }
    text
}
