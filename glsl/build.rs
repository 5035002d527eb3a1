//! Writes the table of the shaders: every file of `glsl/` with its text, but this one. So a new shader is a new file, and nothing else.
//!
//! A build script rather than a crate such as `include_dir`, because it is as short as the use of one would be, and
//! because Cargo watches a folder for a build script, but not for a macro: a file that comes or goes would not be noticed.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=glsl/build.rs");
    println!("cargo::rerun-if-changed=glsl");
    let folder = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("Cargo sets it")).join("glsl");
    let mut files = files_in(&folder)?;
    files.sort();
    let rows = files.iter().map(|file| {
        let parts = file
            .strip_prefix(&folder)
            .expect("it lies in the folder")
            .iter();
        let name: Vec<_> = parts.map(|part| part.to_string_lossy()).collect();
        format!("({:?}, include_str!({file:?})),\n", name.join("/"))
    });
    let table = format!("&[\n{}]\n", rows.collect::<String>());
    let out = PathBuf::from(env::var("OUT_DIR").expect("Cargo sets it"));
    fs::write(out.join("shaders.rs"), table)
}

/// Every file in a folder and the folders inside of it.
fn files_in(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            files.extend(files_in(&path)?);
        } else if path.extension().is_none_or(|ending| ending != "rs") {
            files.push(path);
        }
    }
    Ok(files)
}
