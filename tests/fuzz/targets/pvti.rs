//! VTK's images in several files: what the first empty line ends names the others, the rest is the file `a.vti`.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| folder::Folder::of_volume("v.pvti"));

fuzz_target!(|bytes: &[u8]| {
    let end = bytes.windows(2).position(|pair| pair == b"\n\n");
    let (head, piece) = bytes.split_at(end.map_or(bytes.len(), |end| end + 2));
    FOLDER.write("v.pvti", head);
    FOLDER.write("a.vti", piece);
    folder::load(FOLDER.path("scene.toml"));
});
