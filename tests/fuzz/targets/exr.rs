//! EXR pictures, as `check` reads them.
#![no_main]

mod folder;

use std::sync::LazyLock;

use libfuzzer_sys::fuzz_target;
use onionskin::Image;

static FOLDER: LazyLock<folder::Folder> = LazyLock::new(|| folder::Folder::with("empty", ""));

// A decoder's panic that the reader turns into words is none: the hook would end the process all the same.
fuzz_target!(init: std::panic::set_hook(Box::new(|_| ())), |bytes: &[u8]| {
    let _ = Image::load_within(FOLDER.write("picture.exr", bytes), &folder::memory());
});
