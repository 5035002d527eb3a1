//! Bad input on the command line: a clear error, exit code 2, and no file that was not there before. Nothing here gets
//! as far as OpenGL; `gl_cli/bad_input.rs` has what does.
//!
//! [`Desk::refused`] holds for every case that the exit code is 2, that standard output is empty, and that the folder
//! has exactly the files that it had, with their content; so these tests are about what is said.

use std::fs::File;

use crate::kit::cli::{Answer, Desk, SQUARE};

/// Three vertices, so that the next line is the fourth.
const THREE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// A file named as a result that is already there, to be left alone.
const KEPT: &[u8] = b"the picture of yesterday";

/// Every subcommand that reads a scene refuses this one; a picture of the same name as the output is kept.
#[track_caller]
fn refused_scene(desk: Desk, name: &str) -> Answer {
    let desk = desk.with("kept.png", KEPT).with("image.png", picture());
    let compared = desk.refused(&["compare", name]);
    let checked = desk.refused(&["check", name, "image.png", "-o", "kept.png"]);
    let rendered = desk.refused(&["render", name, "-o", "new.png"]);
    let again = desk.refused(&["render", name, "-o", "kept.png"]);
    assert_eq!(rendered.err, again.err);
    assert_eq!(rendered.err, compared.err);
    assert_eq!(rendered.err, checked.err);
    rendered
}

/// A model of this content is refused.
#[track_caller]
fn refused_model(content: impl AsRef<[u8]>) -> Answer {
    refused_scene(Desk::new().with("m.obj", content), "m.obj")
}

/// A model whose fourth line is this is refused, with file, line and word.
#[track_caller]
fn refused_line(line: &str, word: &str) -> Answer {
    let answer = refused_model(format!("{THREE}{line}\nf 1 2 3\n"));
    answer.says(&[&format!("onionskin: m.obj:4: '{word}': ")]);
    remedied(answer)
}

/// A scene file of this content, beside a model `m.obj`, is refused.
#[track_caller]
fn refused_file(content: &str) -> Answer {
    let desk = Desk::new().with("m.obj", SQUARE).with("s.toml", content);
    remedied(refused_scene(desk, "s.toml"))
}

/// A square is not rendered with these arguments.
#[track_caller]
fn refused_arguments(arguments: &[&str]) -> Answer {
    let desk = Desk::new().with("m.obj", SQUARE).with("kept.png", KEPT);
    remedied(desk.refused(arguments))
}

/// `check` of a square refuses this image.
#[track_caller]
fn refused_image(content: impl AsRef<[u8]>) -> Answer {
    let desk = Desk::new().with("m.obj", SQUARE).with("i.png", content);
    remedied(desk.refused(&["check", "m.obj", "i.png"]))
}

/// A message has a second line, which says what to do.
#[track_caller]
fn remedied(answer: Answer) -> Answer {
    let remedy = answer.err.lines().nth(1).unwrap_or_default();
    assert!(remedy.starts_with("  ") && remedy.len() > 10, "{answer}");
    answer
}

/// A PNG of 1 x 1.
fn picture() -> Vec<u8> {
    let desk = Desk::new();
    let white = onionskin::Rgba::opaque([1.0; 3]);
    let image = onionskin::Image::filled(1, 1, white);
    image.save(desk.path("i.png")).expect("a picture");
    std::fs::read(desk.path("i.png")).expect("a picture")
}

#[test]
fn a_missing_model() {
    refused_scene(Desk::new(), "gone.obj").says(&["gone.obj: there is no such file", "spelling"]);
}

#[test]
fn a_missing_scene_file() {
    refused_scene(Desk::new(), "gone.toml").says(&["gone.toml: there is no such file"]);
}

#[test]
fn a_model_that_a_scene_file_names_and_that_is_not_there() {
    refused_file("[[mesh]]\nfile = \"gone.obj\"\n").says(&["gone.obj", "there is no such file"]);
}

#[test]
fn an_empty_model() {
    refused_model("").says(&["m.obj: ", "empty"]);
}

#[test]
fn a_model_cut_off_within_a_face() {
    refused_model(format!("{THREE}f 1 2")).says(&["m.obj:4: '1 2': ", "cut off"]);
}

#[test]
fn a_binary_model() {
    refused_model(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR").says(&["m.obj:", "binary", "UTF-8"]);
}

#[test]
fn a_gigantic_model() {
    let desk = Desk::new();
    let file = File::create(desk.path("m.obj")).expect("a file");
    // Sparse: it takes no room on the disk.
    file.set_len(64 << 30).expect("a sparse file");
    refused_scene(desk, "m.obj").says(&["m.obj: ", "2 GiB", "Split"]);
}

#[test]
fn an_index_beyond_the_vertices() {
    refused_line("f 1 2 4", "4").says(&["no vertex 4: 3 are defined"]);
}

#[test]
fn an_index_of_zero() {
    refused_line("f 0 1 2", "0").says(&["count from 1"]);
}

#[test]
fn a_negative_index_before_the_first_vertex() {
    refused_line("f -1 -2 -4", "-4").says(&["no vertex -4"]);
}

/// What no face needs stops nothing (`scene/obj_tolerated.rs`); here the only face needs it.
#[test]
fn a_model_whose_only_face_needs_a_vertex_without_a_place() {
    for word in ["nan", "inf", "1.#INF", "x", "1e400", ""] {
        let model = format!("v 0 0 0\nv 1 0 0\nv 0 0 {word}\nf 1 2 3\n");
        refused_model(model).says(&["m.obj:3: ", "none of the model's faces can be drawn"]);
    }
}

#[test]
fn a_model_of_another_kind() {
    refused_scene(Desk::new().with("m.stl", "solid"), "m.stl").says(&["m.stl: ", ".obj", ".toml"]);
}

#[test]
fn an_unknown_key_of_a_scene_file() {
    refused_file("size = [64, 48]\ncolour = 1\n[[mesh]]\nfile = \"m.obj\"\n").says(&[
        "s.toml:2: 'colour': ",
        "size, background, camera, path, mesh",
    ]);
}

#[test]
fn an_unknown_key_of_a_mesh() {
    refused_file("[[mesh]]\nfile = \"m.obj\"\nopacitty = 0.5\n")
        .says(&["s.toml:3: 'opacitty': ", "opacity"]);
}

#[test]
fn a_scene_file_that_is_not_toml() {
    refused_file("size = [64, 48\n").says(&["s.toml:", "not TOML"]);
}

#[test]
fn a_scene_files_size_of_0() {
    refused_file("size = [64, 0]\n[[mesh]]\nfile = \"m.obj\"\n").says(&["s.toml:1: ", "size"]);
}

#[test]
fn a_size_of_0() {
    for size in ["0x5", "5x0", "0x0"] {
        refused_arguments(&["render", "m.obj", "-o", "kept.png", "--size", size]).says(&[
            "--size",
            &format!("'{size}' is not a size"),
            "1024x768",
        ]);
    }
}

#[test]
fn a_size_that_is_none() {
    for size in ["5", "axb", "5x", "5x-5", "5x5x5", "99999999999x1"] {
        refused_arguments(&["compare", "m.obj", "--size", size])
            .says(&[&format!("'{size}' is not a size")]);
    }
}

#[test]
fn an_output_in_a_folder_that_is_not_there() {
    refused_arguments(&["render", "m.obj", "-o", "gone/new.png"])
        .says(&["cannot write gone/new.png", "there is no folder gone"]);
}

#[test]
fn an_output_below_a_file() {
    refused_arguments(&["render", "m.obj", "-o", "m.obj/new.png"])
        .says(&["cannot write m.obj/new.png", "there is no folder m.obj"]);
}

#[test]
fn an_output_that_is_a_folder() {
    let desk = Desk::new().with("m.obj", SQUARE);
    std::fs::create_dir(desk.path("new.png")).expect("a folder");
    for arguments in [
        ["render", "m.obj", "-o", "new.png"].as_slice(),
        &["check", "m.obj", "m.png", "-o", "new.png"],
    ] {
        remedied(desk.refused(arguments))
            .says(&["cannot write new.png", "there is a folder of that name"]);
    }
}

#[test]
#[cfg(target_os = "linux")]
fn an_output_in_a_folder_that_takes_no_files() {
    // Of root as well.
    refused_arguments(&["render", "m.obj", "-o", "/proc/new.png"])
        .says(&["cannot write /proc/new.png", "you may write there"]);
}

#[test]
fn an_output_of_no_kind() {
    for name in ["new.jpg", "new", "kept.png.txt", ".png"] {
        refused_arguments(&["render", "m.obj", "-o", name]).says(&[".png", ".exr"]);
        refused_arguments(&["check", "m.obj", "kept.png", "-o", name]).says(&[".png", ".exr"]);
    }
}

#[test]
fn an_unknown_method() {
    for command in [
        ["render", "m.obj", "-o", "new.png", "-m", "peeling"].as_slice(),
        &["compare", "m.obj", "-m", "blend,peeling"],
    ] {
        let answer = refused_arguments(command);
        answer.says(&["there is no method 'peeling'"]);
        for entry in onionskin::registry() {
            answer.says(&[entry.name]);
        }
    }
}

#[test]
fn an_option_of_another_method() {
    for option in [
        ["--peels", "3"].as_slice(),
        &["--occlusion-ratio", "0.1"],
        &["--layers"],
        &["--as-printed"],
    ] {
        let render = ["render", "m.obj", "-o", "new.png", "-m", "blend"];
        refused_arguments(&[&render, option].concat()).says(&[
            "blend has no",
            option[0],
            "depth-peeling",
        ]);
    }
}

#[test]
fn an_occlusion_ratio_out_of_range() {
    for ratio in ["1.5", "-0.1", "nan", "inf"] {
        let option = format!("--occlusion-ratio={ratio}");
        refused_arguments(&["render", "m.obj", "-o", "new.png", &option])
            .says(&["occlusion ratio", "between 0 and 1"]);
    }
}

#[test]
fn listing_1_as_printed_that_is_not_told_when_to_stop() {
    refused_arguments(&["render", "m.obj", "-o", "new.png", "--as-printed"])
        .says(&["no way to find out when to stop", "--peels"]);
}

#[test]
fn an_unknown_backend_of_an_argument() {
    refused_arguments(&["render", "m.obj", "-o", "new.png", "--backend", "glx"])
        .says(&["there is no backend 'glx'", "egl or osmesa"]);
}

#[test]
fn an_unknown_backend_of_the_environment() {
    let desk = Desk::new()
        .with("m.obj", SQUARE)
        .with_variable("ONIONSKIN_BACKEND", "glx");
    desk.refused(&["compare", "m.obj"])
        .says(&["there is no backend 'glx'", "ONIONSKIN_BACKEND"]);
}

#[test]
fn a_missing_image() {
    refused_arguments(&["check", "m.obj", "gone.png"]).says(&["gone.png: "]);
}

#[test]
fn an_image_that_is_none() {
    refused_image("a text").says(&["i.png: cannot decode it", "PNG"]);
}

#[test]
fn an_image_cut_off() {
    let mut picture = picture();
    picture.truncate(picture.len() / 2);
    refused_image(picture).says(&["i.png: cannot decode it"]);
}

#[test]
fn an_empty_image() {
    refused_image("").says(&["i.png: cannot decode it"]);
}

#[test]
fn a_gigantic_image() {
    let desk = Desk::new().with("m.obj", SQUARE);
    let file = File::create(desk.path("i.png")).expect("a file");
    file.set_len(64 << 30).expect("a sparse file");
    remedied(desk.refused(&["check", "m.obj", "i.png"])).says(&["i.png: ", "bytes"]);
}

#[test]
#[cfg(unix)]
fn an_image_that_never_ends() {
    let desk = Desk::new().with("m.obj", SQUARE);
    std::os::unix::fs::symlink("/dev/zero", desk.path("i.png")).expect("a link");
    // `files` would read it to its end.
    let answer = desk.run(&["check", "m.obj", "i.png"]);
    assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{answer}");
    answer.says(&["i.png: this is no file"]);
}

#[test]
fn an_image_of_another_kind() {
    refused_arguments(&["check", "m.obj", "m.obj"]).says(&["m.obj: ", ".png", ".exr"]);
}

#[test]
fn an_image_of_another_size_with_the_argument_that_helps() {
    refused_image(picture()).says(&["i.png is 1 x 1", "1024 x 768", "add --size 1x1"]);
}

#[test]
fn a_difference_picture_that_would_replace_the_image() {
    let desk = Desk::new()
        .with("m.obj", SQUARE)
        .with("difference.png", picture());
    for arguments in [
        ["check", "m.obj", "difference.png"].as_slice(),
        &["check", "m.obj", "difference.png", "-o", "./difference.png"],
    ] {
        remedied(desk.refused(arguments)).says(&["would replace", "--output"]);
    }
}

#[test]
fn a_bound_or_a_gain_that_is_none() {
    for option in ["--bound=-1", "--bound=1.01", "--bound=nan", "--bound=inf"] {
        refused_arguments(&["check", "m.obj", "kept.png", option]).says(&["--bound is ", "0 to 1"]);
    }
    for option in ["--gain=0", "--gain=nan", "--gain=inf"] {
        refused_arguments(&["check", "m.obj", "kept.png", option]).says(&["--gain is "]);
    }
}
