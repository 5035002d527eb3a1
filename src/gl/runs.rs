//! The order in which triangles are drawn: runs of one mesh's triangles, a draw call each.

use glow::HasContext;

use super::program::Program;
use crate::scene::Scene;

/// Triangles of one mesh that are drawn by one call: `count` indices from `first`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Run {
    pub(super) mesh: usize,
    pub(super) first: i32,
    pub(super) count: i32,
    /// The place of its first triangle in the order of submission.
    pub(super) place: u32,
}

/// A large mesh is drawn in pieces of so many indices with a flush after each. A driver whose vertex stage and
/// rasteriser run side by side, as llvmpipe's do, can then rasterise a piece while it transforms the next one.
pub(super) const PIECE: i32 = 3 * 10_000;

impl Run {
    /// Draws the run with the program, which is current, as is the vertex array. Returns the number of triangles.
    ///
    /// # Safety
    /// Every index of the run is that of a vertex.
    pub(super) unsafe fn draw(&self, gl: &glow::Context, program: &Program) -> u64 {
        let mut triangles = 0;
        for piece in self.pieces() {
            triangles += piece.count as u64 / 3;
            // SAFETY: the caller says so; the location is the program's.
            unsafe {
                // gl_PrimitiveID starts at 0 in every draw.
                gl.uniform_1_u32(program.first_triangle.as_ref(), piece.place);
                gl.draw_elements(
                    glow::TRIANGLES,
                    piece.count,
                    glow::UNSIGNED_INT,
                    piece.first * 4,
                );
                if piece.count == PIECE {
                    gl.flush();
                }
            }
        }
        triangles
    }

    pub(super) fn pieces(&self) -> impl Iterator<Item = Self> + use<> {
        let (mesh, start, place) = (self.mesh, self.first, self.place);
        let end = start + self.count;
        (start..end).step_by(PIECE as usize).map(move |first| Self {
            mesh,
            first,
            count: PIECE.min(end - first),
            place: place + (first - start) as u32 / 3,
        })
    }
}

/// The triangles of each mesh as they are drawn in several orders, one after the other, and the runs of each order.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Ordered {
    /// A list for each mesh.
    pub(super) triangles: Vec<Vec<[u32; 3]>>,
    /// A list for each order.
    pub(super) runs: Vec<Vec<Run>>,
}

impl Ordered {
    /// The orders have each triangle as mesh and number.
    pub(super) fn new(scene: &Scene, orders: &[Vec<[u32; 2]>]) -> Self {
        let mut triangles: Vec<Vec<[u32; 3]>> = vec![Vec::new(); scene.meshes.len()];
        let mut runs_of = |order: &Vec<[u32; 2]>| {
            let mut runs: Vec<Run> = Vec::new();
            for (place, &[mesh, triangle]) in order.iter().enumerate() {
                let mesh = mesh as usize;
                let of_mesh = &mut triangles[mesh];
                match runs.last_mut() {
                    Some(run) if run.mesh == mesh => run.count += 3,
                    _ => runs.push(Run {
                        mesh,
                        first: of_mesh.len() as i32 * 3,
                        count: 3,
                        place: place as u32,
                    }),
                }
                of_mesh.push(scene.meshes[mesh].triangles[triangle as usize]);
            }
            runs
        };
        let runs = orders.iter().map(&mut runs_of).collect();
        Self { triangles, runs }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Mesh;

    #[test]
    fn each_order_has_runs_of_its_own_in_the_triangles_of_its_meshes() {
        let mesh = |first: u32| Mesh {
            triangles: vec![[first; 3], [first + 1; 3], [first + 2; 3]],
            ..Mesh::default()
        };
        let scene = Scene::of("two meshes", vec![mesh(10), mesh(20)]);
        let orders = [
            vec![[0, 2], [0, 0], [1, 1], [0, 1]],
            Vec::new(),
            vec![[1, 0], [1, 2]],
        ];
        let ordered = Ordered::new(&scene, &orders);
        let of_0 = vec![[12; 3], [10; 3], [11; 3]];
        let of_1 = vec![[21; 3], [20; 3], [22; 3]];
        assert_eq!(ordered.triangles, [of_0, of_1]);
        let run = |mesh, first, count, place| Run {
            mesh,
            first,
            count,
            place,
        };
        let first = vec![run(0, 0, 6, 0), run(1, 0, 3, 2), run(0, 6, 3, 3)];
        assert_eq!(ordered.runs, [first, vec![], vec![run(1, 3, 6, 0)]]);
    }

    #[test]
    fn a_long_run_is_drawn_in_pieces_that_know_their_places() {
        let run = Run {
            mesh: 3,
            first: 6,
            count: 2 * PIECE + 9,
            place: 100,
        };
        let pieces: Vec<_> = run.pieces().collect();
        let firsts: Vec<_> = pieces.iter().map(|piece| piece.first).collect();
        assert_eq!(firsts, [6, 6 + PIECE, 6 + 2 * PIECE]);
        let places: Vec<_> = pieces.iter().map(|piece| piece.place).collect();
        assert_eq!(places, [100, 10_100, 20_100]);
        assert_eq!(pieces[2].count, 9);
    }
}
