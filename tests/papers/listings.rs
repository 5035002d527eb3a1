//! The listings as data: printed like the paper's, unrolled into calls, lowered to one depth unit. No GL.

use onionskin::low_level::papers::{everitt_2001, vtk};
use onionskin::low_level::steps::{
    Amendment, Call, Compare, DepthUnits, Machine, Map, Objects, Query, Reading, Reason, Recorder,
    Variables, free_variables, gl::*, print, run,
};
use onionskin::{Error, Text, papers, steps};

use crate::kit::changed::changed;
use crate::kit::golden::assert_golden;

#[test]
pub(crate) fn e03_listing_1_prints_as_the_paper_has_it() {
    let transcript = include_str!("../print/everitt/listing-1.txt");
    assert_eq!(print::listing(&everitt_2001::LISTING_1, &[]), transcript);
}

#[test]
pub(crate) fn e03_two_rounds_of_listing_1_unroll_with_their_buffers() {
    let mut recorder = Recorder::new();
    run(
        &everitt_2001::LISTING_1,
        &[],
        Variables::new().with("num_passes", 2.0),
        &mut recorder,
    )
    .unwrap();
    assert_golden("everitt_listing_1_two_rounds.txt", &recorder.trace());
}

#[test]
pub(crate) fn e03_unit_0_becomes_a_shadow_lookup_and_unit_1_the_ordinary_depth_test() {
    let mut recorder = Recorder::new();
    let variables = Variables::new().with("num_passes", 2.0);
    run(
        &everitt_2001::LISTING_1,
        &[],
        variables,
        &mut DepthUnits::new(&mut recorder),
    )
    .unwrap();
    assert_golden(
        "everitt_listing_1_two_rounds_lowered.txt",
        &recorder.trace(),
    );
}

#[test]
fn depth_unit_0_cannot_write() {
    let mut recorder = Recorder::new();
    let mut units = DepthUnits::new(&mut recorder);
    units.perform(&Call::ActiveDepthUnit { unit: 0 }).unwrap();
    let error = units
        .perform(&Call::DepthMask { flag: true })
        .unwrap_err()
        .to_string();
    assert!(
        error.contains("depth unit 0 cannot perform glDepthMask(flag = GL_TRUE)"),
        "{error}"
    );
    assert!(
        units
            .perform(&Call::Clear {
                mask: DEPTH_BUFFER_BIT
            })
            .is_err()
    );
    assert!(units.perform(&Call::ActiveDepthUnit { unit: 2 }).is_err());
}

#[test]
fn the_loop_stops_at_the_first_empty_peel() {
    let (outcome, calls) = peel([5, 3, 0], [4, 2], f64::INFINITY, 0.0);
    assert_eq!(outcome, (Some(Reason::EmptyLayer), 2.0, 3.0));
    let draws = calls
        .iter()
        .filter(|call| {
            matches!(
                call,
                Call::Draw {
                    objects: Objects::Transparent
                }
            )
        })
        .count();
    assert_eq!(draws, 3);
}

#[test]
fn the_loop_stops_at_the_limit_without_an_empty_peel() {
    let (outcome, _) = peel([5, 3], [4, 2], 2.0, 0.0);
    assert_eq!(outcome, (None, 2.0, 2.0));
}

#[test]
fn the_loop_stops_after_the_peel_that_changed_fewer_pixels_than_the_ratio() {
    // 100 pixels: 10% are 10, and 9 are fewer.
    let (outcome, _) = peel([50, 30, 20], [40, 10, 9], f64::INFINITY, 0.1);
    assert_eq!(outcome, (Some(Reason::OcclusionRatio), 3.0, 3.0));
}

#[test]
fn a_variable_that_was_never_set_is_an_error_that_names_it() {
    let mut recorder = Recorder::new();
    let error = run(
        &everitt_2001::LISTING_1,
        &[],
        Variables::new(),
        &mut recorder,
    )
    .unwrap_err();
    assert!(matches!(error, Error::OutOfOrder { .. }));
    assert!(error.to_string().contains("num_passes"), "{error}");
}

#[test]
fn every_amendment_finds_what_it_replaces_exactly_once() {
    let listing_1 = [
        vtk::NO_CLEAR,
        vtk::CULL_BY_OPAQUE,
        vtk::QUERY,
        vtk::KEEP_DEPTH,
        vtk::UNDER,
    ];
    let composite = [
        everitt_2001::ALPHA,
        vtk::ONLY_THE_LAYER,
        vtk::COUNT_THE_LAYER,
    ];
    for amendment in listing_1 {
        assert_eq!(
            amendment.occurrences(everitt_2001::LISTING_1.steps),
            1,
            "{}",
            amendment.place
        );
    }
    for amendment in composite {
        assert_eq!(
            amendment.occurrences(everitt_2001::COMPOSITE.steps),
            1,
            "{}",
            amendment.place
        );
    }
}

#[test]
fn an_outer_amendment_reaches_into_the_listings_that_are_run() {
    const DROPPED: Amendment = changed(steps! { clear color buffer; }, steps! {});
    let mut recorder = Recorder::new().answering_every_query(1);
    let variables = Variables::new()
        .with("num_passes", 1.0)
        .with("occlusion_ratio", 0.0)
        .with("window_area", 1.0);
    run(
        &vtk::ON_THE_FLY,
        &[DROPPED],
        variables,
        &mut DepthUnits::new(&mut recorder),
    )
    .unwrap();
    let clears = recorder
        .calls
        .iter()
        .filter(|call| {
            **call
                == Call::Clear {
                    mask: COLOR_BUFFER_BIT,
                }
        })
        .count();
    // Without the amendment it would be one: the accumulation's.
    assert_eq!(clears, 0);
}

#[test]
fn a_call_prints_with_its_arguments_named() {
    let call = Call::DepthFunc {
        func: Compare::Less,
    };
    assert_eq!(call.to_string(), "glDepthFunc(func = GL_LESS)");
    let copy = Call::CopyImage {
        from: Map::named("color buffer"),
        to: Map::numbered("layer", 3),
    };
    let swap = Call::Swap {
        a: Map::named("zPeel"),
        b: Map::named("zPeelNext"),
    };
    assert_eq!(swap.to_string(), "swap(a = zPeel, b = zPeelNext)");
    assert_eq!(
        copy.to_string(),
        "glCopyImageSubData(src = color buffer, dst = layer 3)"
    );
}

/// Runs the on-the-fly peeling over 100 pixels with queries that answer as told: why it stopped, layers, peels.
fn peel(
    peeled: impl IntoIterator<Item = u64>,
    pixels: impl IntoIterator<Item = u64>,
    limit: f64,
    ratio: f64,
) -> ((Option<Reason>, f64, f64), Vec<Call>) {
    let mut recorder = Recorder::new()
        .answering(Query("peeled"), peeled)
        .answering(Query("pixels"), pixels);
    let variables = Variables::new()
        .with("num_passes", limit)
        .with("occlusion_ratio", ratio)
        .with("window_area", 100.0);
    let outcome = run(
        &vtk::ON_THE_FLY,
        &[],
        variables,
        &mut DepthUnits::new(&mut recorder),
    )
    .unwrap();
    let number = |name| outcome.variables.get(name).unwrap();
    (
        (outcome.stopped, number("num_layers"), number("peels")),
        recorder.calls,
    )
}

/// Given what is free, every listing of every paper runs, as printed and as amended; so nothing is missing that is read.
#[test]
fn with_its_free_variables_every_listing_runs() {
    let mut several = 0;
    for paper in papers() {
        for (key, text) in paper.texts {
            for reading in Reading::ALL {
                let Text::Listing(listing, amendments) = text else {
                    continue;
                };
                let amendments = reading.of(amendments);
                let free = free_variables(listing, &amendments);
                several += free.len();
                let given = Variables::new();
                let given = free.iter().fold(given, |all, name| all.with(name, 2.0));
                let mut recorder = Recorder::new().answering_every_query(1);
                run(listing, &amendments, given, &mut recorder)
                    .unwrap_or_else(|error| panic!("{}/{key}: {error}", paper.key));
            }
        }
    }
    assert!(several > 5, "some have free variables: {several}");
}

#[test]
fn without_a_free_variable_that_it_reads_a_listing_does_not_run() {
    let listing = &everitt_2001::LISTING_1;
    assert_eq!(free_variables(listing, &[]), ["num_passes"]);
    let mut recorder = Recorder::new().answering_every_query(1);
    assert!(run(listing, &[], Variables::new(), &mut recorder).is_err());
}
