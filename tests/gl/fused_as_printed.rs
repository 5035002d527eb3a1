//! ppAO and ppDP as printed, on scenes with volumes: what errata LX01, LX04, LX05 and LX07 cost where the lists hold the faces of
//! boxes, too. A face that is lost is a toggle that is lost, so that a ray sees a volume where there is none.

use crate::kit::bounds::distance;
use crate::kit::driver::keeps_lists_in_order;
use onionskin::low_level::oracle::volumes::Ray;
use onionskin::low_level::papers::lindholm_2015::components::{PP_DP, STOP};
use onionskin::low_level::papers::lindholm_2015::fused::{EVALUATE_BUFFER, FUSED_PP_DP};
use onionskin::options::{ABufferOptions, ArraySort, Manager, RecordColor};
use onionskin::{Context, Frame, Image, Method, Scene, Transfer, TransferPoint};

use crate::kit::emulated::{Pixels, counts, render};
use crate::kit::fog_scenes::fog_and_pane;

/// As in `gl/volumes.rs`.
const BOUND: f64 = 4.0 * distance(0.5);
const SIGMA: f64 = 0.7_f32 as f64;
const AS_PRINTED: ABufferOptions = ABufferOptions {
    manager: Manager::Dfb,
    color: RecordColor::Float,
    sort: ArraySort::Insertion,
    reading: onionskin::options::Reading::AsPrinted,
    ..ABufferOptions::DEFAULT
};
const PP_DP_AS_PRINTED: ABufferOptions = ABufferOptions {
    pp_dp: true,
    peel: 1,
    ..AS_PRINTED
};

/// What a ray passes, front to back: heights between which there is red fog of a density, or a pane of `fog_and_pane`.
#[derive(Clone, Copy)]
enum Part {
    Fog(f64, f64, f64),
    Pane,
}
use Part::{Fog, Pane};

/// The largest difference of an image from what the parts make of every pixel, over the scene's background.
fn off(scene: &Scene, image: &Image, parts: &[Part]) -> f64 {
    let [width, height] = scene.size;
    let alpha = f64::from(scene.meshes[0].vertices[0].color.a);
    let mut worst = 0.0_f64;
    for (number, found) in (0..width * height).zip(&image.pixels) {
        let place = [number % width, height - 1 - number / width];
        let slant = Ray::through(&scene.camera, scene.size, place)
            .direction
            .length();
        let (mut light, mut clear) = ([0.0; 3], 1.0);
        for part in parts {
            let (channel, opacity) = match *part {
                Fog(from, to, sigma) => (0, 1.0 - (-sigma * slant * (from - to)).exp()),
                Pane => (2, alpha),
            };
            light[channel] += clear * opacity;
            clear *= 1.0 - opacity;
        }
        light[1] += clear;
        let pairs = [found.r, found.g, found.b].into_iter().zip(light);
        for (found, expected) in pairs {
            worst = worst.max((f64::from(found) - expected).abs());
        }
    }
    worst
}

fn by(context: &Context, scene: &Scene, options: ABufferOptions) -> Frame {
    render(context, scene, &Method::ABuffer(options))
}

/// Right when it is amended, and as printed what the parts are.
fn loses(
    context: &Context,
    scene: &Scene,
    options: ABufferOptions,
    lost: u64,
    right: &[Part],
    printed: &[Part],
) {
    let amended = ABufferOptions {
        reading: onionskin::options::Reading::Amended,
        ..options
    };
    let frame = by(context, scene, amended);
    assert_eq!(frame.stats.lost, Some(0));
    let error = off(scene, &frame.image, right);
    assert!(error < BOUND, "amended: {error}");
    let frame = by(context, scene, options);
    let pixels = u64::from(scene.size[0] * scene.size[1]);
    assert_eq!(frame.stats.lost, Some(lost * pixels));
    let error = off(scene, &frame.image, printed);
    assert!(error < BOUND, "as printed: {error}");
    let difference = off(scene, &frame.image, right);
    assert!(difference > 1000.0 * BOUND, "no difference: {difference}");
    println!("{lost} fragments of every pixel lost, off by {difference:.2}");
}

/// Two volumes in one box: every face is there twice.
fn twice(peel: u32) -> (Scene, ABufferOptions) {
    let mut scene = fog_and_pane(5.0, -0.4, 0.4, 0.3);
    let points = [0.0_f32, 1.0].map(|value| TransferPoint {
        value,
        color: [1.0, 0.0, 0.0],
        density: value * 0.5,
    });
    let second = scene.volumes[0].clone();
    scene
        .volumes
        .push(second.with_transfer(Transfer::new(points.into()).unwrap()));
    let options = ABufferOptions {
        peel,
        ..PP_DP_AS_PRINTED
    };
    (scene, options)
}

/// Erratum LX01. With a buffer of 1 the second volume's faces are lost, and it is not seen; with one of 2 only the face where
/// it is left is, and it goes on to the far plane, 20 from the eye at 5.
#[test]
pub(crate) fn l13_a_tie_that_is_lost_is_a_volume_that_is_not_seen_or_does_not_end() {
    let context = Context::headless().unwrap();
    if !keeps_lists_in_order(&context) {
        return;
    }
    let both = SIGMA * 1.5;
    let right = [Fog(1.0, -0.4, both), Pane, Fog(-0.4, -1.0, both)];
    let (scene, options) = twice(1);
    let first = [Fog(1.0, -0.4, SIGMA), Pane, Fog(-0.4, -1.0, SIGMA)];
    loses(&context, &scene, options, 2, &right, &first);
    let (scene, options) = twice(2);
    let endless = [
        Fog(1.0, -0.4, both),
        Pane,
        Fog(-0.4, -1.0, both),
        Fog(-1.0, -15.0, SIGMA * 0.5),
    ];
    loses(&context, &scene, options, 1, &right, &endless);
}

/// Erratum LX04. A face before the near plane lies at depth 0, to which it is clamped, and is skipped. So the ray is outside
/// of the fog until it leaves it, and then inside.
#[test]
pub(crate) fn l13_a_face_before_the_near_plane_is_skipped_and_the_fog_is_inside_out() {
    let context = Context::headless().unwrap();
    let scene = fog_and_pane(1.2, -0.4, 0.4, 0.3);
    let right = [Fog(0.7, -0.4, SIGMA), Pane, Fog(-0.4, -1.0, SIGMA)];
    let inside_out = [Pane, Fog(-1.0, 1.2 - 20.0, SIGMA)];
    for peel in [1, 8] {
        let options = ABufferOptions {
            peel,
            ..PP_DP_AS_PRINTED
        };
        loses(&context, &scene, options, 1, &right, &inside_out);
    }
}

/// Erratum LX05. Past the last segment a pixel is not resolved: its volumes are not seen either.
#[test]
pub(crate) fn l11_past_the_last_segment_there_is_no_fog() {
    let context = Context::headless().unwrap();
    let mut scene = fog_and_pane(5.0, -0.4, 0.4, 0.3);
    let pane = scene.meshes[0].clone();
    scene.meshes.extend(std::iter::repeat_n(pane, 6));
    let options = ABufferOptions {
        pp_ao: true,
        pp_dp: true,
        array: 8,
        ..AS_PRINTED
    };
    let mut right = vec![Fog(1.0, -0.4, SIGMA)];
    right.extend([Pane; 7]);
    right.push(Fog(-0.4, -1.0, SIGMA));
    loses(&context, &scene, options, 9, &right, &[]);
}

/// Errata LX06 and LX07. With a segment of 256, whose reference is clamped to 255, every pixel passes again: fog and pane are
/// there twice.
#[test]
pub(crate) fn lx07_with_a_segment_of_256_the_fog_is_seen_through_itself() {
    let context = Context::headless().unwrap();
    let scene = fog_and_pane(5.0, -0.4, 0.4, 0.3);
    let options = ABufferOptions {
        pp_ao: true,
        array: 256,
        ..AS_PRINTED
    };
    let once = [Fog(1.0, -0.4, SIGMA), Pane, Fog(-0.4, -1.0, SIGMA)];
    let twice = [once, once].concat();
    loses(&context, &scene, options, 0, &once, &twice);
}

/// Without ties and nothing before the near plane, what is printed is right; and the pseudocode loses what the shader does.
#[test]
fn l13_the_pseudocode_as_printed_loses_as_many_faces() {
    let context = Context::headless().unwrap();
    let printed = [STOP, FUSED_PP_DP[4], EVALUATE_BUFFER];
    for (scene, loses_any) in [
        (twice(1).0, true),
        (fog_and_pane(1.2, -0.4, 0.4, 0.3), true),
        (fog_and_pane(5.0, -0.4, 0.4, 0.3), false),
        (fog_and_pane(0.75, -0.4, 0.4, 0.3), false),
    ] {
        let pixels = Pixels::of(&context, &scene);
        for peel in [1, 2, 3] {
            let options = ABufferOptions {
                peel,
                ..PP_DP_AS_PRINTED
            };
            let on_gl = counts(&by(&context, &scene, options));
            let (_, emulated) = pixels.emulate(&PP_DP, &printed, peel);
            assert_eq!(emulated, on_gl, "{peel}, eye {}", scene.camera.eye);
            // A buffer of 3 ends nowhere between two equal faces and the pane.
            assert_eq!(
                on_gl[2] > 0,
                loses_any && (peel < 3 || scene.volumes.len() < 2),
                "{peel}"
            );
        }
    }
}
