//! What of Lindholm et al. 2015 can be shown without GL: ppDP's rules on random and on all lists, and the stencil
//! arithmetic of ppAO's masks.

#[path = "common/pp_dp.rs"]
mod pp_dp;
use pp_dp::{Rule, peel};

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

/// What could mark a pixel as resolved.
#[derive(Clone, Copy, Debug)]
enum Mark {
    Keep,
    Replace,
    Invert,
}

/// How often a pixel of this complexity is resolved by the segments 8, 16 ... `max`, masked by an 8-bit stencil that
/// counted with INCR, or with INCR_WRAP.
fn times_resolved(complexity: u32, max: u32, mark: Mark, wraps: bool) -> u32 {
    let mut stencil = if wraps {
        complexity % 256
    } else {
        complexity.min(255)
    };
    let mut times = 0;
    let mut size = 8;
    while size <= max {
        // glStencilFunc clamps its reference to the stencil buffer's bits.
        let reference = size.min(255);
        if reference >= stencil {
            times += 1;
            stencil = match mark {
                Mark::Keep => stencil,
                Mark::Replace => reference,
                Mark::Invert => 255 - stencil,
            };
        }
        size *= 2;
    }
    times
}

/// Errata L5 to L7, for every complexity from 1 to 600.
#[test]
fn l11_of_the_stencil_s_marks_only_invert_works_and_only_below_128() {
    let bad = |max, mark| {
        let wrong = |&c: &u32| times_resolved(c, max, mark, false) != 1;
        (1..=600).filter(wrong).collect::<Vec<u32>>()
    };
    // Past the last segment nothing is resolved, whatever the mark.
    assert_eq!(bad(64, Mark::Invert), (65..=600).collect::<Vec<_>>());
    // Without a mark, or with the reference, every lower segment's pixels come again.
    for mark in [Mark::Keep, Mark::Replace] {
        assert_eq!(times_resolved(5, 64, mark, false), 4, "{mark:?}");
    }
    // With 128 as the last segment, none below 128 is wrong by INVERT: 255 - 127 = 128 comes after it.
    assert_eq!(bad(128, Mark::Invert), (129..=600).collect::<Vec<_>>());
    // With 256, which is clamped to 255, everything above the first test that it passes is resolved once more.
    assert!(bad(256, Mark::Invert).len() > 100);
    assert_eq!(times_resolved(127, 256, Mark::Invert, false), 2);
    // L6: with INCR_WRAP, 256 to 263 land in the segment of 8.
    assert_eq!(times_resolved(260, 64, Mark::Invert, true), 1);
}

/// The amended masks: previous segment < count <= i, the last one takes what is left.
#[test]
fn l11_by_an_integer_counter_every_pixel_is_in_one_segment() {
    for max in [8, 16, 64, 256] {
        for complexity in 1..=600_u32 {
            let mut size = 8;
            let mut times = 0;
            while size <= max {
                let before = if size == 8 { 0 } else { size / 2 };
                times += u32::from(complexity > before && (complexity <= size || size == max));
                size *= 2;
            }
            assert_eq!(times, 1, "{complexity} {max}");
        }
    }
}
