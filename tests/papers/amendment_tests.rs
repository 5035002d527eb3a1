//! Every amendment names a test that exists: one of this binary, or one that a claim or an erratum names by its path, which
//! the compiler checks.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use onionskin::low_level::steps::{Origin, Reading};
use onionskin::papers;

use crate::ledger::{cited, compiled};

/// Of a method whose paper has no claims here, a test of another binary, with that binary's file.
const WITHOUT_CLAIMS: [(&str, &str); 5] = [
    (
        "by_images_every_image_is_the_same",
        include_str!("../gl/by_images.rs"),
    ),
    (
        "every_bundled_scene_is_exact_by_the_verified_painter",
        include_str!("../gl/verified_painter.rs"),
    ),
    (
        "triangles_that_cross_planes_are_drawn_in_pieces",
        include_str!("../gl/verified_painter_pieces.rs"),
    ),
    (
        "a_query_that_is_read_a_peel_late_costs_one_peel_and_changes_no_bit",
        include_str!("../gl/peeling_improved.rs"),
    ),
    (
        "only_pixels_that_are_alive_are_peeled_and_no_bit_changes",
        include_str!("../gl/peeling_improved.rs"),
    ),
];

#[test]
fn every_amendment_names_a_test_that_is_compiled() {
    let existing = existing();
    let missing: Vec<_> = named()
        .into_iter()
        .filter(|name| !existing.contains(name))
        .collect();
    assert!(missing.is_empty(), "no such tests: {missing:?}");
    assert!(!existing.contains("no_such_test"));
}

/// The amendments are read from the sources, for some stand in no text: improvements, and those that methods choose. The
/// data themselves say whether the reading finds them.
#[test]
fn every_amendment_of_every_text_is_among_those_that_are_held_against_the_tests() {
    let named = named();
    let of_texts: Vec<_> = papers()
        .iter()
        .flat_map(|paper| paper.texts)
        .flat_map(|(_, text)| text.tests())
        .collect();
    for test in &of_texts {
        assert!(named.contains(*test), "{test}");
    }
    // Of every kind of text, and of what texts run.
    for test in [
        "v06_both_ways_of_compositing_give_the_same_image",
        "cx22_pixels_that_are_done_composite_their_last_layer_again",
        "l13_what_lies_at_depth_0_is_skipped_as_printed",
        "every_pixel_of_a_layer_is_counted_once",
        "l16_without_the_opaque_surface_a_ray_goes_on_behind_it",
    ] {
        assert!(of_texts.contains(&test), "{test}");
    }
}

/// Improvements, which amend nothing that is wrong and belong to no claim.
const IMPROVEMENTS: [&str; 8] = [
    "GEQUAL",
    "early stop",
    "batches",
    "images",
    "nothing opaque",
    "in pieces",
    "late query",
    "alive",
];

/// So that a reader of a listing finds the key in the tables.
#[test]
fn every_amendment_s_key_is_that_of_an_erratum_or_of_a_claim_or_an_improvement_s() {
    let errata = papers().iter().flat_map(|paper| paper.errata);
    let errata: BTreeSet<&str> = errata.map(|erratum| erratum.key).collect();
    let claims = papers().iter().flat_map(|paper| paper.claims);
    let claims: BTreeSet<&str> = claims.map(|claim| claim.key).collect();
    // Those of the sources, for some stand in no text.
    let keys = strings("key: \"");
    let keys = keys.iter().flat_map(|keys| keys.split(", "));
    let keys: BTreeSet<&str> = keys
        .filter(|key| !papers().iter().any(|paper| paper.key == *key))
        .collect();
    let known =
        |key: &&str| errata.contains(*key) || claims.contains(*key) || IMPROVEMENTS.contains(key);
    let unknown: Vec<_> = keys.iter().filter(|key| !known(key)).collect();
    assert!(unknown.is_empty(), "{unknown:?}");
    let improvements = IMPROVEMENTS.iter().filter(|key| keys.contains(**key));
    assert_eq!(improvements.count(), IMPROVEMENTS.len());
    assert!(!known(&"CX99"));
    // What corrects a paper or fills its silence is an erratum of it.
    let mut amending = BTreeSet::new();
    for paper in papers() {
        for (name, text) in paper.texts {
            for reading in [Reading::AsPrinted, Reading::Amended] {
                for line in text.lines(reading) {
                    if let Some(Origin::Filling { key, .. } | Origin::Amendment { key, .. }) =
                        line.origin
                    {
                        for key in key.split(", ") {
                            assert!(errata.contains(key), "{}/{name}: {key}", paper.key);
                            amending.insert(key);
                        }
                    }
                }
            }
        }
    }
    assert!(amending.len() > 20, "{amending:?}");
}

/// The names of tests, without their modules.
fn existing() -> BTreeSet<String> {
    let cited = cited().into_iter().map(str::to_owned);
    let paths = compiled().into_iter().chain(cited);
    let name = |path: String| path.rsplit("::").next().unwrap().to_owned();
    let in_file = |(name, file): &(&str, &str)| file.contains(&format!("#[test]\nfn {name}()"));
    let others = WITHOUT_CLAIMS.iter().filter(|test| in_file(test));
    paths
        .map(name)
        .chain(others.map(|(name, _)| (*name).to_owned()))
        .collect()
}

/// The tests that the amendments in the sources name.
fn named() -> BTreeSet<String> {
    let found = strings("test: \"");
    assert!(found.len() > 40, "{}", found.len());
    found
}

/// The strings of this field in the sources.
fn strings(field: &str) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    collect(&folder, field, &mut found);
    found
}

fn collect(folder: &Path, field: &str, found: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        // Pages have keys of their own.
        if path.is_dir() && path.ends_with("src/edition") {
            continue;
        }
        if path.is_dir() {
            collect(&path, field, found);
            continue;
        }
        let text = fs::read_to_string(&path).unwrap();
        let lines = text.lines().map(str::trim);
        let strings = lines.filter_map(|line| line.strip_prefix(field)?.strip_suffix("\","));
        found.extend(strings.map(str::to_owned));
    }
}
