//! Where the lines of texts come from: each has an origin, and quotations are the papers' own.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use crate::print::*;
use onionskin::low_level::steps::pseudo::{self, list};
use onionskin::low_level::steps::{
    Amendment, Dialect, Listing, Met, Origin, Reading, Scope, Statement, Step, TextLine, gl::*,
    print,
};
use onionskin::{Text, lists, papers, pseudo, steps};

/// An amendment's own statements come from it; those that it only repeats come from where they came from.
#[test]
fn statements_that_an_amendment_repeats_keep_their_origin() {
    const ADDED: Amendment = crate::kit::changed::changed(
        steps! { glDepthFunc(LESS); },
        steps! {
            glDisable(BLEND);
            glDepthFunc(LESS);
            glDisable(STENCIL_TEST);
        },
    );
    let Text::Listing(pass_1, _) = text("carr/pass-1") else {
        panic!("it is a listing");
    };
    let lines = print::lines(pass_1, &[ADDED]);
    let letter = |text: &str| {
        let line = lines.iter().find(|line| line.text == text).expect(text);
        line.origin.map(Origin::letter)
    };
    assert_eq!(letter("glDisable(BLEND);"), Some('a'));
    assert_eq!(letter("glDepthFunc(LESS);"), Some('p'));
    assert_eq!(letter("glDisable(STENCIL_TEST);"), Some('a'));
    assert_eq!(letter("glEnable(STENCIL_TEST);"), Some('p'));
}

/// A mark holds up to the next one of its block, and inside of what stands there.
#[test]
fn a_mark_holds_for_its_block() {
    const STEPS: &[Step] = steps! {
        prose "in a sentence";
        for (i in 0..2) {
            drawScreen();
            edition "for a reason";
            drawOpaqueObjects();
        }
        drawScreen();
    };
    const LINES: &[pseudo::Line] = pseudo! { printed; spelt "composite"; composite; composite; };
    const ON_LISTS: &[list::ListLine] = lists! { line "an empty loop"; printed; blend f; };
    assert_eq!(origins(STEPS, Scope::of(&[])), "sses");
    assert_eq!(origins(LINES, Scope::of(&[])), "pp");
    assert_eq!(origins(ON_LISTS, Scope::of(&[])), "?p");
}

fn origins<S: Statement>(statements: &'static [S], scope: Scope<'_, S>) -> String {
    let mut found = String::new();
    for met in scope.walk(statements) {
        match met {
            Met::Amendment(_) => {}
            Met::Line(_, scope) => found.push(scope.origin().map_or('?', Origin::letter)),
            Met::Statement(statement, scope) => {
                found.push(scope.origin().map_or('?', Origin::letter));
                for body in statement.bodies() {
                    found += &origins(body, scope);
                }
            }
        }
    }
    found
}

#[test]
fn every_line_of_every_text_has_an_origin() {
    let mut letters = BTreeSet::new();
    for paper in papers() {
        for (key, text) in paper.texts {
            for reading in Reading::ALL {
                for line in text.lines(reading) {
                    let origin = line.origin.map(Origin::letter);
                    let where_from = format!("{}/{key}: {}", paper.key, line.text);
                    assert!(origin.is_some() || line.note, "{where_from}");
                    letters.extend(origin);
                    // What fills and what amends stands only where it is read so.
                    let as_it_is = origin != Some('a') || reading == Reading::Amended;
                    let silent = origin != Some('f') || reading != Reading::Literal;
                    let filled = origin != Some('?') || reading == Reading::Literal;
                    let fits = as_it_is && silent && filled;
                    assert!(fits, "{} {where_from}", reading.name());
                }
            }
        }
    }
    assert_eq!(letters.into_iter().collect::<String>(), "?aefps");
    // A line that no mark precedes has none.
    const NONE: Listing = Listing {
        title: "",
        source: "",
        dialect: Dialect::Calls,
        steps: steps! { drawScreen(); },
    };
    assert!(
        print::lines(&NONE, &[])
            .iter()
            .all(|line| line.origin.is_none())
    );
}

/// Calls that connect other calls with maps, and do nothing by themselves.
const PLUMBING: [&str; 7] = [
    "glActiveTexture(",
    "glBindBufferBase(",
    "glBindFramebuffer(",
    "glBindImageTexture(",
    "glBindTexture(",
    "glFramebufferDepth(",
    "glMemoryBarrier(",
];

/// The words of a sentence that ask for such a call.
const ASKING: [(&str, &str); 2] = [
    ("glBindTexture(", "textured quad"),
    ("glBindBufferBase(", "base offset into the pool"),
];

/// Lines of plumbing that are said to be a sentence's, though it does not ask for them.
fn not_asked_for(lines: &[TextLine]) -> Vec<&str> {
    let unasked = |line: &&TextLine| {
        let text = line.text.trim_start();
        let Some(call) = PLUMBING.iter().find(|call| text.starts_with(**call)) else {
            return false;
        };
        let asks = |quote: &str| {
            ASKING
                .iter()
                .any(|(asked, words)| asked == call && quote.contains(words))
        };
        matches!(line.origin, Some(Origin::Prose { quote }) if !asks(quote))
    };
    let unasked = lines.iter().filter(unasked);
    unasked.map(|line| line.text.as_str()).collect()
}

#[test]
fn no_sentence_is_said_to_ask_for_a_texture_unit() {
    let mut plumbing = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            for reading in Reading::ALL {
                let lines = text.lines(reading);
                let none: [&str; 0] = [];
                assert_eq!(not_asked_for(&lines), none, "{}/{key}", paper.key);
                let is = |line: &&TextLine| line.text.trim_start().starts_with("glActiveTexture(");
                plumbing += lines.iter().filter(is).count();
            }
        }
    }
    assert!(plumbing > 50, "{plumbing}");
    const STEPS: &[Step] = steps! {
        prose "each layer as viewport-sized textured quad";
        glActiveTexture(2);
        glBindTexture(onionskin::low_level::papers::stage::ACCUMULATED);
        edition "as it was before";
        glActiveTexture(0);
    };
    let listing = Listing {
        title: "",
        source: "",
        dialect: Dialect::Calls,
        steps: STEPS,
    };
    assert_eq!(
        not_asked_for(&print::lines(&listing, &[])),
        ["glActiveTexture(TEXTURE2);"]
    );
}

/// In the literal reading each filling's place says that the paper is silent there, and why it is filled elsewhere. Otherwise
/// it is the text without any amendment.
#[test]
fn literally_the_place_of_every_filling_says_that_the_paper_is_silent() {
    let mut silences = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            let literal = text.lines(Reading::Literal);
            let (silent, rest): (Vec<_>, Vec<_>) = literal
                .into_iter()
                .partition(|line| matches!(line.origin, Some(Origin::Silence { .. })));
            let bare = match text {
                Text::Listing(listing, _) => print::lines(listing, &[]),
                Text::Pseudocode(algorithm, _) => pseudo::lines(algorithm, &[]),
                Text::Lists(algorithm, _) => list::lines(algorithm, &[]),
            };
            assert_eq!(rest, bare, "{}/{key}", paper.key);
            // The reason of each filling that stands in the text, once for each place; inner ones go with the outer one.
            let filled: BTreeSet<_> = text
                .lines(Reading::AsPrinted)
                .iter()
                .filter_map(|line| match line.origin {
                    Some(Origin::Filling { why, .. }) => Some(why),
                    _ => None,
                })
                .collect();
            for line in &silent {
                let Some(Origin::Silence { key, why, .. }) = line.origin else {
                    panic!("it is one");
                };
                assert!(line.note && filled.contains(why), "{key}");
                let says = |words: &str| assert!(line.text.contains(words), "{}", line.text);
                says("// the paper does not say: ");
                says(why);
                says(&format!(
                    "(filled by {key} in the reading as-printed, because "
                ));
            }
            assert_eq!(silent.is_empty(), filled.is_empty(), "{}/{key}", paper.key);
            silences += silent.len();
        }
    }
    assert!(silences >= 15, "{silences}");
}

/// What is quoted stands in one of the papers.
#[test]
fn every_quotation_is_from_a_paper() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/papers");
    let Ok(scans) = fs::read_dir(folder) else {
        println!("skipped: there are no scans of the papers beside the project");
        return;
    };
    let scans = scans.map(|scan| fs::read_to_string(scan.unwrap().path()).expect("a scan"));
    let scans: Vec<_> = scans.map(|scan| flowing(&scan)).collect();
    let found = |part: &str| scans.iter().any(|scan| scan.contains(&flowing(part)));
    let mut quotations = BTreeSet::new();
    for paper in papers() {
        for (_, text) in paper.texts {
            for line in text.lines(Reading::Amended) {
                match line.origin {
                    Some(Origin::Prose { quote }) => _ = quotations.insert(quote),
                    // A filling quotes between quotation marks.
                    Some(Origin::Filling { rests_on, .. }) => {
                        quotations.extend(rests_on.split('"').skip(1).step_by(2));
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(quotations.len() > 30, "{}", quotations.len());
    let parts = quotations
        .iter()
        .flat_map(|quotation| quotation.split(" ... "));
    let missing: Vec<_> = parts.filter(|part| !found(part)).collect();
    assert!(missing.is_empty(), "{missing:#?}");
    assert!(!found("the algorithm peels the opaque geometry"));
}

/// A text without its line breaks, and without what a typesetter and a scanner do to words.
fn flowing(text: &str) -> String {
    let text = text
        .to_lowercase()
        .replace("-\n", "")
        .replace(['“', '”'], "\"");
    text.chars().filter(|c| !c.is_whitespace()).collect()
}
