//! The seed of generators that scatter things at random.

use super::keys::Keys;
use crate::error::Result;

/// TOML's whole numbers are signed and have 64 bits.
pub(super) fn seed(keys: &Keys) -> Result<u64> {
    let seed = keys.integer("seed", &(0..=i64::MAX as u64))?;
    Ok(seed.unwrap_or(0))
}
