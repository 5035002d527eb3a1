//! Arrows along a flow: a sparse glyph representation, as in figure 10 of Lindholm et al. 2015.

use super::flow::Seeds;
use super::limits::{LENGTH, count_within, few_enough, within};
use super::tube::{self, Ring};
use super::{Generator, Refusal, WHITE, checked, named};
use crate::error::Result;
use crate::scene::mesh::Mesh;

/// Arrows as closed surfaces. Each starts at its seed.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrows {
    /// The flow, and the points where the arrows start.
    pub seeds: Seeds,
    /// The length of an arrow where the flow has speed 1, 1e-6 to 1e6. Other arrows are longer or shorter in
    /// proportion.
    pub length: f32,
    /// Sides of shaft and head, 3 to 1,000.
    pub sides: u32,
}

impl Default for Arrows {
    /// A hundred arrows in the default swirl.
    fn default() -> Self {
        Self {
            seeds: Seeds::default(),
            length: 0.4,
            sides: 12,
        }
    }
}

/// The radii of shaft and head and the start of the head, as parts of an arrow's length.
const SHAFT: f64 = 0.04;
const HEAD: f64 = 0.12;
const NECK: f64 = 0.65;
/// An arrow shorter than this part of `length` is left out, because there is hardly any flow.
const SHORTEST: f64 = 1e-3;

/// Arrows along a flow. There is no arrow where the flow stands still.
///
/// # Errors
/// A parameter is out of its range.
pub fn arrows(parameters: &Arrows) -> Result<Mesh> {
    checked(parameters)
}

impl Generator for Arrows {
    fn check(&self) -> Result<(), Refusal> {
        self.seeds.check()?;
        within("length", self.length, LENGTH)?;
        count_within("sides", self.sides, [3, 1000])?;
        few_enough("count", self.triangle_count())
    }

    /// An upper bound: there may be fewer arrows than seeds.
    fn triangle_count(&self) -> u64 {
        u64::from(self.seeds.count) * tube::triangles_of(3, u64::from(self.sides))
    }

    fn vertex_count(&self) -> u64 {
        u64::from(self.seeds.count) * tube::vertices_of(3, u64::from(self.sides))
    }

    fn build(&self) -> Mesh {
        let mut mesh = named("arrows", self);
        for start in self.seeds.points() {
            let velocity = self.seeds.flow.velocity(start);
            let speed = velocity.length();
            if speed < SHORTEST {
                continue;
            }
            let arrow = velocity * f64::from(self.length);
            let scale = arrow.length();
            let ring = |part: f64, radius: f64| Ring {
                centre: start + arrow * part,
                radius: radius * scale,
            };
            let rings = [ring(0.0, SHAFT), ring(NECK, SHAFT), ring(NECK, HEAD)];
            tube::add(&mut mesh, &rings, [start, start + arrow], self.sides);
        }
        mesh.painted(WHITE)
    }
}
