//! Choosing between the two sorts of a Local Array, if the caller leaves the choice open.

use super::options::{ABufferOptions, ArraySort, SMALLEST_SEGMENT};
use crate::gl::network::odd_even_merge;

/// Whether insertion sorts the Local Arrays. `counts` are the pixels' complexities, `layers` is the largest of them.
///
/// A network compares the same number of pairs for every pixel. Insertion compares about n²/4 pairs for n fragments,
/// but with dynamic indices, which on llvmpipe cost four times as much. So both take equally long if the mean of n²
/// over the covered pixels is the number of the network's pairs. Measured at 1024 x 768: 20 against 191 pairs, 46
/// against 59 ms (random triangles); 100 against 543, 221 against 238 ms (the molecule); 256 against 63, 236 against
/// 151 ms (16 quads); 4096 against 543, 1483 against 541 ms (64 quads).
///
/// A network is also long to compile, so it has to save more than that ([`network_pays`]).
///
/// ppDP alone inserts into a short array. With the loop written out, that was always quicker: by 6 % on the mesh of the
/// bench, and by 31 % on 16 quads.
pub(super) fn inserts(options: &ABufferOptions, counts: &[u32], layers: u32) -> bool {
    match options.sort {
        ArraySort::Insertion => true,
        ArraySort::Network => false,
        ArraySort::Automatic => {
            let written_out = options.pp_dp && !options.pp_ao;
            !written_out && !network_pays(counts, pairs(options, layers) as u64)
        }
    }
}

/// Comparisons that take as long as the driver takes to compile one of a network's pairs. On llvmpipe a pair of up to 32
/// elements took 4 to 5 ms, one of 64 or 128 took 12 to 14 ms (7.4 s and 17 s for all of them), and a comparison 0.35 ns.
const fn compiling_a_pair(pairs: u64) -> u64 {
    match pairs {
        0..=191 => 14_000_000,
        _ => 40_000_000,
    }
}

/// The frames in which a network has to save the time of its compiling. A single frame never would, and a large image is
/// seldom rendered in so few that a driver's cache does not have the program. A small one would take thousands.
const FRAMES: u64 = 30;

fn network_pays(counts: &[u32], pairs: u64) -> bool {
    let (mut squares, mut covered) = (0, 0);
    for &count in counts {
        squares += u64::from(count).pow(2);
        covered += u64::from(count > 0);
    }
    let compiling = compiling_a_pair(pairs) * pairs / FRAMES;
    squares > covered * pairs + compiling
}

/// The number of elements that a network sorts. Elements beyond the deepest pixel's are empty, and need no comparison. But
/// every size is a program that the driver compiles, so there are only those of ppAO's segments.
pub(super) fn network_size(options: &ABufferOptions, layers: u32) -> u32 {
    let filled = layers.next_power_of_two().max(SMALLEST_SEGMENT);
    filled.min(options.array)
}

/// The number of pairs that a network compares.
fn pairs(options: &ABufferOptions, layers: u32) -> usize {
    odd_even_merge(network_size(options, layers) as usize).len()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn inserts(options: &ABufferOptions, counts: &[u32]) -> bool {
        let layers = counts.iter().copied().max().unwrap_or(0);
        super::inserts(options, counts, layers)
    }

    fn automatic(pp_ao: bool, pp_dp: bool) -> ABufferOptions {
        ABufferOptions {
            pp_ao,
            pp_dp,
            ..ABufferOptions::DEFAULT
        }
    }

    #[test]
    fn few_fragments_are_inserted_even_if_some_pixels_have_many() {
        let mut counts = vec![3; 1000];
        counts.extend([0; 500]);
        counts[7] = 40;
        assert!(inserts(&automatic(false, false), &counts));
        assert!(inserts(&automatic(true, false), &counts));
        assert!(inserts(&automatic(true, true), &counts));
    }

    #[test]
    fn many_fragments_of_a_large_image_go_through_a_network() {
        for n in [16, 20, 64, 300] {
            let counts = |pixels| vec![n; pixels];
            assert!(!inserts(&automatic(false, false), &counts(1024 * 768)));
            // The same in small is drawn before a network is compiled.
            assert!(inserts(&automatic(false, false), &counts(64 * 48)), "{n}");
        }
    }

    #[test]
    fn a_network_is_as_large_as_the_deepest_pixel_needs_and_of_few_sizes() {
        let size = |array, layers| {
            let options = ABufferOptions {
                array,
                ..ABufferOptions::DEFAULT
            };
            network_size(&options, layers)
        };
        let sizes = [0, 1, 8, 9, 33, 64, 65, 1000].map(|layers| size(64, layers));
        assert_eq!(sizes, [8, 8, 8, 16, 64, 64, 64, 64]);
        assert_eq!([0, 3, 9].map(|layers| size(4, layers)), [4; 3]);
    }

    #[test]
    fn pp_dp_alone_is_written_out() {
        assert!(!inserts(&automatic(false, true), &[1; 10]));
    }

    #[test]
    fn what_is_asked_for_is_what_is_done() {
        for (sort, expected) in [(ArraySort::Insertion, true), (ArraySort::Network, false)] {
            for n in [0, 1, 300] {
                let options = ABufferOptions {
                    sort,
                    ..ABufferOptions::DEFAULT
                };
                assert_eq!(inserts(&options, &[n; 10]), expected);
            }
        }
    }

    #[test]
    fn an_image_without_fragments_has_a_sort_too() {
        assert!(inserts(&automatic(false, false), &[0; 10]));
        assert!(inserts(&automatic(false, false), &[]));
    }
}
