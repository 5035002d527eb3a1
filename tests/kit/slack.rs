//! What an image of volumes on OpenGL may be off by because of where the rasteriser has the faces of their boxes.

use glam::DVec2;
use onionskin::low_level::oracle::{surfaces::Surfaces, volumes::Ray};
use onionskin::{Frame, Scene, Volume};

use super::sampled::{centres, places};

/// What a pixel may be off by for the rasteriser's sake; infinite where it may see another box, at outlines.
///
/// Where a box is entered and left is the depth of a face whose vertices stand on 1/256 of a pixel, up to half of that from
/// where they are. So a crossing, and with it the samples behind it, may move by a third of what it differs three times as
/// far aside; light gained or lost is no more than that length times the densities, where it is entered, where it is left,
/// and in the samples between. So it is where a surface lies elsewhere because of its triangle's shape, before it and behind.
pub fn slack(scene: &Scene) -> Vec<f64> {
    let [width, height] = scene.size;
    let met = |pixel: u32, [right, up]: [u32; 2]| -> Vec<[f64; 2]> {
        let [x, y] = [pixel % width, height - 1 - pixel / width];
        // 1.5/256 of a pixel from its middle.
        let fine = [256 * x + 126 + 3 * right, 256 * y + 126 + 3 * up];
        let ray = Ray::through(&scene.camera, [width * 256, height * 256], fine);
        let volumes = scene.volumes.iter();
        volumes.map(|volume| crossing(&ray, volume)).collect()
    };
    let moved = |a: &[[f64; 2]], b: &[[f64; 2]]| {
        let pairs = a.as_flattened().iter().zip(b.as_flattened());
        let moved = pairs.map(|(a, b)| if a == b { 0.0 } else { (a - b).abs() });
        moved.fold(0.0, f64::max)
    };
    let points = |volume: &Volume| {
        let points = volume.transfer.points().iter();
        points
            .map(|point| f64::from(point.density))
            .fold(0.0, f64::max)
    };
    let densities: f64 = scene.volumes.iter().map(points).sum();
    let of_surfaces = moved_surfaces(scene);
    (0..width * height)
        .map(|pixel| {
            let middle = met(pixel, [0, 0]);
            let aside = [[0, 1], [1, 0], [1, 1]].map(|to| moved(&met(pixel, to), &middle));
            let of_boxes = aside.into_iter().fold(0.0, f64::max);
            densities * (of_boxes + 2.0 * of_surfaces[pixel as usize])
        })
        .collect()
}

/// By how much the surfaces of each pixel may lie elsewhere for a rasteriser, all together.
fn moved_surfaces(scene: &Scene) -> Vec<f64> {
    let [width, height] = scene.size;
    let size = DVec2::new(f64::from(width), f64::from(height));
    let surfaces = Surfaces::of(scene, scene.size);
    let place = places(scene);
    let mut moved = vec![0.0; (width * height) as usize];
    let triangles = scene.meshes.iter().flat_map(|mesh| {
        let all = 0..mesh.triangle_count();
        all.map(|triangle| mesh.corners(triangle))
    });
    for (order, corners) in (0..).zip(triangles) {
        // What is cut by the plane of the eye has no outline.
        let [Some(a), Some(b), Some(c)] = corners.map(&place) else {
            continue;
        };
        for [x, y] in centres([a, b, c], size) {
            let at = surfaces.meeting([x, y], order);
            moved[((height - 1 - y) * width + x) as usize] += at.error / (at.inverse * at.inverse);
        }
    }
    moved
}

/// Where a ray is in the box of a volume; infinities where it is not.
pub fn crossing(ray: &Ray, volume: &Volume) -> [f64; 2] {
    let to_index = volume.world_to_index();
    let from = to_index.transform_point3(ray.origin);
    let along = to_index.transform_vector3(ray.direction);
    let (first, second) = (-from / along, (volume.last() - from) / along);
    let enter = first.min(second).max_element().max(ray.near);
    let leave = first.max(second).min_element().min(ray.far);
    if enter < leave {
        [enter, leave]
    } else {
        [f64::INFINITY; 2]
    }
}

/// How many pixels are compared with `exact`'s, and the largest difference, less what [`slack`] allows.
pub fn compare(frame: &Frame, exact: &Frame, scene: &Scene) -> (usize, f64) {
    let pixels = frame.image.pixels.iter().zip(&exact.image.pixels);
    let mut slack = slack(scene);
    // Where the order of two surfaces hangs on a rounding, either is right.
    if let Some(hanging) = &exact.hanging {
        let hangs = slack
            .iter_mut()
            .zip(&hanging.drawn)
            .filter(|(_, hangs)| **hangs);
        hangs.for_each(|(slack, _)| *slack = f64::INFINITY);
    }
    let (mut compared, mut worst) = (0, 0.0_f64);
    for ((a, b), slack) in pixels.zip(slack) {
        let channels = a.to_array().into_iter().zip(b.to_array());
        let off = channels.map(|(a, b)| f64::from((a - b).abs()));
        // A channel that is not a number is off by infinitely much, whatever the slack allows.
        let off = off.map(|off| if off.is_nan() { f64::INFINITY } else { off });
        let off = off.fold(0.0, f64::max);
        worst = worst.max(if off == f64::INFINITY {
            off
        } else {
            off - slack
        });
        compared += usize::from(slack < f64::INFINITY);
    }
    (compared, worst)
}
