//! Tubes along the streamlines of a flow.

use super::flow::{Seeds, streamline};
use super::limits::{LENGTH, count_within, few_enough, within};
use super::tube::{self, Ring};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::Mesh;

/// Streamlines as closed tubes.
#[derive(Clone, Debug, PartialEq)]
pub struct Streamlines {
    /// The flow, and the points through which the lines go, one point per line.
    pub seeds: Seeds,
    /// The length of a line, 1e-6 to 1e6. Half of it lies upstream of the seed.
    pub length: f32,
    /// The number of steps along a line, 2 to 100,000.
    pub steps: u32,
    /// The radius of a tube, 1e-6 to 1e6.
    pub tube: f32,
    /// The number of sides of a tube, 3 to 1,000.
    pub sides: u32,
}

impl Default for Streamlines {
    /// A hundred lines of the default swirl.
    fn default() -> Self {
        Self {
            seeds: Seeds::default(),
            length: 1.5,
            steps: 48,
            tube: 0.008,
            sides: 6,
        }
    }
}

/// Streamlines by the classical fourth-order Runge-Kutta method, as closed tubes. A line ends where the flow stands still.
///
/// # Errors
/// A parameter is out of its range.
pub fn streamlines(parameters: &Streamlines) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Streamlines {
    fn check(&self) -> Result<(), Refusal> {
        self.seeds.check()?;
        within("length", self.length, LENGTH)?;
        count_within("steps", self.steps, [2, 100_000])?;
        within("tube", self.tube, LENGTH)?;
        count_within("sides", self.sides, [3, 1000])?;
        few_enough("count", self.triangle_count())
    }

    /// An upper bound: a line that ends early has fewer.
    fn triangle_count(&self) -> u64 {
        let rings = u64::from(self.steps) + 1;
        u64::from(self.seeds.count) * tube::triangles_of(rings, u64::from(self.sides))
    }

    fn vertex_count(&self) -> u64 {
        let rings = u64::from(self.steps) + 1;
        u64::from(self.seeds.count) * tube::vertices_of(rings, u64::from(self.sides))
    }

    fn build(&self) -> Mesh {
        let mut mesh = named("streamlines", self);
        let radius = f64::from(self.tube);
        for seed in self.seeds.points() {
            let line = streamline(&self.seeds.flow, seed, f64::from(self.length), self.steps);
            if let [start, .., end] = line[..] {
                let rings: Vec<_> = line
                    .into_iter()
                    .map(|centre| Ring { centre, radius })
                    .collect();
                tube::add(&mut mesh, &rings, [start, end], self.sides);
            }
        }
        mesh.painted(WHITE)
    }
}
