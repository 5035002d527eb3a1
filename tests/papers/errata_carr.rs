//! Errata of Carr et al. (2008) that are gaps, numbers and contradictions, on the emulated pixel. Those with an amendment
//! are in `papers/emulator_carr_errata.rs`, those that only the print can show in `papers/errata_in_print.rs`.

use onionskin::low_level::emulator::{Group, run_algorithm};
use onionskin::low_level::papers::carr_2008::ideal::{ALGORITHM_2, AMENDMENTS_2, RESET_Z3};
use onionskin::low_level::papers::carr_2008::{D_SN, DEPTH_BUFFER, Z_MIN_POST, Z_MIN_PREV};
use onionskin::low_level::steps::pseudo::Line;
use onionskin::low_level::steps::{Amendment, Kind};
use onionskin::steps;

use crate::kit::changed::changed;
use crate::kit::peels::{Loop, Pixel, amended, bad, depth_of, emulate, pixel, random_image};

#[test]
pub(crate) fn cx15_each_map_is_lost_that_is_not_copied_before_the_next_pass() {
    const COPIES: [Amendment; 3] = [
        changed(steps! { glCopyImageSubData(DEPTH_BUFFER, D_SN); }, &[]),
        changed(
            steps! { glCopyImageSubData(DEPTH_BUFFER, Z_MIN_PREV); },
            &[],
        ),
        changed(
            steps! { glCopyImageSubData(DEPTH_BUFFER, Z_MIN_POST); },
            &[],
        ),
    ];
    let pixels = random_image(8);
    for (copy, map) in COPIES
        .into_iter()
        .zip(["D(sn)", "z_min_prev", "z_min_post"])
    {
        let mut amendments = vec![copy];
        amendments.extend(Loop::A.amendments());
        let wrong = emulate(Loop::A, &pixels, &amendments).bad(&pixels);
        assert_eq!(wrong, 1024, "{map}");
    }
}

#[test]
pub(crate) fn cx24_a_query_over_pass_1_counts_what_it_composites_too() {
    // What a sample query over pass 1 would see: fragments that change z1 to z3, and fragments that are composited.
    const QUERIED: Amendment<Line> = Amendment {
        key: "changed",
        kind: Kind::Correction,
        place: "Algorithm 2, line 31",
        printed: onionskin::pseudo! { if (zFragment = zPeel) then { composite; } },
        amended: onionskin::pseudo! {
            if (zFragment = zPeel and zFragment < zOpaque) then {
                gChanged <- true;
                composite;
            }
        },
        why: "gChanged is an occlusion query, as in Algorithm 1",
        test: "this one",
    };
    let pixels = random_image(8);
    let right = run_algorithm(&ALGORITHM_2, &AMENDMENTS_2, &pixels, 20).unwrap();
    let queried = run_algorithm(&ALGORITHM_2, &[RESET_Z3, QUERIED], &pixels, 20).unwrap();
    println!(
        "{} iterations instead of {}",
        queried.iterations, right.iterations
    );
    assert_eq!(
        (
            bad(&pixels, &right.composited),
            bad(&pixels, &queried.composited)
        ),
        (0, 0)
    );
    assert_eq!(queried.iterations, right.iterations + 1);
    // As printed, where z3 is kept, the last layer is composited for ever, so the query would never be 0.
    assert!(
        !run_algorithm(&ALGORITHM_2, &[QUERIED], &pixels, 20)
            .unwrap()
            .ended
    );
}

/// Slices front to back, and among them a cone of so many layers, which is submitted last: each layer lies so many parts
/// of the slices behind the one before.
fn slices_and_cone(slices: usize, layers: usize, parts: usize) -> Vec<Pixel> {
    let mut surfaces = pixel((0..slices).map(|k| depth_of(k, slices)));
    for surface in &mut surfaces {
        surface.group = Group::Sorted;
    }
    let between = |layer: usize| depth_of((layer + 1) * slices / parts, slices) + 1e-4;
    for (mut surface, number) in pixel((0..layers).map(between)).into_iter().zip(0..) {
        surface.fragment.order = slices as u32 + number;
        surfaces.push(surface);
    }
    vec![surfaces]
}

/// Iterations of coherent layer peeling for slices with a cone's two layers, at one and two parts of their depth.
fn iterations_by_slices(slices: [usize; 7], parts: usize) -> [u32; 7] {
    slices.map(|slices| {
        let iterations = |which| amended(which, &slices_and_cone(slices, 2, parts)).iterations();
        let [hybrid, a, b] = [Loop::Hybrid, Loop::A, Loop::B].map(iterations);
        println!("{slices:5} slices: hybrid {hybrid}, A {a}, B {b}");
        assert_eq!((hybrid, a), (3, b), "hybrid layer peeling is constant");
        a
    })
}

#[test]
pub(crate) fn cx29_where_the_cone_lies_decides_up_to_how_many_slices_iterations_are_constant() {
    const SLICES: [usize; 7] = [32, 64, 128, 192, 256, 512, 1024];
    let near_the_front = iterations_by_slices(SLICES, 10);
    // Four fifths of the slices lie behind the cone: more than 128 of them from 192 slices on.
    let behind = |slices: usize| (slices as u32 * 4 / 5).div_ceil(128);
    assert_eq!(near_the_front, SLICES.map(|slices| 3 + behind(slices)));
    assert_eq!(near_the_front[..5], [4, 4, 4, 5, 5]);
    // A third before it, in it and behind it: no more than 128 up to 256 slices, the end of the figure.
    let in_the_middle = iterations_by_slices(SLICES, 3);
    assert_eq!(in_the_middle[..5], [in_the_middle[0]; 5]);
    assert!(in_the_middle[5] > in_the_middle[4] && in_the_middle[6] > in_the_middle[5]);
}

#[test]
pub(crate) fn cx30_no_cone_takes_257_and_3_iterations() {
    // With and without the iteration that finds nothing.
    for layers in 0..6 {
        let pixels = slices_and_cone(256, layers, 10);
        let [hybrid, peeling] = [Loop::Hybrid, Loop::LayerPeeling]
            .map(|which| amended(which, &pixels).iterations() as usize);
        assert_eq!((hybrid, peeling), (layers + 1, 256 + layers + 1));
        for counted in [0, 1] {
            assert_ne!((peeling - counted, hybrid - counted), (257, 3));
        }
    }
}

/// The factors of `glBlendFunc` in the specification of OpenGL 4.6, table 17.2.
const FACTORS: [&str; 19] = [
    "ZERO",
    "ONE",
    "SRC_COLOR",
    "ONE_MINUS_SRC_COLOR",
    "DST_COLOR",
    "ONE_MINUS_DST_COLOR",
    "SRC_ALPHA",
    "ONE_MINUS_SRC_ALPHA",
    "DST_ALPHA",
    "ONE_MINUS_DST_ALPHA",
    "CONSTANT_COLOR",
    "ONE_MINUS_CONSTANT_COLOR",
    "CONSTANT_ALPHA",
    "ONE_MINUS_CONSTANT_ALPHA",
    "SRC_ALPHA_SATURATE",
    "SRC1_COLOR",
    "ONE_MINUS_SRC1_COLOR",
    "SRC1_ALPHA",
    "ONE_MINUS_SRC1_ALPHA",
];

#[test]
pub(crate) fn cx33_one_of_section_6_s_four_factors_is_none_of_opengl_s() {
    let text = include_str!("../print/carr/section-6.txt");
    let (_, arguments) = text.split_once("glBlendFuncSeparate(").unwrap();
    let (arguments, _) = arguments.split_once(')').unwrap();
    let unknown: Vec<_> = arguments
        .split(',')
        .map(str::trim)
        .filter(|factor| !FACTORS.contains(factor))
        .collect();
    assert_eq!(unknown, ["DEST_ALPHA"]);
}
