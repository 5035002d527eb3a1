//! Negative controls: shaders of volumes with one changed word. A comparison of `fused.rs` or `slices.rs` must refuse each
//! of them.

use onionskin::low_level::methods::{ABufferOptions, RecordColor};
use onionskin::low_level::scene::Scene;
use onionskin::{Context, Frame, Method, Renderer};

use crate::fused::BOUND;
use crate::kit::changed::{Change, with_change};
use crate::kit::fog_scenes::{fog_and_pane, off, random_scene};
use crate::kit::slack;

const RAY: &str = "a_buffer/volume_ray.glsl";
const VIEW: &str = "common/view_ray.glsl";
const VOLUME: &str = "common/volume.glsl";
const SLICE: &str = "surface/slice.frag";

/// Changes nothing.
const NONE: Change = [RAY, "occupancy ^= ", "occupancy ^= "];
const NO_TOGGLE: Change = [RAY, "occupancy ^= 1u << (id & NUMBER);", ""];
const ENTERED_FOR_GOOD: Change = [RAY, "occupancy ^= ", "occupancy |= "];
const LAST_STEP_UNCUT: Change = [
    RAY,
    "min(float(number) * step_length, thickness)",
    "float(number) * step_length",
];
const BEGINS_OUTSIDE: Change = [RAY, "occupancy = left_again & ~entered;", "occupancy = 0u;"];
const OPAQUE_IGNORED: Change = [
    RAY,
    "min(depth, texelFetch(opaque, ivec2(gl_FragCoord.xy), 0).r)",
    "depth",
];
const SAMPLED_AT_THE_BEGINNING: Change = [RAY, "(from + to) / (2.0 * slant)", "from / slant"];
const LAST_STEP_LENGTH: Change = [
    RAY,
    "smallest = min(smallest, places[i].eye.w)",
    "smallest = places[i].eye.w",
];
const NO_SLANT: Change = [VIEW, "length(vec3(toward * frustum.zw, 1.0))", "1.0"];
const ONE_VOLUME_AT_A_TIME: Change = [VIEW, "media += medium_at", "media = medium_at"];
const NEAREST_SAMPLE: Change = [
    VOLUME,
    "vec3 part = index - vec3(cell);",
    "vec3 part = vec3(0.0);",
];
const SLICE_UNCORRECTED: Change = [SLICE, "media.a * slice_spacing * slant", "media.a * slant"];
const SLICE_EVERYWHERE: Change = [SLICE, "is_inside(places[i], toward, distance)", "true"];

fn rays() -> Method {
    Method::ABuffer(ABufferOptions {
        color: RecordColor::Float,
        pp_dp: true,
        peel: 3,
        ..ABufferOptions::default()
    })
}

fn render(context: &Context, scene: &Scene, method: &Method, change: Change) -> Frame {
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height).unwrap();
    let mut renderer = with_change(renderer.with_slices(24).unwrap(), change);
    renderer.render(scene, method).unwrap()
}

/// The error of fog and a pane relative to exp(-sigma L), with fewer samples than their size allows.
fn off_closed_form(context: &Context, eye: f64, alpha: f32, change: Change) -> f64 {
    let scene = fog_and_pane(eye, -0.4, alpha, 0.3);
    let frame = render(context, &scene, &rays(), change);
    off(&scene, &frame.image, f64::from(0.7_f32))
}

#[test]
fn l16_the_closed_form_notices_a_changed_word() {
    let context = Context::headless().unwrap();
    for (eye, alpha, changes) in [
        (
            5.0,
            0.4,
            &[NO_TOGGLE, ENTERED_FOR_GOOD, LAST_STEP_UNCUT, NO_SLANT][..],
        ),
        // The eye inside: its box has the face only where it is left.
        (0.75, 0.4, &[BEGINS_OUTSIDE, NO_TOGGLE, LAST_STEP_UNCUT]),
        (5.0, 1.0, &[OPAQUE_IGNORED]),
    ] {
        let unchanged = off_closed_form(&context, eye, alpha, NONE);
        assert!(unchanged < BOUND, "eye {eye}: {unchanged}");
        for change in changes {
            let off = off_closed_form(&context, eye, alpha, *change);
            println!("eye {eye}, alpha {alpha}, {change:?}: {off:.1e}");
            assert!(off > 2.0 * BOUND, "{change:?}, eye {eye}: {off}");
        }
    }
}

#[test]
fn l16_the_f64_caster_notices_a_changed_word() {
    let context = Context::headless().unwrap();
    // Opaque surfaces, four volumes, the eye in one of them; the one with the smallest sampling distance is not the last.
    let mut scene = random_scene(3);
    scene.volumes.reverse();
    let exact = render(&context, &scene, &Method::Exact, NONE);
    let off = |change| {
        let frame = render(&context, &scene, &rays(), change);
        slack::compare(&frame, &exact, &scene).1
    };
    assert!(off(NONE) < BOUND);
    for change in [
        NO_TOGGLE,
        ENTERED_FOR_GOOD,
        LAST_STEP_UNCUT,
        BEGINS_OUTSIDE,
        OPAQUE_IGNORED,
        SAMPLED_AT_THE_BEGINNING,
        LAST_STEP_LENGTH,
        NO_SLANT,
        ONE_VOLUME_AT_A_TIME,
        NEAREST_SAMPLE,
    ] {
        let off = off(change);
        println!("{change:?}: {off:.1e}");
        assert!(off > 2.0 * BOUND, "{change:?}: {off}");
    }
}

#[test]
fn l16_slices_with_a_changed_word_are_not_the_fused_image_s() {
    let context = Context::headless().unwrap();
    let hybrid = Method::HybridLayerPeeling(Default::default());
    // The pane at a border of two slabs, so that the slices' closed form is its own.
    let fog = fog_and_pane(5.0, 0.0, 0.4, 0.3);
    let off_closed_form = |change| {
        let frame = render(&context, &fog, &hybrid, change);
        off(&fog, &frame.image, f64::from(0.7_f32))
    };
    assert!(off_closed_form(NONE) < BOUND);
    for change in [SLICE_UNCORRECTED, NO_SLANT] {
        assert!(off_closed_form(change) > 2.0 * BOUND, "{change:?}");
    }
    let scene = random_scene(3);
    let fused = render(&context, &scene, &rays(), NONE);
    let rms = |change| {
        let frame = render(&context, &scene, &hybrid, change);
        onionskin::low_level::image::Comparison::new(&frame.image, &fused.image, 0.0)
            .unwrap()
            .rms
    };
    let right = rms(NONE);
    for change in [
        SLICE_UNCORRECTED,
        SLICE_EVERYWHERE,
        ONE_VOLUME_AT_A_TIME,
        NEAREST_SAMPLE,
    ] {
        let wrong = rms(change);
        println!("{change:?}: rms {wrong:.1e}, right {right:.1e}");
        assert!(wrong > 2.0 * right, "{change:?}: {wrong}, right {right}");
    }
}

/// A change that changes nothing is a mistake in the control.
#[test]
#[should_panic(expected = "no such word")]
fn a_word_that_is_not_there_cannot_be_changed() {
    let context = Context::headless().unwrap();
    let scene = fog_and_pane(5.0, -0.4, 0.4, 0.3);
    render(&context, &scene, &rays(), [RAY, "no such word", ""]);
}
