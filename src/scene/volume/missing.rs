//! Samples that are not numbers. Simulations, masks and resampled images write NaN where there is nothing.

use super::check::{EMPTY, LARGEST};

/// The meaning of a sample that is NaN or infinite.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(in crate::low_level::scene) enum Missing {
    /// The sample is empty: the cells around it have no density.
    #[default]
    Empty,
    /// The sample has this finite value.
    Value(f32),
}

/// Counts of samples that are replaced.
#[derive(Debug, Default, PartialEq, Eq)]
struct Count {
    nan: usize,
    infinite: usize,
    /// Finite samples beyond the range that is kept.
    large: usize,
}

/// Replaces samples that are not numbers, and moves samples that are too large to the largest number that is kept.
/// Returns a sentence with their numbers.
pub(super) fn replace(samples: &mut [f32], missing: Missing) -> Option<String> {
    let value = match missing {
        Missing::Empty => EMPTY,
        Missing::Value(value) => value.clamp(-LARGEST, LARGEST),
    };
    let mut count = Count::default();
    for sample in samples.iter_mut() {
        if sample.abs() <= LARGEST {
            continue;
        }
        if sample.is_finite() {
            count.large += 1;
            *sample = LARGEST.copysign(*sample);
        } else {
            let kind = if sample.is_nan() {
                &mut count.nan
            } else {
                &mut count.infinite
            };
            *kind += 1;
            *sample = value;
        }
    }
    count.sentence(samples.len(), missing)
}

impl Count {
    fn sentence(&self, all: usize, missing: Missing) -> Option<String> {
        let mut parts = Vec::new();
        let bad = self.nan + self.infinite;
        if bad > 0 {
            let Self { nan, infinite, .. } = self;
            let meaning = match missing {
                Missing::Empty => {
                    "they are empty, and so are the cells around them (`nan` in [[volume]] gives them a value)"
                        .to_owned()
                }
                Missing::Value(value) => format!("they are taken as {value}, as `nan` says"),
            };
            parts.push(format!(
                "{bad} of {all} samples are not numbers ({nan} NaN, {infinite} infinite): {meaning}"
            ));
        }
        if self.large > 0 {
            parts.push(format!(
                "{} of {all} samples are beyond {LARGEST:e}, and are taken as that",
                self.large
            ));
        }
        (!parts.is_empty()).then(|| parts.join("; "))
    }
}
