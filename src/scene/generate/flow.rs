//! Flows, and the lines along them.

use std::f64::consts::TAU;

use glam::DVec3;

use super::Refusal;
use super::limits::{COORDINATE, LENGTH, all_within, count_within, within};
use super::volumes::{Field, Swirl};
use crate::scene::chance::Chance;

/// A steady flow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Flow {
    /// A vortex with a jet. Of its lattice only the size matters.
    Swirl(Swirl),
    /// A rigid rotation about the z axis, with a period of 2 pi.
    Rotation,
    /// A bundle along the z axis that is tied together at z = 0. A line's distance from the axis grows as sqrt(1 + z
    /// squared).
    Bundle,
}

impl Default for Flow {
    fn default() -> Self {
        Self::Swirl(Swirl::default())
    }
}

impl Flow {
    /// The flow at a point of the world.
    pub fn velocity(&self, point: DVec3) -> DVec3 {
        match self {
            Self::Swirl(swirl) => swirl.velocity(point),
            Self::Rotation => DVec3::Z.cross(point),
            Self::Bundle => {
                let apart = point.z / (1.0 + point.z * point.z);
                DVec3::new(point.x * apart, point.y * apart, 1.0)
            }
        }
    }

    fn check(&self) -> Result<(), Refusal> {
        match self {
            Self::Swirl(swirl) => {
                within("size", swirl.lattice.size, LENGTH)?;
                swirl.check()
            }
            Self::Rotation | Self::Bundle => Ok(()),
        }
    }
}

/// A flow, and the points at which it is shown. They are drawn from a box, with even density.
#[derive(Clone, Debug, PartialEq)]
pub struct Seeds {
    /// The flow.
    pub flow: Flow,
    /// The number of points, 1 to 1,000,000.
    pub count: u32,
    /// The box's centre, coordinates -1e6 to 1e6.
    pub centre: [f32; 3],
    /// The lengths of the box's edges, 0 to 1e6.
    pub extent: [f32; 3],
    /// The seed of the points. The same seed gives the same points.
    pub seed: u64,
}

impl Default for Seeds {
    /// A hundred points of the default swirl.
    fn default() -> Self {
        Self {
            flow: Flow::default(),
            count: 100,
            centre: [0.0; 3],
            extent: [1.6; 3],
            seed: 0,
        }
    }
}

impl Seeds {
    pub(super) fn check(&self) -> Result<(), Refusal> {
        self.flow.check()?;
        count_within("count", self.count, [1, 1_000_000])?;
        all_within("centre", &self.centre, COORDINATE)?;
        all_within("extent", &self.extent, [0.0, COORDINATE[1]])
    }

    pub(super) fn points(&self) -> impl Iterator<Item = DVec3> {
        let mut chance = Chance::new(self.seed);
        let centre = DVec3::from_array(self.centre.map(f64::from));
        let extent = DVec3::from_array(self.extent.map(f64::from));
        (0..self.count).map(move |_| {
            let [x, y, z] = std::array::from_fn(|_| f64::from(chance.between(-0.5, 0.5)));
            centre + extent * DVec3::new(x, y, z)
        })
    }
}

/// One step of the classical fourth-order Runge-Kutta method.
pub fn runge_kutta(velocity: impl Fn(DVec3) -> DVec3, point: DVec3, step: f64) -> DVec3 {
    let first = velocity(point);
    let second = velocity(point + first * (step / 2.0));
    let third = velocity(point + second * (step / 2.0));
    let fourth = velocity(point + third * step);
    point + (first + 2.0 * (second + third) + fourth) * (step / 6.0)
}

/// The streamline through a point, in steps of equal length. Half of it lies upstream and half downstream. It ends
/// early where the flow stands still.
pub(super) fn streamline(flow: &Flow, seed: DVec3, length: f64, steps: u32) -> Vec<DVec3> {
    let direction = |point| flow.velocity(point).normalize_or_zero();
    let step = length / f64::from(steps);
    let walk = |from: DVec3, step: f64, count: u32| -> Vec<DVec3> {
        let next = |point: &DVec3| {
            let moved = runge_kutta(direction, *point, step);
            // At least half a step: around a point where the flow stands still, the directions cancel.
            (moved.distance(*point) > step.abs() / 2.0).then_some(moved)
        };
        let points = std::iter::successors(Some(from), next);
        points.take(count as usize + 1).collect()
    };
    let mut points = walk(seed, -step, steps / 2);
    points.reverse();
    points.extend(walk(seed, step, steps - steps / 2).into_iter().skip(1));
    points
}

/// A point of the circle of radius 1 that two directions span.
pub(super) fn around([right, up]: [DVec3; 2], part: f64) -> DVec3 {
    let (sin, cos) = (TAU * part).sin_cos();
    right * cos + up * sin
}
