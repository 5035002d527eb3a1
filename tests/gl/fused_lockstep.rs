//! Fused rendering twice: section 6.1 and ppDP line by line on the emulated pixel, and the shaders on OpenGL. The same
//! light from the same lists, in as many subpasses, by as many records.

use crate::kit::bounds::distance;
use crate::kit::stack;
use std::cell::Cell;

use onionskin::low_level::papers::lindholm_2015::components::PP_DP;
use onionskin::low_level::papers::lindholm_2015::fused::{FUSED, FUSED_AMENDMENTS, FUSED_PP_DP};
use onionskin::options::Manager;
use onionskin::{Context, Scene, Transfer, TransferPoint};
use proptest::prelude::*;
use proptest::test_runner::TestError;

use crate::kit::emulated::{Pixels, apart, counts, on_gl};
use crate::kit::fog_plans::plans;
use crate::kit::fog_scenes::fog_and_pane;

/// As in `gl/volumes.rs`.
const BOUND: f64 = 4.0 * distance(0.5);

/// Panes in, before and behind overlapping volumes, the eye in one, in two or in none of them: every ray meets the same.
pub(crate) fn whole_scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for (eye, alpha) in [(5.0, 0.4), (1.2, 0.4), (0.75, 0.4), (5.0, 1.0)] {
        let mut scene = fog_and_pane(eye, -0.4, alpha, 0.3);
        for (height, alpha) in [(0.2, 0.3), (-0.8, 0.5), (-1.5, 0.2)] {
            scene
                .meshes
                .extend(fog_and_pane(eye, height, alpha, 0.3).meshes);
        }
        let mut second = scene.volumes[0].clone();
        second = second
            .transformed(&onionskin::Transform {
                scale: glam::DVec3::splat(1.4),
                ..Default::default()
            })
            .unwrap();
        let points = [0.0_f32, 1.0].map(|value| TransferPoint {
            value,
            color: [0.2, 1.0 - value, 0.3],
            density: value * 0.5,
        });
        scene
            .volumes
            .push(second.with_transfer(Transfer::new(points.into()).unwrap()));
        scenes.push(scene);
    }
    scenes
}

#[test]
pub(crate) fn l16_l17_the_pseudocode_and_the_shaders_see_the_same_light() {
    let context = Context::headless().unwrap();
    let mut worst = 0.0_f64;
    for scene in whole_scenes() {
        let pixels = Pixels::of(&context, &scene);
        for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
            for peel in [None, Some(1), Some(3), Some(8)] {
                let frame = on_gl(&context, &scene, manager, peel);
                let (image, emulated) = match peel {
                    None => pixels.emulate(&FUSED, &FUSED_AMENDMENTS, 64),
                    Some(array) => pixels.emulate(&PP_DP, &FUSED_PP_DP, array),
                };
                let what = format!("{manager:?} {peel:?} eye {}", scene.camera.eye);
                let off = apart(&frame, image, &scene);
                assert!(off < BOUND, "{what}: {off}");
                worst = worst.max(off);
                assert_eq!(emulated, counts(&frame), "{what}");
            }
        }
    }
    println!("at most {worst:e} apart");
}

#[test]
fn l16_l17_random_scenes_are_the_same_on_both() {
    let context = Context::headless().unwrap();
    let largest = Cell::new(0.0_f64);
    let ran = stack::runner(16).run(&(plans(), 1..9_u32), |(plan, array)| {
        let scene = plan.scene();
        let pixels = Pixels::of(&context, &scene);
        let frame = on_gl(&context, &scene, Manager::Dfb, Some(array));
        let (image, _) = pixels.emulate(&PP_DP, &FUSED_PP_DP, array);
        let off = apart(&frame, image, &scene);
        largest.set(largest.get().max(off));
        prop_assert!(off < BOUND, "{off}");
        Ok(())
    });
    match ran {
        Ok(()) => println!("at most {:e} apart", largest.get()),
        Err(TestError::Fail(why, (plan, array))) => panic!("arrays of {array}: {why}\n{plan:#?}"),
        Err(other) => panic!("{other}"),
    }
}

/// As the prose alone has it, without where a ray begins and what ends it.
#[test]
fn an_algorithm_that_differs_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scenes = whole_scenes();
    for (scene, dropped) in [(&scenes[2], 0), (&scenes[3], 1)] {
        let pixels = Pixels::of(&context, scene);
        let frame = on_gl(&context, scene, Manager::Dfb, None);
        let (image, _) = pixels.emulate(&FUSED, &[FUSED_AMENDMENTS[1 - dropped]], 64);
        assert!(apart(&frame, image, scene) > 2.0 * BOUND);
    }
}
