//! The listings and algorithms of Carr et al. (2008) against transcripts of the paper. No GL.
//!
//! The transcripts leave out what is no statement: the comments that name stencilOp's three places, `gChanged`'s "occlusion
//! query", semicolons of Algorithm 2. Arrows are written `<-`, and subscripts on the line.

use crate::kit::diff::diff;
use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal, passes};
use onionskin::low_level::steps::{Amendment, gl::*, print, pseudo};
use onionskin::{Text, papers, steps};

const PASSES: &str = include_str!("../transcripts/carr_passes.txt");
const ALGORITHM_1: &str = include_str!("../transcripts/carr_algorithm_1.txt");
const ALGORITHM_2: &str = include_str!("../transcripts/carr_algorithm_2.txt");

/// The transcript of one pass, spelled as the printer spells it: a space after a comma.
fn transcript(pass: &str) -> String {
    let text = PASSES.split(&format!("{pass}\n")).nth(1).unwrap();
    let text = text.split("\n\n").next().unwrap();
    // GL calls it DST_ALPHA; the paper prints DEST_ALPHA.
    text.replace(',', ", ").replace("DEST_ALPHA", "DST_ALPHA")
}

#[test]
fn the_state_listings_print_as_the_paper_has_them() {
    for (name, listing) in [
        ("Pass 1", &passes::PASS_1),
        ("Pass 2", &passes::PASS_2),
        ("Pass 3", &passes::PASS_3),
        ("Pass 4", &passes::PASS_4),
        ("Section 6", &passes::SECTION_6),
    ] {
        let found = diff(
            &points(&transcript(name)),
            &points(&print::listing(listing, &[])),
        );
        assert_eq!(found, "", "{name}");
    }
}

/// `1.0` and `1` are the same number.
fn points(text: &str) -> String {
    text.replace(".0", "")
}

#[test]
fn a_changed_word_is_found_by_the_diff() {
    const WORD: Amendment = Amendment {
        key: "changed",
        place: "pass 3",
        printed: steps! { glDepthFunc(GREATER); },
        amended: steps! { glDepthFunc(GEQUAL); },
        why: "a negative control",
        test: "this one",
    };
    let changed = print::listing(&passes::PASS_3, &[WORD]);
    let found = diff(&points(&transcript("Pass 3")), &points(&changed));
    assert!(found.contains("+glDepthFunc(GEQUAL);"), "{found}");
}

#[test]
fn c02_algorithm_1_prints_as_the_paper_has_it() {
    assert_eq!(
        diff(ALGORITHM_1, &pseudo::print(&hybrid::ALGORITHM_1, &[])),
        ""
    );
}

#[test]
fn algorithm_2_prints_as_the_paper_has_it() {
    assert_eq!(
        diff(ALGORITHM_2, &pseudo::print(&ideal::ALGORITHM_2, &[])),
        ""
    );
}

#[test]
fn a_changed_line_of_an_algorithm_is_found_by_the_diff() {
    let amended = pseudo::print(&hybrid::ALGORITHM_1, &hybrid::AMENDMENTS_1);
    let found = diff(ALGORITHM_1, &amended);
    assert!(found.contains("zPeel <= zFragment < zPeelNext"), "{found}");
    assert!(found.contains("zPeel <- before zNear"), "{found}");
}

#[test]
fn every_amendment_of_an_algorithm_is_found_in_it_once() {
    for (amendments, algorithm) in [
        (&hybrid::AMENDMENTS_1[..], &hybrid::ALGORITHM_1),
        (&ideal::AMENDMENTS_2[..], &ideal::ALGORITHM_2),
        (&ideal::TIGHT_BOUND[..], &ideal::ALGORITHM_2),
    ] {
        for amendment in amendments {
            assert_eq!(
                amendment.occurrences(algorithm.lines),
                1,
                "{}",
                amendment.place
            );
        }
    }
}

#[test]
fn every_amendment_of_the_loops_shows_where_it_holds() {
    let a = print::listing(&coherent::VARIANT_A, &coherent::AMENDMENTS);
    let b = print::listing(&coherent::VARIANT_B, &coherent::AMENDMENTS);
    for amendment in coherent::AMENDMENTS {
        let line = format!("// {}: {}", amendment.key, amendment.why);
        assert!(a.contains(&line) || b.contains(&line), "{line}");
    }
    // And as printed none does.
    let as_printed = print::listing(&coherent::VARIANT_A, &[]);
    assert!(!as_printed.contains("// X"), "{as_printed}");
}

#[test]
fn x25_the_passes_of_section_5_are_six() {
    // "Using five passes", says the opening of section 5.
    let draws = print::listing(&coherent::LOOP_A, &[])
        .matches("drawTransparentObjects")
        .count();
    assert_eq!(draws, 6);
    let draws = print::listing(&coherent::LOOP_B, &[])
        .matches("drawTransparentObjects")
        .count();
    assert_eq!(draws, 5);
}

#[test]
fn x18_three_calls_of_section_6_do_nothing() {
    // glClearStencil without a clear of the stencil, and a clear of the depth that the next line makes again.
    let text = print::listing(&passes::SECTION_6, &[]);
    assert!(
        text.contains("glClearStencil(0)") && !text.contains("STENCIL_BUFFER_BIT"),
        "{text}"
    );
    let cleared_twice = "glClear(DEPTH_BUFFER_BIT);\nglClear(COLOR_AND_DEPTH_BUFFER_BITS);";
    assert!(text.contains(cleared_twice), "{text}");
}

#[test]
fn the_paper_is_in_the_index_with_all_it_prints() {
    let carr = papers().iter().find(|paper| paper.key == "carr").unwrap();
    let listings = carr
        .texts
        .iter()
        .filter(|(_, text)| matches!(text, Text::Listing(..)));
    assert_eq!((listings.count(), carr.texts.len()), (12, 12 + 2));
}
