//! A stack of parallel quads: known colours at known depths.

use glam::Vec3;

use super::limits::{
    COORDINATE, FRACTION, LENGTH, all_within, count_within, few_enough, refusal, within,
};
use super::{Generator, Refusal, SubmissionOrder, checked};
use crate::error::Result;
use crate::fragment::Rgba;
use crate::scene::mesh::{Mesh, Vertex};

/// Quads parallel to the xy plane, centred on the z axis, facing +z. Quad 0 is at z = 0, the others behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct Quads {
    /// The number of quads, 1 to 10,000,000. If `depths` is given, it must be the number of depths.
    pub count: u32,
    /// Width and height of each quad, 1e-6 to 1e6.
    pub size: [f32; 2],
    /// The distance from one quad to the next, 0 to 1e6.
    pub spacing: f32,
    /// Instead of `spacing`: the distance of each quad behind z = 0, -1e6 to 1e6, in any order. Equal distances make
    /// ties.
    pub depths: Vec<f32>,
    /// The colours of quad 0, quad 1 and so on, in linear RGB, 0 to 1. The list must not be empty; after its end it
    /// starts again.
    pub colors: Vec<[f32; 3]>,
    /// The opacity of all quads, 0 to 1.
    pub alpha: f32,
    /// The order of submission.
    pub order: SubmissionOrder,
    /// The seed of [`SubmissionOrder::Shuffled`].
    pub seed: u64,
}

impl Default for Quads {
    /// Eight quads of half opacity in six colours. Each has a size of 2 by 2; they are 0.1 apart and submitted back to
    /// front.
    fn default() -> Self {
        Self {
            count: 8,
            size: [2.0, 2.0],
            spacing: 0.1,
            depths: Vec::new(),
            colors: PALETTE.to_vec(),
            alpha: 0.5,
            order: SubmissionOrder::default(),
            seed: 0,
        }
    }
}

/// Six colours that can still be told apart when they are blended.
const PALETTE: [[f32; 3]; 6] = [
    [0.85, 0.15, 0.15],
    [0.15, 0.65, 0.2],
    [0.15, 0.3, 0.85],
    [0.9, 0.75, 0.1],
    [0.1, 0.7, 0.75],
    [0.7, 0.2, 0.7],
];

/// A stack of quads, two triangles each, as one mesh.
///
/// # Errors
/// A parameter is out of its range.
pub fn quads(parameters: &Quads) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Quads {
    fn check(&self) -> Result<(), Refusal> {
        count_within("count", self.count, [1, u32::MAX])?;
        few_enough("count", self.triangle_count())?;
        all_within("size", &self.size, LENGTH)?;
        within("spacing", self.spacing, [0.0, COORDINATE[1]])?;
        all_within("depths", &self.depths, COORDINATE)?;
        all_within("colors", self.colors.as_flattened(), FRACTION)?;
        within("alpha", self.alpha, FRACTION)?;
        // The depth of the last quad, if the depth of the first is 0.
        let deepest = self.spacing * (self.count - 1) as f32;
        within("spacing", deepest, [0.0, COORDINATE[1]])?;
        if self.colors.is_empty() {
            let remedy = "Give at least one colour, or leave `colors` out.";
            return Err(refusal("colors", "`colors` is empty", remedy));
        }
        if !self.depths.is_empty() && self.depths.len() != self.count as usize {
            let (depths, count) = (self.depths.len(), self.count);
            let what = format!("{depths} `depths` for a `count` of {count}");
            return Err(refusal(
                "depths",
                what,
                "Give as many, or leave one of the two out.",
            ));
        }
        Ok(())
    }

    fn triangle_count(&self) -> u64 {
        2 * u64::from(self.count)
    }

    fn vertex_count(&self) -> u64 {
        4 * u64::from(self.count)
    }

    fn has_colors(&self) -> bool {
        true
    }

    fn build(&self) -> Mesh {
        let even = (0..self.count).map(|i| i as f32 * self.spacing);
        let depths = if self.depths.is_empty() {
            even.collect()
        } else {
            self.depths.clone()
        };
        let mut vertices = Vec::with_capacity(4 * depths.len());
        let mut triangles = Vec::with_capacity(2 * depths.len());
        for i in self.order.of(&depths, self.seed) {
            let first = vertices.len() as u32;
            vertices.extend(self.corners(depths[i], self.colors[i % self.colors.len()]));
            triangles.extend([[0, 1, 2], [0, 2, 3]].map(|t| t.map(|corner| first + corner)));
        }
        Mesh::new("quads", vertices, triangles)
    }
}

impl Quads {
    fn corners(&self, depth: f32, [r, g, b]: [f32; 3]) -> [Vertex; 4] {
        let [width, height] = self.size;
        [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)].map(|(x, y)| Vertex {
            position: Vec3::new(x * width, y * height, -depth).as_dvec3(),
            normal: Vec3::Z,
            color: Rgba::new(r, g, b, self.alpha),
        })
    }
}
