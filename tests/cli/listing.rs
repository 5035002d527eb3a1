//! `onionskin listing`: the texts of the papers, in every reading, with the origins of their lines.

use onionskin::low_level::steps::{Origin, Reading};
use onionskin::papers;

use crate::help::{refused, result};
use crate::kit::cli::Desk;

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

/// The first line, and what is below it.
fn titled(text: &str) -> (String, String) {
    let (title, text) = text.split_once('\n').expect("a title");
    (title.to_owned(), text.to_owned())
}
