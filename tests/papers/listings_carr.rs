//! The listings and algorithms of Carr et al. (2008): what the paper says of them, and where amendments hold. No GL.

use onionskin::low_level::papers::carr_2008::{coherent, hybrid, ideal};
use onionskin::low_level::steps::{print, pseudo};
use onionskin::{Text, papers};

#[test]
pub(crate) fn c02_algorithm_1_prints_as_the_paper_has_it() {
    let transcript = include_str!("../print/carr/algorithm-1.txt");
    assert_eq!(pseudo::print(&hybrid::ALGORITHM_1, &[]), transcript);
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
pub(crate) fn cx25_the_passes_of_section_5_are_six() {
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
fn the_paper_is_in_the_index_with_all_it_prints() {
    let carr = papers().iter().find(|paper| paper.key == "carr").unwrap();
    let listings = carr
        .texts
        .iter()
        .filter(|(_, text)| matches!(text, Text::Listing(..)));
    assert_eq!((listings.count(), carr.texts.len()), (12, 12 + 2));
}
