//! The papers' print, to the letter. `tests/print` has a transcript of each printed text, which nothing rewrites. In them
//! only white space is not the papers' own: the scans have lost most of it.

use std::fs;
use std::path::Path;

use onionskin::low_level::steps::{
    Amendment, Listing, Met, Origin, Reading, Scope, Spelling, Statement, gl::*, print,
};
use onionskin::{Text, papers, steps, texts};

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
            Text::Pseudocode(algorithm, _) => {
                spellings(algorithm.lines, &|line| line[0].to_string())
            }
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
pub(crate) fn bare(text: &str) -> String {
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

pub(crate) fn squeezed(line: &str) -> String {
    line.split_whitespace().collect()
}

pub(crate) fn text(key: &str) -> &'static Text {
    texts(key).expect("a text").remove(0).1
}

pub(crate) fn transcript(key: &str) -> String {
    read(&format!("{key}.txt"))
}

pub(crate) fn read(name: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/print");
    fs::read_to_string(folder.join(name)).expect("a file of tests/print")
}

/// The printed lines alone.
pub(crate) fn printed(text: &Text, reading: Reading) -> String {
    let lines = text.lines(reading);
    let printed = lines
        .iter()
        .filter(|line| line.origin == Some(Origin::Printed));
    printed.map(|line| format!("{}\n", line.text)).collect()
}
