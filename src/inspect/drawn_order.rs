//! The order in which a method has the fragments of a pixel drawn.

use std::collections::HashMap;

use crate::gl::DrawnOrder;
use crate::scene::Scene;

/// The triangles of a scene, numbered through all meshes in the order of submission.
pub(super) struct Numbering {
    /// The number of each mesh's first triangle.
    firsts: Vec<u32>,
    /// The number of each mesh's first vertex among those of transparent meshes, or `None` if the mesh is opaque.
    vertices: Vec<Option<u32>>,
}

/// A triangle in every way in which an order may name it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Triangle {
    /// The mesh, and the triangle's number in it.
    pub(super) place: [u32; 2],
    /// The corners as numbers of vertices through all transparent meshes, or `None` if the mesh is opaque.
    pub(super) corners: Option<[u32; 3]>,
}

impl Numbering {
    pub(super) fn of(scene: &Scene) -> Self {
        let (mut triangle, mut vertex) = (0, 0);
        let (mut firsts, mut vertices) = (Vec::new(), Vec::new());
        for mesh in &scene.meshes {
            firsts.push(triangle);
            triangle += mesh.triangles.len() as u32;
            vertices.push((!mesh.opaque).then_some(vertex));
            if !mesh.opaque {
                vertex += mesh.vertices.len() as u32;
            }
        }
        Self { firsts, vertices }
    }

    pub(super) fn number(&self, [mesh, triangle]: [u32; 2]) -> u32 {
        self.firsts[mesh as usize] + triangle
    }

    pub(super) fn triangle(&self, scene: &Scene, number: u32) -> Triangle {
        // Meshes without triangles begin at the same number as the next mesh. The last of them has the triangle.
        let mesh = self.firsts.partition_point(|&first| first <= number) - 1;
        let triangle = number - self.firsts[mesh];
        let corners = scene.meshes[mesh].triangles[triangle as usize];
        Triangle {
            place: [mesh as u32, triangle],
            corners: self.vertices[mesh].map(|first| corners.map(|corner| first + corner)),
        }
    }

    /// The numbers of all transparent triangles.
    pub(super) fn transparent(&self, scene: &Scene) -> Vec<u32> {
        let meshes = scene.meshes.iter().zip(&self.firsts);
        let transparent = meshes.filter(|(mesh, _)| !mesh.opaque);
        let numbers = transparent.flat_map(|(mesh, &first)| {
            let end = first + mesh.triangles.len() as u32;
            first..end
        });
        numbers.collect()
    }
}

/// Some triangles, by their places in the list, in the order in which they are drawn. Those that are not drawn are left out.
/// The list is in the order of submission. `None` if a triangle is drawn in pieces, of which it is not known here which has
/// the pixel.
pub(super) fn drawn(triangles: &[Triangle], order: DrawnOrder<'_>) -> Option<Vec<usize>> {
    Some(match order {
        DrawnOrder::Submission => (0..triangles.len()).collect(),
        DrawnOrder::Triangles(order) => {
            let places = triangles.iter().enumerate();
            let places: HashMap<_, _> = places.map(|(at, triangle)| (triangle.place, at)).collect();
            order
                .iter()
                .filter_map(|it| places.get(it).copied())
                .collect()
        }
        DrawnOrder::Corners(order) => return by_corners(triangles, order),
    })
}

/// Opaque triangles come first. Of triangles with the same corners, the one that was submitted first comes first.
fn by_corners(triangles: &[Triangle], order: &[[u32; 3]]) -> Option<Vec<usize>> {
    let mut drawn = Vec::new();
    let mut waiting: HashMap<[u32; 3], Vec<usize>> = HashMap::new();
    for (at, triangle) in triangles.iter().enumerate().rev() {
        match triangle.corners {
            Some(corners) => waiting.entry(corners).or_default().push(at),
            None => drawn.insert(0, at),
        }
    }
    for corners in order {
        if let Some(same) = waiting.get_mut(corners) {
            drawn.push(same.pop()?);
        }
    }
    Some(drawn)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Mesh, Vertex};

    fn scene() -> Scene {
        let mesh = |opaque, triangles: Vec<[u32; 3]>| Mesh {
            opaque,
            vertices: vec![Vertex::default(); 4],
            triangles,
            ..Mesh::default()
        };
        let meshes = vec![
            mesh(false, vec![[0, 1, 2], [1, 2, 3]]),
            mesh(true, vec![[0, 1, 2]]),
            mesh(false, vec![[0, 1, 2], [0, 1, 2]]),
        ];
        Scene::of("three meshes", meshes)
    }

    fn triangles(numbers: &[u32]) -> Vec<Triangle> {
        let scene = scene();
        let numbering = Numbering::of(&scene);
        let triangle = |&number: &u32| numbering.triangle(&scene, number);
        numbers.iter().map(triangle).collect()
    }

    #[test]
    fn a_triangle_s_number_leads_to_its_place_and_back() {
        let numbering = Numbering::of(&scene());
        let places = triangles(&[0, 1, 2, 4]).into_iter().map(|it| it.place);
        let places: Vec<_> = places.collect();
        assert_eq!(places, [[0, 0], [0, 1], [1, 0], [2, 1]]);
        let numbers: Vec<_> = places.into_iter().map(|it| numbering.number(it)).collect();
        assert_eq!(numbers, [0, 1, 2, 4]);
        assert_eq!(numbering.transparent(&scene()), [0, 1, 3, 4]);
    }

    #[test]
    fn corners_of_transparent_triangles_are_numbered_through_and_opaque_ones_have_none() {
        let corners: Vec<_> = triangles(&[1, 2, 3]).iter().map(|it| it.corners).collect();
        assert_eq!(corners, [Some([1, 2, 3]), None, Some([4, 5, 6])]);
    }

    #[test]
    fn triangles_come_in_the_order_in_which_they_are_drawn_and_the_others_not_at_all() {
        let drawn = |order| drawn(&triangles(&[0, 2, 3, 4]), order).unwrap();
        assert_eq!(drawn(DrawnOrder::Submission), [0, 1, 2, 3]);
        assert_eq!(
            drawn(DrawnOrder::Triangles(&[[2, 1], [0, 1], [0, 0]])),
            [3, 0]
        );
        // Triangles 3 and 4 have the same corners.
        let corners = [[4, 5, 6], [1, 2, 3], [4, 5, 6]];
        assert_eq!(drawn(DrawnOrder::Corners(&corners)), [1, 2, 3]);
    }

    #[test]
    fn a_triangle_that_is_drawn_more_often_than_it_is_there_has_no_place() {
        let twice = [[0, 1, 2], [0, 1, 2]];
        assert_eq!(
            drawn(&triangles(&[0, 2]), DrawnOrder::Corners(&twice)),
            None
        );
    }
}
