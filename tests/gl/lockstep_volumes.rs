//! Fused rendering on the emulated pixel, call by call, and on OpenGL: the same records in every list, boxes among them, the
//! same costs, and the same light.

use onionskin::low_level::emulator::{Group, PixelRay, RayEvent, RayHappening, Surface};
use onionskin::low_level::fragment::Source;
use onionskin::low_level::oracle::volumes::Ray;
use onionskin::low_level::papers::lindholm_2015 as paper;
use onionskin::low_level::papers::stage;
use onionskin::options::{ABufferOptions, Fill, RecordColor};
use onionskin::{Context, Renderer, Scene};

use crate::fused_lockstep::whole_scenes;
use crate::kit::a_buffer::{MANAGERS, small};
use crate::kit::both::{parting, surfaces_of};
use crate::kit::bounds::distance;
use crate::kit::changed::Change;
use crate::kit::gl_lists::{Left, left};
use crate::lockstep_lists::{Emulated, compare_lists, fills_in_order};

/// As in `gl/volumes.rs`.
const BOUND: f64 = 4.0 * distance(0.5);

/// Each pixel's surfaces, and behind them the faces of boxes, where OpenGL's rasteriser has them.
fn with_boxes(context: &Context, scene: &Scene, left: &Left) -> Vec<Vec<Surface>> {
    let mut pixels = surfaces_of(context, scene);
    for (pixel, surfaces) in pixels.iter_mut().enumerate() {
        let list = left.list(pixel).into_iter();
        let faces = list.filter(|it| matches!(Source::of(it.order), Source::Proxy { .. }));
        surfaces.extend(faces.map(|fragment| Surface {
            fragment,
            group: Group::Proxy,
        }));
    }
    pixels
}

/// Fills and resolves on both, and compares. Returns how many records of boxes there were, and by how much the light is off.
fn compare(
    context: &Context,
    scene: &Scene,
    options: ABufferOptions,
    change: Option<Change>,
) -> (usize, f64) {
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height).unwrap();
    let left = left(&mut renderer.with_given_planes(), scene, options, change);
    let surfaces = with_boxes(context, scene, &left);
    let is_box = |surface: &&Surface| surface.group == Group::Proxy;
    let boxes = surfaces.iter().flatten().filter(is_box).count();
    let mut emulated = Emulated::new(context, scene, options, surfaces);
    let rays = (0..width * height).map(|pixel| {
        let place = [pixel % width, pixel / width];
        let ray = Ray::through(&scene.camera, scene.size, place);
        PixelRay {
            origin: ray.origin,
            direction: ray.direction,
        }
    });
    let camera = scene.camera;
    emulated.emulator.set_planes([camera.near, camera.far]);
    emulated
        .emulator
        .set_volumes(scene.volumes.clone(), rays.collect());
    emulated.fill();
    // Without a fragment nothing is drawn.
    let pixels: Vec<_> = (0..left.image.len())
        .filter(|&pixel| left.counted(pixel) > 0)
        .collect();
    for &pixel in &pixels {
        compare_lists(&emulated, &left, pixel, &mut [0; 2]);
    }
    emulated.resolve();
    let costs = emulated.emulator.integers(paper::COST).unwrap();
    let image = emulated.emulator.colors(stage::IMAGE_COLOR).unwrap();
    let (mut worst, mut toggled) = (0.0_f64, 0);
    for &pixel in &pixels {
        assert!(
            left.costs[pixel] == costs[pixel],
            "the resolve of pixel {pixel} costs {:?} on OpenGL and {:?} on the emulated pixel",
            left.costs[pixel],
            costs[pixel],
        );
        let last = emulated.emulator.records()[pixel].resolves.last();
        let ray = last.and_then(|last| last.ray.as_ref()).expect("a ray");
        let is_face = |event: &&RayEvent| matches!(event.what, RayHappening::Toggles(_));
        toggled += ray.events.iter().filter(is_face).count();
        let channels = left.image[pixel].iter().zip(image[pixel]);
        let off = channels.map(|(a, b)| f64::from((a - b).abs()));
        let off = off.max_by(f64::total_cmp).unwrap();
        assert!(
            off < BOUND,
            "the image at pixel {pixel} is {:?} on OpenGL and {:?} on the emulated pixel",
            left.image[pixel],
            image[pixel],
        );
        worst = worst.max(off);
    }
    // Every face is met, unless a static array has dropped it.
    let drops = !options.pp_dp && options.array < 64;
    assert!(
        toggled == boxes || drops && toggled < boxes,
        "{toggled} of {boxes}"
    );
    (boxes, worst)
}

#[test]
fn whole_fused_scenes_by_every_manager_and_local_array() {
    let context = Context::headless().unwrap();
    if !fills_in_order(&context, Fill::Automatic) {
        return;
    }
    for scene in whole_scenes() {
        for manager in MANAGERS {
            for (pp_dp, peel, array) in
                [(false, 8, 64), (false, 8, 4), (true, 1, 64), (true, 3, 64)]
            {
                let options = ABufferOptions {
                    pp_dp,
                    peel,
                    array,
                    color: RecordColor::Float,
                    ..small(manager)
                };
                let (boxes, off) = compare(&context, &scene, options, None);
                println!("{manager:?}, peeling {pp_dp}, {array}: {boxes} faces, off by {off:.1e}");
                assert!(boxes > 100, "{boxes}");
            }
        }
    }
}

#[test]
fn a_changed_word_of_the_rays_is_noticed() {
    const CHANGES: [(Change, &str); 3] = [
        (
            [
                "a_buffer/volume_ray.glsl",
                "occupancy = left_again & ~entered;",
                "occupancy = 0u;",
            ],
            "the image",
        ),
        (
            [
                "a_buffer/volume_ray.glsl",
                "occupancy ^= 1u <<",
                "occupancy |= 1u <<",
            ],
            "the image",
        ),
        (
            ["a_buffer/volume_ray.glsl", "composited += 1u;", ""],
            "the resolve",
        ),
    ];
    let context = Context::headless().unwrap();
    if !fills_in_order(&context, Fill::Automatic) {
        return;
    }
    let scene = &whole_scenes()[2];
    for (change, said) in CHANGES {
        let what = parting(|| {
            compare(&context, scene, small(MANAGERS[1]), Some(change));
        });
        assert!(what.starts_with(said), "{change:?}: {what}");
    }
}
