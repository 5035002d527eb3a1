//! The help, the listings and the table of methods: everything that the program says without OpenGL.

use onionskin::low_level::methods::Volumes;
use onionskin::low_level::steps::{Origin, Reading};
use onionskin::{papers, registry};

use crate::kit::cli::{Answer, Desk};
use crate::kit::golden::assert_golden;

const SUBCOMMANDS: [&str; 12] = [
    "render",
    "compare",
    "bench",
    "check",
    "complexity",
    "animate",
    "listing",
    "claims",
    "errata",
    "methods",
    "doctor",
    "licences",
];

fn result(arguments: &[&str]) -> String {
    Desk::new().result(arguments)
}

#[track_caller]
fn refused(arguments: &[&str]) -> Answer {
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
            let desk = Desk::new();
            // A command line that clap takes fails later, because the example's files are not here.
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
fn without_a_name_the_listings_are_listed_by_paper() {
    let mut expected = String::new();
    for paper in papers() {
        expected += &format!("{}\n", paper.citation);
        for (key, text) in paper.texts {
            let name = format!("{}/{key}", paper.key);
            expected += &format!("  {name:<28} {}\n", text.title());
        }
    }
    assert_eq!(result(&["listing"]), expected);
}

#[test]
fn a_text_is_printed_in_every_reading_under_its_title_with_the_letters_of_its_origins() {
    for paper in papers() {
        for (key, text) in paper.texts {
            let name = format!("{}/{key}", paper.key);
            for (reading, flag) in READINGS {
                let arguments = ["listing", &name].into_iter().chain(flag);
                let (title, printed) = titled(&result(&arguments.collect::<Vec<_>>()));
                assert_eq!(title, format!("// {}: {}", text.source(), text.title()));
                let (body, legend) = printed.rsplit_once("\n\n").expect("a legend");
                let lines = text.lines(reading);
                assert_eq!(body.lines().count(), lines.len());
                for (shown, line) in body.lines().zip(&lines) {
                    let letter = line.origin.map_or(' ', Origin::letter);
                    let expected = format!("{letter} {}", line.text);
                    assert_eq!(shown, expected.trim_end(), "{name}");
                    assert!(
                        letter == ' ' || legend.contains(&format!("  {letter} ")),
                        "{legend}"
                    );
                }
            }
        }
    }
}

const READINGS: [(Reading, Option<&str>); 3] = [
    (Reading::Literal, Some("--literal")),
    (Reading::AsPrinted, Some("--as-printed")),
    (Reading::Amended, None),
];

#[test]
fn a_listing_without_what_is_not_printed_is_the_paper_s_own() {
    for (name, transcript) in [
        (
            "everitt/listing-1",
            include_str!("../print/everitt/listing-1.txt"),
        ),
        (
            "everitt/listing-2",
            include_str!("../print/everitt/listing-2.txt"),
        ),
        (
            "carr/section-6",
            include_str!("../print/carr/section-6.txt"),
        ),
        (
            "lindholm/section-5.1",
            include_str!("../print/lindholm/section-5.1.txt"),
        ),
    ] {
        for flag in ["--as-printed", "--literal"] {
            let text = result(&["listing", name, flag]);
            let printed = text.lines().filter_map(|line| line.strip_prefix('p'));
            let printed: String = printed
                .map(|line| format!("{}\n", line.strip_prefix(' ').unwrap_or(line)))
                .collect();
            assert_eq!(printed, transcript, "{name}");
        }
    }
}

/// The program's output goes to a pipe here.
#[test]
fn only_a_terminal_gets_colours() {
    let text = result(&["listing", "carr/coherent-a"]);
    assert!(!text.contains('\u{1b}'));
}

#[test]
fn a_listing_as_json_has_every_line_with_its_origin_and_every_step_as_data() {
    for paper in papers() {
        for (key, text) in paper.texts {
            let name = format!("{}/{key}", paper.key);
            for (reading, flag) in READINGS {
                let arguments = ["listing", &name, "--json"].into_iter().chain(flag);
                let answer = Desk::new().run(&arguments.collect::<Vec<_>>());
                let objects = answer.objects();
                assert_eq!(objects.len(), 1);
                let object = &objects[0];
                assert_eq!(object["key"], name);
                assert_eq!(object["reading"], reading.name());
                let lines = object["lines"].as_array().expect("lines");
                let expected = text.lines(reading);
                assert_eq!(lines.len(), expected.len());
                for (line, expected) in lines.iter().zip(expected) {
                    assert_eq!(line["text"], expected.text);
                    let is = expected.origin.map(Origin::name);
                    assert_eq!(line["origin"]["is"].as_str(), is);
                }
                let steps = object["steps"].as_array().expect("steps");
                assert!(!steps.is_empty(), "{name}");
                steps.iter().for_each(expect_step);
            }
        }
    }
}

/// A step says what it is, and so does everything inside of it.
fn expect_step(step: &serde_json::Value) {
    let known = [
        "call",
        "let",
        "if",
        "for",
        "for-down",
        "stop",
        "depth-unit",
        "run",
        "silence",
        "line",
    ];
    let what = step["step"].as_str().expect("what it is");
    assert!(known.contains(&what), "{step}");
    assert!(step.get("origin").is_some(), "{step}");
    if what == "call" {
        assert!(
            step["name"].is_string() && step["arguments"].is_object(),
            "{step}"
        );
    }
    for inside in ["body", "then", "otherwise"] {
        let steps = step.get(inside).and_then(serde_json::Value::as_array);
        steps.into_iter().flatten().for_each(expect_step);
    }
}

#[test]
fn pseudocode_makes_no_calls_that_could_be_unrolled() {
    for name in ["carr/algorithm-1", "lindholm/section-5.2"] {
        refused(&["listing", name, "--unroll", "2"]).says(&["pseudocode"]);
    }
}

#[test]
fn as_printed_and_as_amended_are_not_the_same() {
    let both = |name| {
        let amended = result(&["listing", name]);
        (amended, result(&["listing", name, "--as-printed"]))
    };
    let (amended, printed) = both("carr/section-6");
    assert_ne!(amended, printed);
    // Listing 1 needs no amendment. What VTK adds to it is VTK's.
    let (amended, printed) = both("everitt/listing-1");
    assert_eq!(amended, printed);
    assert!(both("vtk/keep-layers").0.contains("// V04: "));
}

#[test]
fn a_listing_of_two_rounds_is_unrolled_into_its_calls() {
    let name = "everitt/listing-1";
    let (_, text) = titled(&result(&["listing", name, "--as-printed", "--unroll", "2"]));
    assert_eq!(
        text,
        include_str!("../transcripts/everitt_listing_1_two_rounds.txt")
    );
}

#[test]
fn a_paper_alone_gives_all_of_its_listings() {
    for paper in papers() {
        let each = paper.texts.iter().map(|(key, _)| {
            let name = format!("{}/{key}", paper.key);
            result(&["listing", &name])
        });
        let each: Vec<_> = each.collect();
        assert_eq!(result(&["listing", paper.key]), each.join("\n"));
    }
}

#[test]
fn an_unknown_listing_is_refused_with_those_that_there_are() {
    for name in ["everit", "everitt/listing-9", "everitt/", "/", ""] {
        let answer = refused(&["listing", name]);
        answer.says(&[&format!("there is no listing '{name}'")]);
        for paper in papers() {
            for (key, _) in paper.texts {
                answer.says(&[&format!("{}/{key}", paper.key)]);
            }
        }
    }
}

#[test]
fn a_number_of_rounds_that_is_none_is_refused() {
    for number in ["two", "0", "4294967295"] {
        refused(&["listing", "everitt/listing-1", "--unroll", number])
            .says(&[&format!("'{number}'"), "--unroll"]);
    }
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

/// The first line, and what is below it.
fn titled(text: &str) -> (String, String) {
    let (title, text) = text.split_once('\n').expect("a title");
    (title.to_owned(), text.to_owned())
}
