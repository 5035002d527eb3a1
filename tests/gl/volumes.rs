//! Volumes and surfaces in one image, by `exact` on the driver's own fragments.

use crate::kit::bounds::distance;
use onionskin::{Context, Error, Image, Mesh, Method, Renderer, Rgba, Scene, Transfer, registry};

use crate::kit::cast::cast;
use crate::kit::fog::cast_fog;
use crate::kit::fog_scenes::{fog_and_pane, fog_with_a_gap, fogs_and_panes, off, random_scene};

/// Where a surface ends a volume, times densities of up to 4 between colours that differ by up to 1.
const BOUND: f64 = 4.0 * distance(0.5);

fn exact(context: &Context, scene: &Scene) -> Image {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, &Method::Exact).unwrap().image
}

#[test]
fn l16_fog_and_a_pane_follow_the_closed_form() {
    let context = Context::headless().unwrap();
    for (what, scene) in fogs_and_panes() {
        let off = off(&scene, &exact(&context, &scene), f64::from(0.7_f32));
        assert!(off < BOUND, "{what}: {off}");
    }
}

#[test]
fn fog_a_thousandth_denser_or_a_pane_elsewhere_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = fog_and_pane(5.0, 0.3, 0.4, 0.5);
    let image = exact(&context, &scene);
    assert!(off(&scene, &image, 0.7007) > BOUND);
    assert!(off(&fog_and_pane(5.0, 0.303, 0.4, 0.5), &image, 0.7) > BOUND);
}

#[test]
fn l16_every_pane_cuts_the_fog_and_the_image_stays_the_same() {
    let context = Context::headless().unwrap();
    let mut scene = fog_and_pane(5.0, 0.3, 0.4, 0.5);
    let whole = exact(&context, &scene);
    let mut invisible = scene.meshes[0]
        .clone()
        .painted(Rgba::new(1.0, 1.0, 1.0, 0.0));
    invisible.opaque = false;
    for count in [1, 5, 20] {
        let cuts = (0..count).map(|i| {
            let mut mesh: Mesh = invisible.clone();
            let z = 1.1 - 2.2 * f64::from(i) / f64::from(count);
            mesh.vertices
                .iter_mut()
                .for_each(|vertex| vertex.position.z = z);
            mesh
        });
        scene.meshes.truncate(1);
        scene.meshes.extend(cuts);
        let cut = exact(&context, &scene);
        for (a, b) in whole.pixels.iter().zip(&cut.pixels) {
            // One rounding to f32.
            let same = a
                .to_array()
                .into_iter()
                .zip(b.to_array())
                .all(|(a, b)| (a - b).abs() < 1e-6);
            assert!(same, "{count} cuts: {a:?} {b:?}");
        }
    }
}

/// How many pixels are compared, and the largest difference of one.
fn compare(image: &Image, scene: &Scene) -> (usize, f64) {
    let hits = cast(scene);
    let expected = cast_fog(scene, &hits);
    let (mut compared, mut worst) = (0, 0.0_f64);
    for (pixel, [r, g, b]) in expected.into_iter().enumerate() {
        if hits.doubtful[pixel] {
            continue;
        }
        compared += 1;
        let found = image.pixels[pixel];
        let pairs = [(found.r, r), (found.g, g), (found.b, b)];
        for (found, expected) in pairs {
            worst = worst.max((f64::from(found) - expected).abs());
        }
    }
    (compared, worst)
}

#[test]
pub(crate) fn l16_a_second_caster_agrees_on_random_scenes() {
    let context = Context::headless().unwrap();
    for seed in 0..12 {
        let scene = random_scene(seed);
        let (compared, worst) = compare(&exact(&context, &scene), &scene);
        assert!(compared > 48 * 36 * 3 / 4, "seed {seed}: {compared}");
        assert!(worst < BOUND, "seed {seed}: {worst}");
    }
}

#[test]
fn a_volume_less_a_denser_one_or_another_step_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = random_scene(3);
    let image = exact(&context, &scene);
    let changed = |change: fn(&mut Scene)| {
        let mut other = scene.clone();
        change(&mut other);
        compare(&image, &other).1
    };
    assert!(changed(|_| ()) < BOUND);
    for change in [
        |scene: &mut Scene| _ = scene.volumes.pop(),
        // A ray takes the smallest step of its volumes.
        |scene: &mut Scene| scene.volumes.iter_mut().for_each(|it| it.step *= 2.0),
        |scene: &mut Scene| scene.meshes[0].triangles.truncate(20),
        |scene: &mut Scene| {
            for volume in &mut scene.volumes {
                let mut points = volume.transfer.points().to_vec();
                points.iter_mut().for_each(|point| point.density *= 1.02);
                volume.transfer = Transfer::new(points).unwrap();
            }
        },
    ] {
        let worst = changed(change);
        assert!(worst > 2.0 * BOUND, "{worst}");
    }
}

#[test]
fn l16_the_order_of_triangles_and_volumes_does_not_matter() {
    let context = Context::headless().unwrap();
    let mut scene = random_scene(3);
    let image = exact(&context, &scene);
    scene.volumes.reverse();
    scene.meshes[0] = scene.meshes[0].shuffled(7);
    let other = exact(&context, &scene);
    for (a, b) in image.pixels.iter().zip(&other.pixels) {
        let pairs = a.to_array().into_iter().zip(b.to_array());
        assert!(
            pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-6),
            "{a:?} {b:?}"
        );
    }
}

#[test]
fn every_other_method_refuses_volumes_and_names_exact() {
    let context = Context::headless().unwrap();
    let scene = random_scene(1);
    let mut renderer = Renderer::new(&context, 48, 36).unwrap();
    for entry in registry() {
        let result = renderer.render(&scene, &entry.method);
        if entry.volumes.are_rendered() {
            result.unwrap();
            continue;
        }
        match result {
            Err(Error::Option { what, remedy, .. }) => {
                assert!(
                    what.contains(entry.name) && what.contains("volumes (2)"),
                    "{what}"
                );
                assert!(remedy.contains("exact"), "{remedy}");
            }
            other => panic!("{}: {other:?}", entry.name),
        }
        let mut without = scene.clone();
        without.volumes.clear();
        if entry.needs.is_empty() {
            renderer.render(&without, &entry.method).unwrap();
        }
    }
}

#[test]
fn the_bundled_scene_shows_its_fog_its_vortex_and_its_ring() {
    let context = Context::headless().unwrap();
    let path = "examples/scenes/fog.toml";
    let mut scene = Scene::load_at(path, Some([160, 120])).unwrap();
    let whole = exact(&context, &scene);
    let changed = |scene: &Scene| {
        let image = exact(&context, scene);
        let pairs = whole.pixels.iter().zip(&image.pixels);
        pairs.filter(|(a, b)| a != b).count()
    };
    let mut without = scene.clone();
    without.volumes.remove(0);
    assert!(changed(&without) > 2000);
    let mut without = scene.clone();
    without.volumes.remove(1);
    assert!(changed(&without) > 1000);
    scene.meshes.clear();
    assert!(changed(&scene) > 1000);
}

#[test]
fn empty_samples_and_the_cells_around_them_are_not_seen() {
    let context = Context::headless().unwrap();
    let scene = fog_with_a_gap(0.02);
    let image = exact(&context, &scene);
    let sigma = f64::from(0.7_f32);
    let off_half = off(&scene, &image, sigma / 2.0);
    // Two half steps, seen at 8 degrees at the most.
    assert!(off_half < sigma * 1.01 * 0.01, "{off_half}");
    assert!(off(&scene, &image, sigma) > 0.2, "a gap would go unnoticed");
}
