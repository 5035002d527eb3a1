//! What the examples share: the folder of their scenes, and the folder for their pictures.

use std::path::{Path, PathBuf};

/// A file in the folder that the first argument names, or in `out` without an argument. The folder is made if it is
/// missing.
#[allow(dead_code)] // a window writes none
pub fn output(name: &str) -> onionskin::Result<PathBuf> {
    let folder = PathBuf::from(std::env::args().nth(1).unwrap_or_else(|| "out".into()));
    std::fs::create_dir_all(&folder).map_err(|e| {
        let what = format!("cannot make the folder {}: {e}", folder.display());
        onionskin::Error::usage(what, "name another one")
    })?;
    Ok(folder.join(name))
}

/// A bundled scene file.
#[allow(dead_code)] // the first example makes its own
pub fn scene(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("examples/scenes")
        .join(name)
}
