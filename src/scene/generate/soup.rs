//! Soups: random triangles of random colours.

use glam::Vec3;

use super::limits::{FRACTION, LENGTH, all_within, count_within, few_enough, refusal, within};
use super::{Generator, Refusal, checked};
use crate::error::Result;
use crate::fragment::Rgba;
use crate::scene::chance::Chance;
use crate::scene::mesh::{Mesh, Vertex};
use crate::scene::normals;

/// Random triangles. The seed decides everything about them.
#[derive(Clone, Debug, PartialEq)]
pub struct Soup {
    /// The number of triangles, 1 to 20,000,000. A larger soup with the same seed starts with the same triangles.
    pub count: u32,
    /// The triangles' middles are in a cube from -`extent` to `extent`, 1e-6 to 1e6.
    pub extent: f32,
    /// The corners of a triangle are in a cube. These are its smallest and its largest edge, 1e-6 to 1e6.
    pub triangle_size: [f32; 2],
    /// The lowest and the highest opacity of a triangle, 0 to 1. Its vertices have the same.
    pub alpha: [f32; 2],
    /// The seed.
    pub seed: u64,
}

impl Default for Soup {
    /// 1000 triangles in a cube from -1 to 1, with sizes and opacities of 0.2 to 0.8.
    fn default() -> Self {
        Self {
            count: 1000,
            extent: 1.0,
            triangle_size: [0.2, 0.8],
            alpha: [0.2, 0.8],
            seed: 0,
        }
    }
}

/// Random triangles, as one mesh. No two share a vertex.
///
/// # Errors
/// A parameter is out of its range.
pub fn soup(parameters: &Soup) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Soup {
    fn check(&self) -> Result<(), Refusal> {
        count_within("count", self.count, [1, u32::MAX])?;
        few_enough("count", self.triangle_count())?;
        within("extent", self.extent, LENGTH)?;
        all_within("triangle_size", &self.triangle_size, LENGTH)?;
        all_within("alpha", &self.alpha, FRACTION)?;
        let pairs = [("triangle_size", self.triangle_size), ("alpha", self.alpha)];
        for (key, [low, high]) in pairs {
            if low > high {
                let what = format!("`{key}` starts at {low} and ends at {high}");
                return Err(refusal(key, what, "Put the smaller number first."));
            }
        }
        Ok(())
    }

    fn triangle_count(&self) -> u64 {
        u64::from(self.count)
    }

    fn vertex_count(&self) -> u64 {
        3 * u64::from(self.count)
    }

    fn has_colors(&self) -> bool {
        true
    }

    fn build(&self) -> Mesh {
        let mut chance = Chance::new(self.seed);
        let mut vertices = Vec::with_capacity(3 * self.count as usize);
        vertices.extend((0..self.count).flat_map(|_| self.triangle(&mut chance)));
        let triangles = (0..self.count).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]);
        Mesh::new("soup", vertices, triangles.collect())
    }
}

impl Soup {
    /// The order of the draws is part of what a seed means: middle, size, corners, colour, opacity.
    fn triangle(&self, chance: &mut Chance) -> [Vertex; 3] {
        let middle = vector(chance, self.extent);
        let [smallest, largest] = self.triangle_size;
        let half = chance.between(smallest, largest) / 2.0;
        let positions = [(); 3].map(|()| (middle + vector(chance, half)).as_dvec3());
        let [r, g, b] = [(); 3].map(|()| chance.unit());
        let color = Rgba::new(r, g, b, chance.between(self.alpha[0], self.alpha[1]));
        let normal = normals::face(positions);
        positions.map(|position| Vertex {
            position,
            normal,
            color,
        })
    }
}

/// A random vector in a cube from -`half` to `half`.
fn vector(chance: &mut Chance, half: f32) -> Vec3 {
    Vec3::from_array([(); 3].map(|()| chance.between(-half, half)))
}
