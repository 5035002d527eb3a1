//! Planes that other triangles cross, such as slices of a volume that a beam goes through.
//!
//! A triangle that crosses planes has no place in their order, for parts of it lie before and behind each. But these parts
//! do. So the triangle is drawn once for each slab between two planes, and the shader keeps the fragments that lie in the
//! slab. Slabs and planes are drawn from back to front. The bounds of a triangle's slabs are the same numbers on both sides,
//! and there are none before its first slab and behind its last one: so every fragment is kept exactly once, whatever is
//! rounded. A fragment that is rounded to the wrong side of a plane fails the proof, as ever.
//!
//! A fragment that is not kept takes little time. Without pieces, each pixel of such a triangle is marked.

use glam::{DVec3, Vec3};

use super::view_order::{Sorted, Triangles, counting_sort, threads};
use crate::scene::{Camera, Mesh, Scene};

/// The most planes, of which each has a place between two slabs.
const MOST_PLANES: usize = 1 << 14;
/// More pieces than so many for each triangle of the scene are not worth their memory.
const MOST_PIECES: usize = 4;

/// The transparent triangles of a scene with planes, in pieces, whatever the camera.
#[derive(Debug)]
pub(super) struct Pieces {
    /// Of the planes.
    normal: Vec3,
    /// Where the planes lie along the normal, in ascending order.
    planes: Vec<f32>,
    /// In the order of submission. A triangle in several pieces is there as often.
    triangles: Vec<[u32; 3]>,
    /// What each piece keeps: from where on along the normal, and up to where.
    bounds: Vec<[f32; 2]>,
    /// The slab of each piece or the plane that it lies in: slab 0 is 0, plane 0 is 1, the slab behind it 2.
    places: Vec<u16>,
}

impl Pieces {
    /// Those of a scene whose sorted meshes lie in parallel planes that other triangles cross. `None` for all other scenes.
    pub(super) fn of(scene: &Scene, triangles: &Triangles) -> Option<Self> {
        let meshes = || scene.meshes.iter().filter(|mesh| !mesh.opaque);
        if !meshes().any(|mesh| mesh.sorted) || meshes().all(|mesh| mesh.sorted) {
            return None;
        }
        let sorted: Vec<bool> = meshes()
            .flat_map(|mesh| std::iter::repeat_n(mesh.sorted, mesh.triangles.len()))
            .collect();
        let normal = normal(meshes().filter(|mesh| mesh.sorted))?.as_vec3();
        let along: Vec<f32> = triangles
            .positions
            .iter()
            .map(|position| position.dot(normal))
            .collect();
        // What f32 makes of a sum of three products that are at most as large.
        let largest = triangles.positions.iter().map(|position| position.length());
        let noise = 8.0 * f32::EPSILON * largest.fold(0.0, f32::max);
        let range = |triangle: &[u32; 3]| {
            let [a, b, c] = triangle.map(|corner| along[corner as usize]);
            [a.min(b).min(c), a.max(b).max(c)]
        };
        let mut planes = Vec::new();
        for (triangle, _) in triangles
            .submitted
            .iter()
            .zip(&sorted)
            .filter(|(_, sorted)| **sorted)
        {
            let [low, high] = range(triangle);
            if high - low > noise {
                return None;
            }
            planes.push((low + high) / 2.0);
        }
        planes.sort_unstable_by(f32::total_cmp);
        planes.dedup_by(|next, plane| *next - *plane <= noise);
        if planes.len() > MOST_PLANES {
            return None;
        }
        let mut pieces = Self {
            normal,
            planes,
            triangles: Vec::new(),
            bounds: Vec::new(),
            places: Vec::new(),
        };
        for (triangle, sorted) in triangles.submitted.iter().zip(sorted) {
            pieces.add(*triangle, range(triangle), sorted.then_some(noise));
            if pieces.triangles.len() > MOST_PIECES * triangles.submitted.len() {
                return None;
            }
        }
        (pieces.triangles.len() > triangles.submitted.len()).then_some(pieces)
    }

    /// Adds the pieces of a triangle that lies between `low` and `high`; of one that is in a plane, as far as `noise` can
    /// tell.
    fn add(&mut self, triangle: [u32; 3], [low, high]: [f32; 2], noise: Option<f32>) {
        const EVERYTHING: [f32; 2] = [f32::NEG_INFINITY, f32::INFINITY];
        if let Some(noise) = noise {
            let plane = self.planes.partition_point(|plane| *plane < low - noise);
            self.push(triangle, EVERYTHING, 2 * plane + 1);
            return;
        }
        let first = self.planes.partition_point(|plane| *plane <= low);
        let last = self
            .planes
            .partition_point(|plane| *plane < high)
            .max(first);
        for slab in first..=last {
            let from = match slab == first {
                true => EVERYTHING[0],
                false => self.planes[slab - 1],
            };
            let to = match slab == last {
                true => EVERYTHING[1],
                false => self.planes[slab],
            };
            self.push(triangle, [from, to], 2 * slab);
        }
    }

    fn push(&mut self, triangle: [u32; 3], bounds: [f32; 2], place: usize) {
        self.triangles.push(triangle);
        self.bounds.push(bounds);
        self.places.push(place as u16);
    }

    /// The pieces, the farthest slab or plane first, and those of one slab as far as their centroids say. `origin` is what
    /// the drawn positions are relative to. The first of the bounds is the normal and where the positions' origin is along
    /// it; the others are the pieces' own.
    pub(super) fn back_to_front(
        &self,
        triangles: &Triangles,
        camera: &Camera,
        origin: DVec3,
    ) -> Sorted {
        let eye = (camera.eye - triangles.origin).as_vec3().dot(self.normal);
        // The eye's slab is the last. Those behind it come first, the farthest of them first of all, then those before it.
        let last = 2 * self.planes.len();
        let eyes = 2 * self.planes.partition_point(|plane| *plane <= eye);
        let key = |place: usize| match place > eyes {
            true => last - place,
            false => last - eyes + place,
        };
        let numbers: Vec<u32> = (0..self.triangles.len() as u32).collect();
        let by_centroid = triangles.sort(camera, &self.triangles, &numbers);
        let keys: Vec<u16> = by_centroid
            .iter()
            .map(|&number| key(self.places[number as usize].into()) as u16)
            .collect();
        let order = counting_sort(threads(keys.len()), last + 1, &keys, &by_centroid);
        let shift = self.normal.as_dvec3().dot(triangles.origin - origin) as f32;
        let head = self.normal.extend(shift).to_array();
        let bounds = order.iter().map(|&number| {
            let [from, to] = self.bounds[number as usize];
            [from, to, 0.0, 0.0]
        });
        Sorted {
            triangles: order
                .iter()
                .map(|&number| self.triangles[number as usize])
                .collect(),
            bounds: Some(std::iter::once(head).chain(bounds).collect()),
        }
    }
}

/// The mean of the triangles' normals, all of which look to the side to which the first one does.
fn normal<'m>(meshes: impl Iterator<Item = &'m Mesh>) -> Option<DVec3> {
    let mut sum = DVec3::ZERO;
    for mesh in meshes {
        for corners in &mesh.triangles {
            let [a, b, c] = corners.map(|corner| mesh.vertices[corner as usize].position);
            let normal = (b - a).cross(c - a);
            sum += if normal.dot(sum) < 0.0 {
                -normal
            } else {
                normal
            };
        }
    }
    sum.try_normalize()
}
