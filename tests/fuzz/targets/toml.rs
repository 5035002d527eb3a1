//! Scene files. What a file generates may be as large as the file asks for, so that here it stays small.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> =
    LazyLock::new(|| folder::Folder::with("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));

fuzz_target!(|bytes: &[u8]| {
    folder::load(FOLDER.write("scene.toml", bytes));
});
