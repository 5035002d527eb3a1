//! EXR pictures, as `check` reads them.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use onionskin::Image;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| folder::Folder::with("empty", ""));

fuzz_target!(|bytes: &[u8]| {
    let _ = Image::load(FOLDER.write("picture.exr", bytes));
});
