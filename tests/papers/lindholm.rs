//! What of Lindholm et al. 2015 can be shown without GL and without the pseudocode: ppDP's rules on random and on all
//! lists, in Rust. `papers/emulator_lists.rs` holds the pseudocode against them.

use crate::kit::pp_dp::{Rule, peel};

/// Numbers that look random and are the same on every run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: u32) -> u32 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % u64::from(n)) as u32
    }

    fn depths(&mut self, count: usize, levels: u32) -> Vec<u32> {
        (0..count).map(|_| 1 + self.below(levels)).collect()
    }
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
            let mut sorted: Vec<usize> = (0..depths.len()).collect();
            sorted.sort_by_key(|&f| depths[f]);
            for n in 1..=7 {
                let peeled = peel(&depths, n, Rule::Amended);
                assert_eq!(peeled.resolved, sorted, "{depths:?} {n}");
                assert_eq!(
                    peeled.subpasses,
                    depths.len().div_ceil(n).max(1),
                    "{depths:?} {n}"
                );
            }
        }
    }
}

/// Erratum L1. Twenty coplanar fragments and a buffer of eight: twelve are lost.
#[test]
fn l13_printed_peeling_loses_coplanar_fragments() {
    assert_eq!(peel(&[5; 20], 8, Rule::Printed).lost, 12);
    let mut chance = Chance(1);
    let share = |chance: &mut Chance, levels| {
        let lists = (0..3000).map(|_| chance.depths(24, levels));
        lists
            .filter(|depths| peel(depths, 8, Rule::Printed).lost > 0)
            .count()
    };
    let [few, some, most] = [1000, 64, 12].map(|levels| share(&mut chance, levels));
    println!("lists that lose something: {few} of 3000 on 1000 levels, {some} on 64, {most} on 12");
    assert!(0 < few && few < 150 && few < some && some < most && most > 2000);
}

/// Erratum L2. The text resolves n - 1 of n but takes the minimum from the n-th: one fragment is lost with each subpass
/// that overflowed.
#[test]
fn l12_resolving_n_minus_1_but_going_on_from_the_nth_loses_one_a_pass() {
    for (count, lost) in [(24, 2), (64, 7)] {
        let depths: Vec<u32> = (1..=count).collect();
        let peeled = peel(&depths, 8, Rule::PrintedText);
        assert_eq!(peeled.lost, lost);
        assert_eq!(peel(&depths, 8, Rule::Printed).lost, 0);
    }
    // The pseudocode resolves n: three passes for 24 where the text says ceil(24 / 7) = 4, eight for 64 instead of 10.
    let passes = |count: u32| peel(&(1..=count).collect::<Vec<_>>(), 8, Rule::Printed).subpasses;
    assert_eq!([passes(24), passes(64)], [3, 8]);
    assert_eq!([24_u32.div_ceil(7), 64_u32.div_ceil(7)], [4, 10]);
}

/// Erratum L3. "Until all fragments are resolved", read as a count, never holds once a tie is lost.
#[test]
fn l13_a_loop_that_waits_for_a_lost_tie_never_ends() {
    let mut chance = Chance(2);
    let lists: Vec<_> = (0..500).map(|_| chance.depths(24, 64)).collect();
    let endless = lists
        .iter()
        .filter(|depths| !peel(depths, 8, Rule::Printed).ends_by_count)
        .count();
    println!("{endless} of 500 lists on 64 levels never end");
    assert!(endless > 50);
    assert!(
        lists
            .iter()
            .all(|depths| peel(depths, 8, Rule::Amended).ends_by_count)
    );
}

/// Erratum L4. Min depth 0 and `<=`: a fragment at the near plane is never seen.
#[test]
fn l13_a_fragment_at_depth_0_is_skipped_as_printed() {
    assert_eq!(peel(&[0, 3, 4], 8, Rule::Printed).lost, 1);
    assert_eq!(peel(&[0, 3, 4], 8, Rule::Amended).lost, 0);
}
