//! The prefix scan of an A-buffer on the emulated machine: the same levels as on OpenGL, each made by the twin of its shader.

use super::shaders::{scan_gather, scan_reduce, scan_spread};

/// Scans the counts of an image's pixels, as the complexity map holds them, in chunks of so many, at least 2.
///
/// Returns the levels, the pixels' base offsets first: for each number of a level, the sum of those before it, modulo 2^32.
pub fn prefix_scan(complexity: &[f32], chunk: usize) -> Vec<Vec<u32>> {
    let mut levels = vec![scan_gather(complexity)];
    while let Some(level) = levels.last().filter(|level| level.len() > 1) {
        levels.push(scan_reduce(level, chunk));
    }
    let mut above: Option<Vec<u32>> = None;
    for level in levels.iter_mut().rev() {
        scan_spread(level, above.as_deref(), chunk);
        above = Some(level.clone());
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_base_offset_is_the_sum_of_the_counts_before() {
        for numbers in [0, 1, 2, 3, 4, 5, 16, 17, 1000] {
            let counts: Vec<f32> = (0..numbers).map(|at| (at * 7 % 5) as f32).collect();
            let levels = prefix_scan(&counts, 4);
            let mut before = 0;
            for (count, offset) in counts.iter().zip(&levels[0]) {
                assert_eq!(*offset, before);
                before += *count as u32;
            }
            assert_eq!(levels[0].len(), numbers);
            assert!(levels.last().unwrap().len() <= 1);
        }
    }
}
