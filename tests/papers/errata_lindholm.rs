//! Errata of Lindholm et al. 2015 that show on lists. Those with an amendment are in `papers/emulator_lists.rs`, those that
//! only the print can show in `papers/errata_in_print.rs`.

use onionskin::low_level::emulator::run_on_lists;
use onionskin::low_level::fragment::{Fragment, Rgba};
use onionskin::low_level::papers::lindholm_2015::components::{PP_AO, PP_DP, STOP};

/// A pixel's list: fragments at these depths.
fn list(depths: &[f32]) -> Vec<Fragment> {
    let fragment = |(&depth, order)| Fragment {
        depth,
        color: Rgba::default(),
        order,
    };
    depths.iter().zip(0..).map(fragment).collect()
}

#[test]
pub(crate) fn lx08_filled_once_a_segment_every_fragment_is_there_four_times() {
    let once = list(&[0.25, 0.5, 0.75]);
    // Segments of 8, 16, 32 and 64; the Fill Step runs in the loop over them.
    let filled = [(); 4].map(|()| once.clone()).concat();
    let shown = |list: Vec<Fragment>| {
        let run = run_on_lists(&PP_AO, &[], &[list], 64, 100).unwrap();
        run.pixels[0].composited.clone()
    };
    assert_eq!(shown(once), [0, 1, 2]);
    let shown = shown(filled);
    assert_eq!(shown.len(), 12);
    assert!((0..3).all(|order| shown.iter().filter(|&&other| other == order).count() == 4));
}

#[test]
pub(crate) fn lx11_an_empty_list_takes_a_subpass_without_a_last_element() {
    let of = |count: usize| {
        let run = run_on_lists(&PP_DP, &[STOP], &[list(&vec![0.5; count])], 8, 100).unwrap();
        let pixel = &run.pixels[0];
        (pixel.subpasses, pixel.records_read, pixel.composited.len())
    };
    // One subpass, which stores the depth of the last of no elements. The emulated pixel stores nothing then.
    assert_eq!(of(0), (1, 0, 0));
    // A full buffer has a last element, and takes as many.
    assert_eq!(of(8), (1, 8, 8));
    assert_eq!(of(9).0, 2);
}
