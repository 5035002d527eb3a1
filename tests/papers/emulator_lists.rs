//! ppAO's and ppDP's pseudocode, as printed and as amended, run line by line on lists of fragments: on all small ones,
//! and on random ones that shrink.

use crate::kit::stack;
use onionskin::low_level::emulator::{ListRun, run_on_lists};
use onionskin::low_level::papers::lindholm_2015::components::*;
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::pseudo::Pseudocode;
use onionskin::low_level::steps::pseudo::list::{self, Counter, ListLine, Mark};
use onionskin::{Fragment, Rgba};
use proptest::prelude::*;
use proptest::test_runner::TestError;

use crate::kit::masks::{stencil, times_resolved};
use crate::kit::pp_dp::{Rule, peel};

/// Printed, with a condition that ends it (erratum LX03).
const PRINTED: [Amendment<ListLine>; 1] = [STOP];
/// The text beside the pseudocode, likewise.
const TEXT: [Amendment<ListLine>; 2] = [AS_THE_TEXT_SAYS, STOP];

/// More subpasses than any list here needs.
const ENOUGH: u32 = 100;

fn list(depths: &[u32]) -> Vec<Fragment> {
    let fragment = |(order, &depth): (usize, &u32)| Fragment {
        depth: depth as f32 / 1024.0,
        color: Rgba::default(),
        order: order as u32,
    };
    depths.iter().enumerate().map(fragment).collect()
}

fn run(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
    lists: &[Vec<Fragment>],
    array: u32,
) -> ListRun {
    run_on_lists(algorithm, amendments, lists, array, ENOUGH).expect("it runs")
}

/// The oracle's order: nearest first, and of equal depths the one submitted first.
fn sorted(list: &[Fragment]) -> Vec<u32> {
    let mut orders: Vec<u32> = (0..list.len() as u32).collect();
    orders.sort_by(|&a, &b| {
        let depth = |order: u32| list[order as usize].depth;
        depth(a).total_cmp(&depth(b))
    });
    orders
}

/// Every list of up to `longest` fragments on three depths, 0 among them.
fn small_lists(longest: u32) -> Vec<Vec<u32>> {
    let codes = (0..=longest).flat_map(|count| (0..3_u32.pow(count)).map(move |c| (count, c)));
    codes
        .map(|(count, code)| (0..count).map(|at| code / 3_u32.pow(at) % 3).collect())
        .collect()
}

/// Every order in which a list's records can lie in memory, for lists of up to four.
fn orders(list: &[Fragment]) -> Vec<Vec<Fragment>> {
    let Some((first, rest)) = list.split_first() else {
        return vec![Vec::new()];
    };
    let places = |shorter: Vec<Fragment>| {
        (0..=shorter.len()).map(move |place| {
            let mut longer = shorter.clone();
            longer.insert(place, *first);
            longer
        })
    };
    orders(rest).into_iter().flat_map(places).collect()
}

#[test]
fn every_amendment_is_found_in_its_algorithm_once() {
    let by_stencil = by_stencil(&[], &[]);
    for (algorithm, amendments) in [
        (&PP_DP, &PP_DP_AMENDMENTS[..]),
        (&PP_DP, &N_MINUS_1),
        (&PP_DP, &TEXT),
        (&STATIC_ARRAY, &[KEEP_NEAREST]),
        (
            &PP_AO,
            &[PP_AO_AMENDMENT, PP_AO_WITH_PP_DP, PP_AO_KEEPING_NEAREST],
        ),
        (&PP_AO, &by_stencil),
    ] {
        for amendment in amendments {
            let found = amendment.occurrences(algorithm.lines);
            assert_eq!(found, 1, "{}", amendment.place);
        }
    }
}

/// Lists of up to four fragments on three depths, in every order in memory, with every small buffer: nothing is lost, the
/// order is the oracle's, and no subpass is wasted.
#[test]
pub(crate) fn l13_amended_peeling_is_the_oracle_s_order_of_every_small_list_however_it_lies_in_memory()
 {
    let lists: Vec<_> = small_lists(4).iter().map(|depths| list(depths)).collect();
    let mut cases = 0;
    for submitted in &lists {
        let in_memory = orders(submitted);
        for n in 1..=5 {
            let run = run(&PP_DP, &PP_DP_AMENDMENTS, &in_memory, n);
            assert!(run.ended);
            for (pixel, list) in run.pixels.iter().zip(&in_memory) {
                assert_eq!(pixel.composited, sorted(submitted), "{list:?} {n}");
                let passes = (list.len() as u32).div_ceil(n).max(1);
                assert_eq!(pixel.subpasses, passes, "{list:?} {n}");
                assert_eq!(pixel.records_read, passes * list.len() as u32);
                cases += 1;
            }
        }
    }
    // 3^c lists of c fragments, c! orders, five buffers.
    assert_eq!(cases, 5 * (1 + 3 + 9 * 2 + 27 * 6 + 81 * 24));
}

/// The emulator against a twin in Rust that knows no lines: each rule, every list of up to six fragments, every buffer.
#[test]
fn every_rule_loses_what_its_twin_loses_on_every_small_list() {
    let small = small_lists(6);
    let lists: Vec<_> = small.iter().map(|depths| list(depths)).collect();
    let mut lost = [0; 3];
    for n in 1..=7 {
        for (which, (rule, amendments)) in [
            (Rule::Printed, &PRINTED[..]),
            (Rule::PrintedText, &TEXT),
            (Rule::Amended, &PP_DP_AMENDMENTS),
        ]
        .into_iter()
        .enumerate()
        {
            let run = run(&PP_DP, amendments, &lists, n);
            for (depths, pixel) in small.iter().zip(&run.pixels) {
                let twin = peel(depths, n as usize, rule);
                let resolved: Vec<u32> = twin.resolved.iter().map(|&f| f as u32).collect();
                assert_eq!(pixel.composited, resolved, "{rule:?} {depths:?} {n}");
                assert_eq!(pixel.subpasses as usize, twin.subpasses, "{depths:?} {n}");
                lost[which] += twin.lost;
            }
        }
    }
    assert!(lost[0] > 0 && lost[1] > lost[0] && lost[2] == 0, "{lost:?}");
}

#[test]
pub(crate) fn l13_random_lists_come_out_in_the_oracle_s_order() {
    let depths = proptest::collection::vec(0..40_u32, 0..60);
    let checked = stack::runner(2000).run(&(depths, 1..12_u32), |(depths, n)| {
        let submitted = list(&depths);
        let run = run(
            &PP_DP,
            &PP_DP_AMENDMENTS,
            std::slice::from_ref(&submitted),
            n,
        );
        prop_assert!(run.ended);
        prop_assert_eq!(&run.pixels[0].composited, &sorted(&submitted));
        let (count, passes) = (depths.len() as u32, run.pixels[0].subpasses);
        prop_assert_eq!(passes, count.div_ceil(n).max(1));
        if n > 1 {
            prop_assert!(passes <= count.div_ceil(n - 1).max(1), "L12's bound");
        }
        Ok(())
    });
    if let Err(TestError::Fail(why, case)) = checked {
        panic!("{why}: depths and n {case:?}");
    }
}

/// Erratum LX01. Twenty coplanar fragments and a buffer of eight: twelve are lost. With the rule amended but not what is
/// stored, the same.
#[test]
pub(crate) fn l13_ties_are_lost_where_a_buffer_ends_as_printed() {
    let lists = [list(&[5; 20])];
    let composited = |amendments: &[_]| {
        run(&PP_DP, amendments, &lists, 8).pixels[0]
            .composited
            .len()
    };
    assert_eq!(composited(&PRINTED), 8);
    assert_eq!(composited(&[SKIP_BY_ID, STOP]), 8);
    assert_eq!(composited(&[SKIP_BY_ID, STORE_ID, STOP]), 20);
}

/// Erratum LX04.
#[test]
pub(crate) fn l13_what_lies_at_depth_0_is_skipped_as_printed() {
    let lists = [list(&[3, 0, 4])];
    let composited = |amendments: &[_]| {
        run(&PP_DP, amendments, &lists, 8).pixels[0]
            .composited
            .clone()
    };
    assert_eq!(composited(&PRINTED), [0, 2]);
    assert_eq!(composited(&[START, STOP]), [1, 0, 2]);
}

/// Erratum LX03. Read as a count, "until all fragments are resolved" holds of what was not lost only.
#[test]
pub(crate) fn l13_a_loop_that_waits_for_a_lost_fragment_never_ends() {
    let distinct = [list(&[5, 1, 3, 2, 4])];
    let tied = [list(&[5, 1, 3, 3, 4])];
    let ends = |amendments: &[_], lists: &[_]| run(&PP_DP, amendments, lists, 2).ended;
    assert!(ends(&[], &distinct));
    assert!(!ends(&[], &tied));
    assert!(ends(&PRINTED, &tied));
    let subpasses = run(&PP_DP, &[], &tied, 2).pixels[0].subpasses;
    assert_eq!(subpasses, ENOUGH, "it was left after the limit");
}

/// Erratum LX02. The text's n - 1 a subpass loses one with each that overflows, because it goes on from the n-th. Going on
/// from the last that was resolved loses none, within the bound that the text gives; with n = 1 it stands still.
#[test]
pub(crate) fn l12_n_minus_1_a_pass_but_going_on_from_the_nth_loses_one_a_pass() {
    for count in 1..=64_u32 {
        let lists = [list(&(1..=count).collect::<Vec<_>>())];
        for n in 2..=9 {
            let bound = count.div_ceil(n - 1);
            let text = run(&PP_DP, &TEXT, &lists, n);
            let right = run(&PP_DP, &N_MINUS_1, &lists, n);
            let [text, right] = [&text.pixels[0], &right.pixels[0]];
            let lost = count - text.composited.len() as u32;
            assert_eq!(lost, text.subpasses - 1, "{count} {n}");
            assert_eq!(right.composited, sorted(&lists[0]), "{count} {n}");
            assert!(right.subpasses <= bound, "{count} {n}");
            assert_eq!(right.subpasses, (count - 1).div_ceil(n - 1).max(1));
            let printed = &run(&PP_DP, &PRINTED, &lists, n).pixels[0];
            assert_eq!(
                printed.subpasses,
                count.div_ceil(n),
                "resolves n, not n - 1"
            );
        }
    }
    assert!(!run(&PP_DP, &N_MINUS_1, &[list(&[1, 2])], 1).ended);
}

/// Lists of 1, 2, 3 ... fragments, a few of them tied.
fn every_complexity(most: u32) -> Vec<Vec<Fragment>> {
    let depths = |count: u32| (0..count).map(|f| f * 389 % 997 % 61).collect::<Vec<_>>();
    (1..=most).map(|count| list(&depths(count))).collect()
}

/// Erratum LX05. Amended, every pixel is in one segment: the smallest that holds it, and the last if none does.
#[test]
pub(crate) fn l11_past_the_last_segment_nothing_is_resolved_as_printed() {
    let lists = every_complexity(600);
    for max in [8, 16, 64, 256] {
        let printed = run(&PP_AO, &[], &lists, max);
        let amended = run(&PP_AO, &[PP_AO_WITH_PP_DP], &lists, max);
        for ((list, printed), amended) in lists.iter().zip(&printed.pixels).zip(&amended.pixels) {
            let count = list.len() as u32;
            assert_eq!(printed.times, u32::from(count <= max), "{count} {max}");
            assert_eq!(amended.times, 1, "{count} {max}");
            assert_eq!(amended.composited, sorted(list), "{count} {max}");
            let segment = count.next_power_of_two().clamp(8, max);
            assert_eq!(
                amended.slots,
                [segment, count.min(segment)],
                "{count} {max}"
            );
            assert_eq!(amended.subpasses, count.div_ceil(segment), "{count} {max}");
        }
    }
}

/// What lies past N in the list is lost: the last in memory, not the farthest.
#[test]
pub(crate) fn l09_without_pp_dp_the_last_segment_drops_what_overflows_it() {
    let lists = every_complexity(40);
    let run = run(&PP_AO, &[PP_AO_AMENDMENT], &lists, 16);
    for (list, pixel) in lists.iter().zip(&run.pixels) {
        let kept = &list[..list.len().min(16)];
        assert_eq!(pixel.composited, sorted(kept));
        assert_eq!(pixel.times, 1);
    }
}

/// A static array of every size, and every list of up to four fragments on three depths in every order in memory: it keeps
/// the first of the list, or the nearest, whatever the order.
#[test]
pub(crate) fn l09_a_full_array_keeps_the_first_of_its_list_or_the_nearest() {
    for depths in small_lists(4) {
        let submitted = list(&depths);
        let in_memory = orders(&submitted);
        for n in 1..=5 {
            let first = run(&STATIC_ARRAY, &[], &in_memory, n);
            let nearest = run(&STATIC_ARRAY, &[KEEP_NEAREST], &in_memory, n);
            let fits = (n as usize).min(depths.len());
            let the_nearest = &sorted(&submitted)[..fits];
            for ((list, first), nearest) in in_memory.iter().zip(&first.pixels).zip(&nearest.pixels)
            {
                let mut kept: Vec<u32> = list[..fits].iter().map(|f| f.order).collect();
                kept.sort_by(|&a, &b| {
                    let depth = |order: u32| submitted[order as usize].depth;
                    depth(a).total_cmp(&depth(b)).then(a.cmp(&b))
                });
                assert_eq!(first.composited, kept, "{list:?} {n}");
                assert_eq!(nearest.composited, the_nearest, "{list:?} {n}");
                // The nearest are not known before the whole list has been read.
                assert_eq!((first.records_read, first.subpasses), (fits as u32, 1));
                let read = (nearest.records_read, nearest.subpasses);
                assert_eq!(read, (list.len() as u32, 1));
                assert_eq!(first.slots, nearest.slots);
            }
        }
    }
}

/// How often the pixels of 1, 2, 3 ... 600 fragments are resolved with a stencil buffer's masks.
fn times(counter: Counter, mark: Mark, max: u32) -> Vec<u32> {
    let run = run(&PP_AO, &stencil(counter, mark), &every_complexity(600), max);
    run.pixels.iter().map(|pixel| pixel.times).collect()
}

/// The complexities of pixels that are not resolved exactly once.
fn wrong(times: &[u32]) -> Vec<usize> {
    (1..=times.len())
        .filter(|&complexity| times[complexity - 1] != 1)
        .collect()
}

/// Every counter, mark and last segment, for every complexity from 1 to 600, against arithmetic.
#[test]
pub(crate) fn l11_the_stencil_s_masks_are_what_arithmetic_says() {
    for counter in [Counter::Stencil, Counter::StencilWrapping] {
        for mark in [Mark::Keep, Mark::Replace, Mark::Invert] {
            for max in [8, 16, 32, 64, 128, 256] {
                let expected = (1..=600).map(|c| times_resolved(c, max, mark, counter));
                assert!(times(counter, mark, max).into_iter().eq(expected));
            }
        }
    }
}

/// Erratum LX07: what marks a pixel is not said.
#[test]
pub(crate) fn l11_of_the_marks_only_invert_works_and_only_up_to_128() {
    let invert = |max| wrong(&times(Counter::Stencil, Mark::Invert, max));
    assert_eq!(
        invert(64),
        (65..=600).collect::<Vec<_>>(),
        "past the last (LX05)"
    );
    // 255 - 127 = 128 comes after the segment of 128.
    assert_eq!(invert(128), (129..=600).collect::<Vec<_>>());
    // A reference of 256 is clamped to 255, and so passes what was inverted before.
    assert_eq!(invert(256), (1..=128).collect::<Vec<_>>());
    for mark in [Mark::Keep, Mark::Replace] {
        // Every segment from its own on.
        let times = times(Counter::Stencil, mark, 64);
        assert_eq!(
            [times[4], times[14], times[31], times[63]],
            [4, 3, 2, 1],
            "{mark:?}"
        );
    }
}

/// Erratum LX06: eight bits stay at 255 by INCR, and begin again by INCR_WRAP, where 256 to 264 seem to fit an array of 8.
#[test]
pub(crate) fn l11_eight_bits_send_what_is_past_255_to_the_wrong_segment() {
    let lists = every_complexity(600);
    let wrapping = stencil(Counter::StencilWrapping, Mark::Invert);
    let wrapping = &run(&PP_AO, &wrapping, &lists, 64).pixels[259];
    assert_eq!(wrapping.slots, [8, 8], "260 fragments in an array of 8");
    // By INCR all of 255 and more share a segment, if there is one so large: 256, clamped to 255.
    let staying = run(&PP_AO, &stencil(Counter::Stencil, Mark::Keep), &lists, 256);
    assert!(staying.pixels[254..].iter().all(|pixel| pixel.times == 1));
    // Its array takes 256, the rest is lost without ppDP.
    assert_eq!(staying.pixels[599].composited.len(), 256);
}

#[test]
fn lines_out_of_place_are_refused_and_nothing_panics() {
    let algorithm = |lines| Pseudocode {
        title: "nothing",
        source: "here",
        lines,
    };
    let refused = |lines, array| {
        let run = run_on_lists(&algorithm(lines), &[], &[list(&[1])], array, ENOUGH);
        run.unwrap_err().to_string()
    };
    assert!(refused(&[ListLine::ResolveSegment], 8).contains("resolve segment"));
    assert!(refused(&[ListLine::Input, ListLine::ClearBuffer], 8).contains("clear buffer"));
    assert!(refused(&[ListLine::Input, ListLine::Repeat(&[])], 8).contains("repeat"));
    assert!(refused(&[ListLine::Until(list::End::AllResolved)], 8).contains("until"));
    assert!(refused(&[ListLine::Segments(&[])], 7).contains("last segment cannot be 7"));
    assert!(refused(&[], 0).contains("Local Array of 0"));
}
