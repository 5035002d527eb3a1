//! Sorting triangles on the CPU approximately front to back. Coherent layer peeling corrects the rest (Carr et al.
//! 2008, section 9: "a simple bucket sort of triangle centroids").
//!
//! It is done beforehand, for one view, and a frame's time does not contain it.

use std::fmt;
use std::str::FromStr;

use super::choice::{Choice, Takes, Value};
use crate::error::{Error, Result};
use crate::scene::{Mesh, Scene};

/// The order in which transparent triangles are submitted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum TriangleSort {
    /// The scene's order.
    Submission,
    /// Mesh by mesh, the mesh with the nearest middle first.
    Objects,
    /// By centroid, into as many buckets as the scene asks for: [`Buckets`](Self::Buckets), 256 of them, or as many as there
    /// are triangles if that is more. There are fewer where meshes would take turns more than 1024 times.
    #[default]
    Automatic,
    /// By centroid, into this many equally deep buckets between the nearest and the farthest. Within a bucket,
    /// triangles have the scene's order. 0 and 1 sort nothing.
    Buckets(u32),
    /// The same buckets, the farthest first. This is the worst order, to measure the value of sorting.
    Reversed(u32),
}

pub(super) const SORT: Choice = Choice {
    name: "sort",
    takes: Takes::Value("HOW"),
    help: "How triangles are sorted beforehand: submission, objects, reversed=N, buckets=N, or buckets, as many as the \
           scene asks for",
};

/// The fewest buckets. On the bundled scenes more of them saved no iteration (`benches/carr.rs`).
const FEWEST: u32 = 256;
/// The most buckets.
const MOST: u32 = 1 << 20;
/// The most draws that a pass may need because buckets make the meshes take turns.
const MOST_DRAWS: usize = 1024;

/// As many buckets as triangles separate whatever lies at equal distances, such as slices. But each time that another
/// mesh has its turn costs a draw call, so there are fewer buckets where that happens too often.
fn in_own_buckets(scene: &Scene, meshes: &[u32]) -> Vec<[u32; 2]> {
    let triangles = every_triangle(scene, meshes).len() as u32;
    let mut count = triangles.min(MOST).next_power_of_two().max(FEWEST);
    loop {
        let order = in_buckets(scene, meshes, count).concat();
        if count == FEWEST || turns(&order) <= MOST_DRAWS {
            return order;
        }
        count /= 2;
    }
}

/// How often the order goes on to another mesh.
fn turns(order: &[[u32; 2]]) -> usize {
    let others = order.windows(2).filter(|pair| pair[0][0] != pair[1][0]);
    others.count() + 1
}

impl FromStr for TriangleSort {
    type Err = Error;

    /// `submission`, `objects`, `buckets` or `buckets=N`, `reversed` with 256 buckets or `reversed=N`.
    fn from_str(text: &str) -> Result<Self> {
        let unknown = || {
            Error::usage(
                format!("'{text}' is no way to sort"),
                "write submission, objects, reversed, or buckets=N with N from 1 to 16777216",
            )
        };
        match text.split_once('=') {
            None if text == "submission" => Ok(Self::Submission),
            None if text == "objects" => Ok(Self::Objects),
            None if text == "buckets" => Ok(Self::Automatic),
            None if text == "reversed" => Ok(Self::Reversed(256)),
            Some(("buckets", count)) => buckets(count).map(Self::Buckets).ok_or_else(unknown),
            Some(("reversed", count)) => buckets(count).map(Self::Reversed).ok_or_else(unknown),
            _ => Err(unknown()),
        }
    }
}

/// The number of buckets, if so many fit into memory.
fn buckets(text: &str) -> Option<u32> {
    let count = text.parse().ok();
    count.filter(|count| (1..=1 << 24).contains(count))
}

impl fmt::Display for TriangleSort {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Submission => f.pad("submission"),
            Self::Objects => f.pad("objects"),
            Self::Automatic => f.pad("buckets"),
            Self::Buckets(count) => write!(f, "buckets={count}"),
            Self::Reversed(count) => write!(f, "reversed={count}"),
        }
    }
}

impl Value for TriangleSort {
    fn set(&mut self, text: &str) -> Result<()> {
        *self = text.parse()?;
        Ok(())
    }

    fn text(&self) -> Option<String> {
        Some(self.to_string())
    }
}

impl TriangleSort {
    /// Every triangle as mesh and number: opaque triangles first, then the others in this order.
    pub(super) fn order(self, scene: &Scene) -> Vec<[u32; 2]> {
        let (opaque, transparent): (Vec<u32>, Vec<u32>) =
            (0..scene.meshes.len() as u32).partition(|&mesh| scene.meshes[mesh as usize].opaque);
        let mut order = every_triangle(scene, &opaque);
        order.extend(match self {
            Self::Submission => every_triangle(scene, &transparent),
            Self::Objects => {
                let depth = |&mesh: &u32| middle_depth(scene, mesh);
                every_triangle(scene, &nearest_first(transparent, depth))
            }
            Self::Automatic => in_own_buckets(scene, &transparent),
            Self::Buckets(count) => in_buckets(scene, &transparent, count).concat(),
            Self::Reversed(count) => {
                let mut buckets = in_buckets(scene, &transparent, count);
                buckets.reverse();
                buckets.concat()
            }
        });
        order
    }
}

/// Three times a triangle's distance along the view direction. The factor does not change an order.
pub(super) fn centroid_depth(scene: &Scene, mesh: &Mesh, triangle: [u32; 3]) -> f64 {
    let forward = scene.camera.target - scene.camera.eye;
    let depth = |corner: u32| mesh.vertices[corner as usize].position.dot(forward);
    triangle.into_iter().map(depth).sum()
}

/// Every triangle in the order of hybrid layer peeling: those of sorted meshes, exactly by depth, come after the
/// others.
pub(super) fn sorted_meshes_front_to_back(scene: &Scene) -> Vec<[u32; 2]> {
    let (sorted, others): (Vec<u32>, Vec<u32>) =
        (0..scene.meshes.len() as u32).partition(|&mesh| scene.meshes[mesh as usize].sorted);
    let depth = |&triangle: &[u32; 2]| depth_of(scene, triangle);
    let mut front_to_back = nearest_first(every_triangle(scene, &sorted), depth);
    let mut order = every_triangle(scene, &others);
    order.append(&mut front_to_back);
    order
}

/// The nearer triangle comes first. Equally near ones stay in their order.
fn nearest_first<T>(items: Vec<T>, depth: impl Fn(&T) -> f64) -> Vec<T> {
    let mut keyed: Vec<(f64, T)> = items.into_iter().map(|item| (depth(&item), item)).collect();
    keyed.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    keyed.into_iter().map(|(_, item)| item).collect()
}

fn depth_of(scene: &Scene, [mesh, triangle]: [u32; 2]) -> f64 {
    let mesh = &scene.meshes[mesh as usize];
    centroid_depth(scene, mesh, mesh.triangles[triangle as usize])
}

fn every_triangle(scene: &Scene, meshes: &[u32]) -> Vec<[u32; 2]> {
    meshes
        .iter()
        .flat_map(|&mesh| {
            let count = scene.meshes[mesh as usize].triangles.len() as u32;
            (0..count).map(move |triangle| [mesh, triangle])
        })
        .collect()
}

fn middle_depth(scene: &Scene, mesh: u32) -> f64 {
    let forward = scene.camera.target - scene.camera.eye;
    let bounds = scene.meshes[mesh as usize].bounds();
    bounds.map_or(0.0, |bounds| bounds.centre().dot(forward))
}

/// Linear in the number of triangles.
fn in_buckets(scene: &Scene, meshes: &[u32], count: u32) -> Vec<Vec<[u32; 2]>> {
    let count = count.max(1) as usize;
    let triangles = every_triangle(scene, meshes);
    let depths: Vec<f64> = triangles.iter().map(|&t| depth_of(scene, t)).collect();
    let near = depths.iter().copied().fold(f64::INFINITY, f64::min);
    let far = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let bucket_of = |depth: f64| {
        let part = (depth - near) / (far - near);
        // This is not a number if all depths are equal. Then there is one bucket.
        ((part * count as f64) as usize).min(count - 1)
    };
    let mut buckets: Vec<Vec<[u32; 2]>> = vec![Vec::new(); count];
    for (triangle, depth) in triangles.into_iter().zip(depths) {
        buckets[bucket_of(depth)].push(triangle);
    }
    buckets
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Camera;
    use crate::scene::generate::{Quads, SubmissionOrder, quads};

    fn stack(order: SubmissionOrder) -> Scene {
        let parameters = Quads {
            count: 9,
            order,
            ..Quads::default()
        };
        Scene::of("quads", vec![quads(&parameters).unwrap()])
    }

    fn is_sorted(scene: &Scene, order: &[[u32; 2]]) -> bool {
        order.is_sorted_by_key(|&triangle| depth_of(scene, triangle))
    }

    #[test]
    fn enough_buckets_sort_a_stack_whatever_its_order() {
        for order in [
            SubmissionOrder::FrontToBack,
            SubmissionOrder::BackToFront,
            SubmissionOrder::Shuffled,
        ] {
            let scene = stack(order);
            assert!(is_sorted(&scene, &TriangleSort::Buckets(64).order(&scene)));
        }
    }

    /// Two stacks that take turns at every quad: fewer buckets, whose triangles are drawn mesh by mesh.
    #[test]
    fn meshes_that_take_turns_too_often_get_fewer_buckets() {
        let stacks = |count| {
            let parameters = Quads {
                count,
                ..Quads::default()
            };
            let mesh = quads(&parameters).unwrap();
            let mut scene = Scene::of("two", vec![mesh.clone(), mesh]);
            scene.meshes[1]
                .vertices
                .iter_mut()
                .for_each(|v| v.position.z -= 0.05);
            scene.camera = Camera::looking(glam::DVec3::Z * 4.0, glam::DVec3::ZERO);
            scene
        };
        let few = stacks(500);
        let order = TriangleSort::Automatic.order(&few);
        assert!(is_sorted(&few, &order) && turns(&order) == 1000);
        let many = stacks(3000);
        let order = TriangleSort::Automatic.order(&many);
        assert!(!is_sorted(&many, &order) && turns(&order) <= MOST_DRAWS);
    }

    #[test]
    fn five_hundred_slices_are_sorted_by_as_many_buckets_as_triangles_and_not_by_256() {
        let parameters = Quads {
            count: 500,
            order: SubmissionOrder::BackToFront,
            ..Quads::default()
        };
        let mut scene = Scene::of("quads", vec![quads(&parameters).unwrap()]);
        scene.camera = Camera::looking(glam::DVec3::Z * 4.0, glam::DVec3::ZERO);
        assert!(is_sorted(&scene, &TriangleSort::Automatic.order(&scene)));
        assert!(!is_sorted(
            &scene,
            &TriangleSort::Buckets(256).order(&scene)
        ));
    }

    #[test]
    fn reversed_buckets_are_as_unsorted_as_can_be() {
        let scene = stack(SubmissionOrder::FrontToBack);
        let mut order = TriangleSort::Reversed(64).order(&scene);
        assert!(!is_sorted(&scene, &order));
        order.reverse();
        assert!(is_sorted(&scene, &order));
    }

    #[test]
    fn one_bucket_sorts_nothing() {
        let scene = stack(SubmissionOrder::BackToFront);
        let order = TriangleSort::Buckets(1).order(&scene);
        assert_eq!(order, TriangleSort::Submission.order(&scene));
        assert!(!is_sorted(&scene, &order));
    }

    #[test]
    fn every_triangle_is_submitted_once_whatever_the_sorting() {
        let scene = stack(SubmissionOrder::Shuffled);
        for sorting in [
            TriangleSort::Submission,
            TriangleSort::Objects,
            TriangleSort::Automatic,
            TriangleSort::Buckets(3),
        ] {
            let mut order = sorting.order(&scene);
            order.sort_unstable();
            assert_eq!(order, every_triangle(&scene, &[0]), "{sorting:?}");
        }
    }

    #[test]
    fn the_nearest_object_comes_first() {
        let near = stack(SubmissionOrder::FrontToBack).meshes.remove(0);
        let mut far = near.clone();
        for vertex in &mut far.vertices {
            vertex.position.z -= 5.0;
        }
        let scene = Scene::of("two", vec![far, near]);
        assert_eq!(TriangleSort::Objects.order(&scene)[0], [1, 0]);
    }
}
