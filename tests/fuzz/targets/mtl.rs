//! The materials of Wavefront models.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| {
    folder::Folder::with(
        "model.obj",
        "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n",
    )
});

fuzz_target!(|bytes: &[u8]| {
    FOLDER.write("model.mtl", bytes);
    folder::load(FOLDER.path("model.obj"));
});
