//! The ranges of allowed numbers, in words and as a test.

/// A range of numbers.
pub(super) struct Limits {
    /// The range in words, to complete 'this must be'.
    pub(super) words: &'static str,
    /// Whether a finite number is within the range.
    pub(super) allow: fn(f64) -> bool,
}

impl Limits {
    /// Whether a number is finite, in the range of f32, and within this range.
    pub(super) fn hold(&self, number: f64) -> bool {
        number.abs() <= f64::from(f32::MAX) && (self.allow)(number)
    }
}

/// Colours and opacities.
pub(super) const FRACTION: Limits = Limits {
    words: "a number from 0 to 1",
    allow: |x| (0.0..=1.0).contains(&x),
};

/// Positions and directions.
pub(super) const ANY: Limits = Limits {
    words: "a finite number that fits 32 bits",
    allow: |_| true,
};

/// Distances.
pub(super) const POSITIVE: Limits = Limits {
    words: "a finite number greater than 0",
    allow: |x| x > 0.0,
};

/// A field of view.
pub(super) const OPENING: Limits = Limits {
    words: "an angle in degrees, more than 0 and less than 180",
    allow: |x| x > 0.0 && x < 180.0,
};

/// Scale factors. Factors beyond these are typing errors, and would take normals out of range.
pub(super) const FACTOR: Limits = Limits {
    words: "a factor other than 0, of a size from 1e-6 to 1e6",
    allow: |x| (1e-6..=1e6).contains(&x.abs()),
};

/// Extinctions per world unit.
pub(super) const DENSITY: Limits = Limits {
    words: "a number from 0 to 1e6",
    allow: |x| (0.0..=1e6).contains(&x),
};

/// Sampling distances in voxels. A smaller distance would take for ever; with a larger one hardly anything is sampled.
pub(super) const STEP: Limits = Limits {
    words: "a number of voxels from 0.001 to 1000",
    allow: |x| (1e-3..=1e3).contains(&x),
};
