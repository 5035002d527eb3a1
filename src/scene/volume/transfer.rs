//! Transfer functions: the colour and the density of a stored value.

use glam::DVec3;

use crate::error::{Error, Result};

/// A point of a transfer function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TransferPoint {
    /// The stored value, finite.
    pub value: f32,
    /// Linear RGB, 0 to 1.
    pub color: [f32; 3],
    /// Extinction per world unit, 0 to 1e6. A length l lets exp(-`density` l) of the light through.
    pub density: f32,
}

/// The colour and density of each stored value. They are linear between points, and constant before the first and after
/// the last point.
///
/// A length l of a constant value sends out the light `color` x (1 - exp(-`density` x l)) and lets exp(-`density` x l)
/// of the light behind it through. Two points of the same value make a jump. At the value itself the second point
/// counts.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer {
    points: Vec<TransferPoint>,
}

/// The colour and density of one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Medium {
    /// Linear RGB.
    pub color: DVec3,
    /// Extinction per world unit.
    pub density: f64,
}

impl Medium {
    /// No colour and no density.
    pub const NONE: Self = Self {
        color: DVec3::ZERO,
        density: 0.0,
    };
}

impl Transfer {
    /// The largest density that is allowed.
    pub const MAX_DENSITY: f32 = 1e6;

    /// A transfer function through points, in ascending order of their values.
    ///
    /// # Errors
    /// There is no point, a value is less than the one before it, or a number is out of its range.
    pub fn new(points: Vec<TransferPoint>) -> Result<Self> {
        match fault(&points) {
            None => Ok(Self { points }),
            Some((number, what, remedy)) => Err(Error::scene(
                format!("the transfer function's point {number} {what}"),
                remedy,
            )),
        }
    }

    /// The points, in ascending order of their values.
    pub fn points(&self) -> &[TransferPoint] {
        &self.points
    }

    /// The colour and density of a value. NaN, which means empty, has neither.
    pub fn at(&self, value: f64) -> Medium {
        if value.is_nan() {
            return Medium::NONE;
        }
        let after = self
            .points
            .partition_point(|point| f64::from(point.value) <= value);
        let medium = |point: &TransferPoint| Medium {
            color: DVec3::from_array(point.color.map(f64::from)),
            density: f64::from(point.density),
        };
        if after == 0 {
            return medium(&self.points[0]);
        }
        let from = &self.points[after - 1];
        let Some(to) = self.points.get(after) else {
            return medium(from);
        };
        let [low, high] = [from.value, to.value].map(f64::from);
        let part = (value - low) / (high - low);
        let (from, to) = (medium(from), medium(to));
        Medium {
            color: from.color.lerp(to.color, part),
            density: from.density + (to.density - from.density) * part,
        }
    }
}

impl Default for Transfer {
    /// A white transfer function whose density is the value itself, from 0 to [`Transfer::MAX_DENSITY`].
    fn default() -> Self {
        let point = |value| TransferPoint {
            value,
            color: [1.0; 3],
            density: value,
        };
        Self {
            points: vec![point(0.0), point(Self::MAX_DENSITY)],
        }
    }
}

/// The first wrong point: its number from 1, what is wrong with it, and what to do.
pub(in crate::low_level::scene) fn fault(
    points: &[TransferPoint],
) -> Option<(usize, String, &'static str)> {
    if points.is_empty() {
        return Some((1, "is missing".into(), "Give at least one point."));
    }
    for (i, point) in points.iter().enumerate() {
        let wrong = |what: String, remedy| Some((i + 1, what, remedy));
        if !point.value.is_finite() {
            return wrong(
                format!("has the value {}", point.value),
                "Give a finite number.",
            );
        }
        if !point.color.iter().all(|c| (0.0..=1.0).contains(c)) {
            return wrong(
                format!("has the colour {:?}", point.color),
                "Give three numbers from 0 to 1.",
            );
        }
        if !(0.0..=Transfer::MAX_DENSITY).contains(&point.density) {
            return wrong(
                format!("has the density {}", point.density),
                "Give a number from 0 to 1e6.",
            );
        }
        if i > 0 && point.value < points[i - 1].value {
            return wrong(
                format!(
                    "has the value {}, less than {} before it",
                    point.value,
                    points[i - 1].value
                ),
                "Put the points in the order of their values.",
            );
        }
    }
    None
}
