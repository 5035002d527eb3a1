//! The papers' print, to the letter. `tests/print` has a transcript of each printed text, which nothing rewrites. In them
//! only white space is not the papers' own: the scans have lost most of it.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use onionskin::low_level::steps::pseudo::{self, list};
use onionskin::low_level::steps::{
    Amendment, Dialect, Listing, Met, Origin, Reading, Scope, Spelling, Statement, Step, TextLine,
    gl::*, print,
};
use onionskin::{Text, lists, papers, pseudo, steps, texts};

/// The texts that papers print, each with the scan of its paper.
const PRINTED: [(&str, &str); 11] = [
    ("carr/pass-1", "carr-2008-second-scan"),
    ("carr/pass-2", "carr-2008-second-scan"),
    ("carr/pass-3", "carr-2008-second-scan"),
    ("carr/pass-4", "carr-2008-second-scan"),
    ("carr/section-6", "carr-2008-second-scan"),
    ("carr/algorithm-1", "carr-2008-second-scan"),
    ("carr/algorithm-2", "carr-2008-second-scan"),
    ("everitt/listing-1", "everitt-2001"),
    ("everitt/listing-2", "everitt-2001"),
    ("lindholm/section-5.1", "lindholm-2015"),
    ("lindholm/section-5.2", "lindholm-2015"),
];

#[test]
fn what_is_printed_is_the_paper_s_to_the_letter() {
    for (key, _) in PRINTED {
        for reading in [Reading::Literal, Reading::AsPrinted] {
            assert_eq!(printed(text(key), reading), transcript(key), "{key}");
        }
    }
}

/// A text whose every line is printed is one of those that have a transcript.
#[test]
fn whatever_is_printed_has_a_transcript() {
    let transcripts = PRINTED.map(|(key, _)| transcript(key));
    let mut found = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            let lines = text.lines(Reading::Literal);
            let mut lines = lines.iter().filter(|line| !line.note);
            if lines.all(|line| line.origin == Some(Origin::Printed)) {
                let printed = printed(text, Reading::Literal);
                assert!(transcripts.contains(&printed), "{}/{key}", paper.key);
                found += 1;
            }
        }
    }
    assert!(found >= PRINTED.len(), "{found}");
}

#[test]
fn a_changed_letter_is_noticed() {
    const WORD: Amendment = crate::kit::changed::changed(
        steps! { glDepthFunc(GREATER); },
        steps! { glDepthFunc(GEQUAL); },
    );
    let Text::Listing(pass_3, _) = text("carr/pass-3") else {
        panic!("it is a listing");
    };
    let changed = print::listing(pass_3, &[WORD]);
    let expected = transcript("carr/pass-3");
    assert!(changed.contains("glDepthFunc(GEQUAL);\n"), "{changed}");
    assert!(expected.contains("glDepthFunc(GREATER);\n"), "{expected}");
    // What stands in the place of a printed line is not printed.
    let text = Text::Listing(*pass_3, &[WORD]);
    let left = printed(&text, Reading::Amended);
    assert_eq!(left, expected.replace("glDepthFunc(GREATER);\n", ""));
}

/// The paper's own spelling of a statement and what the statement does are one thing.
#[test]
fn a_spelling_says_what_its_statement_does() {
    let mut spelt = 0;
    for (key, _) in PRINTED {
        let differing = match text(key) {
            Text::Listing(listing, _) => spellings(listing.steps, &|step| {
                print::listing(
                    &Listing {
                        steps: step,
                        ..*listing
                    },
                    &[],
                )
            }),
            Text::Pseudocode(algorithm, _) => spellings(algorithm.lines, &|line| line[0].head()),
            Text::Lists(algorithm, _) => spellings(algorithm.lines, &|line| line[0].to_string()),
        };
        spelt += differing.len();
        for (spelling, own) in differing {
            assert_eq!(bare(&spelling), bare(&own), "{key}");
        }
    }
    assert!(spelt > 20, "{spelt}");
    assert_ne!(
        bare("glTranslatef( 0, 0,.5);"),
        bare("glTranslatef(0, 0, 0.25);")
    );
    assert_ne!(bare("z1 ← zOpaque;"), bare("z2 ← zOpaque"));
}

/// The spelt statements, each with how it would be printed.
fn spellings<S: Statement>(
    statements: &'static [S],
    print: &dyn Fn(&'static [S]) -> String,
) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for met in Scope::of(&[]).walk(statements) {
        let Met::Statement(statement, scope) = met else {
            continue;
        };
        if let Some(Spelling { text, meaning }) = scope.spelling() {
            // The wrong word, and the right one.
            let text = match meaning {
                Some("GL_DST_ALPHA") => text.replace("DEST_ALPHA", "DST_ALPHA"),
                Some(other) => panic!("{other}"),
                None => text.to_owned(),
            };
            found.push((text, print(std::slice::from_ref(statement))));
        }
        for body in statement.bodies() {
            found.extend(spellings(body, print));
        }
    }
    found
}

/// A line without what its paper may write in one way or another: comments, white space, brackets, ends, zeros.
fn bare(text: &str) -> String {
    let no_comment = |line: &str| {
        let code = line.split('▷').next().unwrap_or_default();
        code.split("//").next().unwrap_or_default().to_owned()
    };
    let code: String = text.lines().map(no_comment).collect();
    let letters = code.chars().filter(|c| !" ();".contains(*c));
    let letters: String = letters.collect();
    letters.replace("0.5", ".5").replace("0.0", "0")
}

/// `repairs.tsv` says line by line what a scan has and what was read.
#[test]
fn the_transcripts_are_the_scans_but_for_the_repairs_that_are_listed() {
    let scans = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/papers");
    if !scans.exists() {
        println!("skipped: there are no scans of the papers beside the project");
        return;
    }
    let repairs = read("repairs.tsv");
    let repairs: Vec<Vec<&str>> = repairs
        .lines()
        .map(|line| line.split('\t').collect())
        .collect();
    let mut repaired = 0;
    for (key, scan) in PRINTED {
        let scan = fs::read_to_string(scans.join(format!("{scan}.txt"))).expect("a scan");
        let repair = |line: String| {
            let of_line = |it: &&Vec<&str>| it[0] == key && squeezed(it[1]) == line;
            repairs
                .iter()
                .find(of_line)
                .map_or(line, |it| squeezed(it[2]))
        };
        let lines = |text: &str| -> Vec<String> {
            let lines = text.lines().map(squeezed);
            lines.filter(|line| !line.is_empty()).collect()
        };
        let (before, expected) = (lines(&scan), lines(&transcript(key)));
        let after: Vec<_> = before.iter().cloned().map(repair).collect();
        let at = after.windows(expected.len()).position(|it| it == expected);
        let at = at.unwrap_or_else(|| panic!("{key} is not in the scan"));
        let here = at..at + expected.len();
        repaired += here.filter(|&line| before[line] != after[line]).count();
    }
    // And no repair is idle.
    assert_eq!(repaired, repairs.len() - 1);
}

fn squeezed(line: &str) -> String {
    line.split_whitespace().collect()
}

fn text(key: &str) -> &'static Text {
    texts(key).expect("a text").remove(0).1
}

fn transcript(key: &str) -> String {
    read(&format!("{key}.txt"))
}

fn read(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/print");
    fs::read_to_string(folder.join(name)).expect("a file of tests/print")
}

/// The printed lines alone.
fn printed(text: &Text, reading: Reading) -> String {
    let lines = text.lines(reading);
    let printed = lines
        .iter()
        .filter(|line| line.origin == Some(Origin::Printed));
    printed.map(|line| format!("{}\n", line.text)).collect()
}

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
