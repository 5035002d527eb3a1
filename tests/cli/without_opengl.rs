//! Without OpenGL: what is said of it, and what works all the same.

// Where the dynamic linker looks first is known of Linux.
#![cfg(target_os = "linux")]

use std::fs::File;

use crate::kit::cli::{Desk, SQUARE};

/// A desk on which no OpenGL can be loaded: empty files stand where the dynamic linker looks first.
fn without_gl() -> (tempfile::TempDir, Desk) {
    let folder = tempfile::tempdir().expect("a folder");
    for name in [
        "libEGL.so.1",
        "libEGL.so",
        "libOSMesa.so.8",
        "libOSMesa.so.6",
        "libOSMesa.so",
    ] {
        File::create(folder.path().join(name)).expect("a file");
    }
    let desk = Desk::new()
        .with("m.obj", SQUARE)
        .with("kept.png", "the picture of yesterday")
        .with_variable("LD_LIBRARY_PATH", folder.path().to_string_lossy())
        .with_variable("ONIONSKIN_BACKEND", "");
    (folder, desk)
}

#[test]
fn without_opengl_every_attempt_is_listed_with_its_answer() {
    let (_folder, desk) = without_gl();
    for output in ["new.png", "kept.png"] {
        desk.refused(&["render", "m.obj", "-o", output]).says(&[
            "no OpenGL 4.3",
            "\n  egl, loading libEGL.so.1: ",
            "\n  osmesa, loading libOSMesa.so.8: ",
            // What the dynamic linker says of an empty file.
            "libOSMesa.so.8: file too short",
        ]);
    }
}

#[test]
fn without_opengl_the_packages_are_named_that_bring_it() {
    let (_folder, desk) = without_gl();
    let answer = desk.refused(&["compare", "m.obj"]);
    answer.says(&["apt install libegl1 libgl1-mesa-dri", "libosmesa6"]);
    answer.says(&["dnf install mesa-libEGL", "pacman -S mesa"]);
}

#[test]
fn without_opengl_only_the_backend_that_was_asked_for_is_tried() {
    let (_folder, desk) = without_gl();
    let answer = desk.refused(&["render", "m.obj", "-o", "new.png", "--backend", "osmesa"]);
    answer.says(&["libOSMesa.so.8"]);
    assert!(!answer.err.contains("libEGL.so.1"), "{answer}");
}

#[test]
fn without_opengl_the_doctor_says_of_each_backend_why_and_ends_with_2() {
    let (_folder, desk) = without_gl();
    let answer = desk.run(&["doctor"]);
    assert_eq!(answer.code, 2, "{answer}");
    answer.says(&["apt install"]);
    assert_eq!(answer.out.matches("does not work").count(), 2, "{answer}");
}

#[test]
fn without_opengl_the_doctors_json_has_an_object_for_each_backend() {
    let (_folder, desk) = without_gl();
    let answer = desk.run(&["doctor", "--json"]);
    assert_eq!(answer.code, 2, "{answer}");
    for (object, backend) in answer.objects().iter().zip(["egl", "osmesa"]) {
        assert_eq!(object["backend"], backend);
        assert_eq!(object["works"], false);
        assert!(object["answer"].is_string(), "{answer}");
    }
    assert_eq!(answer.objects().len(), 2, "{answer}");
}

#[test]
fn without_opengl_the_help_the_listings_and_the_methods_work() {
    let (_folder, desk) = without_gl();
    for arguments in [["--help"], ["listing"], ["methods"]] {
        desk.result(&arguments);
    }
}

#[test]
fn without_opengl_bad_input_is_still_what_is_said_first() {
    let (_folder, desk) = without_gl();
    desk.with("bad.obj", "f 1 2 3\n")
        .refused(&["render", "bad.obj", "-o", "new.png"])
        .says(&["bad.obj:1: '1': "]);
}
