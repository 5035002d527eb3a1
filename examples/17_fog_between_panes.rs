//! How much light comes through a ball of fog between two panes of glass (Lindholm et al. 2015, section 6)?
//!
//! Each pixel's list holds the fragments of the panes and of the box around the fog. The ray is cast between them. The
//! right colour of every pixel has a closed form. The fog's density falls from σ in the ball's middle to 0 at its
//! radius R as σ (1 - r²/R²). So a ray with half a chord of h inside has the optical depth 4σh³ / 3R², and lets
//! exp(-4σh³ / 3R²) of the light through. A pane lets 1 - α of it through.
//!
//! Writes the picture, and shows how far it is from the closed form. The finer the lattice of samples, the smaller the
//! difference.
//!
//! `cargo run --example 17_fog_between_panes [FOLDER]`

use glam::{DAffine3, DVec3};
use onionskin::generate::{Quads, quads};
use onionskin::low_level::oracle::volumes::Ray;
use onionskin::options::{ABufferOptions, RecordColor};
use onionskin::report::{Measure, Panels};
use onionskin::{
    Camera, Context, Image, Mesh, Method, Renderer, Rgba, Scene, Transfer, TransferPoint,
    Transform, Volume,
};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [480, 360];
const RADIUS: f64 = 1.0;
const SIGMA: f32 = 2.5;
const FOG: [f32; 3] = [0.95, 0.45, 0.1];
const BACKGROUND: [f32; 3] = [0.97, 0.97, 0.94];
/// Width and height of a pane, and the part of the light that it takes.
const PANE: f64 = 1.7;
const ALPHA: f32 = 0.4;
/// Each pane's middle and colour, the nearer pane first.
const PANES: [(DVec3, [f32; 3]); 2] = [
    (DVec3::new(-0.72, 0.35, 1.2), [0.1, 0.35, 0.85]),
    (DVec3::new(0.72, -0.35, -1.2), [0.05, 0.55, 0.35]),
];

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let method = Method::ABuffer(ABufferOptions {
        color: RecordColor::Float,
        ..ABufferOptions::default()
    });
    println!("samples a side  largest difference from the closed form");
    for samples in [9, 17, 33, 65, 129] {
        let scene = scene(samples)?;
        let frame = renderer.render(&scene, &method)?;
        let differences = differences(&scene, &frame.image);
        let largest = differences.iter().copied().fold(0.0, f64::max);
        println!("{samples:>14}  {largest:.1e}");
        if samples == 129 {
            let path = example::output("17_fog_between_panes.png")?;
            Panels::new("A ball of fog between two panes (Lindholm et al. 2015, section 6)")
                .picture(&frame.image, "fog of 129 samples a side")
                .measure(
                    Measure::new(SIZE[0], SIZE[1], differences),
                    "difference from the closed form: largest channel",
                )
                .save(&path)?;
            println!("{}", path.display());
        }
    }
    Ok(())
}

fn scene(samples: usize) -> onionskin::Result<Scene> {
    let panes: onionskin::Result<Vec<Mesh>> = PANES.iter().map(pane).collect();
    let mut scene =
        Scene::of("fog between panes", panes?).with_volumes(vec![ball_of_fog(samples)?]);
    scene.size = SIZE;
    scene.background = BACKGROUND;
    scene.camera = Camera {
        eye: DVec3::new(0.0, 0.0, 6.5),
        target: DVec3::ZERO,
        up: DVec3::Y,
        fov: 26.0,
        near: 1.0,
        far: 20.0,
    };
    Ok(scene)
}

fn pane(&(middle, color): &(DVec3, [f32; 3])) -> onionskin::Result<Mesh> {
    let pane = quads(&Quads {
        count: 1,
        size: [PANE as f32; 2],
        depths: vec![0.0],
        colors: vec![color],
        alpha: ALPHA,
        ..Quads::default()
    })?;
    Ok(pane.transformed(&Transform {
        translate: middle,
        ..Transform::default()
    }))
}

/// 1 - r²/R², sampled on a cube around the ball. Outside of the ball the value is negative, and has no density.
fn ball_of_fog(samples: usize) -> onionskin::Result<Volume> {
    let last = (samples - 1) as f64;
    let place = |i: usize| (2.0 * i as f64 / last - 1.0) * 1.05 * RADIUS;
    let value = |number: usize| {
        let [x, y, z] = [1, samples, samples * samples].map(|by| place(number / by % samples));
        (1.0 - (x * x + y * y + z * z) / (RADIUS * RADIUS)) as f32
    };
    let mut placement = DAffine3::from_scale(DVec3::splat(2.0 * 1.05 * RADIUS / last));
    placement.translation = DVec3::splat(place(0));
    let all = (0..samples.pow(3)).map(value).collect();
    let volume = Volume::new("ball of fog", [samples; 3], all, placement)?;
    let point = |value: f32| TransferPoint {
        value,
        color: FOG,
        density: value * SIGMA,
    };
    Ok(volume.with_transfer(Transfer::new(vec![point(0.0), point(1.0)])?))
}

/// The closed form: pane, fog, pane, background, front to back in f64.
fn closed_form(scene: &Scene, pixel: [u32; 2]) -> [f64; 3] {
    let ray = Ray::through(&scene.camera, SIZE, pixel);
    let along = ray.direction.normalize();
    let aside = ray.origin - along * along.dot(ray.origin);
    let half_chord = (RADIUS * RADIUS - aside.length_squared()).max(0.0).sqrt();
    let depth = 4.0 * f64::from(SIGMA) * half_chord.powi(3) / (3.0 * RADIUS * RADIUS);
    let [near, far] = PANES.map(|(middle, color)| {
        let to_plane = (middle.z - ray.origin.z) / ray.direction.z;
        let off = ray.origin + ray.direction * to_plane - middle;
        let hit = off.x.abs().max(off.y.abs()) < PANE / 2.0;
        (if hit { f64::from(ALPHA) } else { 0.0 }, color)
    });
    let layers = [near, (1.0 - (-depth).exp(), FOG), far, (1.0, BACKGROUND)];
    let mut light = [0.0; 3];
    let mut visible = 1.0;
    for (alpha, color) in layers {
        for (light, color) in light.iter_mut().zip(color) {
            *light += visible * alpha * f64::from(color);
        }
        visible *= 1.0 - alpha;
    }
    light
}

/// The largest difference of any channel, for each pixel.
fn differences(scene: &Scene, image: &Image) -> Vec<f64> {
    let [width, height] = SIZE;
    let of_pixel = |(number, found): (u32, &Rgba)| {
        let expected = closed_form(scene, [number % width, height - 1 - number / width]);
        let channels = found.to_array().into_iter().zip(expected);
        let off = channels.map(|(found, expected)| (f64::from(found) - expected).abs());
        off.fold(0.0, f64::max)
    };
    (0..width * height)
        .zip(&image.pixels)
        .map(of_pixel)
        .collect()
}
