//! Figure 2 of Carr et al. (2008), value by value on the emulated pixel, and section 4's definitions held against what
//! the passes find.

use onionskin::low_level::emulator::FragmentOutcome::*;
use onionskin::low_level::emulator::{Draw, Emulator};
use onionskin::low_level::methods::begin_batch;
use onionskin::low_level::papers::carr_2008::coherent::{
    self, CLEAN_STATE, COMPOSITE_HALF_OPEN, LOOP_A, NO_TESTS, RUN_HALF_OPEN,
};
use onionskin::low_level::papers::carr_2008::{D_SN, Z_MIN_POST, Z_MIN_PREV};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Amendment, Variables, gl::*, run};
use onionskin::{Format, steps};

use crate::figure_2_orders::{End, fits};
use crate::kit::changed::changed;
use crate::kit::peels::{Loop, Pixel, pixel, random_image};

/// One of the 18 orders of depth that fit what the text says of figure 2.
const ORDER: [usize; 11] = [0, 4, 3, 5, 6, 10, 9, 7, 2, 1, 8];

/// Its depths: s_k is submitted as number k.
const FIGURE_2: [f32; 11] = {
    let mut depths = [0.0; 11];
    let mut place = 0;
    while place < ORDER.len() {
        depths[ORDER[place]] = (place + 1) as f32 / 16.0;
        place += 1;
    }
    depths
};

/// Figure 2's iteration: everything up to s4 has been peeled. The six passes' draws.
fn figure_2(amendments: &[Amendment]) -> Vec<Draw> {
    let mut emulator = Emulator::new(vec![pixel(FIGURE_2)]).watching(0);
    Loop::A.allocate_maps(&mut emulator, Format::Rgba32F, Format::Depth32FStencil8);
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut emulator).unwrap();
    begin_batch(&mut emulator, FIGURE_2[4], 1.0).unwrap();
    let variables = Variables::new().with("iteration_limit", 1.0);
    let draws_before = emulator.record().draws.len();
    run(&LOOP_A, amendments, variables, &mut emulator).unwrap();
    emulator.record().draws[draws_before..].to_vec()
}

/// The iteration is not the first, whose range would begin at D(sc) itself.
const LATER: [Amendment; 5] = [
    CLEAN_STATE,
    RUN_HALF_OPEN,
    COMPOSITE_HALF_OPEN,
    NO_TESTS,
    coherent::BEFORE_OPAQUE,
];

#[test]
pub(crate) fn c07_pass_1_counts_s1_s2_and_s3() {
    let pass = &figure_2(&LATER)[0];
    print!("{pass}");
    assert_eq!(pass.with(Pass), [1, 2, 3]);
    assert_eq!(pass.with(DepthFail), [5, 6, 7, 8, 9, 10]);
    assert_eq!(pass.with(Discarded), [0, 4]);
    assert_eq!(pass.left, (3, FIGURE_2[3]));
}

#[test]
pub(crate) fn c08_pass_2_stops_at_s2() {
    let pass = &figure_2(&LATER)[1];
    assert_eq!(pass.with(Pass), [1, 2]);
    assert_eq!(pass.with(StencilFail), [3, 5, 6, 7, 8, 9, 10]);
    assert_eq!(pass.left, (1, FIGURE_2[2]));
}

#[test]
pub(crate) fn cx02_s1_is_not_skipped_in_pass_2_but_drawn() {
    // "In the case of Figure 2 we skip s1 and stop at s2": s1 passes, and counts the stencil down.
    let pass = &figure_2(&LATER)[1];
    let s1 = pass.fates.iter().find(|fate| fate.order == 1).unwrap();
    assert_eq!((s1.outcome, s1.stencil), (Pass, [3, 2]));
}

#[test]
pub(crate) fn c09_pass_3_counts_s3_s5_s6_and_s7_and_s9_inverts_the_count() {
    let pass = &figure_2(&LATER)[2];
    assert_eq!(pass.with(Pass), [3, 5, 6, 7]);
    assert_eq!(pass.with(DepthFail), [9]);
    assert_eq!(pass.with(StencilFail), [10]);
    let s9 = pass.fates.iter().find(|fate| fate.order == 9).unwrap();
    assert_eq!(s9.stencil, [4, 251]);
}

#[test]
pub(crate) fn cx01_s9_does_not_set_the_depth_in_pass_3() {
    // The text: "sets the depth to D(s9)". A fragment that fails the depth test never writes depth.
    let pass = &figure_2(&LATER)[2];
    assert_eq!(pass.left, (251, FIGURE_2[7]));
    assert_ne!(FIGURE_2[7], FIGURE_2[9]);
}

#[test]
pub(crate) fn c10_pass_4_skips_as_many_and_finds_s10() {
    let pass = &figure_2(&LATER)[3];
    assert_eq!(pass.with(StencilFail), [3, 5, 6, 7]);
    assert_eq!(pass.with(Pass), [9, 10]);
    assert_eq!(pass.left, (255, FIGURE_2[10]));
}

#[test]
pub(crate) fn c11_pass_5_composites_the_run_and_pass_6_what_ends_it() {
    // The range of figure 2's caption, [D(s3), D(s10)]: s3, s5, s6 in pass 5, s10 in pass 6.
    let draws = figure_2(&LATER);
    assert_eq!(draws[4].with(Pass), [3, 5, 6]);
    assert_eq!(draws[5].with(Pass), [10]);
}

#[test]
fn figure_2_with_one_changed_word_is_another_trace() {
    const PASS_2: Amendment = changed(
        steps! { glStencilOp(KEEP, KEEP, DECR); },
        steps! { glStencilOp(KEEP, KEEP, KEEP); },
    );
    const PASS_2_FROM_2: Amendment = changed(
        steps! { glStencilFunc(LESS, 1, 0xFF); },
        steps! { glStencilFunc(LESS, 2, 0xFF); },
    );
    const PASS_3: Amendment = changed(
        steps! { glStencilOp(KEEP, INVERT, INCR); },
        steps! { glStencilOp(KEEP, KEEP, INCR); },
    );
    let with = |word| figure_2(&[&LATER[..], &[word]].concat());
    // CX02: s1 is drawn, and counts down.
    let s1 = |draws: &[Draw]| {
        draws[1]
            .fates
            .iter()
            .find(|fate| fate.order == 1)
            .unwrap()
            .stencil
    };
    assert_ne!(s1(&with(PASS_2)), [3, 2]);
    assert_ne!(with(PASS_2_FROM_2)[1].left, (1, FIGURE_2[2]));
    // CX36: s9 inverts.
    let draws = with(PASS_3);
    assert_ne!(draws[2].left, (251, FIGURE_2[7]));
    assert_ne!(draws[3].left, (255, FIGURE_2[10]));
}

/// The depths of s1 to s10 as places.
fn places(order: [usize; 11]) -> [u32; 10] {
    let place = |s| order.iter().position(|&other| other == s);
    std::array::from_fn(|at| place(at + 1).expect("it is in the order") as u32)
}

#[test]
fn the_order_that_is_run_here_is_one_that_fits_the_text() {
    assert!(fits(&places(ORDER), End::Open).is_some());
}

#[test]
fn figure_2_s_labels_from_left_to_right_are_not_an_order_of_depth() {
    // As the text of the figure comes out of the PDF: S4 S3 S5 S6 S10 S2 S9 S7 ... S1 S8.
    let order = [0, 4, 3, 5, 6, 10, 2, 9, 7, 1, 8];
    assert!(fits(&places(order), End::Open).is_none());
}

/// What section 4 defines, straight from a sequence of depths: D(sn), z_min_prev, z_min_post; 1 for infinity.
/// `predecessor` says which surface precedes one in order for z_min_post.
fn definitions(depths: &[f32], predecessor: impl Fn(usize, [f32; 2]) -> Option<usize>) -> [f32; 3] {
    let n = (0..depths.len()).min_by(|&a, &b| depths[a].total_cmp(&depths[b]).then(a.cmp(&b)));
    let n = n.expect("a sequence is not empty");
    let prev = depths[..n].iter().copied().fold(1.0, f32::min);
    let range = [depths[n], prev];
    let out_of_order = (n + 1..depths.len()).filter(|&i| {
        let inside = range[0] <= depths[i] && depths[i] < range[1];
        inside && predecessor(i, range).is_some_and(|p| depths[i] <= depths[p])
    });
    let post = out_of_order.map(|i| depths[i]).fold(1.0, f32::min);
    [depths[n], prev, post]
}

/// The predecessor as section 4.2 prints it, s_{i-1}.
fn printed(i: usize, _: [f32; 2]) -> Option<usize> {
    i.checked_sub(1)
}

/// The previous surface in the range: what passes 3 and 4 compare with.
fn in_range(depths: &[f32]) -> impl Fn(usize, [f32; 2]) -> Option<usize> {
    move |i, [low, high]| (0..i).rev().find(|&p| low <= depths[p] && depths[p] < high)
}

/// What the passes leave in the maps after one iteration.
fn found(which: Loop, pixels: &[Pixel]) -> Vec<[f32; 3]> {
    let mut emulator = Emulator::new(pixels.to_vec());
    which.allocate_maps(&mut emulator, Format::Rgba32F, Format::Depth32FStencil8);
    which.run(&mut emulator, &which.amendments(), 1.0);
    let sn = emulator.depths(D_SN).unwrap();
    let post = emulator.depths(Z_MIN_POST).unwrap();
    let prev: Vec<f32> = match which {
        Loop::B => emulator
            .colors(Z_MIN_PREV)
            .unwrap()
            .iter()
            .map(|c| c[0])
            .collect(),
        _ => emulator.depths(Z_MIN_PREV).unwrap().to_vec(),
    };
    (0..pixels.len())
        .map(|p| [sn[p], prev[p], post[p]])
        .collect()
}

fn depths(pixel: &Pixel) -> Vec<f32> {
    pixel.iter().map(|surface| surface.fragment.depth).collect()
}

#[test]
pub(crate) fn c06_the_passes_find_what_section_4_defines() {
    for n in [1, 2, 5, 8, 16] {
        let pixels = random_image(n);
        for which in [Loop::A, Loop::B] {
            for (pixel, found) in pixels.iter().zip(found(which, &pixels)) {
                let depths = depths(pixel);
                let [sn, prev, post] = definitions(&depths, in_range(&depths));
                assert_eq!(found, [sn, prev, post], "{which:?} {depths:?}");
            }
        }
    }
}

#[test]
pub(crate) fn cx07_a_predecessor_outside_of_the_range_hides_a_surface_that_is_out_of_order() {
    // A surface whose predecessor in the whole list lies outside of the range, and nearer, counts as in order by the
    // printed text, although it lies before an earlier surface of the range.
    let differs = |n: usize| {
        let pixels = random_image(n);
        pixels
            .iter()
            .filter(|pixel| {
                let depths = depths(pixel);
                definitions(&depths, printed) != definitions(&depths, in_range(&depths))
            })
            .count()
    };
    // z_min_post by the printed text is not what the passes find, in some of 1024 random sequences.
    let counts = [8, 16].map(differs);
    assert_eq!(counts, [184, 226]);
}
