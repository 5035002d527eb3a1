//! The claims about ppDP of Lindholm et al. 2015, by its pseudocode, run line by line on random and on all small lists.
//! `papers/emulator_lists.rs` holds the pseudocode against the same rules in Rust.

use onionskin::low_level::emulator::run_on_lists;
use onionskin::low_level::papers::lindholm_2015::components::{
    AS_THE_TEXT_SAYS, PP_DP, PP_DP_AMENDMENTS, STOP,
};
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::pseudo::list::ListLine;
use onionskin::{Fragment, Rgba};

use crate::kit::chance::Chance;

/// As printed, with a condition that ends it (erratum LX03).
const PRINTED: [Amendment<ListLine>; 1] = [STOP];
/// As the text beside the pseudocode says, likewise.
const TEXT: [Amendment<ListLine>; 2] = [AS_THE_TEXT_SAYS, STOP];

/// More subpasses than any list here needs.
const ENOUGH: u32 = 100;

/// What came of a list.
struct Peeled {
    /// Fragments in the order in which they were resolved, by their place in the list.
    resolved: Vec<u32>,
    lost: usize,
    subpasses: u32,
    /// Whether the loop ended by itself.
    ended: bool,
}

/// Peels a list of depths, in the order of submission, with a buffer of `n`.
fn peel(depths: &[u32], n: u32, amendments: &[Amendment<ListLine>]) -> Peeled {
    let fragment = |(order, &depth): (usize, &u32)| Fragment {
        depth: depth as f32 / 1024.0,
        color: Rgba::default(),
        order: order as u32,
    };
    let list = depths.iter().enumerate().map(fragment).collect();
    let mut run = run_on_lists(&PP_DP, amendments, &[list], n, ENOUGH).expect("it runs");
    let pixel = run.pixels.remove(0);
    Peeled {
        lost: depths.len() - pixel.composited.len(),
        resolved: pixel.composited,
        subpasses: pixel.subpasses,
        ended: run.ended,
    }
}

fn depths(chance: &mut Chance, count: usize, levels: u32) -> Vec<u32> {
    let depth = |_| 1 + chance.below(levels as usize) as u32;
    (0..count).map(depth).collect()
}

/// Every list of up to six fragments on three depths, with depth 0 among them, and every buffer: nothing is lost, and the
/// order is the oracle's.
#[test]
fn l13_amended_peeling_is_a_stable_sort_of_every_small_list() {
    for count in 0..=6_u32 {
        for code in 0..3_u32.pow(count) {
            let depths: Vec<u32> = (0..count)
                .map(|place| code / 3_u32.pow(place) % 3)
                .collect();
            let mut sorted: Vec<u32> = (0..count).collect();
            sorted.sort_by_key(|&f| depths[f as usize]);
            for n in 1..=7 {
                let peeled = peel(&depths, n, &PP_DP_AMENDMENTS);
                assert_eq!(peeled.resolved, sorted, "{depths:?} {n}");
                assert_eq!(peeled.subpasses, count.div_ceil(n).max(1), "{depths:?} {n}");
            }
        }
    }
}

/// Erratum LX01. Twenty coplanar fragments and a buffer of eight: twelve are lost.
#[test]
fn l13_printed_peeling_loses_coplanar_fragments() {
    assert_eq!(peel(&[5; 20], 8, &PRINTED).lost, 12);
    let mut chance = Chance::new(1);
    let share = |chance: &mut Chance, levels| {
        let lists = (0..3000).map(|_| depths(chance, 24, levels));
        lists
            .filter(|depths| peel(depths, 8, &PRINTED).lost > 0)
            .count()
    };
    let [few, some, most] = [1000, 64, 12].map(|levels| share(&mut chance, levels));
    println!("lists that lose something: {few} of 3000 on 1000 levels, {some} on 64, {most} on 12");
    assert!(0 < few && few < 150 && few < some && some < most && most > 2000);
}

/// Erratum LX02. The text resolves n - 1 of n but takes the minimum from the n-th: one fragment is lost with each subpass
/// that overflowed.
#[test]
fn l12_resolving_n_minus_1_but_going_on_from_the_nth_loses_one_a_pass() {
    for (count, lost) in [(24, 2), (64, 7)] {
        let depths: Vec<u32> = (1..=count).collect();
        let peeled = peel(&depths, 8, &TEXT);
        assert_eq!(peeled.lost, lost);
        assert_eq!(peel(&depths, 8, &PRINTED).lost, 0);
    }
    // The pseudocode resolves n: three passes for 24 where the text says ceil(24 / 7) = 4, eight for 64 instead of 10.
    let passes = |count: u32| peel(&(1..=count).collect::<Vec<_>>(), 8, &PRINTED).subpasses;
    assert_eq!([passes(24), passes(64)], [3, 8]);
    assert_eq!([24_u32.div_ceil(7), 64_u32.div_ceil(7)], [4, 10]);
}

/// Erratum LX03. "Until all fragments are resolved", read as a count, never holds once a tie is lost.
#[test]
fn l13_a_loop_that_waits_for_a_lost_tie_never_ends() {
    let mut chance = Chance::new(2);
    let lists: Vec<_> = (0..500).map(|_| depths(&mut chance, 24, 64)).collect();
    // Without another condition it waits for what it has lost: it is left after so many subpasses.
    let never = |depths: &&Vec<u32>| !peel(depths, 8, &[]).ended;
    let endless = lists.iter().filter(never).count();
    let losing = |depths: &&Vec<u32>| peel(depths, 8, &PRINTED).lost > 0;
    assert_eq!(endless, lists.iter().filter(losing).count());
    println!("{endless} of 500 lists on 64 levels never end");
    assert!(endless > 50);
    // With the other errors amended nothing is lost, and so the condition as printed holds.
    let others = PP_DP_AMENDMENTS.map(|one| (one.key != STOP.key).then_some(one));
    let others: Vec<_> = others.into_iter().flatten().collect();
    assert_eq!(others.len(), PP_DP_AMENDMENTS.len() - 1);
    assert!(lists.iter().all(|depths| peel(depths, 8, &others).ended));
}

/// Erratum LX04. Min depth 0 and `<=`: a fragment at the near plane is never seen.
#[test]
fn l13_a_fragment_at_depth_0_is_skipped_as_printed() {
    assert_eq!(peel(&[0, 3, 4], 8, &PRINTED).lost, 1);
    assert_eq!(peel(&[0, 3, 4], 8, &PP_DP_AMENDMENTS).lost, 0);
}
