//! The triangles that reach marked pixels, and how many of them reach each.
//!
//! The lists need room before they are filled. Counting their fragments on the GPU takes a draw of all these triangles,
//! which takes more than half as long as the draw that fills the lists. The CPU knows as much: which rows a triangle has, and from where to where it
//! reaches in each. The marked pixels of such a span have consecutive [`Numbers`], so a span is counted with two additions,
//! however long it is.
//!
//! What it finds is a bound: spans are longer than the triangle by what OpenGL may round, and no opaque surface hides
//! anything. OpenGL counts the fragments when it fills the lists, so a bound that is too low is noticed
//! (in `a_buffer/marked.rs`).

use std::ops::Range;

use glam::{DMat4, Mat4, Vec2, Vec3, Vec4};

use super::estimate::whole_numbers;
use super::view_order::{Triangles, in_parts, of_parts};
use crate::gl::Numbers;
use crate::scene::Camera;

/// Triangles that reach marked pixels.
#[derive(Debug)]
pub(super) struct Touching {
    /// In the order of submission.
    pub(super) triangles: Vec<[u32; 3]>,
    /// How many of them reach each marked pixel, by its number.
    pub(super) counts: Vec<u32>,
}

impl Triangles {
    /// The triangles that may have a fragment in a marked pixel.
    pub(super) fn touching(&self, camera: &Camera, size: [u32; 2], numbers: &Numbers) -> Touching {
        let view = View::new(self, camera, size);
        let places = in_parts(&self.positions, |part| {
            part.iter().map(|position| view.place(*position)).collect()
        });
        let parts = of_parts(&self.submitted, |part| {
            let mut spans = Spans::new(numbers);
            let touches = |triangle: &&[u32; 3]| {
                let corners = triangle.map(|corner| places[corner as usize]);
                if are_known(&corners) {
                    return spans.add(&corners, &view);
                }
                let left = view.clipped(triangle.map(|corner| self.positions[corner as usize]));
                match are_known(&left) {
                    true => spans.add(&left, &view),
                    false => spans.add(&view.image(), &view),
                }
            };
            let triangles: Vec<[u32; 3]> = part.iter().filter(touches).copied().collect();
            (triangles, spans.changes)
        });
        let mut triangles = Vec::new();
        let mut counts = vec![0u32; numbers.count() as usize];
        for (part, changes) in parts {
            triangles.extend(part);
            for (count, more) in counts.iter_mut().zip(sums(&changes)) {
                *count += more;
            }
        }
        Touching { triangles, counts }
    }
}

/// How positions come to be pixels.
struct View {
    to_clip: Mat4,
    /// In pixels.
    size: Vec2,
    near: f32,
    /// By how many pixels OpenGL may have a corner elsewhere, if it is in the image.
    slack: f32,
}

impl View {
    fn new(triangles: &Triangles, camera: &Camera, [width, height]: [u32; 2]) -> Self {
        let to_clip = camera.projection(width, height)
            * camera.view()
            * DMat4::from_translation(triangles.origin);
        Self {
            to_clip: to_clip.as_mat4(),
            size: Vec2::new(width as f32, height as f32),
            near: camera.near as f32,
            slack: slack(triangles, &to_clip, camera.near, width.max(height)),
        }
    }

    /// Where a corner is, in pixels, less the half by which a pixel's centre is in it. A corner before the near plane is
    /// nowhere.
    fn place(&self, position: Vec3) -> Vec2 {
        let clip = self.to_clip * position.extend(1.0);
        match clip.w >= self.near {
            true => self.in_pixels(clip),
            false => Vec2::NAN,
        }
    }

    fn in_pixels(&self, clip: Vec4) -> Vec2 {
        (clip.truncate().truncate() / clip.w + 1.0) * 0.5 * self.size - 0.5
    }

    /// The corners of the image.
    fn image(&self) -> [Vec2; 4] {
        let Vec2 { x, y } = self.size;
        [Vec2::ZERO, Vec2::new(x, 0.0), self.size, Vec2::new(0.0, y)]
    }

    /// The corners of what the near plane leaves of a triangle, and a little that it does not leave.
    fn clipped(&self, triangle: [Vec3; 3]) -> Vec<Vec2> {
        let corners = triangle.map(|position| self.to_clip * position.extend(1.0));
        // OpenGL may round a corner to the other side.
        let near = self.near * 0.999;
        let mut left = Vec::with_capacity(4);
        for (number, &corner) in corners.iter().enumerate() {
            let next = corners[(number + 1) % 3];
            if corner.w >= near {
                left.push(self.in_pixels(corner));
            }
            if (corner.w >= near) != (next.w >= near) {
                let part = (near - corner.w) / (next.w - corner.w);
                left.push(self.in_pixels(corner.lerp(next, part)));
            }
        }
        left
    }
}

/// By how many pixels OpenGL may have a corner elsewhere.
///
/// Drivers round to 1/16 of a pixel at the coarsest (the least GL_SUBPIXEL_BITS is 4), and compute in f32, as it is
/// done here. Of a sum of four products, f32 has an error of 4 units in the last place of their absolute values' sum;
/// OpenGL has two matrices. Division by w multiplies the error by at most 1 / near, and once more for w's own error.
fn slack(triangles: &Triangles, to_clip: &DMat4, near: f64, longest: u32) -> f32 {
    let far = triangles.positions.iter().copied().map(Vec3::abs);
    let far = far.fold(Vec3::ZERO, Vec3::max).as_dvec3().extend(1.0);
    let terms = |row: usize| to_clip.row(row).abs().dot(far);
    let terms = terms(0).max(terms(1)).max(terms(3));
    let unit = f64::from(f32::EPSILON);
    let error = (4.0 + 2.0 * 4.0) * unit * terms / near;
    let pixels = f64::from(longest) / 2.0;
    (1.0 / 16.0 + 2.0 * error * pixels) as f32
}

/// Whether corners are somewhere. They are not if one lies before the near plane, or if f32 overflows.
fn are_known(corners: &[Vec2]) -> bool {
    corners.iter().all(|corner| corner.is_finite())
}

/// Of a triangle's largest coordinate: by how many pixels its edges may lie elsewhere. Four roundings here, to find where an
/// edge crosses a row, and as many when a driver clips the triangle to what it can draw.
const ROUNDED: f32 = 8.0 * f32::EPSILON;

/// Spans of marked pixels, one after the other in their order by number.
struct Spans<'n> {
    numbers: &'n Numbers,
    /// By how many more spans a number is in than the number before, modulo 2^32.
    changes: Vec<u32>,
}

impl<'n> Spans<'n> {
    fn new(numbers: &'n Numbers) -> Self {
        Self {
            numbers,
            changes: vec![0; numbers.count() as usize + 1],
        }
    }

    /// Adds the marked pixels whose centres are in a convex polygon, or not farther from it than it may lie elsewhere. Returns
    /// whether there are any.
    fn add(&mut self, corners: &[Vec2], view: &View) -> bool {
        let largest = corners.iter().fold(0.0, |largest: f32, corner| {
            corner.abs().max_element().max(largest)
        });
        let slack = view.slack + ROUNDED * largest;
        let low = corners.iter().copied().fold(Vec2::INFINITY, Vec2::min) - slack;
        let high = corners.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max) + slack;
        let [columns, rows] = [
            within(low.x, high.x, view.size.x),
            within(low.y, high.y, view.size.y),
        ];
        let mut is_any = false;
        for row in rows {
            // Most rows of most triangles have no marks, which is seen at once.
            if self.numbers.is_any(columns.clone(), row)
                && let Some([left, right]) = reach(corners, row as f32, slack)
            {
                let span = within(left - slack, right + slack, view.size.x);
                is_any |= self.add_span(span, row);
            }
        }
        is_any
    }

    fn add_span(&mut self, columns: Range<u32>, row: u32) -> bool {
        let is_any = self.numbers.is_any(columns.clone(), row);
        if is_any {
            let [first, end] = [columns.start, columns.end]
                .map(|column| self.numbers.before(column, row) as usize);
            self.changes[first] = self.changes[first].wrapping_add(1);
            self.changes[end] = self.changes[end].wrapping_sub(1);
        }
        is_any
    }
}

/// What changes add up to, number by number.
fn sums(changes: &[u32]) -> impl Iterator<Item = u32> {
    changes.iter().scan(0u32, |sum, change| {
        *sum = sum.wrapping_add(*change);
        Some(*sum)
    })
}

/// The whole numbers from one number to another, from 0 on and below `end`.
fn within(low: f32, high: f32, end: f32) -> Range<u32> {
    let numbers = whole_numbers(low, high, end as i32);
    // An empty range may begin anywhere.
    let start = numbers.start.min(end as i32) as u32;
    start..start.max(numbers.end as u32)
}

/// From where to where a convex polygon reaches in a row, or not farther above and below it than `slack`.
fn reach(corners: &[Vec2], row: f32, slack: f32) -> Option<[f32; 2]> {
    let (below, above) = (row - slack, row + slack);
    let mut reach = [f32::INFINITY, f32::NEG_INFINITY];
    let mut last = *corners.last()?;
    for &corner in corners {
        let (a, b) = match last.y <= corner.y {
            true => (last, corner),
            false => (corner, last),
        };
        last = corner;
        if b.y < below || a.y > above {
            continue;
        }
        let at = |y: f32| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y));
        let from = if a.y < below { at(below) } else { a.x };
        let to = if b.y > above { at(above) } else { b.x };
        reach = [reach[0].min(from).min(to), reach[1].max(from).max(to)];
    }
    (reach[0] <= reach[1]).then_some(reach)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;
    use rand::Rng;
    use rand_pcg::Pcg32;

    use super::*;
    use crate::scene::{Mesh, Scene, Vertex};

    const SIZE: [u32; 2] = [70, 40];

    /// A number from -1 to 1.
    fn number(chance: &mut Pcg32) -> f64 {
        f64::from(chance.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0
    }

    fn vector(chance: &mut Pcg32) -> DVec3 {
        DVec3::from_array(std::array::from_fn(|_| number(chance)))
    }

    /// Triangles around the eye and in sight of it, from a tenth of a pixel to much larger than the image.
    fn scene(chance: &mut Pcg32) -> Scene {
        let mut vertices = Vec::new();
        for _ in 0..300 {
            let place = 4.0 * vector(chance);
            let size = 10f64.powf(2.5 * number(chance));
            vertices.extend((0..3).map(|_| Vertex {
                position: place + size * vector(chance),
                ..Vertex::default()
            }));
        }
        let triangles = (0..300).map(|number| [0, 1, 2].map(|corner| 3 * number + corner));
        let mesh = Mesh::new("triangles", vertices, triangles.collect());
        let camera = Camera {
            near: 0.1,
            far: 1e4,
            ..Camera::looking(DVec3::ZERO, DVec3::new(0.3, 0.2, -1.0))
        };
        Scene::new(camera, SIZE).with_mesh(mesh)
    }

    /// How many triangles the rays of the marked pixels meet behind the near plane, by an intersection in f64.
    fn met(scene: &Scene, pixels: &[[u32; 2]]) -> Vec<u32> {
        let camera = &scene.camera;
        let [width, height] = SIZE;
        let from_clip = (camera.projection(width, height) * camera.view()).inverse();
        let forward = (camera.target - camera.eye).normalize();
        let mesh = &scene.meshes[0];
        let meets = |direction: DVec3, triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|corner| mesh.vertices[corner as usize].position);
            let (u, v, from) = (b - a, c - a, camera.eye - a);
            let across = direction.cross(v);
            let size = u.dot(across);
            let [right, up] = [from.dot(across) / size, direction.dot(from.cross(u)) / size];
            let distance = v.dot(from.cross(u)) / size * direction.dot(forward);
            right >= 0.0 && up >= 0.0 && right + up <= 1.0 && distance > camera.near
        };
        let count = |&[x, y]: &[u32; 2]| {
            let part = |at: u32, of: u32| (f64::from(at) + 0.5) / f64::from(of) * 2.0 - 1.0;
            let there = from_clip.project_point3(DVec3::new(part(x, width), part(y, height), 0.5));
            let direction = (there - camera.eye).normalize();
            mesh.triangles
                .iter()
                .filter(|it| meets(direction, it))
                .count() as u32
        };
        pixels.iter().map(count).collect()
    }

    /// Marks some pixels, or nearly all.
    fn marked(chance: &mut Pcg32, of: u32) -> (Numbers, Vec<[u32; 2]>) {
        let [width, height] = SIZE;
        let across = width.div_ceil(32);
        let mut marks = vec![0; (across * height) as usize];
        let mut pixels = Vec::new();
        for y in 0..height {
            for x in 0..width {
                if !chance.next_u32().is_multiple_of(of) {
                    continue;
                }
                marks[(y * across + x / 32) as usize] |= 1 << (x % 32);
                pixels.push([x, y]);
            }
        }
        (Numbers::of(&marks, SIZE), pixels)
    }

    #[test]
    fn no_triangle_of_a_marked_pixel_is_left_out_and_few_are_counted_too_many() {
        let (mut counted, mut there, mut missed_without_slack) = (0, 0, 0);
        for seed in 0..30 {
            let mut chance = Pcg32::new(seed, 16);
            let scene = scene(&mut chance);
            let (numbers, pixels) = marked(&mut chance, [1, 7, 400][seed as usize % 3]);
            let triangles = Triangles::of(&scene);
            let expected = met(&scene, &pixels);
            let touching = triangles.touching(&scene.camera, SIZE, &numbers);
            for (pixel, (expected, bound)) in
                pixels.iter().zip(expected.iter().zip(&touching.counts))
            {
                assert!(
                    expected <= bound,
                    "seed {seed}, {pixel:?}: {expected} of {bound}"
                );
            }
            // Those that are drawn are enough for all.
            let mut again = Triangles::of(&scene);
            again.submitted = touching.triangles;
            let drawn = again.touching(&scene.camera, SIZE, &numbers);
            assert_eq!(drawn.counts, touching.counts, "seed {seed}");
            assert_eq!(drawn.triangles.len(), again.submitted.len(), "seed {seed}");
            counted += touching.counts.iter().sum::<u32>();
            there += expected.iter().sum::<u32>();
            // With half a pixel less on all sides, triangles are missed.
            let shrunk = View {
                slack: -0.5,
                ..View::new(&triangles, &scene.camera, SIZE)
            };
            let mut spans = Spans::new(&numbers);
            for triangle in &triangles.submitted {
                let corners = triangle.map(|corner| triangles.positions[corner as usize]);
                spans.add(&shrunk.clipped(corners), &shrunk);
            }
            let counts = sums(&spans.changes).zip(&expected);
            missed_without_slack += counts.filter(|(count, expected)| count < *expected).count();
        }
        println!("{counted} counted, {there} there");
        assert!(there > 50_000 && f64::from(counted) < 1.1 * f64::from(there));
        assert!(missed_without_slack > 1000, "{missed_without_slack}");
    }
}
