//! The help and the table of methods: everything that the program says without OpenGL.

use onionskin::low_level::methods::Volumes;
use onionskin::registry;

use crate::kit::cli::{Answer, Desk};
use crate::kit::golden::assert_golden;

const SUBCOMMANDS: [&str; 14] = [
    "render",
    "compare",
    "bench",
    "check",
    "complexity",
    "inspect",
    "animate",
    "listing",
    "claims",
    "errata",
    "edition",
    "methods",
    "doctor",
    "licences",
];

pub(crate) fn result(arguments: &[&str]) -> String {
    Desk::new().result(arguments)
}

#[track_caller]
pub(crate) fn refused(arguments: &[&str]) -> Answer {
    Desk::new().refused(arguments)
}

#[test]
fn the_help_is_the_one_that_is_kept() {
    assert_golden("help.txt", &result(&["--help"]));
}

#[test]
fn the_help_of_every_subcommand_is_the_one_that_is_kept() {
    for name in SUBCOMMANDS {
        assert_golden(&format!("help_{name}.txt"), &result(&[name, "--help"]));
    }
}

#[test]
fn every_subcommand_is_in_the_help_and_its_help_is_tested() {
    let help = result(&["--help"]);
    let list = help.split("Commands:\n").nth(1).unwrap();
    let list = list.split("\n\n").next().unwrap();
    let names: Vec<_> = list
        .lines()
        .filter_map(|line| line.split_whitespace().next())
        .filter(|&name| name != "help")
        .collect();
    assert_eq!(names, SUBCOMMANDS);
}

#[test]
fn every_example_in_the_help_is_a_command_that_the_program_knows() {
    let mut examples = 0;
    let helps = SUBCOMMANDS.map(|name| result(&[name, "--help"]));
    for help in [&helps[..], &[result(&["--help"])]].concat() {
        for line in help.lines() {
            let Some(command) = line.strip_prefix("  onionskin ") else {
                continue;
            };
            // What explains the example stands after two spaces, what goes on in a pipe after a bar.
            let command = command.split("  ").next().unwrap();
            let command = command.split(" | ").next().unwrap();
            let mut words: Vec<_> = command.split(' ').collect();
            // A command line that clap takes fails later, because the example's files are not here, or stand in the way.
            let desk = Desk::new().with("site", "");
            let with_flag_that_is_not = [&words[..], &["--no-such-flag"]].concat();
            desk.refused(&with_flag_that_is_not)
                .says(&["unexpected argument '--no-such-flag'"]);
            words.push("--help");
            desk.result(&words);
            let answer = desk.run(&words[..words.len() - 1]);
            assert!(!answer.err.contains("Usage:"), "{answer}");
            examples += 1;
        }
    }
    assert!(examples >= 10, "{examples} examples");
}

#[test]
fn the_short_help_is_shorter_and_has_every_argument() {
    let arguments = |help: &str| -> Vec<String> {
        let words = help.split_whitespace();
        let flags = words.filter(|word| word.starts_with("--") && word.len() > 2);
        let mut flags: Vec<_> = flags
            .map(|flag| flag.trim_matches(|c: char| !c.is_alphanumeric()).to_owned())
            .collect();
        flags.sort();
        flags.dedup();
        flags
    };
    let (short, long) = (result(&["render", "-h"]), result(&["render", "--help"]));
    assert!(short.len() < long.len());
    for flag in arguments(long.split("\nOptions:").nth(1).unwrap()) {
        assert!(arguments(&short).contains(&flag), "{flag}");
    }
}

#[test]
fn the_version_is_the_packages() {
    let version = concat!("onionskin ", env!("CARGO_PKG_VERSION"), "\n");
    assert_eq!(result(&["--version"]), version);
}

#[test]
fn without_arguments_the_help_is_the_error() {
    refused(&[]).says(&["Usage: onionskin", "Examples:"]);
}

#[test]
fn an_unknown_subcommand_is_refused_with_the_one_that_was_meant() {
    refused(&["rendr"]).says(&["unrecognized subcommand 'rendr'", "'render'"]);
}

#[test]
fn an_unknown_flag_is_refused_with_the_one_that_was_meant() {
    refused(&["render", "a.obj", "-o", "a.png", "--sise", "1x1"])
        .says(&["unexpected argument '--sise'", "'--size'"]);
}

#[test]
fn a_missing_argument_is_named() {
    refused(&["render", "a.obj"]).says(&["--output <FILE>"]);
}

#[test]
fn the_methods_are_those_of_the_registry_in_its_order() {
    let table = result(&["methods"]);
    let names: Vec<_> = table
        .lines()
        .skip(1)
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    let expected: Vec<_> = registry().iter().map(|entry| entry.name).collect();
    assert_eq!(names, expected, "{table}");
}

#[test]
fn the_methods_as_json_are_one_object_each_with_what_the_registry_says() {
    let answer = Desk::new().run(&["methods", "--json"]);
    let objects = answer.objects();
    assert_eq!(objects.len(), registry().len());
    for (object, entry) in objects.iter().zip(registry()) {
        let keys: Vec<_> = object.keys().map(String::as_str).collect();
        let expected = [
            "exact",
            "exact_volumes",
            "exactness",
            "keeps",
            "memory",
            "name",
            "needs",
            "source",
            "ties",
        ];
        assert_eq!(keys, expected);
        assert_eq!(object["name"], entry.name);
        assert_eq!(object["source"], entry.source);
        assert_eq!(object["exact"], entry.exact);
        assert_eq!(
            object["exact_volumes"],
            serde_json::json!(entry.exact_volumes())
        );
        assert_eq!(object["exactness"], entry.exactness);
        assert_eq!(object["keeps"], serde_json::json!(entry.keeps));
        assert_eq!(object["ties"], entry.ties.to_string());
        assert_eq!(object["memory"], entry.memory.to_string());
        assert_eq!(object["needs"], serde_json::json!(entry.needs));
    }
}

/// Carr et al.'s methods draw volumes as slices, and of slices no method's image is exact.
#[test]
fn the_registry_calls_volumes_exact_only_where_rays_are_cast() {
    for entry in registry() {
        let exact = entry.volumes == Volumes::Rays;
        let expected = (entry.volumes != Volumes::Refused).then_some(exact);
        assert_eq!(entry.exact_volumes(), expected, "{}", entry.name);
        let says_no = entry.exactness.contains("volumes as slices: no");
        assert_eq!(says_no, entry.exact && expected == Some(false));
        assert_eq!(entry.exactness.starts_with("yes"), entry.exact);
    }
}

/// The embedded font's licence asks for its text and the copyright notice in every copy. The notice is held against the
/// font's own name table, so that another font cannot come without its own.
#[test]
fn the_licences_are_printed_and_the_font_s_is_that_of_the_embedded_font() {
    let text = result(&["licences"]);
    assert!(text.contains("MIT License"), "{text}");
    assert!(text.contains("UBUNTU FONT LICENCE Version 1.0") && text.contains("TERMINATION"));
    let notice = text
        .lines()
        .find(|line| line.contains("Canonical"))
        .expect("the font's copyright notice");
    let in_the_font: Vec<u8> = notice.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let holds = |font: &[u8]| {
        font.windows(in_the_font.len())
            .any(|part| part == in_the_font)
    };
    assert!(holds(epaint_default_fonts::UBUNTU_LIGHT), "{notice}");
    assert!(!holds(epaint_default_fonts::HACK_REGULAR));
}

#[test]
#[cfg(target_os = "linux")]
fn a_reader_that_stops_reading_is_no_error() {
    use std::process::{Command, Stdio};
    // A pipe whose reading end is closed before the program writes its first line.
    let (reader, writer) = std::io::pipe().expect("a pipe");
    drop(reader);
    let output = Command::new(env!("CARGO_BIN_EXE_onionskin"))
        .arg("listing")
        .stdout(Stdio::from(writer))
        .output()
        .expect("the program runs");
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), &*err), (Some(0), ""));
}

#[test]
#[cfg(target_os = "linux")]
fn a_full_disk_under_the_standard_output_is_an_error() {
    use std::process::Command;
    let full = std::fs::File::options()
        .write(true)
        .open("/dev/full")
        .expect("Linux has it");
    let output = Command::new(env!("CARGO_BIN_EXE_onionskin"))
        .arg("listing")
        .stdout(full)
        .output()
        .expect("the program runs");
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2), "{err}");
    assert!(err.contains("cannot write standard output"), "{err}");
}
