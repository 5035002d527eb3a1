//! The checks that generators share.

use super::{MAX_TRIANGLES, Refusal};

/// Checks that a number is finite and in its range.
pub(super) fn within(key: &'static str, value: f32, [low, high]: [f32; 2]) -> Result<(), Refusal> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(refusal(
        key,
        format!("`{key}` is {value}"),
        format!("Give a number from {low} to {high}."),
    ))
}

/// Checks that all numbers are finite and in their range.
pub(super) fn all_within(
    key: &'static str,
    values: &[f32],
    range: [f32; 2],
) -> Result<(), Refusal> {
    values
        .iter()
        .try_for_each(|&value| within(key, value, range))
}

/// Checks that a whole number is in its range.
pub(super) fn count_within(
    key: &'static str,
    value: u32,
    [low, high]: [u32; 2],
) -> Result<(), Refusal> {
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(refusal(
        key,
        format!("`{key}` is {value}"),
        format!("Give a whole number from {low} to {high}."),
    ))
}

/// Checks that the number of triangles is not too large. `key` is the parameter to reduce.
pub(super) fn few_enough(key: &'static str, triangles: u64) -> Result<(), Refusal> {
    if triangles <= MAX_TRIANGLES {
        return Ok(());
    }
    Err(refusal(
        key,
        format!("this makes {triangles} triangles, and at most {MAX_TRIANGLES} are generated"),
        format!("Give a smaller `{key}`."),
    ))
}

/// The fault of a parameter.
pub(super) fn refusal(
    key: &'static str,
    what: impl Into<String>,
    remedy: impl Into<String>,
) -> Refusal {
    Refusal {
        key,
        what: what.into(),
        remedy: remedy.into(),
    }
}

/// Lengths and coordinates. They are far from the largest f32, so that nothing that is computed from them overflows.
pub(super) const COORDINATE: [f32; 2] = [-1e6, 1e6];
/// Sizes.
pub(super) const LENGTH: [f32; 2] = [1e-6, 1e6];
/// Colours and opacities.
pub(super) const FRACTION: [f32; 2] = [0.0, 1.0];
