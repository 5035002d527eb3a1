//! Resolves on drivers that end a shader's loops early ([`Quirks::loop_limit`]). A pixel that reached the limit would lose
//! fragments.

use super::options::LARGEST_NETWORK;
use crate::error::{Error, Result};
use crate::gl::{LoopLimit, Quirks};
use crate::scene::Volume;

/// For iterations that are not counted here.
const RESERVE: u64 = 5_535;
/// Records that ppDP takes in one iteration (`pp_dp.glsl`).
const STRIDE: u64 = 4;
/// The largest array of ppDP.
const LARGEST_PEEL: u32 = 64;
/// In the worst order, the number of elements that insertion into a sorted array moves is the square of the complexity.
const INSERTION: u32 = 200;

/// The size of ppDP's array for a pixel of so many fragments: `peel`, or a larger one if the driver needs it.
///
/// # Errors
/// If no array is large enough.
pub(super) fn peel_that_fits(quirks: Quirks, peel: u32, complexity: u32) -> Result<u32> {
    let Some(limit) = quirks.loop_limit else {
        return Ok(peel);
    };
    let fits = |peel: u32| {
        let (peel, complexity) = (u64::from(peel), u64::from(complexity));
        let subpasses = complexity.div_ceil(peel);
        // The list, and clearing and resolving the array.
        subpasses * (complexity.div_ceil(STRIDE) + 2 * peel) <= most(limit)
    };
    let larger = [16, 32, LARGEST_PEEL].into_iter().filter(|&n| n > peel);
    std::iter::once(peel)
        .chain(larger)
        .find(|&peel| fits(peel))
        .ok_or_else(|| Error::Driver {
            what: format!(
                "a pixel has {complexity} fragments, and this driver ends a shader's loops after {} iterations",
                limit.iterations
            ),
            remedy: "peel its layers instead (depth-peeling), or render on another driver"
                .into(),
        })
}

/// Whether ppDP may insert with a loop.
pub(super) fn insertion_fits(quirks: Quirks, complexity: u32) -> bool {
    quirks.loop_limit.is_none() || complexity <= INSERTION
}

/// Whether a static array of `array` elements may keep the nearest of so many fragments by insertion with a loop, which in
/// the worst order moves all of its elements for each fragment.
pub(super) fn keeping_by_insertion_fits(quirks: Quirks, array: u32, complexity: u32) -> bool {
    let (array, complexity) = (u64::from(array), u64::from(complexity));
    let moved = complexity.saturating_sub(array) * (array + 1);
    let iterations = sorting(array) + moved + 2 * array;
    quirks
        .loop_limit
        .is_none_or(|limit| iterations <= most(limit))
}

/// Checks that it may keep them at all: a loop walks the list, and a loop sorts the largest arrays.
///
/// # Errors
/// If the list is too long.
pub(super) fn expect_keeping_fits(quirks: Quirks, array: u32, complexity: u32) -> Result<()> {
    let Some(limit) = quirks.loop_limit else {
        return Ok(());
    };
    let iterations = sorting(u64::from(array)) + u64::from(complexity) + 2 * u64::from(array);
    if complexity <= array || iterations <= most(limit) {
        return Ok(());
    }
    Err(Error::Driver {
        what: format!(
            "the nearest of a pixel's {complexity} fragments are not to be found: this driver ends a shader's loops \
             after {} iterations",
            limit.iterations
        ),
        remedy: "keep the first of each list instead, or peel the layers (depth-peeling)".into(),
    })
}

/// Checks that ppDP may insert so many fragments into an array that is too large to be written out. In the worst order each
/// of them moves all elements, and pixels that are shaded along with it sort theirs.
///
/// # Errors
/// If it would take too many iterations.
pub(super) fn expect_inserting_fits(quirks: Quirks, array: u32, complexity: u32) -> Result<()> {
    let Some(limit) = quirks.loop_limit else {
        return Ok(());
    };
    let (elements, fragments) = (u64::from(array), u64::from(complexity));
    let iterations = sorting(elements) + elements * fragments;
    let inserts = array > LARGEST_NETWORK && complexity > array;
    if !inserts || iterations <= most(limit) {
        return Ok(());
    }
    Err(Error::Driver {
        what: format!(
            "a pixel's {complexity} fragments cannot be peeled with an array of {array}: this driver ends a shader's loops \
             after {} iterations",
            limit.iterations
        ),
        remedy: format!("choose an array of {LARGEST_NETWORK} or less"),
    })
}

/// The most elements that insertion moves to sort an array.
const fn sorting(array: u64) -> u64 {
    array * array / 2
}

/// Checks that the volumes of a scene can be sampled along every ray. In the worst case, no two of the pixels that are
/// shaded together sample at the same time.
///
/// # Errors
/// If a ray through all of them, from corner to corner, would take too many samples.
pub(super) fn expect_samples_fit(quirks: Quirks, volumes: &[Volume]) -> Result<()> {
    let Some(limit) = quirks.loop_limit else {
        return Ok(());
    };
    let steps = volumes.iter().map(Volume::sampling_distance);
    let Some(step) = steps.reduce(f64::min) else {
        return Ok(());
    };
    let longest = |volume: &Volume| {
        let corners = volume.corners();
        let diagonals = (0..4).map(|corner| corners[corner].distance(corners[7 - corner]));
        diagonals.fold(0.0, f64::max)
    };
    let samples = (volumes.iter().map(longest).sum::<f64>() / step).ceil();
    let LoopLimit { iterations, pixels } = limit;
    if samples * pixels as f64 <= most(limit) as f64 {
        return Ok(());
    }
    Err(Error::Driver {
        what: format!(
            "a ray may take {samples} samples in the volumes, and this driver ends the loops of the {pixels} pixels \
             that it shades together after {iterations} iterations"
        ),
        remedy: "give the volumes a larger step, or render with the method exact".into(),
    })
}

fn most(limit: LoopLimit) -> u64 {
    limit.iterations.saturating_sub(RESERVE)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Llvmpipe's.
    fn limited() -> Quirks {
        let limit = LoopLimit {
            iterations: 65_535,
            pixels: 8,
        };
        Quirks {
            loop_limit: Some(limit),
            ..Quirks::default()
        }
    }

    fn unlimited() -> Quirks {
        Quirks::default()
    }

    #[test]
    fn the_array_grows_only_where_the_driver_needs_it() {
        let peel = |complexity| peel_that_fits(limited(), 8, complexity).unwrap();
        assert_eq!([8, 300, 1000, 2000, 3500].map(peel), [8, 8, 8, 32, 64]);
        assert_eq!(peel_that_fits(unlimited(), 8, 1_000_000).unwrap(), 8);
        assert!(peel_that_fits(limited(), 8, 10_000).is_err());
    }

    #[test]
    fn a_large_array_peels_only_what_the_driver_has_the_iterations_for() {
        let fits = |array, complexity| expect_inserting_fits(limited(), array, complexity).is_ok();
        assert!(fits(64, 3000) && fits(128, 3000) && fits(256, 256) && !fits(256, 257));
        assert!(expect_inserting_fits(unlimited(), 256, 1_000_000).is_ok());
    }

    #[test]
    fn the_nearest_are_kept_by_insertion_only_where_the_driver_has_the_iterations() {
        let fits = |array, complexity| keeping_by_insertion_fits(limited(), array, complexity);
        assert!(fits(64, 64) && fits(256, 256) && fits(64, 800) && fits(8, 6_000));
        assert!(!fits(64, 1_000) && !fits(256, 500) && !fits(8, 8_000));
        assert!(keeping_by_insertion_fits(unlimited(), 64, 1_000_000));
        let whole = |array, complexity| expect_keeping_fits(limited(), array, complexity).is_ok();
        assert!(
            whole(64, 50_000) && whole(256, 20_000) && !whole(256, 30_000) && !whole(8, 60_000)
        );
    }
}
