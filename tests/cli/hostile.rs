//! Hostile command lines: each is refused with exit code 2, with words that name the thing, without a panic, and with no
//! file that was not there before ([`Desk::refused`] holds all that). None gets as far as OpenGL.

use crate::kit::cli::{Desk, SQUARE};

/// A volume that is generated, and a mesh.
const FOG: &str = "[[volume]]\ngenerate = \"ball\"\nsamples = 32\ntransfer = [\n\
                   { value = 0, color = [1, 1, 1], density = 0 },\n\
                   { value = 1, color = [1, 1, 1], density = 1 },\n]\n";

fn desk() -> Desk {
    let desk = Desk::new()
        .with("m.obj", SQUARE)
        .with("fog.toml", FOG)
        .with("kept.png", "the picture of yesterday")
        .with("empty.toml", "")
        .with("empty.obj", "")
        .with("text.png", "a text")
        .with("half.exr", b"\x76\x2f\x31\x01")
        .with("utf16.toml", utf_16("size = [64, 48]\n"))
        .with("latin1.toml", b"# Caf\xe9\n")
        .with("noise.toml", b"\x1b]0;\x07 = [")
        .with("noise.obj", b"v \x1b[31m 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        .with("deep.toml", "a = [".to_owned() + &"[".repeat(100_000));
    std::fs::create_dir(desk.path("folder")).expect("a folder");
    std::fs::create_dir(desk.path("folder.png")).expect("a folder");
    desk
}

fn utf_16(text: &str) -> Vec<u8> {
    let units = [0xfeff].into_iter().chain(text.encode_utf16());
    units.flat_map(u16::to_le_bytes).collect()
}

/// Each command line must be refused with these words. All that are not are shown.
#[track_caller]
pub(super) fn all_refused(cases: &[(&[&str], &[&str])]) {
    let desk = desk();
    let before = desk.files();
    let mut wrong = Vec::new();
    for (arguments, words) in cases {
        let answer = desk.run(arguments);
        if answer.code != 2 || !answer.out.is_empty() {
            wrong.push(format!("not refused: {answer}"));
        }
        let missing = words.iter().filter(|word| !answer.err.contains(**word));
        wrong.extend(missing.map(|word| format!("no '{word}' in: {answer}")));
        if desk.files() != before {
            panic!("files: {:?}\n{answer}", desk.names());
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn commands_and_options_that_there_are_not() {
    let desk = desk();
    // clap answers an empty command line with help, on standard error.
    let answer = desk.run(&[]);
    assert_eq!(answer.code, 2, "{answer}");
    all_refused(&[
        (&["rendr", "m.obj"], &["rendr", "render"]),
        (&[""], &["''"]),
        (&["-"], &["'-'"]),
        (&["--"], &["onionskin"]),
        (&["--rendr"], &["--rendr"]),
        (&["-x"], &["-x"]),
        (&["render"], &["SCENE|MODEL"]),
        (&["render", "m.obj"], &["--output"]),
        (&["render", "m.obj", "-o"], &["--output"]),
        (
            &["render", "m.obj", "-o", "a.png", "-o", "b.png"],
            &["--output", "multiple"],
        ),
        (&["render", "m.obj", "m.obj", "-o", "a.png"], &["m.obj"]),
        (
            &["render", "m.obj", "-o", "a.png", "--sise", "4x4"],
            &["--sise", "--size"],
        ),
        (&["compare"], &["SCENE|MODEL"]),
        (&["doctor", "-o", "a.png"], &["-o"]),
        (&["check", "m.obj"], &["IMAGE"]),
        (&["check", "m.obj", "kept.png", "kept.png"], &["kept.png"]),
        (&["complexity"], &["SCENE|MODEL"]),
        (&["animate", "m.obj"], &["--output"]),
        (&["methods", "blend"], &["blend"]),
        (&["doctor", "--jsno"], &["--jsno"]),
        (&["listing", "a", "b"], &["'b'"]),
    ]);
}

#[test]
fn scenes_that_are_none() {
    all_refused(&[
        (&["render", "", "-o", "a.png"], &["SCENE|MODEL"]),
        (
            &["render", "gone.toml", "-o", "a.png"],
            &["gone.toml: there is no such file"],
        ),
        (
            &["compare", "gone.obj"],
            &["gone.obj: there is no such file"],
        ),
        (
            &["complexity", "folder"],
            &["folder: ", "neither a scene file nor a model"],
        ),
        (&["compare", "."], &["neither a scene file nor a model"]),
        (&["compare", "/"], &["neither a scene file nor a model"]),
        (&["compare", "m.obj/m.obj"], &["m.obj/m.obj: "]),
        (&["compare", "kept.png"], &["kept.png: ", ".toml", ".obj"]),
        (&["compare", "empty.obj"], &["empty.obj: ", "empty"]),
        (
            &["compare", "utf16.toml"],
            &["utf16.toml: this is text in UTF-16", "UTF-8"],
        ),
        (
            &["compare", "latin1.toml"],
            &[
                "latin1.toml:1: ",
                "not UTF-8",
                "0xe9",
                "'é' in Latin-1",
                "iconv",
            ],
        ),
        (&["compare", "noise.toml"], &["noise.toml:1"]),
        (&["compare", "noise.obj"], &["noise.obj:1: '\\u{1b}[31m': "]),
        (&["compare", "deep.toml"], &["deep.toml:1"]),
        (
            &["animate", "gone.toml", "-o", "f"],
            &["gone.toml: there is no such file"],
        ),
        (&["check", "gone.toml", "kept.png"], &["kept.png"]),
        (
            &["compare", "a\nonionskin: all is well.obj"],
            &["a\\nonionskin: all is well.obj: there is no such file"],
        ),
        (
            &["compare", "\u{1b}[2J.obj"],
            &["\\u{1b}[2J.obj: there is no such file"],
        ),
        (
            &["compare", "\u{202e}jbo.obj"],
            &["\\u{202e}jbo.obj: there is no such file"],
        ),
    ]);
}

#[test]
#[cfg(unix)]
fn scenes_and_images_that_block_or_never_end() {
    let desk = Desk::new();
    for (name, target) in [
        ("zero.obj", "/dev/zero"),
        ("tty.toml", "/dev/tty"),
        ("random.png", "/dev/urandom"),
    ] {
        std::os::unix::fs::symlink(target, desk.path(name)).expect("a link");
    }
    for name in ["pipe.obj", "pipe.toml", "pipe.png"] {
        let made = std::process::Command::new("mkfifo")
            .arg(desk.path(name))
            .status();
        assert!(made.expect("mkfifo runs").success());
    }
    std::fs::write(desk.path("m.obj"), SQUARE).expect("a file");
    std::fs::write(desk.path("s.toml"), "[[mesh]]\nfile = \"pipe.obj\"\n").expect("a file");
    std::fs::write(desk.path("v.toml"), "[[volume]]\nfile = \"zero.nrrd\"\ntransfer = [{ value = 0, color = [1, 1, 1], density = 0 }]\n").expect("a file");
    std::os::unix::fs::symlink("/dev/zero", desk.path("zero.nrrd")).expect("a link");
    // Listing the folder with contents would read them to their end, so `refused` is not for this.
    let refused = |arguments: &[&str], words: &[&str]| {
        let answer = desk.run(arguments);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{answer}");
        answer.says(words);
    };
    for name in ["zero.obj", "pipe.obj", "pipe.toml"] {
        refused(&["compare", name], &[name, "a device or a pipe"]);
    }
    refused(&["compare", "tty.toml"], &["tty.toml"]);
    refused(
        &["compare", "s.toml"],
        &["pipe.obj: ", "a device or a pipe"],
    );
    refused(
        &["compare", "v.toml"],
        &["zero.nrrd: ", "a device or a pipe"],
    );
    refused(
        &["check", "m.obj", "pipe.png"],
        &["pipe.png: this is no file"],
    );
    refused(
        &["check", "m.obj", "random.png"],
        &["random.png: this is no file"],
    );
    refused(
        &["render", "m.obj", "-o", "pipe.png"],
        &["pipe.png", "a pipe or a device"],
    );
    refused(
        &["check", "m.obj", "m.png", "-o", "random.png"],
        &["random.png", "a pipe or a device"],
    );
    refused(
        &["complexity", "m.obj", "--csv", "/dev/full"],
        &["/dev/full"],
    );
}

#[test]
fn a_path_with_backslashes_is_told_from_one_with_slashes() {
    let desk = Desk::new();
    std::fs::create_dir(desk.path("scenes")).expect("a folder");
    let desk = desk.with("scenes/m.obj", SQUARE);
    if cfg!(unix) {
        desk.refused(&["compare", "scenes\\m.obj"])
            .says(&["no such file", "Did you mean 'scenes/m.obj'?"]);
        std::fs::write(desk.path("scenes/i.png"), "").expect("a file");
        desk.refused(&["check", "scenes/m.obj", "scenes\\i.png"])
            .says(&["no such file", "Did you mean 'scenes/i.png'?"]);
        let answer = desk.refused(&["compare", "scenes\\n.obj"]);
        answer.says(&["no such file"]);
        assert!(!answer.err.contains("Did you mean"), "{answer}");
    }
}

#[test]
fn sizes_and_memory_that_are_none() {
    all_refused(&[
        (
            &["render", "m.obj", "-o", "a.png", "--size", "0x0"],
            &["'0x0' is not a size"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "--size", "-1x5"],
            &["'-1'"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "--size="],
            &["'' is not a size"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "--size", "4294967296x1"],
            &["is not a size"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "--size", "1e3x1e3"],
            &["'1e3x1e3' is not a size"],
        ),
        (
            &["compare", "m.obj", "--size", "10 x 10"],
            &["'10 x 10' is not a size"],
        ),
        (
            &["compare", "m.obj", "--size", "\u{1b}[31m"],
            &["'\\u{1b}[31m' is not a size"],
        ),
        (
            &["compare", "m.obj", "--size=1\nfine"],
            &["'1\\nfine' is not a size"],
        ),
        (
            &["compare", "m.obj", "--max-memory", "lots"],
            &["'lots' is not an amount of memory", "8G"],
        ),
        (
            &["compare", "m.obj", "--max-memory", "0"],
            &["'0' is not an amount of memory"],
        ),
        (
            &["compare", "m.obj", "--max-memory=-5G"],
            &["'-5G' is not an amount"],
        ),
        (
            &["compare", "m.obj", "--max-memory", "nan"],
            &["'nan' is not an amount"],
        ),
        (
            &["compare", "m.obj", "--max-memory", "9999999999T"],
            &["is not an amount"],
        ),
        (
            &["compare", "m.obj", "--max-memory", "10"],
            &["m.obj: ", "bytes take", "--max-memory"],
        ),
        (
            &[
                "render",
                "m.obj",
                "-o",
                "a.png",
                "--max-memory",
                "10M",
                "--size",
                "4000x4000",
            ],
            &["4000 x 4000 pixels", "--max-memory"],
        ),
        (
            &[
                "complexity",
                "m.obj",
                "--max-memory",
                "1K",
                "--size",
                "20000x20000",
            ],
            &["20000 x 20000 pixels"],
        ),
        (
            &["compare", "fog.toml", "--max-memory", "100K"],
            &["fog.toml:3: ", "the samples take 128.0 KiB"],
        ),
    ]);
}

#[test]
fn outputs_that_cannot_be() {
    all_refused(&[
        (&["render", "m.obj", "-o", ""], &["--output"]),
        (
            &["render", "m.obj", "-o", "."],
            &["not the name of a picture"],
        ),
        (
            &["render", "m.obj", "-o", "/"],
            &["not the name of a picture"],
        ),
        (&["render", "m.obj", "-o", "a.jpg"], &["a.jpg", ".png"]),
        (&["render", "m.obj", "-o", "a.png/"], &["a.png/"]),
        (
            &["render", "m.obj", "-o", "folder.png"],
            &["folder.png", "a folder of that name"],
        ),
        (
            &["render", "m.obj", "-o", "gone/a.png"],
            &["gone/a.png", "there is no folder gone"],
        ),
        (&["render", "m.obj", "-o", "m.obj/a.png"], &["m.obj/a.png"]),
        (&["render", "m.obj", "-o", "/proc/a.png"], &["/proc/a.png"]),
        (&["render", "m.obj", "-o", "/dev/stdout"], &["/dev/stdout"]),
        (&["render", "m.obj", "-o", "/dev/full"], &["/dev/full"]),
        (
            &["render", "m.obj", "-o", "\u{1b}c/a.png"],
            &["\\u{1b}c/a.png", "no folder \\u{1b}c"],
        ),
        (&["complexity", "m.obj", "-o", "a.svg"], &["a.svg"]),
        (&["complexity", "m.obj", "--plot", "a.exr"], &["a.exr"]),
        (
            &["complexity", "m.obj", "--csv", "a.txt"],
            &["a.txt", ".csv"],
        ),
        (
            &["complexity", "m.obj", "--csv", "gone/a.csv"],
            &["gone/a.csv"],
        ),
        (&["check", "m.obj", "kept.png", "-o", "a.gif"], &["a.gif"]),
        (
            &["check", "m.obj", "kept.png", "-o", "kept.png"],
            &["would replace the image kept.png"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--frames", "9..3"],
            &["9..3"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--frames", "0..99999999999"],
            &["0..99999999999"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--frames", "0..37"],
            &["0..37", "36"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--frames", "-1..3"],
            &["'-1'"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--frames", "all"],
            &["'all' is not a range"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--layers"],
            &["no place for layers"],
        ),
    ]);
}
