//! Results do not depend on how many threads the driver rasterises with. llvmpipe reads their number when it is loaded,
//! so each number gets a process of its own.

use std::fs;
use std::process::Command;

fn image(threads: u32, method: &str) -> Vec<u8> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("image.exr");
    let output = Command::new(env!("CARGO_BIN_EXE_onionskin"))
        .args([
            "render",
            "examples/scenes/knots.toml",
            "--size",
            "140x100",
            "-m",
            method,
            "-o",
        ])
        .arg(&path)
        .env("LP_NUM_THREADS", threads.to_string())
        .output()
        .unwrap();
    assert!(
        output.status.success(),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    fs::read(path).unwrap()
}

#[test]
fn every_exact_method_gives_the_same_image_with_any_number_of_threads() {
    for entry in onionskin::registry().iter().filter(|entry| entry.exact) {
        let context = onionskin::Context::headless().unwrap();
        if !entry.runs_on(context.driver()) {
            println!("skipped: {} needs {:?}", entry.name, entry.needs);
            continue;
        }
        let alone = image(0, entry.name);
        for threads in [1, 2, 7] {
            assert!(
                image(threads, entry.name) == alone,
                "{}, {threads} threads",
                entry.name
            );
        }
    }
}
