//! A scene file with one square.

use onionskin::Scene;

use super::Folder;

pub const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// A scene with the square as its only mesh and these further keys of it.
pub fn square_with(keys: &str) -> Result<Scene, onionskin::Error> {
    Folder::new()
        .with("square.obj", SQUARE)
        .with(
            "scene.toml",
            format!("[[mesh]]\nfile = \"square.obj\"\n{keys}\n"),
        )
        .load("scene.toml")
}

/// The same, loaded.
pub fn square(keys: &str) -> Scene {
    square_with(keys).unwrap_or_else(|error| panic!("{error}"))
}
