//! Environment variables that change which OpenGL there is: a picture comes out, or an error that names the variable.

#![cfg(target_os = "linux")]

use onionskin::Context;

use crate::kit::cli::{Answer, Desk, SQUARE};
use crate::kit::driver::is_mesa;

fn render(name: &str, value: &str) -> (Desk, Answer) {
    let desk = Desk::new()
        .with("m.obj", SQUARE)
        .with_variable(name, value)
        // Of these a machine's own would be to blame as well.
        .with_variable("ONIONSKIN_BACKEND", "");
    let answer = desk.run(&["render", "m.obj", "-o", "m.png", "--size", "16x12"]);
    (desk, answer)
}

/// Whether there is a picture; if not, the message names the variable and its value.
fn picture_or_blame(name: &str, value: &str) -> bool {
    let (desk, answer) = render(name, value);
    let rendered = answer.code == 0;
    assert_eq!(
        desk.names().contains(&"m.png".to_owned()),
        rendered,
        "{answer}"
    );
    if !rendered {
        assert_eq!(answer.code, 2, "{answer}");
        answer.says(&[
            "no OpenGL 4.3 driver was found",
            &format!("{name}={value}"),
            &format!("unset {name}"),
        ]);
    }
    rendered
}

#[test]
fn a_driver_that_is_not_there_is_named_with_the_variable() {
    if !is_mesa(&Context::headless().unwrap()) {
        return;
    }
    for driver in ["wrong", "swr", "d3d12", "virpipe", "a\u{1b}[31mb"] {
        let (_desk, answer) = render("GALLIUM_DRIVER", driver);
        assert_eq!(answer.code, 2, "{answer}");
        answer.says(&["GALLIUM_DRIVER=", "unset GALLIUM_DRIVER"]);
        assert!(!answer.err.contains('\u{1b}'), "{answer}");
    }
}

#[test]
fn the_doctor_survives_a_driver_that_is_not_there() {
    if !is_mesa(&Context::headless().unwrap()) {
        return;
    }
    for driver in ["wrong", "virpipe"] {
        let answer = Desk::new()
            .with_variable("GALLIUM_DRIVER", driver)
            .run(&["doctor"]);
        assert_eq!(answer.code, 2, "{answer}");
        answer.says(&["GALLIUM_DRIVER="]);
        assert_eq!(answer.out.matches("does not work").count(), 2, "{answer}");
    }
}

#[test]
fn a_version_that_a_variable_hides_is_said_to_be_hidden() {
    if !is_mesa(&Context::headless().unwrap()) {
        return;
    }
    for version in ["3.3", "4.2", "3.1"] {
        assert!(
            !picture_or_blame("MESA_GL_VERSION_OVERRIDE", version),
            "{version}"
        );
    }
    let (_desk, answer) = render("MESA_GL_VERSION_OVERRIDE", "3.3");
    answer.says(&[
        "the driver offers only OpenGL 3.3",
        "MESA_GL_VERSION_OVERRIDE=3.3 hides what it has",
    ]);
}

#[test]
fn a_shading_language_that_a_variable_hides_is_said_to_be_hidden() {
    if !is_mesa(&Context::headless().unwrap()) {
        return;
    }
    for version in ["130", "330", "420"] {
        assert!(
            !picture_or_blame("MESA_GLSL_VERSION_OVERRIDE", version),
            "{version}"
        );
    }
}

#[test]
fn every_variable_that_does_harm_is_named() {
    for (name, value) in [
        ("GALLIUM_DRIVER", "softpipe"),
        ("GALLIUM_DRIVER", "zink"),
        ("MESA_LOADER_DRIVER_OVERRIDE", "zink"),
        ("MESA_LOADER_DRIVER_OVERRIDE", "wrong"),
        (
            "MESA_EXTENSION_OVERRIDE",
            "-GL_ARB_shader_storage_buffer_object",
        ),
        ("LIBGL_DRIVERS_PATH", "/nowhere"),
        ("LIBGL_ALWAYS_SOFTWARE", "1"),
        ("LIBGL_ALWAYS_SOFTWARE", "0"),
        ("EGL_PLATFORM", "wrong"),
        ("EGL_PLATFORM", "x11"),
        ("__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere"),
        ("MESA_GL_VERSION_OVERRIDE", "wrong"),
        ("MESA_GLSL_VERSION_OVERRIDE", "wrong"),
        ("DRAW_USE_LLVM", "0"),
    ] {
        let rendered = picture_or_blame(name, value);
        println!(
            "{name}={value}: {}",
            if rendered { "a picture" } else { "named" }
        );
    }
}

#[test]
fn without_any_of_them_nothing_is_blamed() {
    let (_desk, answer) = render("ONIONSKIN_SEED", "1");
    assert_eq!(answer.code, 0, "{answer}");
    assert!(!answer.err.contains("variable"), "{answer}");
}

#[test]
fn the_doctor_says_that_osmesa_is_optional_where_egl_is_there() {
    let answer = Desk::new().run(&["doctor", "--json"]);
    let objects = answer.objects();
    assert_eq!(objects[0]["backend"], "egl");
    let egl = objects[0]["works"] == true;
    let osmesa = &objects[1];
    assert_eq!(objects[0]["optional"], false);
    assert_eq!(osmesa["optional"], egl && osmesa["works"] == false);
    if osmesa["optional"] == true {
        let answer = Desk::new().run(&["doctor"]);
        assert_eq!(answer.code, 0, "{answer}");
        assert!(answer.out.contains("not there, and not needed"), "{answer}");
    }
}
