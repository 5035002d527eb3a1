//! Scenes of fog: a cube and a pane with their closed form, and random ones.

use glam::{DAffine3, DQuat, DVec3};
use onionskin::generate::{Constant, Lattice, Quads, Soup, constant, quads, soup};
use onionskin::{Camera, Image, Scene, Transfer, TransferPoint, Volume};

use super::chance::Chance;

pub fn painted(color: [f32; 3]) -> Transfer {
    let point = |value| TransferPoint {
        value,
        color,
        density: value,
    };
    Transfer::new(vec![point(0.0), point(1000.0)]).unwrap()
}

/// A cube of red fog from -1 to 1, and a blue pane across the view.
pub fn fog_and_pane(eye: f64, pane: f32, alpha: f32, step: f64) -> Scene {
    let mut fog = constant(&Constant {
        lattice: Lattice {
            size: 2.0,
            samples: 3,
        },
        value: 0.7,
    })
    .unwrap()
    .with_transfer(painted([1.0, 0.0, 0.0]));
    fog.step = step;
    let pane = quads(&Quads {
        count: 1,
        size: [20.0; 2],
        depths: vec![0.0],
        colors: vec![[0.0, 0.0, 1.0]],
        alpha,
        ..Quads::default()
    })
    .unwrap()
    .transformed(&onionskin::Transform {
        translate: DVec3::Z * f64::from(pane),
        ..Default::default()
    });
    let mut scene = Scene::of("fog and pane", vec![pane]).with_volumes(vec![fog]);
    scene.size = [16, 12];
    scene.background = [0.0, 1.0, 0.0];
    scene.camera = Camera {
        eye: DVec3::Z * eye,
        target: DVec3::NEG_Z * 9.0,
        up: DVec3::Y,
        fov: 12.0,
        near: 0.5,
        far: 20.0,
    };
    scene
}

/// Fog and a pane seen from outside of it and from inside, the pane in front, inside (seen from both eyes), behind and at a
/// face, clear and opaque, with short steps and ones longer than the cube; and what each is.
pub fn fogs_and_panes() -> Vec<(String, Scene)> {
    let mut scenes = Vec::new();
    for eye in [5.0, 0.75] {
        for pane in [2.0, 0.3, -0.4, -2.0, -1.0] {
            if f64::from(pane) > eye - 0.5 {
                continue;
            }
            for alpha in [0.4, 1.0] {
                for step in [0.05, 0.3, 0.5, 7.0] {
                    let what = format!("eye {eye} pane {pane} alpha {alpha} step {step}");
                    scenes.push((what, fog_and_pane(eye, pane, alpha, step)));
                }
            }
        }
    }
    scenes
}

/// The cube of fog with nothing in its middle half: of its five layers of samples the third is empty, and with it the cells
/// on both sides. What is left is as clear as fog half as dense through and through, up to the steps (of `step` voxels, half
/// a unit each) at the gap's two borders, which belong to the side that their middles are on: half a step each.
pub fn fog_with_a_gap(step: f64) -> Scene {
    let mut scene = fog_and_pane(5.0, 2.0, 0.0, step);
    let layers = (0..125).map(|i| if i / 25 == 2 { f32::NAN } else { 0.7 });
    let mut place = DAffine3::from_scale(DVec3::splat(0.5));
    place.translation = DVec3::splat(-1.0);
    let mut fog = Volume::new("gap", [5; 3], layers.collect(), place).unwrap();
    fog.step = step;
    scene.volumes = vec![fog.with_transfer(painted([1.0, 0.0, 0.0]))];
    scene
}

/// A cube in which density and colour change along z, from 0 and blue to 3 and red.
pub fn gradient() -> Scene {
    let mut scene = fog_and_pane(5.0, 2.0, 0.0, 1.0);
    let samples = (0..8).map(|i| (i / 4) as f32).collect();
    let mut place = DAffine3::from_scale(DVec3::splat(2.0));
    place.translation = DVec3::splat(-1.0);
    let point = |value, color| TransferPoint {
        value,
        color,
        density: 3.0 * value,
    };
    let points = vec![point(0.0, [0.0, 0.0, 1.0]), point(1.0, [1.0, 0.0, 0.0])];
    let volume = Volume::new("gradient", [2; 3], samples, place).unwrap();
    scene.volumes = vec![volume.with_transfer(Transfer::new(points).unwrap())];
    scene
}

/// The largest difference of an image from exp(-sigma L), with the fog `sigma` dense.
pub fn off(scene: &Scene, image: &Image, sigma: f64) -> f64 {
    let [width, height] = scene.size.map(f64::from);
    let pane = scene.meshes[0].vertices[0].position.z;
    let alpha = f64::from(scene.meshes[0].vertices[0].color.a);
    let eye = scene.camera.eye.z;
    let pixel = 2.0 * 6.0_f64.to_radians().tan() / height;
    let mut worst = 0.0_f64;
    for (number, found) in image.pixels.iter().enumerate() {
        let x = ((number as f64 % width).floor() + 0.5 - width / 2.0) * pixel;
        let y = ((number as f64 / width).floor() + 0.5 - height / 2.0) * pixel;
        let slant = (1.0 + x * x + y * y).sqrt();
        // Fog between two heights, seen from the near plane on.
        let clear = |from: f64, to: f64| {
            let from = from.min(1.0).min(eye - 0.5);
            (-sigma * slant * (from - to.max(-1.0)).max(0.0)).exp()
        };
        let [before, behind] = [clear(9.0, pane), clear(pane, -9.0)];
        let green = before * (1.0 - alpha) * behind;
        let blue = before * alpha;
        let red = 1.0 - before + before * (1.0 - alpha) * (1.0 - behind);
        let pairs = [(found.r, red), (found.g, green), (found.b, blue)];
        for (found, expected) in pairs {
            worst = worst.max((f64::from(found) - expected).abs());
        }
    }
    worst
}

/// Random samples in a box anywhere, turned and sheared; or one that the eye is in.
pub fn random_volume(chance: &mut Chance, around_the_eye: bool) -> Volume {
    let dims = [(); 3].map(|()| 2 + (chance.unit() * 4.0) as usize);
    let samples = (0..dims.iter().product())
        .map(|_| chance.unit() as f32)
        .collect();
    let half = if around_the_eye {
        6.0
    } else {
        chance.between(0.4, 1.2)
    };
    let cells = DVec3::from_array(dims.map(|count| (count - 1) as f64));
    let turn = DQuat::from_axis_angle(chance.vector(1.0).normalize(), chance.between(0.0, 6.0));
    let middle = if around_the_eye {
        DVec3::ZERO
    } else {
        chance.vector(1.0)
    };
    let mut unit = DAffine3::from_scale(2.0 * half / cells);
    unit.translation = DVec3::splat(-half);
    let mut shear = DAffine3::IDENTITY;
    shear.matrix3.y_axis.x = chance.between(-0.3, 0.3);
    let placement = DAffine3::from_rotation_translation(turn, middle) * shear * unit;
    let dense = if around_the_eye { 0.2 } else { 2.0 };
    let mut value = 0.0;
    let points = [(); 4].map(|()| {
        value += chance.between(0.0, 0.4) as f32;
        TransferPoint {
            value,
            color: chance.color(),
            density: chance.between(0.0, dense) as f32,
        }
    });
    let mut volume = Volume::new("random", dims, samples, placement).unwrap();
    volume.step = chance.between(0.1, 0.9);
    volume.with_transfer(Transfer::new(points.into()).unwrap())
}

/// Up to 30 triangles, every second scene with opaque ones, and 1 to 4 volumes, every third scene with the eye inside.
pub fn random_scene(seed: u64) -> Scene {
    let mut chance = Chance::new(seed);
    let triangles = |count, alpha, seed| {
        soup(&Soup {
            count,
            alpha,
            seed,
            triangle_size: [0.5, 1.5],
            ..Soup::default()
        })
        .unwrap()
    };
    let mut meshes = vec![triangles(24, [0.1, 0.9], seed)];
    if seed % 2 == 1 {
        meshes.push(triangles(6, [1.0, 1.0], seed + 100));
    }
    let volumes =
        (0..1 + seed % 4).map(|i| random_volume(&mut chance, i == 0 && seed.is_multiple_of(3)));
    let volumes = volumes.collect();
    let mut scene = Scene::of("random", meshes).with_volumes(volumes);
    seen_closely(&mut scene);
    scene
}

/// So near that the near plane cuts volumes, and large ones have the eye in them.
pub fn seen_closely(scene: &mut Scene) {
    scene.size = [48, 36];
    scene.background = [0.9, 0.8, 0.7];
    scene.camera = Camera {
        eye: DVec3::new(0.5, 0.7, 3.2),
        target: DVec3::ZERO,
        up: DVec3::Y,
        fov: 40.0,
        near: 1.0,
        far: 8.0,
    };
}
