//! NRRD, header and samples in one.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| folder::Folder::of_volume("v.nrrd"));

fuzz_target!(|bytes: &[u8]| {
    FOLDER.write("v.nrrd", bytes);
    folder::load(FOLDER.path("scene.toml"));
});
