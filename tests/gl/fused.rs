//! Fused rendering: volumes and surfaces in one list, by A-buffers on GL, against closed forms and against the f64 caster.

use crate::kit::bounds::distance;
use crate::kit::stack;
use std::cell::Cell;

use onionskin::options::{ABufferOptions, ArraySort, Fill, Manager, RecordColor};
use onionskin::{
    Comparison, Context, CountBy, Frame, Method, Renderer, Scene, Transfer, TransferPoint,
};
use proptest::test_runner::{TestCaseError, TestError};

use crate::kit::chance::Chance;
use crate::kit::fog_plans::{Plan, plans};
use crate::kit::fog_scenes::{
    fog_and_pane, fog_with_a_gap, fogs_and_panes, gradient, off, painted, random_scene,
    random_volume,
};
use crate::kit::slack::compare;

/// The places where up to 4 volumes begin and end and of a dozen triangles between, times densities of up to 4 between
/// colours that differ by up to 1.
pub const BOUND: f64 = 20.0 * 4.0 * distance(1.0);

/// Colours in f32, so that what is compared is the rays.
const DFB: ABufferOptions = ABufferOptions {
    manager: Manager::Dfb,
    color: RecordColor::Float,
    ..ABufferOptions::DEFAULT
};

fn render(context: &Context, scene: &Scene, options: ABufferOptions) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, &Method::ABuffer(options)).unwrap()
}

fn refusal(context: &Context, scene: &Scene) -> String {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    let refused = renderer.render(scene, &Method::ABuffer(DFB));
    refused.unwrap_err().to_string()
}

#[test]
pub(crate) fn l16_fog_and_a_pane_follow_the_closed_form() {
    let context = Context::headless().unwrap();
    let mut worst = 0.0_f64;
    for (what, scene) in fogs_and_panes() {
        let frame = render(&context, &scene, DFB);
        let off = off(&scene, &frame.image, f64::from(0.7_f32));
        assert!(off < BOUND, "{what}: {off}");
        assert_eq!(frame.stats.lost, Some(0), "{what}");
        worst = worst.max(off);
    }
    println!("at most {worst:e} off");
}

fn exact(context: &Context, scene: &Scene) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, &Method::Exact).unwrap()
}

/// What is wrong with a plan's image, if anything; otherwise how far it is off.
fn fault(context: &Context, plan: &Plan, change: fn(&mut Scene)) -> Result<f64, String> {
    let scene = plan.scene();
    let mut other = scene.clone();
    change(&mut other);
    let frame = render(context, &other, DFB);
    let (compared, worst) = compare(&frame, &exact(context, &scene), &scene);
    if worst > BOUND || compared < 48 * 36 / 2 || frame.stats.lost != Some(0) {
        return Err(format!(
            "{compared} compared, {worst:e} off, {}",
            frame.stats
        ));
    }
    Ok(worst)
}

#[test]
pub(crate) fn l16_random_scenes_are_the_f64_caster_s() {
    let context = Context::headless().unwrap();
    let largest = Cell::new(0.0_f64);
    let ran = stack::runner(40).run(&plans(), |plan| {
        let worst = fault(&context, &plan, |_| ()).map_err(TestCaseError::fail)?;
        largest.set(largest.get().max(worst));
        Ok(())
    });
    match ran {
        Ok(()) => println!("at most {:e} off", largest.get()),
        Err(TestError::Fail(why, plan)) => panic!("{why}\n{plan:#?}"),
        Err(other) => panic!("{other}"),
    }
}

/// A box that is taken away is all that is left of the plan, whatever else there was.
#[test]
fn a_failure_shrinks_to_what_makes_it_fail() {
    let context = Context::headless().unwrap();
    let ran = stack::runner(40).run(&plans(), |plan| {
        let without = |scene: &mut Scene| _ = scene.volumes.pop();
        fault(&context, &plan, without).map_err(TestCaseError::fail)?;
        Ok(())
    });
    let Err(TestError::Fail(_, plan)) = ran else {
        panic!("a volume less went unnoticed");
    };
    assert_eq!(plan.volumes.len(), 1, "{plan:?}");
    assert!(
        plan.surfaces.is_empty() && plan.opaque.is_empty(),
        "{plan:?}"
    );
}

#[test]
fn a_volume_less_a_denser_one_or_another_step_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = random_scene(3);
    let image = exact(&context, &scene);
    let changed = |change: fn(&mut Scene)| {
        let mut other = scene.clone();
        change(&mut other);
        compare(&render(&context, &other, DFB), &image, &scene).1
    };
    assert!(changed(|_| ()) < BOUND);
    // As if a box's fragments were not toggled at; as if steps were not what they are; other surfaces.
    assert!(changed(|scene| _ = scene.volumes.pop()) > 2.0 * BOUND);
    let steps = |scene: &mut Scene| scene.volumes.iter_mut().for_each(|it| it.step *= 2.0);
    assert!(changed(steps) > 2.0 * BOUND);
    assert!(changed(|scene| scene.meshes[0].triangles.truncate(20)) > 2.0 * BOUND);
}

#[test]
pub(crate) fn l16_l17_every_combination_gives_one_image() {
    let context = Context::headless().unwrap();
    // Both have four volumes, and so the same programs, which take longer to compile than to run.
    let opaque = random_scene(3);
    let mut transparent = random_scene(15);
    transparent.meshes.truncate(1);
    let [width, height] = opaque.size;
    let mut renderer = Renderer::new(&context, width, height).unwrap();
    for (seed, scene) in [(3, opaque), (15, transparent)] {
        let first = renderer.render(&scene, &Method::ABuffer(DFB)).unwrap();
        for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
            for (pp_ao, pp_dp) in [(false, false), (true, false), (false, true), (true, true)] {
                for (fill, sort, budget) in [
                    (Fill::Atomics, ArraySort::Insertion, None),
                    (Fill::Automatic, ArraySort::Network, Some(60_000)),
                ] {
                    // ppDP in subpasses of 3, and of 8 where ppAO ends.
                    let options = ABufferOptions {
                        manager,
                        pp_ao,
                        pp_dp,
                        fill,
                        sort,
                        budget,
                        array: if pp_ao && pp_dp { 8 } else { 64 },
                        peel: 3,
                        ..DFB
                    };
                    let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
                    let counts = frame.stats.a_buffer.unwrap();
                    // The same fragments in the same order, and the same segments between them: the same bits.
                    let error = Comparison::new(&frame.image, &first.image, 0.0).unwrap();
                    let what = format!("seed {seed} {options:?}: {error:?}");
                    assert_eq!((error.over, frame.stats.lost), (0, Some(0)), "{what}");
                    assert_eq!(counts.bands > 1, budget.is_some(), "{what}");
                    assert!(!pp_dp || pp_ao || counts.most_subpasses > 1, "{what}");
                }
            }
        }
    }
}

#[test]
pub(crate) fn l16_densities_of_overlapping_volumes_add() {
    let context = Context::headless().unwrap();
    for eye in [5.0, 0.75] {
        let mut scene = fog_and_pane(eye, -0.4, 0.4, 0.3);
        let mut second = scene.volumes[0].clone();
        let points = [0.0_f32, 1.0].map(|value| TransferPoint {
            value,
            color: [1.0, 0.0, 0.0],
            density: value * 0.5,
        });
        second = second.with_transfer(Transfer::new(points.into()).unwrap());
        scene.volumes.push(second);
        let image = render(&context, &scene, DFB).image;
        let together = off(&scene, &image, f64::from(0.7_f32) * 1.5);
        assert!(together < BOUND, "eye {eye}: {together}");
        assert!(off(&scene, &image, f64::from(0.7_f32)) > 0.01);
    }
}

/// Midpoints: halving the step takes the error to a quarter. Density alone would be exact at every step, for it is linear;
/// the colour changes with it.
#[test]
fn l16_the_image_of_a_gradient_converges_with_the_square_of_the_step() {
    let context = Context::headless().unwrap();
    let mut scene = gradient();
    let mut at = |step| {
        scene.volumes[0].step = step;
        render(&context, &scene, DFB).image
    };
    let limit = at(1.0 / 512.0);
    let errors =
        [0.25, 0.125, 0.0625].map(|step| Comparison::new(&at(step), &limit, 0.0).unwrap().max);
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((3.5..4.5).contains(&ratio), "{errors:?}");
    }
}

#[test]
fn l16_sixteen_volumes_at_once_and_no_more_than_there_are_bits() {
    let context = Context::headless().unwrap();
    let mut chance = Chance::new(0);
    let mut scene = random_scene(2);
    scene.volumes = (0..16)
        .map(|i| random_volume(&mut chance, i == 0))
        .collect();
    let frame = render(&context, &scene, DFB);
    let (_, worst) = compare(&frame, &exact(&context, &scene), &scene);
    assert!(worst < BOUND, "{worst}");
    scene.volumes = vec![scene.volumes[1].clone(); 33];
    let refused = refusal(&context, &scene);
    assert!(
        refused.contains("33 volumes") && refused.contains("32"),
        "{refused}"
    );
}

/// The eye inside of a volume that ends behind the far plane: no face of it is between the planes.
#[test]
fn l16_a_volume_around_the_whole_frustum_is_seen() {
    let context = Context::headless().unwrap();
    let mut scene = fog_and_pane(0.75, -0.1, 0.4, 0.3);
    for far in [1.6, 1.3, 20.0] {
        scene.camera.far = far;
        let frame = render(&context, &scene, DFB);
        let (_, worst) = compare(&frame, &exact(&context, &scene), &scene);
        assert!(worst < BOUND, "{far}: {worst}");
        assert_eq!(frame.stats.lost, Some(0));
    }
}

#[test]
fn a_full_array_and_an_early_end_are_counted() {
    let context = Context::headless().unwrap();
    let scene = random_scene(3);
    let whole = render(&context, &scene, DFB);
    let full = render(&context, &scene, ABufferOptions { array: 2, ..DFB });
    assert!(full.stats.lost > Some(0), "{}", full.stats);
    assert!(full.stats.a_buffer.unwrap().truncated_pixels > 0);
    let mut dense = scene.clone();
    dense.volumes = vec![
        scene.volumes[0]
            .clone()
            .with_transfer(painted([1.0, 0.5, 0.0])),
    ];
    let points = dense.volumes[0].transfer.points().to_vec();
    let points = points.into_iter().map(|point| TransferPoint {
        density: point.density * 20.0,
        ..point
    });
    dense.volumes[0].transfer = Transfer::new(points.collect()).unwrap();
    let whole_dense = render(&context, &dense, DFB);
    for pp_dp in [false, true] {
        let options = ABufferOptions {
            termination: 0.02,
            pp_dp,
            ..DFB
        };
        let early = render(&context, &dense, options);
        let error = Comparison::new(&early.image, &whole_dense.image, 0.02).unwrap();
        assert!(error.over == 0 && error.max > 0.0, "{error:?}");
        assert!(early.stats.lost > Some(0));
    }
    assert_eq!(whole.stats.lost, Some(0));
}

/// Boxes are counted as the lists hold them, wherever opaque surfaces are: twice where a ray passes through one, once where
/// the eye is inside.
#[test]
pub(crate) fn l01_the_complexity_image_counts_boxes() {
    let context = Context::headless().unwrap();
    for (eye, alpha, pane, expected) in [
        (5.0, 0.4, 0.3, 3),
        (5.0, 1.0, 2.0, 2),
        (5.0, 0.4, -2.0, 3),
        (0.75, 1.0, -0.1, 1),
    ] {
        let scene = fog_and_pane(eye, pane, alpha, 0.5);
        let [width, height] = scene.size;
        let mut renderer = Renderer::new(&context, width, height).unwrap();
        for by in [CountBy::Blending, CountBy::Atomics, CountBy::Stencil] {
            let counted = renderer.complexity(&scene, by).unwrap();
            let middle = counted.counts[(height / 2 * width + width / 2) as usize];
            assert_eq!(middle, expected, "{by:?} eye {eye} pane {pane}");
            let frame = renderer.render(&scene, &Method::ABuffer(DFB)).unwrap();
            assert_eq!(frame.stats.fragments, counted.fragments(), "{by:?}");
        }
    }
}

/// llvmpipe ends a shader's loops after 65535 iterations, in silence.
#[test]
fn so_many_samples_that_the_driver_would_lose_some_are_refused() {
    let context = Context::headless().unwrap();
    if context.driver().quirks().loop_limit.is_none() {
        println!("skipped: this driver has no such limit");
        return;
    }
    let scene = fog_and_pane(5.0, 0.3, 0.4, 0.0001);
    let refused = refusal(&context, &scene);
    assert!(
        refused.contains("samples") && refused.contains("step"),
        "{refused}"
    );
    // As many as are taken come out whole.
    let scene = fog_and_pane(5.0, 0.3, 0.4, 0.0005);
    let image = render(&context, &scene, DFB).image;
    let off = off(&scene, &image, f64::from(0.7_f32));
    assert!(off < BOUND, "{off}");
}

#[test]
fn empty_samples_and_the_cells_around_them_are_not_seen() {
    let context = Context::headless().unwrap();
    let scene = fog_with_a_gap(0.02);
    let frame = render(&context, &scene, DFB);
    let sigma = f64::from(0.7_f32);
    let off_half = off(&scene, &frame.image, sigma / 2.0);
    // Two half steps, seen at 8 degrees at the most.
    assert!(off_half < sigma * 1.01 * 0.01, "{off_half}");
    assert!(
        off(&scene, &frame.image, sigma) > 0.2,
        "a gap would go unnoticed"
    );
}
