//! An axis-aligned box.

use glam::DVec3;

/// The smallest box with faces along the axes that holds some points. In the scene's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest coordinates.
    pub min: DVec3,
    /// The corner with the largest coordinates.
    pub max: DVec3,
}

impl Bounds {
    /// The box of some points, or `None` if there is no point.
    pub fn of(points: impl IntoIterator<Item = DVec3>) -> Option<Self> {
        points
            .into_iter()
            .map(|point| Self {
                min: point,
                max: point,
            })
            .reduce(Self::joined)
    }

    /// The box of both.
    #[must_use]
    pub fn joined(self, other: Self) -> Self {
        Self {
            min: self.min.min(other.min),
            max: self.max.max(other.max),
        }
    }

    /// Its middle.
    pub fn centre(&self) -> DVec3 {
        // Halved before they are added: the sum of two of the largest f32 is still exact, but this stays in range.
        self.min * 0.5 + self.max * 0.5
    }

    /// Width, height and depth, none of them negative.
    pub fn size(&self) -> DVec3 {
        self.max - self.min
    }

    /// Its eight corners.
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|i| {
            let pick = |bit: usize, low: f64, high: f64| if i >> bit & 1 == 0 { low } else { high };
            DVec3::new(
                pick(0, self.min.x, self.max.x),
                pick(1, self.min.y, self.max.y),
                pick(2, self.min.z, self.max.z),
            )
        })
    }
}
