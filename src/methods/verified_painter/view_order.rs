//! The triangles of a scene's transparent meshes, back to front for a camera: approximately, and quickly.
//!
//! Triangles are sorted by their centroids' distances along the view, in steps ([`Steps`]). Triangles of one step keep their
//! order of submission. The verified pass proves at which pixels that was good enough, so the sort need not be exact; but
//! it is part of every frame, so it has to be quick. A counting sort is linear, and its parts run on every core.
//!
//! Of the centroid, the nearest and the farthest corner, the centroid leaves the fewest pixels out of order on the bundled
//! scenes but one: of the teapot, whose small triangles stand on a large plane, the farthest corner. A few
//! triangles that are long along the view are a floor or a wall, as a rule, and the small ones lie before it. So long ones
//! are sorted by their farthest corner, unless most are long. That leaves 552 of the teapot's 10,720 pixels, and the same
//! pixels of the other scenes.

use std::ops::Range;
use std::thread::{available_parallelism, scope};

use glam::{DVec3, Vec3};

use crate::scene::{Camera, Mesh, Scene};

/// Into how many equal distances a scene's depth is divided.
#[derive(Clone, Copy, Debug, Default)]
#[repr(usize)]
enum Steps {
    /// In a mesh, triangles that were submitted one after the other are neighbours, as a rule, do not hide each other, and
    /// share vertices, which the driver shades once if they are drawn one after the other, too. With finer steps few
    /// pixels less were out of order, and the driver took longer.
    #[default]
    Coarse = 1 << 10,
    /// Meshes that are sorted exactly, such as slices, have triangles at many distances that hide each other.
    Fine = 1 << 16,
}

/// The part of the scene's depth from which on a triangle is sorted by its farthest corner.
const LONG: f32 = 0.05;
/// About so many triangles tell how many are long.
const SAMPLE: usize = 1000;

/// A thread with fewer triangles than this costs more than it saves.
const LEAST: usize = 10_000;

/// A piece's bounds, which are read as texels of four floats.
pub(super) type Bounds = [f32; 4];

/// Triangles as they are drawn.
#[derive(Debug, Default)]
pub(in crate::low_level::methods) struct Sorted {
    pub(super) triangles: Vec<[u32; 3]>,
    /// Of those that are drawn in pieces: what the shader is told, see [`pieces`](super::pieces).
    pub(super) bounds: Option<Vec<Bounds>>,
}

/// The transparent triangles of a scene, whatever the camera.
#[derive(Debug, Default)]
pub(in crate::low_level::methods) struct Triangles {
    /// Each vertex relative to `origin`. The vertices are numbered through all transparent meshes.
    pub(super) positions: Vec<Vec3>,
    pub(super) origin: DVec3,
    /// In the order of submission.
    pub(in crate::low_level::methods) submitted: Vec<[u32; 3]>,
    steps: Steps,
}

impl Triangles {
    /// Those of the scene's transparent meshes.
    pub(super) fn of(scene: &Scene) -> Self {
        let meshes = || scene.meshes.iter().filter(|mesh| !mesh.opaque);
        let origin = scene.bounds().map_or(DVec3::ZERO, |bounds| bounds.centre());
        let steps = match meshes().any(|mesh| mesh.sorted) {
            true => Steps::Fine,
            false => Steps::Coarse,
        };
        let mut triangles = Self {
            origin,
            steps,
            ..Self::default()
        };
        for mesh in meshes() {
            triangles.add(mesh);
        }
        triangles
    }

    fn add(&mut self, mesh: &Mesh) {
        // `Geometry` refuses more vertices than an index can name.
        let first = self.positions.len() as u32;
        let origin = self.origin;
        let positions = mesh.vertices.iter();
        self.positions
            .extend(positions.map(|vertex| (vertex.position - origin).as_vec3()));
        let triangles = mesh.triangles.iter();
        self.submitted
            .extend(triangles.map(|triangle| triangle.map(|corner| first.saturating_add(corner))));
    }

    /// The triangles, the farthest centroid first.
    pub(super) fn back_to_front(&self, camera: &Camera) -> Sorted {
        Sorted {
            triangles: self.sort(camera, &self.submitted, &self.submitted),
            bounds: None,
        }
    }

    /// Items by their triangles, the one with the farthest centroid first.
    pub(super) fn sort<T: Copy + Default + Send + Sync>(
        &self,
        camera: &Camera,
        triangles: &[[u32; 3]],
        items: &[T],
    ) -> Vec<T> {
        let forward = (camera.target - camera.eye).normalize_or_zero().as_vec3();
        let threads = threads(triangles.len());
        let mut distances = vec![0.0; self.positions.len()];
        side_by_side(threads, &self.positions, &mut distances, |position| {
            position.dot(forward)
        });
        let near = distances.iter().copied().fold(f32::INFINITY, f32::min);
        let far = distances.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        // Three times a centroid's distance, from 0 to the last step. Where all are equal this is not a number, and a
        // cast makes it 0.
        let steps = self.steps as usize;
        let scale = (steps - 1) as f32 / (3.0 * (far - near));
        let long = self.long(&distances, LONG * (far - near));
        let mut keys = vec![0u16; triangles.len()];
        side_by_side(threads, triangles, &mut keys, |corners| {
            let corners = corners.map(|corner| far - distances[corner as usize]);
            let sum = match length(corners) > long {
                true => 3.0 * corners.into_iter().fold(f32::INFINITY, f32::min),
                false => corners.iter().sum(),
            };
            (sum * scale) as u16
        });
        counting_sort(threads, steps, &keys, items)
    }

    /// The length from which on triangles are sorted by their farthest corners: `least`, or no length if more than half of
    /// the triangles are longer. Then none of them is a floor to the others.
    fn long(&self, distances: &[f32], least: f32) -> f32 {
        let looked_at = self
            .submitted
            .iter()
            .step_by(self.submitted.len() / SAMPLE + 1);
        let (mut count, mut longer) = (0, 0);
        for corners in looked_at {
            count += 1;
            longer += usize::from(length(corners.map(|corner| distances[corner as usize])) > least);
        }
        match 2 * longer > count {
            true => f32::INFINITY,
            false => least,
        }
    }
}

/// How long a triangle is along the view.
fn length([a, b, c]: [f32; 3]) -> f32 {
    a.max(b).max(c) - a.min(b).min(c)
}

/// As many threads as the machine has cores, and fewer for few triangles.
pub(super) fn threads(triangles: usize) -> usize {
    let cores = available_parallelism().map_or(1, |cores| cores.get());
    cores.min(triangles / LEAST + 1)
}

/// Fills `to` with a function of `from`, in parts of equal lengths.
fn side_by_side<T: Sync, U: Send>(
    threads: usize,
    from: &[T],
    to: &mut [U],
    function: impl Fn(&T) -> U + Sync,
) {
    let part = from.len().div_ceil(threads).max(1);
    let fill = |(from, to): (&[T], &mut [U])| {
        for (from, to) in from.iter().zip(to) {
            *to = function(from);
        }
    };
    let mut parts = from.chunks(part).zip(to.chunks_mut(part));
    scope(|scope| {
        let first = parts.next();
        for part in parts {
            scope.spawn(|| fill(part));
        }
        first.map(fill);
    });
}

/// What a function makes of each of some parts, one after the other. The parts are made side by side.
pub(super) fn in_parts<T: Sync, U: Send>(
    items: &[T],
    function: impl Fn(&[T]) -> Vec<U> + Sync,
) -> Vec<U> {
    let mut parts = of_parts(items, function).into_iter();
    let mut made = parts.next().unwrap_or_default();
    parts.for_each(|mut part| made.append(&mut part));
    made
}

/// What a function makes of each of some parts. The parts are made side by side.
pub(super) fn of_parts<T: Sync, U: Send>(
    items: &[T],
    function: impl Fn(&[T]) -> U + Sync,
) -> Vec<U> {
    let part = items.len().div_ceil(threads(items.len())).max(1);
    scope(|scope| {
        let mut parts = items.chunks(part);
        let first = parts.next().unwrap_or_default();
        let others = parts.map(|part| scope.spawn(|| function(part)));
        let others: Vec<_> = others.collect();
        let mut made = vec![function(first)];
        let others = others.into_iter().map(|other| other.join());
        made.extend(others.map(|made| made.expect("it does not panic")));
        made
    })
}

/// The items by their keys; items of one key stay in their order. Each thread writes the items of some keys, which lie side
/// by side, so that no two threads write to one place.
pub(super) fn counting_sort<T: Copy + Default + Send + Sync>(
    threads: usize,
    steps: usize,
    keys: &[u16],
    items: &[T],
) -> Vec<T> {
    let mut starts = vec![0u32; steps + 1];
    for &key in keys {
        starts[usize::from(key) + 1] += 1;
    }
    let mut before = 0;
    for start in &mut starts {
        before += *start;
        *start = before;
    }
    let mut sorted = vec![T::default(); items.len()];
    let mut rest = &mut sorted[..];
    scope(|scope| {
        for keys_of_part in parts(&starts, threads) {
            let range = starts[keys_of_part.start] as usize..starts[keys_of_part.end] as usize;
            let (part, after) = std::mem::take(&mut rest).split_at_mut(range.len());
            rest = after;
            let starts = &starts[..];
            let write = move || place(part, keys, items, keys_of_part, starts);
            match rest.is_empty() {
                true => write(),
                false => _ = scope.spawn(write),
            }
        }
    });
    sorted
}

/// Ranges of keys with about as many items each, one for each thread. `starts` has the number of items before each key.
fn parts(starts: &[u32], threads: usize) -> impl Iterator<Item = Range<usize>> {
    let steps = starts.len() - 1;
    let items = starts[steps] as usize;
    let bound = move |part: usize| match part {
        0 => 0,
        _ if part == threads => steps,
        _ => starts.partition_point(|&start| (start as usize) < items * part / threads),
    };
    (0..threads).map(move |part| {
        let first = bound(part).min(steps);
        first..bound(part + 1).clamp(first, steps)
    })
}

/// Writes the items of some keys to their places in the part of these keys.
fn place<T: Copy>(part: &mut [T], keys: &[u16], items: &[T], of: Range<usize>, starts: &[u32]) {
    let first = starts[of.start];
    let mut next: Vec<u32> = starts[of.clone()]
        .iter()
        .map(|start| start - first)
        .collect();
    for (&key, &item) in keys.iter().zip(items) {
        let key = usize::from(key);
        if of.contains(&key) {
            let place = &mut next[key - of.start];
            part[*place as usize] = item;
            *place += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use rand::Rng;
    use rand_pcg::Pcg32;

    use super::*;

    #[test]
    fn a_counting_sort_is_the_stable_sort_whatever_the_threads() {
        let mut chance = Pcg32::new(5, 11);
        for length in [0, 1, 2, 100, 3000] {
            for keys_below in [1, 3, 1000] {
                let keys: Vec<u16> = (0..length)
                    .map(|_| (chance.next_u32() % keys_below) as u16)
                    .collect();
                let items: Vec<u32> = (0..length).collect();
                let mut expected = items.clone();
                expected.sort_by_key(|&item| keys[item as usize]);
                for threads in [1, 2, 3, 7] {
                    assert_eq!(counting_sort(threads, 1000, &keys, &items), expected);
                }
            }
        }
    }

    #[test]
    fn parts_are_filled_side_by_side_in_their_order() {
        let from: Vec<u32> = (0..1001).collect();
        for threads in [1, 2, 5, 2000] {
            let mut to = vec![0; from.len()];
            side_by_side(threads, &from, &mut to, |number| number * 2);
            assert!(from.iter().zip(&to).all(|(from, to)| from * 2 == *to));
        }
        side_by_side(2, &[], &mut [], |number: &u32| *number);
        assert_eq!(in_parts(&from, |part| part.to_vec()), from);
        assert!(in_parts(&[], |part: &[u32]| part.to_vec()).is_empty());
    }
}
