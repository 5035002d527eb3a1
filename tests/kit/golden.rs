//! Text that is kept: `BLESS=1 cargo test` rewrites it, and the diff is read before it is committed.

use std::path::Path;

use super::diff::diff;

/// Holds `actual` against a file of `tests/transcripts/`.
pub fn assert_golden(name: &str, actual: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/transcripts")
        .join(name);
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, actual).unwrap();
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    let difference = diff(&kept, actual);
    assert!(
        difference.is_empty(),
        "{} differs (BLESS=1 rewrites it):\n{difference}",
        path.display()
    );
}
