//! What reaches a terminal: no character of a file, a name or an argument that does something there; and what happens
//! where there is no terminal, or a broken one.

use std::fs::File;
use std::process::{Command, Stdio};

use crate::kit::cli::{Answer, Desk, SQUARE};

/// Nothing in it does something to a terminal, and no line begins that is not the program's.
#[track_caller]
fn harmless(answer: &Answer) {
    for text in [&answer.out, &answer.err] {
        let wrong = text.chars().find(|&c| {
            c.is_control() && c != '\n' || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}')
        });
        assert_eq!(wrong, None, "{answer}");
        assert!(
            !text.lines().any(|line| line.starts_with("fine")),
            "{answer}"
        );
    }
}

/// What a name may do: colours, titles, clearing, 8-bit controls, directions, line ends, bells.
const NAMES: [&str; 7] = [
    "\u{1b}[31mred",
    "\u{1b}]0;title\u{7}",
    "\u{9b}2Jgone",
    "gpj\u{202e}gnp",
    "\u{2066}a\u{200b}b",
    "a\nfine: all is well",
    "a\rfine",
];

#[test]
fn names_of_files_in_arguments() {
    for name in NAMES {
        let desk = Desk::new();
        let model = format!("{name}.obj");
        let picture = format!("{name}.jpg");
        for arguments in [
            ["compare", &model].as_slice(),
            &["compare", name],
            &["render", &model, "-o", &picture],
            &["check", &model, &picture],
            &["complexity", &model, "--csv", name],
            &["render", "m.obj", "-o", "a.png", "-m", name],
            &["listing", name],
            &["compare", "m.obj", "--backend", name],
            &["compare", "m.obj", "--size", name],
            &["compare", "m.obj", &format!("--size={name}")],
            &["animate", "m.obj", "-o", "f", "--frames", name],
            &[name],
            &[&format!("--{name}")],
        ] {
            let answer = desk.refused(arguments);
            harmless(&answer);
        }
    }
}

#[test]
fn words_of_scene_files() {
    for name in NAMES {
        // As TOML writes any character.
        let name: String = name
            .chars()
            .map(|c| format!("\\U{:08x}", u32::from(c)))
            .collect();
        for content in [
            format!("\"{name}\" = 1\n"),
            format!("[[mesh]]\nfile = \"{name}.obj\"\n"),
            format!("[[mesh]]\nfile = \"{name}\"\n"),
            format!("[[mesh]]\ngenerate = \"{name}\"\n"),
            format!("[[mesh]]\ngenerate = \"teapot\"\nshading = \"{name}\"\n"),
            format!("[[mesh]]\ngenerate = \"isosurface\"\nvolume = \"{name}\"\n"),
            format!("[path]\n[[path.show]]\nfrom = 1\nsources = [\"{name}\"]\n"),
        ] {
            let answer = Desk::new()
                .with("s.toml", &content)
                .refused(&["compare", "s.toml"]);
            harmless(&answer);
        }
    }
}

#[test]
fn raw_bytes_of_scene_files_and_models() {
    for name in NAMES {
        for (file, content) in [
            ("s.toml", format!("size = {name}\n")),
            ("s.toml", format!("# {name}\nsize = [0, {name}]\n")),
            ("m.obj", format!("v 0 0 {name}\n")),
            ("m.obj", format!("v 0 0 0\nf {name} 1 1\n")),
        ] {
            let answer = Desk::new().with(file, &content).refused(&["compare", file]);
            harmless(&answer);
        }
    }
}

/// The exit code of a command whose standard error is a full device or a pipe that nobody reads.
fn with_broken_error(desk: &Desk, arguments: &[&str], error: Stdio) -> Option<i32> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_onionskin"));
    command.current_dir(desk.path(".")).args(arguments);
    let status = command.stdout(Stdio::null()).stderr(error).status();
    status.expect("the program runs").code()
}

#[test]
#[cfg(target_os = "linux")]
fn a_broken_standard_error_changes_no_exit_code() {
    let desk = Desk::new().with("m.obj", SQUARE);
    let full = || {
        File::options()
            .write(true)
            .open("/dev/full")
            .expect("/dev/full")
            .into()
    };
    let unread = || std::io::pipe().expect("a pipe").1.into();
    for arguments in [
        ["compare", "gone.obj"].as_slice(),
        &["compare", "m.obj", "-m", "none"],
        &["nothing"],
        &["render", "m.obj"],
    ] {
        assert_eq!(with_broken_error(&desk, arguments, full()), Some(2));
        assert_eq!(with_broken_error(&desk, arguments, unread()), Some(2));
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_standard_output_that_is_full_is_an_error_and_one_that_nobody_reads_is_none() {
    let run = |output: Stdio| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_onionskin"));
        let command = command.args(["listing", "everitt/listing-1"]);
        command.stdout(output).output().expect("the program runs")
    };
    let full = run(File::options()
        .write(true)
        .open("/dev/full")
        .expect("/dev/full")
        .into());
    assert_eq!(full.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&full.stderr).contains("standard output"));
    let unread = run(std::io::pipe().expect("a pipe").1.into());
    assert_eq!((unread.status.code(), unread.stderr.len()), (Some(0), 0));
}
