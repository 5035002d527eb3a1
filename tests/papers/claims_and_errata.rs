//! Claims and errata: none is missing, none has no test, no two have one key.

use std::collections::BTreeSet;
use std::path::Path;

use onionskin::low_level::papers::{Claim, Erratum, papers};

use crate::ledger::cited;

/// Every claim of the four publications that a program can check: the paper's letter, and how many it has.
const NUMBERED: [(&str, u32); 4] = [("E", 15), ("C", 27), ("L", 25), ("V", 10)];

fn claims() -> impl Iterator<Item = &'static Claim> {
    papers().iter().flat_map(|paper| paper.claims)
}

fn errata() -> impl Iterator<Item = &'static Erratum> {
    papers().iter().flat_map(|paper| paper.errata)
}

#[test]
fn every_claim_is_there_in_its_order() {
    let numbered = NUMBERED
        .iter()
        .flat_map(|&(letter, count)| (1..=count).map(move |number| format!("{letter}{number:02}")));
    let expected: Vec<_> = numbered.collect();
    let mut keys: Vec<_> = claims().map(|claim| claim.key).collect();
    keys.sort_by_key(|key| "ECLV".find(&key[..1]));
    assert_eq!(keys, expected);
    assert_eq!(keys.len(), 77);
}

#[test]
fn no_two_rows_have_one_key_and_errata_have_none_that_a_claim_could_have() {
    let mut keys = BTreeSet::new();
    for key in claims()
        .map(|claim| claim.key)
        .chain(errata().map(|erratum| erratum.key))
    {
        assert!(keys.insert(key), "{key} is there twice");
    }
    for paper in papers() {
        let letter = paper.key[..1].to_uppercase();
        let mut numbers = (1..).map(|number| format!("{letter}X{number:02}"));
        for erratum in paper.errata {
            assert_eq!(Some(erratum.key), numbers.next().as_deref());
        }
        assert!(
            paper
                .claims
                .iter()
                .all(|claim| claim.key.starts_with(&letter))
        );
    }
}

#[test]
fn every_claim_has_a_test_whose_name_begins_with_its_key() {
    for claim in claims() {
        let key = claim.key.to_lowercase();
        let by_key = |path: &&&str| {
            let name = path.rsplit("::").next().unwrap();
            name.starts_with(&format!("{key}_")) || name.contains(&format!("_{key}_"))
        };
        let shared = |path: &&&str| path.ends_with("::c07_to_c10_figure_2_on_opengl");
        let own = claim
            .tests
            .iter()
            .filter(by_key)
            .filter(|path| !shared(path));
        assert!(own.count() > 0, "{} {:?}", claim.key, claim.tests);
    }
}

/// The compiler checks the paths of the binaries that have `kit/ledger.rs`.
#[test]
fn every_test_is_in_a_binary_that_checks_its_path() {
    let checks = |binary: &str| {
        let main = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/{binary}/main.rs"));
        let text = std::fs::read_to_string(main).unwrap_or_default();
        text.contains("#[path = \"../kit/ledger.rs\"]")
            && text.contains(&format!("    ({binary} $(:: $name:ident)+) =>"))
    };
    assert!(checks("papers") && !checks("house"));
    for path in cited() {
        let (binary, _) = path.split_once("::").unwrap();
        assert!(checks(binary), "{path}");
    }
}

#[test]
fn every_row_says_something_and_the_errata_that_it_names_are_there() {
    let claims = claims().map(|claim| {
        let figures = claim
            .figures
            .iter()
            .flat_map(|figure| [figure.of, figure.here, figure.paper.unwrap_or("none")]);
        let texts = [claim.place, claim.claim, claim.evidence]
            .into_iter()
            .chain(figures);
        (claim.key, claim.tests, texts.collect::<Vec<_>>())
    });
    let errata_texts = errata().map(|erratum| {
        let texts = [
            erratum.place,
            erratum.printed,
            erratum.executed,
            erratum.change,
        ];
        (erratum.key, erratum.tests, texts.to_vec())
    });
    let keys: BTreeSet<_> = errata().map(|erratum| erratum.key).collect();
    for (key, tests, texts) in claims.chain(errata_texts) {
        assert!(!tests.is_empty(), "{key}");
        for text in texts {
            assert!(
                !text.trim().is_empty() && !text.contains("@@"),
                "{key}: {text}"
            );
            let words = text.split(|c: char| !c.is_ascii_alphanumeric());
            let named = words.filter(|word| {
                word.len() == 4 && word.as_bytes()[1] == b'X' && word[2..].parse::<u8>().is_ok()
            });
            for word in named {
                assert!(keys.contains(word), "{key} names {word}");
            }
        }
    }
}
