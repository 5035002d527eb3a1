//! A tube along a curve that winds around a torus: a closed surface that crosses itself in every view.

use std::f64::consts::TAU;

use glam::DVec3;

use super::grid::Grid;
use super::limits::{LENGTH, count_within, few_enough, refusal, within};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::{Mesh, Vertex};

/// A (p, q) torus knot around the z axis, as a closed tube.
#[derive(Clone, Debug, PartialEq)]
pub struct TorusKnot {
    /// How often the knot goes around the axis, 1 to 100.
    pub p: u32,
    /// How often the knot goes through the torus's hole, 0 to 100. It has no common divisor with `p`. 0 gives a plain
    /// torus.
    pub q: u32,
    /// The radius of the torus's core, 1e-6 to 1e6.
    pub radius: f32,
    /// The distance of the curve from the core, 0 to 1e6 and less than `radius`.
    pub winding: f32,
    /// The radius of the tube, 1e-6 to 1e6. A tube too thick for its curve goes through itself.
    pub tube: f32,
    /// The number of pieces along the curve, 3 to 3,333,333.
    pub segments: u32,
    /// The number of sides of the tube, 3 to 3,333,333.
    pub sides: u32,
}

impl Default for TorusKnot {
    /// A trefoil.
    fn default() -> Self {
        Self {
            p: 2,
            q: 3,
            radius: 1.0,
            winding: 0.45,
            tube: 0.2,
            segments: 256,
            sides: 24,
        }
    }
}

/// A torus knot. Every edge belongs to two triangles.
///
/// # Errors
/// A parameter is out of its range.
pub fn torus_knot(parameters: &TorusKnot) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for TorusKnot {
    fn check(&self) -> Result<(), Refusal> {
        count_within("p", self.p, [1, 100])?;
        count_within("q", self.q, [0, 100])?;
        within("radius", self.radius, LENGTH)?;
        within("winding", self.winding, [0.0, LENGTH[1]])?;
        within("tube", self.tube, LENGTH)?;
        count_within("segments", self.segments, [3, u32::MAX])?;
        count_within("sides", self.sides, [3, u32::MAX])?;
        few_enough("segments", self.triangle_count())?;
        if self.winding >= self.radius {
            let what = format!("`winding` is {} and `radius` {}", self.winding, self.radius);
            return Err(refusal(
                "winding",
                what,
                "Make `winding` less than `radius`.",
            ));
        }
        let divisor = greatest_common_divisor(self.p, self.q);
        if divisor > 1 {
            let what = format!("`p` and `q` are both divisible by {divisor}");
            return Err(refusal(
                "q",
                what,
                "That makes several curves in one place; divide both by it.",
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
        let mut mesh = named("torus-knot", self);
        self.grid().add_to(&mut mesh, |u, v| {
            let (sin, cos) = (TAU * u).sin_cos();
            let frame = self.frame(TAU * v);
            let outwards = frame.away * cos + frame.across * sin;
            Vertex {
                position: frame.point + outwards * f64::from(self.tube),
                normal: outwards.as_vec3(),
                ..Vertex::default()
            }
        });
        mesh.painted(WHITE)
    }
}

/// A point of the curve, and two directions across the curve at this point. Both are the same again when the curve
/// closes.
struct Frame {
    point: DVec3,
    /// The direction away from the torus.
    away: DVec3,
    /// The direction along the torus.
    across: DVec3,
}

impl TorusKnot {
    fn grid(&self) -> Grid {
        Grid {
            cells: [self.sides, self.segments],
            closed: [true, true],
        }
    }

    fn frame(&self, angle: f64) -> Frame {
        let [p, q] = [self.p, self.q].map(f64::from);
        let [radius, winding] = [self.radius, self.winding].map(f64::from);
        let (sin_p, cos_p) = (p * angle).sin_cos();
        let (sin_q, cos_q) = (q * angle).sin_cos();
        let outwards = DVec3::new(cos_p, sin_p, 0.0);
        let around = DVec3::new(-sin_p, cos_p, 0.0);
        // The torus's normal. It is perpendicular to the curve, which runs in the torus.
        let away = outwards * cos_q + DVec3::Z * sin_q;
        let inward_turn = DVec3::Z * cos_q - outwards * sin_q;
        let tangent = around * (p * (radius + winding * cos_q)) + inward_turn * (q * winding);
        Frame {
            point: outwards * radius + away * winding,
            away,
            across: tangent.normalize().cross(away),
        }
    }
}

fn greatest_common_divisor(a: u32, b: u32) -> u32 {
    if b == 0 {
        a
    } else {
        greatest_common_divisor(b, a % b)
    }
}
