//! What each walk through a list skips, drops, keeps in its Local Array and composites, on the emulated pixel.

use onionskin::low_level::emulator::{Resolved, Subpass, run_on_lists};
use onionskin::low_level::papers::lindholm_2015::components::*;
use onionskin::low_level::steps::Amendment;
use onionskin::low_level::steps::pseudo::Pseudocode;
use onionskin::low_level::steps::pseudo::list::ListLine;
use onionskin::{Fragment, Rgba};

use crate::kit::chance::Chance;

fn list(depths: &[usize]) -> Vec<Fragment> {
    let fragment = |(order, &depth): (usize, &usize)| Fragment {
        depth: depth as f32 / 1024.0,
        color: Rgba::default(),
        order: order as u32,
    };
    depths.iter().enumerate().map(fragment).collect()
}

fn resolved(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
    depths: &[usize],
    array: u32,
) -> Resolved {
    let run = run_on_lists(algorithm, amendments, &[list(depths)], array, 100).unwrap();
    assert!(run.ended);
    run.pixels[0].clone()
}

fn pass(skipped: &[u32], dropped: &[u32], array: &[u32]) -> Subpass {
    Subpass {
        skipped: skipped.to_vec(),
        dropped: dropped.to_vec(),
        array: array.to_vec(),
        composited: array.to_vec(),
    }
}

#[test]
fn five_fragments_through_an_array_of_two() {
    let done = resolved(&PP_DP, &PP_DP_AMENDMENTS, &[5, 1, 3, 2, 4], 2);
    let expected = [
        // s0 goes when s2 comes, s2 when s3 comes, and s4 finds no room.
        pass(&[], &[0, 2, 4], &[1, 3]),
        pass(&[1, 3], &[0], &[2, 4]),
        pass(&[1, 2, 3, 4], &[], &[0]),
    ];
    assert_eq!(done.passes, expected);
}

#[test]
fn five_fragments_and_a_static_array_of_three() {
    let first = resolved(&STATIC_ARRAY, &[], &[5, 1, 3, 2, 4], 3);
    assert_eq!(first.passes, [pass(&[], &[3, 4], &[1, 2, 0])]);
    let nearest = resolved(&STATIC_ARRAY, &[KEEP_NEAREST], &[5, 1, 3, 2, 4], 3);
    assert_eq!(nearest.passes, [pass(&[], &[0, 4], &[1, 3, 2])]);
}

/// As the text beside the pseudocode has it, a full array's last element waits.
#[test]
fn what_is_in_the_array_need_not_be_composited() {
    let done = resolved(&PP_DP, &N_MINUS_1, &[3, 1, 2], 2);
    assert_eq!(done.passes[0].array, [1, 2]);
    assert_eq!(done.passes[0].composited, [1]);
}

/// In every walk each record is skipped, dropped or in the array, once; and what is composited is what all walks composite.
#[test]
fn the_records_of_every_walk_add_up() {
    let mut chance = Chance::new(50);
    let mut walks = 0;
    for _ in 0..2000 {
        let depths: Vec<usize> = (0..chance.below(12)).map(|_| chance.below(5)).collect();
        let array = 1 + chance.below(5) as u32;
        let all = (0..depths.len() as u32).collect::<Vec<_>>();
        for (algorithm, amendments) in [
            (&PP_DP, &PP_DP_AMENDMENTS[..]),
            (&PP_DP, &[STOP]),
            (&STATIC_ARRAY, &[]),
            (&STATIC_ARRAY, &[KEEP_NEAREST]),
        ] {
            let done = resolved(algorithm, amendments, &depths, array);
            assert_eq!(done.passes.len(), done.subpasses as usize);
            for pass in &done.passes {
                let parts = [&pass.skipped, &pass.dropped, &pass.array];
                let mut records: Vec<u32> = parts.into_iter().flatten().copied().collect();
                records.sort_unstable();
                assert_eq!(records, all, "{pass:?}");
                walks += 1;
            }
            let passes = done.passes.iter().flat_map(|pass| &pass.composited);
            assert!(passes.eq(&done.composited), "{done:?}");
        }
    }
    assert!(walks > 10_000, "{walks}");
}
