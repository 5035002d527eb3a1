//! Input that is refused only where OpenGL is, or not at all. See `cli/bad_input.rs` for the rest.

use crate::kit::cli::{Desk, SQUARE};
use onionskin::{Context, Image};

const SMALL: [&str; 2] = ["--size", "16x12"];

#[track_caller]
fn rendered_with_a_note(desk: &Desk) -> String {
    let answer = desk.run(&[&["render", "m.obj", "-o", "m.png"], &SMALL[..]].concat());
    assert_eq!(answer.code, 0, "{answer}");
    let image = Image::load(desk.path("m.png")).expect("a picture");
    assert_eq!([image.width, image.height], [16, 12]);
    assert!(
        image.pixels.iter().any(|pixel| pixel.r > 0.0),
        "the square is in it"
    );
    assert_eq!(answer.err.lines().count(), 1, "{answer}");
    answer.err
}

#[test]
fn degenerate_triangles_are_skipped_counted_and_said() {
    let desk = Desk::new().with("m.obj", format!("{SQUARE}f 1 1 2\nf 3 3 3\nf 1 2 2\n"));
    let note = rendered_with_a_note(&desk);
    assert_eq!(note, "note: m.obj: 3 triangles without area skipped\n");
}

#[test]
fn a_missing_material_file_is_a_note_with_its_line() {
    let desk = Desk::new().with("m.obj", format!("# m\nmtllib m.mtl\n{SQUARE}"));
    let note = rendered_with_a_note(&desk);
    assert!(
        note.starts_with("note: m.obj:2: ") && note.contains("'m.mtl' is missing"),
        "{note}"
    );
}

#[test]
fn a_note_is_not_on_standard_output_with_json() {
    let desk = Desk::new().with("m.obj", format!("{SQUARE}f 1 1 2\n"));
    let answer = desk.run(&[&["compare", "m.obj", "--json"], &SMALL[..]].concat());
    assert!(answer.err.starts_with("note: "), "{answer}");
    assert_eq!(
        answer.objects().len(),
        onionskin::registry().len(),
        "{answer}"
    );
}

#[test]
fn a_size_over_the_drivers_limit_is_refused_with_the_limit() {
    let limit = Context::headless().unwrap().driver().largest_image();
    let desk = Desk::new().with("m.obj", SQUARE);
    for size in [format!("{}x1", limit + 1), format!("1x{}", u32::MAX)] {
        desk.refused(&["render", "m.obj", "-o", "m.png", "--size", &size])
            .says(&[&size.replace('x', " x "), &format!("{limit} x {limit}")]);
    }
}

#[test]
fn the_drivers_limit_itself_is_rendered() {
    let limit = Context::headless().unwrap().driver().largest_image();
    let desk = Desk::new().with("m.obj", SQUARE);
    let size = format!("{limit}x1");
    desk.result(&["render", "m.obj", "-o", "m.png", "--size", &size]);
    let image = Image::load(desk.path("m.png")).expect("a picture");
    assert_eq!([image.width, image.height], [limit, 1]);
}

#[test]
fn a_scene_files_size_over_the_drivers_limit_is_refused_with_the_limit() {
    let limit = Context::headless().unwrap().driver().largest_image();
    let scene = "size = [65535, 1]\n[[mesh]]\nfile = \"m.obj\"\n";
    let desk = Desk::new().with("m.obj", SQUARE).with("s.toml", scene);
    assert!(limit < 65535, "this driver has no limit to exceed");
    desk.refused(&["render", "s.toml", "-o", "m.png"])
        .says(&["65535 x 1", &format!("{limit} x {limit}")]);
}

#[test]
fn a_layer_that_cannot_be_written_leaves_neither_image_nor_layers() {
    let material = "newmtl glass\nd 0.5\n";
    let desk = Desk::new()
        .with(
            "m.obj",
            format!(
                "mtllib m.mtl\nusemtl glass\n{SQUARE}v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nf 5 6 7 8\n"
            ),
        )
        .with("m.mtl", material);
    std::fs::create_dir(desk.path("m-layer-1.png")).expect("a folder");
    let render = ["render", "m.obj", "-o", "m.png", "--layers"];
    desk.refused(&[&render, &SMALL[..]].concat())
        .says(&["cannot write m-layer-1.png"]);
}

/// Mesa can be told to offer less than it has.
fn on_an_old_driver(version: &str) -> Option<Desk> {
    let context = Context::headless().unwrap();
    if !context.driver().quirks().obeys_version_override {
        println!("skipped: only Mesa can be told to be old");
        return None;
    }
    let desk = Desk::new().with("m.obj", SQUARE);
    Some(desk.with_variable("MESA_GL_VERSION_OVERRIDE", version))
}

#[test]
fn a_driver_below_4_3_is_refused_with_the_version_that_it_has() {
    for version in ["4.2", "3.3", "3.3COMPAT"] {
        let Some(desk) = on_an_old_driver(version) else {
            return;
        };
        let number = &version[..3];
        desk.refused(&["render", "m.obj", "-o", "m.png"]).says(&[
            &format!("the driver offers only OpenGL {number} "),
            "onionskin needs 4.3",
            "update Mesa",
        ]);
    }
}

#[test]
fn a_driver_of_4_3_will_do() {
    let Some(desk) = on_an_old_driver("4.3") else {
        return;
    };
    desk.result(&[&["render", "m.obj", "-o", "m.png"], &SMALL[..]].concat());
}

#[test]
fn the_doctor_says_that_a_driver_is_too_old_and_ends_with_2() {
    let Some(desk) = on_an_old_driver("4.2") else {
        return;
    };
    let answer = desk.run(&["doctor"]);
    assert_eq!(answer.code, 2, "{answer}");
    assert!(answer.out.contains("offers only OpenGL 4.2 "), "{answer}");
}
