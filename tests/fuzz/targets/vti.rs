//! VTK's ImageData.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| folder::Folder::of_volume("v.vti"));

fuzz_target!(|bytes: &[u8]| {
    FOLDER.write("v.vti", bytes);
    folder::load(FOLDER.path("scene.toml"));
});
