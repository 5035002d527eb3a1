//! Volumes as slices, next to unsorted surfaces (Carr et al. 2008, Algorithm 1): against closed forms, against slices in
//! f64, and against the fused A-buffer as their number grows.

use crate::kit::driver::interpolates_true_corners;
use crate::kit::stack;
use std::cell::Cell;

use onionskin::low_level::methods::{DEFAULT_SLICES, MOST_SLICES};
use onionskin::options::{ABufferOptions, RecordColor};
use onionskin::{Comparison, Context, Error, Frame, Method, Renderer, Scene, registry};
use proptest::test_runner::{TestCaseError, TestError};

use crate::kit::cast::cast;
use crate::kit::fog_plans::plans;
use crate::kit::fog_scenes::{fog_and_pane, fog_with_a_gap, gradient, off, random_scene};
use crate::kit::slices::{Rule, SLICES, cast_slices};

/// Where a slice is met is a depth of f32: with a near plane at 0.5, half of a last place of 1 is 6^2/0.5 x 2^-25 = 2e-6 at
/// a distance of 6. Up to 512 slices are added up in f32, half of a last place of 1 each: 512 x 2^-25 = 1.5e-5.
const BOUND: f64 = 2e-5;

fn hybrid() -> Method {
    Method::HybridLayerPeeling(Default::default())
}

fn render(context: &Context, scene: &Scene, method: &Method, slices: u32) -> Frame {
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height).unwrap();
    let mut renderer = renderer.with_slices(slices).unwrap();
    renderer.render(scene, method).unwrap()
}

/// A ray passes N slabs of thickness d, that is all of the fog; only the slab with a pane in it is on one side of the pane
/// as a whole. So the image is the closed form's of a pane moved to the next border of a slab, at most d/2 away, exactly;
/// and from the pane's own it differs by no more than the fog that has changed sides absorbs, times the pane's opacity.
#[test]
pub(crate) fn l16_slices_of_fog_and_a_pane_follow_the_closed_form() {
    let context = Context::headless().unwrap();
    let sigma = f64::from(0.7_f32);
    let (mut worst, mut most) = (0.0_f64, 0.0_f64);
    for eye in [5.0, 0.75] {
        // In front, inside (seen from both eyes), behind.
        for pane in [2.0, 0.3, -0.4, -2.0] {
            if f64::from(pane) > eye - 0.5 {
                continue;
            }
            for alpha in [0.4, 1.0] {
                for count in [1, 7, 64, 512] {
                    let scene = fog_and_pane(eye, pane, alpha, 0.5);
                    let frame = render(&context, &scene, &hybrid(), count);
                    let top = (eye - 0.5).min(1.0);
                    let spacing = (top + 1.0) / f64::from(count);
                    let before = ((top - f64::from(pane)) / spacing - 0.5).ceil();
                    let before = before.clamp(0.0, f64::from(count));
                    let mut moved = scene.clone();
                    if (-1.0..top).contains(&f64::from(pane)) {
                        let height = top - before * spacing;
                        let corners = moved.meshes[0].vertices.iter_mut();
                        corners.for_each(|corner| corner.position.z = height);
                    }
                    let what = format!("eye {eye} pane {pane} alpha {alpha}, {count} slices");
                    let exactly = off(&moved, &frame.image, sigma);
                    assert!(exactly < BOUND, "{what}: {exactly}");
                    let nearly = off(&scene, &frame.image, sigma);
                    // The image's corner is seen at 8 degrees at the most: 1/cos(8 degrees) = 1.01.
                    let moved_fog = 1.0 - (-sigma * 1.01 * spacing / 2.0).exp();
                    assert!(
                        nearly < f64::from(alpha) * moved_fog + BOUND,
                        "{what}: {nearly}"
                    );
                    assert_eq!(
                        (frame.stats.lost, frame.stats.slices),
                        (Some(0), Some(count)),
                        "{what}"
                    );
                    (worst, most) = (worst.max(exactly), most.max(nearly));
                }
            }
        }
    }
    println!("at most {worst:e} off the moved pane's, {most:e} off the pane's own");
}

/// How many pixels are compared with the slices in f64, and the largest difference.
fn compare(frame: &Frame, scene: &Scene, count: u32, rule: Rule) -> (usize, f64) {
    let expected = cast_slices(scene, &cast(scene), count, rule);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for (found, expected) in frame.image.pixels.iter().zip(expected) {
        let Some([r, g, b]) = expected else {
            continue;
        };
        compared += 1;
        for (found, expected) in [(found.r, r), (found.g, g), (found.b, b)] {
            worst = worst.max((f64::from(found) - expected).abs());
        }
    }
    (compared, worst)
}

#[test]
pub(crate) fn c02_random_scenes_are_the_slices_in_f64_s() {
    let context = Context::headless().unwrap();
    if !interpolates_true_corners(&context) {
        return;
    }
    let largest = Cell::new(0.0_f64);
    let cases = (plans(), 1..100_u32);
    let ran = stack::runner(24).run(&cases, |(plan, count)| {
        let scene = plan.scene();
        let frame = render(&context, &scene, &hybrid(), count);
        let (compared, worst) = compare(&frame, &scene, count, SLICES);
        largest.set(largest.get().max(worst));
        if worst > BOUND || compared < 48 * 36 / 2 || frame.stats.lost != Some(0) {
            let what = format!("{compared} compared, {worst:e} off, {}", frame.stats);
            return Err(TestCaseError::fail(what));
        }
        Ok(())
    });
    match ran {
        Ok(()) => println!("at most {:e} off", largest.get()),
        Err(TestError::Fail(why, (plan, count))) => panic!("{count} slices: {why}\n{plan:#?}"),
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn a_missing_slice_or_another_opacity_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = random_scene(3);
    let frame = render(&context, &scene, &hybrid(), 24);
    let off = |rule| compare(&frame, &scene, 24, rule).1;
    assert!(off(SLICES) < BOUND);
    let changed = [
        Rule {
            missing: Some(12),
            ..SLICES
        },
        Rule {
            corrected: false,
            ..SLICES
        },
        Rule {
            slanted: false,
            ..SLICES
        },
        Rule {
            mixed: false,
            ..SLICES
        },
    ];
    for (number, rule) in changed.into_iter().enumerate() {
        let off = off(rule);
        assert!(off > 2.0 * BOUND, "rule {number}: {off}");
    }
    // One slice more moves them all.
    assert!(compare(&frame, &scene, 25, SLICES).1 > 2.0 * BOUND);
}

#[test]
pub(crate) fn c02_c03_iterations_are_those_of_the_surfaces_alone() {
    let context = Context::headless().unwrap();
    for seed in 0..6 {
        let scene = random_scene(seed);
        let alone = scene.clone().with_volumes(Vec::new());
        let iterations = render(&context, &alone, &hybrid(), 1).stats.iterations;
        assert!(iterations >= 3, "seed {seed}: {iterations}");
        for count in [1, 16, 200] {
            let sliced = render(&context, &scene, &hybrid(), count).stats;
            assert_eq!(sliced.iterations, iterations, "seed {seed}, {count} slices");
            assert!(sliced.fragments > render(&context, &alone, &hybrid(), 1).stats.fragments);
        }
    }
}

/// The scene of Carr et al.'s figure 1 with a volume instead of its generated slices: the cone's two layers, and one that
/// finds nothing.
#[test]
pub(crate) fn c03_figure_1_with_a_volume_takes_3_iterations_instead_of_259() {
    let context = Context::headless().unwrap();
    let mut scene = Scene::load_at("examples/scenes/slices.toml", Some([40, 30])).unwrap();
    scene.meshes.remove(0);
    scene.volumes = fog_and_pane(5.0, 0.0, 0.4, 0.5).volumes;
    let stats = render(&context, &scene, &hybrid(), 256).stats;
    assert_eq!(stats.iterations, 3);
    let layers = Method::LayerPeeling(Default::default());
    let stats = render(&context, &scene, &layers, 256).stats;
    assert_eq!(stats.iterations, 259);
}

/// A mesh whose triangles are sorted among themselves crosses the slices: it is peeled as if it were not.
#[test]
fn sorted_meshes_that_cross_the_slices_come_out_right() {
    let context = Context::headless().unwrap();
    let mut scene = random_scene(4);
    scene.meshes = Scene::load("examples/scenes/slices.toml").unwrap().meshes;
    assert!(scene.meshes[0].sorted);
    let [hybrid, layers] = [hybrid(), Method::LayerPeeling(Default::default())]
        .map(|method| render(&context, &scene, &method, 16).image);
    // As many layers as there are slices of both: see BOUND.
    let error = Comparison::new(&hybrid, &layers, BOUND).unwrap();
    assert_eq!(error.over, 0, "{error:?}");
}

/// Layer peeling takes an iteration for each of them.
#[test]
pub(crate) fn c04_layer_peeling_takes_an_iteration_a_slice() {
    let context = Context::headless().unwrap();
    let layers = Method::LayerPeeling(Default::default());
    let scene = fog_and_pane(5.0, 0.3, 0.4, 0.5);
    for count in [4, 16, 64] {
        // The pane, and one that finds nothing.
        let stats = render(&context, &scene, &layers, count).stats;
        assert_eq!(stats.iterations, count + 2);
        let stats = render(&context, &scene, &hybrid(), count).stats;
        assert_eq!(stats.iterations, 2);
    }
}

/// Every method that draws surfaces in the right order draws slices in it, too. The painter's algorithm, which orders
/// triangles by their middles, is right where no surface crosses a slice.
#[test]
fn every_method_that_takes_slices_gives_one_image() {
    let context = Context::headless().unwrap();
    // 32-bit colours, up to 70 layers: as in BOUND, half of a last place each.
    const SAME: f64 = 1e-5;
    for seed in [1, 3] {
        let scene = random_scene(seed);
        let image = render(&context, &scene, &hybrid(), 40).image;
        let pane = fog_and_pane(5.0, 0.3, 0.4, 0.5);
        let image_of_pane = render(&context, &pane, &hybrid(), 40).image;
        for entry in registry()
            .iter()
            .filter(|entry| entry.volumes.take_slices())
        {
            if !entry.runs_on(context.driver()) {
                println!("skipped: {}", entry.name);
                continue;
            }
            let (scene, image) = match entry.method {
                Method::Painter => (&pane, &image_of_pane),
                _ => (&scene, &image),
            };
            let frame = render(&context, scene, &entry.method, 40);
            let error = Comparison::new(&frame.image, image, SAME).unwrap();
            assert_eq!(error.over, 0, "{}, seed {seed}: {error:?}", entry.name);
        }
    }
}

fn fused(context: &Context, scene: &Scene) -> Frame {
    let options = ABufferOptions {
        color: RecordColor::Float,
        pp_dp: true,
        ..ABufferOptions::default()
    };
    render(context, scene, &Method::ABuffer(options), 1)
}

/// Midpoints: where every ray passes whole slabs, twice as many take the error to a quarter.
#[test]
pub(crate) fn l16_slices_of_a_gradient_converge_with_the_square_of_their_number() {
    let context = Context::headless().unwrap();
    let mut scene = gradient();
    scene.volumes[0].step = 1.0 / 512.0;
    let limit = fused(&context, &scene).image;
    let errors = [4, 8, 16].map(|count| {
        let image = render(&context, &scene, &hybrid(), count).image;
        Comparison::new(&image, &limit, 0.0).unwrap().max
    });
    for pair in errors.windows(2) {
        let ratio = pair[0] / pair[1];
        assert!((3.5..4.5).contains(&ratio), "{errors:?}");
    }
}

/// Where rays enter and leave boxes in the middle of a slab, and surfaces stand in it, half a slab at the most is on the
/// wrong side: the error of the image falls with the number itself.
#[test]
pub(crate) fn l16_slices_converge_to_the_fused_image_of_random_scenes() {
    let context = Context::headless().unwrap();
    let mut scenes: Vec<Scene> = (0..8).map(random_scene).collect();
    for volume in scenes.iter_mut().flat_map(|scene| &mut scene.volumes) {
        volume.step = 0.02;
    }
    let limits: Vec<_> = scenes.iter().map(|scene| fused(&context, scene)).collect();
    let errors = [16, 32, 64, 128, 256].map(|count| {
        let squares = scenes.iter().zip(&limits).map(|(scene, limit)| {
            let frame = render(&context, scene, &hybrid(), count);
            Comparison::new(&frame.image, &limit.image, 0.0)
                .unwrap()
                .rms
                .powi(2)
        });
        (squares.sum::<f64>() / scenes.len() as f64).sqrt()
    });
    println!("{errors:?}");
    let order = (errors[0] / errors[4]).log2() / 4.0;
    assert!((0.85..1.15).contains(&order), "order {order}: {errors:?}");
    assert!(errors.is_sorted_by(|a, b| a > b), "{errors:?}");
}

#[test]
fn what_draws_no_slices_says_so() {
    let context = Context::headless().unwrap();
    let scene = random_scene(1);
    for count in [0, MOST_SLICES + 1] {
        let renderer = Renderer::new(&context, 48, 36).unwrap();
        let refused = renderer.with_slices(count).unwrap_err().to_string();
        assert!(
            refused.contains(&count.to_string()) && refused.contains("1 to 65536"),
            "{refused}"
        );
    }
    let mut renderer = Renderer::new(&context, 48, 36).unwrap();
    for entry in registry() {
        match renderer.render(&scene, &entry.method) {
            Ok(frame) => {
                let slices = (entry.name == "hybrid-layer-peeling").then_some(DEFAULT_SLICES);
                assert_eq!(frame.stats.slices, slices, "{}", entry.name);
            }
            Err(Error::Option { remedy, .. }) => {
                assert!(remedy.contains("hybrid-layer-peeling"), "{remedy}");
                assert_eq!(
                    remedy.contains("as N slices"),
                    entry.volumes.take_slices(),
                    "{remedy}"
                );
            }
            Err(other) => panic!("{}: {other}", entry.name),
        }
    }
    let mut renderer = renderer.with_slices(4).unwrap();
    assert!(renderer.render(&scene, &Method::Blend).is_err());
    let mut many = scene.clone();
    many.volumes = vec![scene.volumes[0].clone(); 33];
    let refused = renderer.render(&many, &hybrid()).unwrap_err().to_string();
    assert!(refused.contains("33 volumes"), "{refused}");
}

/// The number of its slices, and where a ray samples a volume otherwise, are no business of each other.
#[test]
fn a_renderer_goes_on_from_slices_to_surfaces_and_rays() {
    let context = Context::headless().unwrap();
    let scene = random_scene(1);
    let alone = scene.clone().with_volumes(Vec::new());
    let expected = [
        render(&context, &scene, &hybrid(), 9),
        render(&context, &alone, &hybrid(), 9),
        fused(&context, &scene),
    ];
    let mut renderer = Renderer::new(&context, 48, 36)
        .unwrap()
        .with_slices(9)
        .unwrap();
    let a_buffer = ABufferOptions {
        color: RecordColor::Float,
        pp_dp: true,
        ..ABufferOptions::default()
    };
    for _ in 0..2 {
        let again = [
            renderer.render(&scene, &hybrid()).unwrap(),
            renderer.render(&alone, &hybrid()).unwrap(),
            renderer.render(&scene, &Method::ABuffer(a_buffer)).unwrap(),
        ];
        for (frame, expected) in again.iter().zip(&expected) {
            assert_eq!(frame.image.pixels, expected.image.pixels);
            assert_eq!(frame.stats.bytes, expected.stats.bytes, "{}", frame.stats);
        }
    }
    let mut other_step = scene.clone();
    other_step.volumes[0].step *= 3.0;
    let image = render(&context, &other_step, &hybrid(), 9).image;
    assert_eq!(image.pixels, expected[0].image.pixels);
}

/// The planes' part of the eye's own volume begins at the near plane; one behind the eye has none.
#[test]
fn volumes_around_and_behind_the_eye_are_sliced_from_the_near_plane_on() {
    let context = Context::headless().unwrap();
    let mut scene = fog_and_pane(0.75, -0.1, 0.4, 0.3);
    let sigma = f64::from(0.7_f32);
    let image = render(&context, &scene, &hybrid(), 5).image;
    scene.meshes[0]
        .vertices
        .iter_mut()
        .for_each(|v| v.position.z = 0.0);
    // 5 slabs of 0.25 from 0.25 down: the pane is moved from -0.1 to the border at 0.
    let off_border = off(&scene, &image, sigma);
    assert!(off_border < BOUND, "{off_border}");
    scene.camera.eye.z = -2.0;
    let frame = render(&context, &scene, &hybrid(), 5);
    let none = frame
        .image
        .pixels
        .iter()
        .all(|p| p.to_array() == [0.0, 1.0, 0.0, 1.0]);
    assert!(none && frame.stats.fragments == 0, "{}", frame.stats);
}

#[test]
fn empty_samples_and_the_cells_around_them_are_not_sliced() {
    let context = Context::headless().unwrap();
    let scene = fog_with_a_gap(0.5);
    let frame = render(&context, &scene, &hybrid(), 200);
    let sigma = f64::from(0.7_f32);
    let off_half = off(&scene, &frame.image, sigma / 2.0);
    // Two half slabs of 2/200, seen at 8 degrees at the most.
    assert!(off_half < sigma * 1.01 * 0.01, "{off_half}");
    assert!(
        off(&scene, &frame.image, sigma) > 0.2,
        "a gap would go unnoticed"
    );
}
