//! NRRD's header in a file of its own: what the first empty line ends is the header, the rest is the file `v.raw`.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| folder::Folder::of_volume("v.nhdr"));

fuzz_target!(|bytes: &[u8]| {
    let end = bytes.windows(2).position(|pair| pair == b"\n\n");
    let (head, data) = bytes.split_at(end.map_or(bytes.len(), |end| end + 2));
    FOLDER.write("v.nhdr", head);
    FOLDER.write("v.raw", data);
    folder::load(FOLDER.path("scene.toml"));
});
