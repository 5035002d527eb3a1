//! The shell of a cone that is open at its ends, such as a beam.

use std::f64::consts::TAU;

use glam::DVec3;

use super::grid::Grid;
use super::limits::{LENGTH, count_within, few_enough, refusal, within};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::{Mesh, Vertex};

/// A conical shell around the y axis, from y = -`height`/2 to `height`/2. Both ends are open: a ray along the axis
/// meets no surface, and a ray across it meets two.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    /// The radius at the lower end, 0 to 1e6.
    pub bottom: f32,
    /// The radius at the upper end, 0 to 1e6. At most one of the two radii may be 0.
    pub top: f32,
    /// The distance from one end to the other, 1e-6 to 1e6.
    pub height: f32,
    /// The number of flat sides that approximate the round shell, 3 to 10,000,000.
    pub sides: u32,
}

impl Default for Cone {
    /// A cone that is as wide as high, with its apex on top.
    fn default() -> Self {
        Self {
            bottom: 1.0,
            top: 0.0,
            height: 2.0,
            sides: 64,
        }
    }
}

/// A conical shell. A side has one triangle if it ends in an apex, and two otherwise.
///
/// # Errors
/// A parameter is out of its range.
pub fn cone(parameters: &Cone) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Cone {
    fn check(&self) -> Result<(), Refusal> {
        within("bottom", self.bottom, [0.0, LENGTH[1]])?;
        within("top", self.top, [0.0, LENGTH[1]])?;
        within("height", self.height, LENGTH)?;
        count_within("sides", self.sides, [3, u32::MAX])?;
        few_enough("sides", self.triangle_count())?;
        if self.bottom == 0.0 && self.top == 0.0 {
            return Err(refusal(
                "bottom",
                "`bottom` and `top` are both 0",
                "Give one of them a radius.",
            ));
        }
        Ok(())
    }

    fn triangle_count(&self) -> u64 {
        self.grid().triangle_count()
    }

    fn vertex_count(&self) -> u64 {
        self.grid().vertex_count()
    }

    fn build(&self) -> Mesh {
        let mut mesh = named("cone", self);
        let [bottom, top, height] = [self.bottom, self.top, self.height].map(f64::from);
        self.grid().add_to(&mut mesh, |u, v| {
            let (sin, cos) = (TAU * u).sin_cos();
            let radius = bottom + (top - bottom) * v;
            let outwards = DVec3::new(height * cos, bottom - top, -height * sin);
            Vertex {
                position: DVec3::new(radius * cos, height * (v - 0.5), -radius * sin),
                normal: outwards.normalize().as_vec3(),
                ..Vertex::default()
            }
        });
        mesh.drop_degenerate();
        mesh.painted(WHITE)
    }
}

impl Cone {
    fn grid(&self) -> Grid {
        Grid {
            cells: [self.sides, 1],
            closed: [true, false],
        }
    }
}
