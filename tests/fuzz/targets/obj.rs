//! Wavefront models.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> =
    LazyLock::new(|| folder::Folder::with("model.mtl", "newmtl red\nKd 1 0 0\nd 0.5\n"));

fuzz_target!(|bytes: &[u8]| {
    folder::load(FOLDER.write("model.obj", bytes));
});
