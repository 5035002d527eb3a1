//! A second caster of volumes, in f64: boxes as twelve triangles, interpolation as a sum over eight corners, segments
//! composited back to front. It shares no code with the oracle, the volumes or the camera.

use glam::{DMat3, DVec3};
use onionskin::{Scene, Transfer, Volume};

use super::cast::{Cast, Hit};

/// What the rays through all pixels' centres see, row by row from the top. `hits` are the scene's surfaces.
pub fn cast_fog(scene: &Scene, hits: &Cast) -> Vec<[f64; 3]> {
    let [width, _] = scene.size;
    let pixels = hits.pixels.iter().enumerate();
    pixels
        .map(|(pixel, hits)| see(scene, [pixel as u32 % width, pixel as u32 / width], hits))
        .collect()
}

/// How an image is made of the light of one pixel's ray.
fn see(scene: &Scene, pixel: [u32; 2], hits: &[Hit]) -> [f64; 3] {
    let ray = ray(scene, pixel);
    let camera = &scene.camera;
    // Lengths along the ray, as all in here.
    let slant = ray.length();
    let length_of = |depth: f64| {
        let (near, far) = (camera.near, camera.far);
        slant * near / (1.0 - depth * (far - near) / far)
    };
    let mut hits: Vec<Hit> = hits.to_vec();
    hits.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order)));
    let end = hits.iter().position(|hit| hit.color[3] == 1.0);
    let background = scene.background.map(f64::from);
    let (mut light, last) = match end {
        None => (DVec3::from_array(background), camera.far * slant),
        Some(place) => {
            let [r, g, b, _] = hits[place].color;
            (DVec3::new(r, g, b), length_of(hits[place].depth))
        }
    };
    hits.truncate(end.unwrap_or(hits.len()));
    let crossed: Vec<_> = scene
        .volumes
        .iter()
        .map(|volume| (volume, faces_met(volume, camera.eye, ray / slant)))
        .collect();
    let first = camera.near * slant;
    let mut cuts = vec![first, last];
    cuts.extend(hits.iter().map(|hit| length_of(hit.depth)));
    cuts.extend(
        crossed
            .iter()
            .flat_map(|(_, [enter, leave])| [*enter, *leave]),
    );
    cuts.retain(|cut| (first..=last).contains(cut));
    cuts.sort_by(f64::total_cmp);
    for pair in cuts.windows(2).rev() {
        let [from, to] = [pair[0], pair[1]];
        let here = |&&(_, [enter, leave]): &&(&Volume, [f64; 2])| {
            let middle = (from + to) / 2.0;
            enter < middle && middle < leave
        };
        let here: Vec<&Volume> = crossed
            .iter()
            .filter(here)
            .map(|(volume, _)| *volume)
            .collect();
        for hit in hits.iter().rev().filter(|hit| length_of(hit.depth) == to) {
            light = over(hit.color, light);
        }
        light = through(&here, camera.eye, ray / slant, [from, to], light);
    }
    light.to_array()
}

pub fn over([r, g, b, a]: [f64; 4], light: DVec3) -> DVec3 {
    DVec3::new(r, g, b) * a + light * (1.0 - a)
}

pub fn ray(scene: &Scene, [column, row]: [u32; 2]) -> DVec3 {
    let camera = &scene.camera;
    let forward = (camera.target - camera.eye).normalize();
    let right = forward.cross(camera.up).normalize();
    let [width, height] = scene.size.map(f64::from);
    let pixel = 2.0 * (camera.fov.to_radians() / 2.0).tan() / height;
    let aside = f64::from(column) + 0.5 - width / 2.0;
    let below = f64::from(row) + 0.5 - height / 2.0;
    forward + (right * aside - right.cross(forward) * below) * pixel
}

/// Nearest and farthest of the twelve triangles of the volume's box that the line meets; nothing is farther than it is
/// near where it meets none.
fn faces_met(volume: &Volume, eye: DVec3, direction: DVec3) -> [f64; 2] {
    const FACES: [[usize; 4]; 6] = [
        [0, 1, 3, 2],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 3, 7, 6],
        [0, 2, 6, 4],
        [1, 3, 7, 5],
    ];
    let corners = volume.corners();
    let triangles = FACES
        .iter()
        .flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
    let met = triangles.filter_map(|numbers| {
        let [a, b, c] = numbers.map(|number| corners[number]);
        let sides = DMat3::from_cols(b - a, c - a, -direction);
        let at = sides.inverse() * (eye - a);
        let inside = at.x >= 0.0 && at.y >= 0.0 && at.x + at.y <= 1.0;
        (inside && sides.determinant() != 0.0).then_some(at.z)
    });
    met.fold([f64::INFINITY, f64::NEG_INFINITY], |[near, far], at| {
        [near.min(at), far.max(at)]
    })
}

/// The light that comes out of a segment at its near end.
fn through(
    volumes: &[&Volume],
    eye: DVec3,
    direction: DVec3,
    [from, to]: [f64; 2],
    mut light: DVec3,
) -> DVec3 {
    let steps = volumes.iter().map(|volume| volume.step * narrowest(volume));
    let step = steps.fold(f64::INFINITY, f64::min);
    if volumes.is_empty() || to <= from {
        return light;
    }
    let mut places = vec![from];
    while places[places.len() - 1] + step < to {
        places.push(from + step * places.len() as f64);
    }
    places.push(to);
    for pair in places.windows(2).rev() {
        let point = eye + direction * (pair[0] + pair[1]) / 2.0;
        let media: Vec<_> = volumes
            .iter()
            .map(|volume| look(&volume.transfer, value(volume, point)))
            .collect();
        let density: f64 = media.iter().map(|(_, density)| density).sum();
        if density > 0.0 {
            let mixed: DVec3 = media.iter().map(|(color, density)| *color * *density).sum();
            let clear = (-density * (pair[1] - pair[0])).exp();
            light = mixed / density * (1.0 - clear) + light * clear;
        }
    }
    light
}

/// The shortest edge of a voxel, from the corners of the box.
fn narrowest(volume: &Volume) -> f64 {
    let corners = volume.corners();
    let edge =
        |axis: usize| corners[0].distance(corners[1 << axis]) / (volume.dims()[axis] - 1) as f64;
    edge(0).min(edge(1)).min(edge(2))
}

pub fn value(volume: &Volume, point: DVec3) -> f64 {
    let corners = volume.corners();
    let [x, y, z] = volume.dims();
    let edges = DMat3::from_cols(
        corners[1] - corners[0],
        corners[2] - corners[0],
        corners[4] - corners[0],
    );
    let cells = DVec3::new(x as f64 - 1.0, y as f64 - 1.0, z as f64 - 1.0);
    let at = edges.inverse() * (point - corners[0]) * cells;
    let mut sum = 0.0;
    for (number, sample) in volume.samples().iter().enumerate() {
        let place = [number % x, number / x % y, number / (x * y)];
        let weights = (0..3).map(|axis| (1.0 - (at[axis] - place[axis] as f64).abs()).max(0.0));
        sum += weights.product::<f64>() * f64::from(*sample);
    }
    sum
}

pub fn look(transfer: &Transfer, value: f64) -> (DVec3, f64) {
    let points = transfer.points();
    let numbers = |i: usize| {
        let point = &points[i];
        let [r, g, b] = point.color.map(f64::from);
        (DVec3::new(r, g, b), f64::from(point.density))
    };
    if value <= f64::from(points[0].value) {
        return numbers(0);
    }
    for (i, pair) in points.windows(2).enumerate() {
        let [low, high] = [pair[0].value, pair[1].value].map(f64::from);
        if value <= high {
            let part = (value - low) / (high - low);
            let ((from, thin), (to, thick)) = (numbers(i), numbers(i + 1));
            return (
                from * (1.0 - part) + to * part,
                thin * (1.0 - part) + thick * part,
            );
        }
    }
    numbers(points.len() - 1)
}
