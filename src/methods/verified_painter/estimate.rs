//! How much will be out of order, before anything is drawn: a thousand points of the image, at which the sorted triangles
//! are looked through on the CPU.
//!
//! It is an estimate, on which only time hangs. It does not see what opaque surfaces hide, and leaves out triangles that the
//! near plane cuts.

use glam::{DMat4, Vec2, Vec3};

use super::view_order::{Bounds, Sorted, Triangles, in_parts};
use crate::scene::Camera;

/// About so many points, whatever the image's size. On the scenes of the bench's sweep of disorder it was right to 1 %.
const POINTS: f32 = 1000.0;
/// Each row of points is shifted against the one below by this part of their distance, so that they have no common columns:
/// the golden ratio's, by which points crowd nowhere.
const SHIFT: f32 = 0.618_034;

/// A fragment at a point.
#[derive(Clone, Copy)]
struct Hit {
    point: u32,
    /// 1/w, which is larger the nearer the fragment is.
    nearness: f32,
}

/// Points in rows and columns.
struct Points {
    across: i32,
    up: i32,
}

impl Triangles {
    /// The part of the fragments that are in pixels whose order will not be proved, 0 to 1.
    pub(in crate::low_level::methods) fn part_in_disorder(
        &self,
        sorted: &Sorted,
        camera: &Camera,
        [width, height]: [u32; 2],
    ) -> f64 {
        let size = Vec2::new(width as f32, height as f32);
        let step = (size.x * size.y / POINTS).sqrt().max(1.0);
        let points = Points {
            across: (size.x / step) as i32,
            up: (size.y / step) as i32,
        };
        let to_clip =
            camera.projection(width, height) * camera.view() * DMat4::from_translation(self.origin);
        let to_clip = to_clip.as_mat4();
        let near = camera.near as f32;
        // In steps, so that a point of an even row has whole numbers; and 1/w.
        let place = |position: &Vec3| {
            let clip = to_clip * position.extend(1.0);
            let pixel = (clip.truncate().truncate() / clip.w + 1.0) * 0.5 * size;
            match clip.w >= near {
                true => (pixel / step - 0.5).extend(1.0 / clip.w),
                false => Vec3::NAN,
            }
        };
        let places = in_parts(&self.positions, |part| part.iter().map(place).collect());
        let numbers: Vec<usize> = (0..sorted.triangles.len()).collect();
        let hits = in_parts(&numbers, |part| {
            let mut hits = Vec::new();
            for &number in part {
                let triangle = sorted.triangles[number].map(|corner| corner as usize);
                let corners = triangle.map(|corner| places[corner]);
                points.look_at(corners, |point, weights, nearness| {
                    let is_kept = sorted.bounds.as_ref().is_none_or(|bounds| {
                        let position = weights[0] * self.positions[triangle[0]]
                            + weights[1] * self.positions[triangle[1]]
                            + weights[2] * self.positions[triangle[2]];
                        is_between(&bounds[0], &bounds[number + 1], position / nearness)
                    });
                    if is_kept {
                        hits.push(Hit { point, nearness });
                    }
                });
            }
            hits
        });
        points.part_in_disorder(&hits)
    }
}

/// The whole numbers from 0 on between two numbers, less than `count`. Calls of `ceil` and `floor` would take half of the time.
pub(super) fn whole_numbers(low: f32, high: f32, count: i32) -> std::ops::Range<i32> {
    let low = low.max(0.0).min(count as f32);
    let first = low as i32;
    let first = first + i32::from((first as f32) < low);
    let end = match high < 0.0 {
        true => 0,
        false => (high as i32).saturating_add(1),
    };
    first..end.min(count)
}

/// By how much a row of points is shifted.
fn shift(row: i32) -> f32 {
    let shift = row as f32 * SHIFT;
    shift - (shift as i32) as f32
}

/// Whether a piece keeps a fragment. The slabs' normal is in `head`, and where along it the drawn positions' origin lies, which
/// does not matter here.
fn is_between(head: &Bounds, bounds: &Bounds, position: Vec3) -> bool {
    let along = position.dot(Vec3::from_slice(head));
    bounds[0] <= along && along < bounds[1]
}

impl Points {
    /// Finds the points in a triangle: their numbers, the corners' weights times their 1/w, and the points' own 1/w.
    fn look_at(&self, corners: [Vec3; 3], mut found: impl FnMut(u32, [f32; 3], f32)) {
        let [a, b, c] = corners;
        let [p, q, r] = corners.map(Vec3::truncate);
        let area = (q - p).perp_dot(r - p);
        if area == 0.0 || area.is_nan() {
            return;
        }
        let (low, high) = (p.min(q).min(r), p.max(q).max(r));
        for row in whole_numbers(low.y, high.y, self.up) {
            let shift = shift(row);
            for column in whole_numbers(low.x - shift, high.x - shift, self.across) {
                let here = Vec2::new(column as f32 + shift, row as f32);
                let weights = [
                    (q - here).perp_dot(r - here) / area,
                    (r - here).perp_dot(p - here) / area,
                    (p - here).perp_dot(q - here) / area,
                ];
                // On an edge, a point would be in two triangles.
                if weights.iter().all(|weight| *weight > 0.0) {
                    let weights = [weights[0] * a.z, weights[1] * b.z, weights[2] * c.z];
                    found(
                        (row * self.across + column) as u32,
                        weights,
                        weights.iter().sum(),
                    );
                }
            }
        }
    }

    /// The hits come as they are drawn.
    fn part_in_disorder(&self, hits: &[Hit]) -> f64 {
        let mut nearest = vec![0.0; (self.across * self.up) as usize];
        let mut counts = vec![0u64; nearest.len()];
        let mut in_order = vec![true; nearest.len()];
        for hit in hits {
            let point = hit.point as usize;
            in_order[point] &= hit.nearness > nearest[point];
            nearest[point] = hit.nearness;
            counts[point] += 1;
        }
        let out_of_order = counts
            .iter()
            .zip(&in_order)
            .filter(|(_, in_order)| !**in_order);
        let out_of_order: u64 = out_of_order.map(|(count, _)| count).sum();
        out_of_order as f64 / hits.len().max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gl::Context;
    use crate::methods::{Method, Renderer};
    use crate::scene::Scene;

    /// The part that is estimated, and the part that is in lists.
    fn both(context: &Context, name: &str, is_given: bool) -> [f64; 2] {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
        let mut scene = Scene::load(format!("{folder}/{name}.toml")).unwrap();
        scene.size = [320, 240];
        let mut renderer = Renderer::new(context, 320, 240).unwrap();
        let stats = renderer
            .render(&scene, &Method::VerifiedPainter)
            .unwrap()
            .stats;
        let triangles = Triangles::of(&scene);
        let sorted = match is_given {
            true => Sorted {
                triangles: triangles.submitted.clone(),
                bounds: None,
            },
            false => triangles.back_to_front(&scene.camera),
        };
        let estimated = triangles.part_in_disorder(&sorted, &scene.camera, scene.size);
        let counts = stats.verified.expect("the method counts");
        [
            estimated,
            counts.list_fragments as f64 / stats.fragments as f64,
        ]
    }

    #[test]
    fn a_thousand_points_tell_how_much_is_out_of_order() {
        let context = Context::headless().unwrap();
        for name in ["knots", "quads", "sheets64", "soup", "teapot"] {
            let [estimated, counted] = both(&context, name, false);
            println!("{name}: {estimated:.3}, {counted:.3}");
            assert!(
                (estimated - counted).abs() < 0.05,
                "{name}: {estimated} {counted}"
            );
        }
        // Not sorted, the sheets are out of order.
        let [estimated, counted] = both(&context, "sheets64", true);
        assert!(estimated > 0.9 && counted == 0.0, "{estimated} {counted}");
    }

    #[test]
    fn whole_numbers_are_those_between() {
        for (low, high) in [
            (-2.5, 3.5),
            (0.0, 3.0),
            (0.1, 0.9),
            (2.0, 2.0),
            (-3.0, -0.5),
            (7.5, 99.0),
            (f32::NEG_INFINITY, f32::INFINITY),
            (1e30, f32::INFINITY),
        ] {
            let expected: Vec<i32> = (0..10)
                .filter(|&number| low <= number as f32 && number as f32 <= high)
                .collect();
            let found: Vec<i32> = whole_numbers(low, high, 10).collect();
            assert_eq!(found, expected, "{low} {high}");
        }
    }
}
