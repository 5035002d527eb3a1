//! Slices through a volume, as a volume renderer with slices submits them.

use glam::{DVec3, Vec3};

use super::grid::Grid;
use super::limits::{FRACTION, LENGTH, count_within, few_enough, within};
use super::{Generator, Refusal, SubmissionOrder, checked, named};
use crate::error::Result;
use crate::fragment::Rgba;
use crate::scene::mesh::{Mesh, Vertex};

/// Slices through a cloud. They are parallel to the xy plane, at equal distances from z = `size`/2 (the first) to
/// -`size`/2. Each slice is a grid with a colour and an opacity per vertex. The cloud fades to nothing towards the
/// sides of its cube.
#[derive(Clone, Debug, PartialEq)]
pub struct Slices {
    /// The number of slices, 1 to 10,000,000 divided by `cells` squared.
    pub count: u32,
    /// The edge of the cube that the slices fill, 1e-6 to 1e6.
    pub size: f32,
    /// Cells along each edge of a slice, 1 to 3162.
    pub cells: u32,
    /// The opacity of a slice where the cloud is densest, 0 to 1.
    pub alpha: f32,
    /// The order of submission.
    pub order: SubmissionOrder,
    /// The seed of [`SubmissionOrder::Shuffled`].
    pub seed: u64,
}

impl Default for Slices {
    /// 64 slices through a cube with edges of 2, back to front.
    fn default() -> Self {
        Self {
            count: 64,
            size: 2.0,
            cells: 24,
            alpha: 0.1,
            order: SubmissionOrder::default(),
            seed: 0,
        }
    }
}

/// Slices through a cloud, as one mesh.
///
/// # Errors
/// A parameter is out of its range.
pub fn slices(parameters: &Slices) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Slices {
    fn check(&self) -> Result<(), Refusal> {
        count_within("count", self.count, [1, u32::MAX])?;
        within("size", self.size, LENGTH)?;
        // This keeps the product below in range.
        count_within("cells", self.cells, [1, 3162])?;
        within("alpha", self.alpha, FRACTION)?;
        few_enough("count", self.triangle_count())
    }

    fn triangle_count(&self) -> u64 {
        Grid::open(self.cells, self.cells)
            .triangle_count()
            .saturating_mul(u64::from(self.count))
    }

    fn vertex_count(&self) -> u64 {
        Grid::open(self.cells, self.cells)
            .vertex_count()
            .saturating_mul(u64::from(self.count))
    }

    fn has_colors(&self) -> bool {
        true
    }

    fn build(&self) -> Mesh {
        let depths: Vec<f32> = (0..self.count).map(|i| self.depth(i)).collect();
        let mut mesh = named("slices", self);
        for i in self.order.of(&depths, self.seed) {
            let z = 1.0 - 2.0 * f64::from(depths[i]);
            Grid::open(self.cells, self.cells).add_to(&mut mesh, |u, v| {
                self.vertex(DVec3::new(2.0 * u - 1.0, 2.0 * v - 1.0, z))
            });
        }
        Mesh::new(mesh.name, mesh.vertices, mesh.triangles)
    }
}

impl Slices {
    /// The place of a slice: 0 for the first, 1 for the last. A single slice is in the middle.
    fn depth(&self, slice: u32) -> f32 {
        match self.count {
            1 => 0.5,
            count => slice as f32 / (count - 1) as f32,
        }
    }

    /// A point of the cube from -1 to 1.
    fn vertex(&self, point: DVec3) -> Vertex {
        let density = density(point) as f32;
        let [r, g, b] = color(density);
        Vertex {
            position: point * f64::from(self.size) / 2.0,
            normal: Vec3::Z,
            color: Rgba::new(r, g, b, self.alpha * density),
        }
    }
}

/// The density of three soft balls in the cube from -1 to 1. It is between 0 and 1, and 0 on the cube's surface.
fn density(point: DVec3) -> f64 {
    /// The middle of each ball, and how fast its density falls.
    const BALLS: [(DVec3, f64); 3] = [
        (DVec3::new(-0.2, 0.1, 0.0), 5.0),
        (DVec3::new(0.35, -0.25, 0.3), 9.0),
        (DVec3::new(0.15, 0.4, -0.35), 12.0),
    ];
    let clear = BALLS.map(|(middle, rate)| 1.0 - (-rate * point.distance_squared(middle)).exp());
    let window = (DVec3::ONE - point * point).element_product();
    window * (1.0 - clear.into_iter().product::<f64>())
}

/// The colour of a density: blue where the cloud is thin, then white, then orange where it is dense.
fn color(density: f32) -> [f32; 3] {
    const THIN: Vec3 = Vec3::new(0.15, 0.3, 0.8);
    const MIDDLE: Vec3 = Vec3::new(0.9, 0.9, 0.85);
    const DENSE: Vec3 = Vec3::new(0.95, 0.45, 0.1);
    let color = if density < 0.5 {
        THIN.lerp(MIDDLE, density * 2.0)
    } else {
        MIDDLE.lerp(DENSE, density * 2.0 - 1.0)
    };
    color.to_array()
}
