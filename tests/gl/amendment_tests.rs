//! The tests that amendments name, as far as they draw with OpenGL, exist.

use crate::kit::amendment_tests::{IN_GL, compiled};

#[test]
fn the_tests_that_amendments_name_are_compiled() {
    let compiled = compiled();
    let missing = IN_GL.iter().filter(|name| !compiled.contains(**name));
    let missing: Vec<_> = missing.collect();
    assert!(missing.is_empty(), "no such tests here: {missing:?}");
    assert!(!compiled.contains("no_such_test"));
}
