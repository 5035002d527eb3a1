//! The bundled scenes. Their files are part of the program, and are unpacked into a temporary folder, from which they are
//! loaded as any other scene is.

use std::fs;
use std::path::PathBuf;

use tempfile::TempDir;

use crate::error::{Error, Result};

/// The folder of the bundled scenes, which is removed at the end.
pub(super) struct Scenes(TempDir);

/// The files, by their paths.
macro_rules! files {
    ($($path:literal,)*) => {
        &[$(($path, include_bytes!(concat!("../../../examples/", $path)))),*]
    };
}

const FILES: &[(&str, &[u8])] = files! {
    "data/molecule/ligand_ballstick.obj",
    "data/molecule/pot_neg.obj",
    "data/molecule/pot_pos.obj",
    "data/molecule/potential_fine.nrrd",
    "data/molecule/potential_wide.nrrd",
    "data/molecule/ribbon.obj",
    "data/molecule/surface.obj",
    "scenes/flow.toml",
    "scenes/fog.toml",
    "scenes/knots.toml",
    "scenes/medical.toml",
    "scenes/molecule.toml",
    "scenes/molecule_fused.toml",
    "scenes/quads.toml",
    "scenes/sheets64.toml",
    "scenes/slices.toml",
    "scenes/soup.toml",
    "scenes/space.toml",
    "scenes/teapot.toml",
};

impl Scenes {
    pub(super) fn unpacked() -> Result<Self> {
        let unpack = || -> std::io::Result<TempDir> {
            let folder = tempfile::tempdir()?;
            fs::create_dir_all(folder.path().join("data/molecule"))?;
            fs::create_dir(folder.path().join("scenes"))?;
            for (path, bytes) in FILES {
                fs::write(folder.path().join(path), bytes)?;
            }
            Ok(folder)
        };
        unpack().map(Self).map_err(|error| Error::Output {
            path: std::env::temp_dir(),
            what: format!("the bundled scenes cannot be unpacked there: {error}"),
            remedy: "Set TMPDIR to a folder that can be written to and has 10 MB free.".into(),
            source: Some(error),
        })
    }

    pub(super) fn path(&self, name: &str) -> PathBuf {
        self.0.path().join("scenes").join(format!("{name}.toml"))
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;

    #[test]
    fn every_bundled_scene_is_part_of_the_program() {
        let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
        let mut there = BTreeSet::new();
        for folder in ["scenes", "data/molecule"] {
            for entry in fs::read_dir(examples.join(folder)).unwrap() {
                let name = entry.unwrap().file_name().into_string().unwrap();
                there.insert(format!("{folder}/{name}"));
            }
        }
        there.remove("data/molecule/NOTICE.md");
        let ours: BTreeSet<_> = FILES.iter().map(|(path, _)| path.to_string()).collect();
        assert_eq!(ours, there);
    }
}
