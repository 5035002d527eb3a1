//! Batcher's odd-even merge sort as a list of comparators, with which a shader sorts by constant indices only.

/// The largest array that a network sorts; larger ones take the driver too long to compile. Llvmpipe takes two seconds for 32
/// elements and six for 64.
pub const LARGEST_NETWORK: u32 = 128;

/// The comparators that sort `n` elements, `n` a power of two: each puts the smaller element first.
pub fn odd_even_merge(n: usize) -> Vec<(usize, usize)> {
    assert!(
        n.is_power_of_two(),
        "a network for {n} elements, which is no power of two"
    );
    let mut comparators = Vec::new();
    let mut sorted = 1;
    // Runs of `sorted` elements are merged two by two.
    while sorted < n {
        let mut distance = sorted;
        while distance >= 1 {
            for start in (distance % sorted..n - distance).step_by(2 * distance) {
                for i in start..(start + distance).min(n - distance) {
                    // Only inside of a pair of runs.
                    if i / (2 * sorted) == (i + distance) / (2 * sorted) {
                        comparators.push((i, i + distance));
                    }
                }
            }
            distance /= 2;
        }
        sorted *= 2;
    }
    comparators
}

/// The network as a shader includes it: one `X(i, j)` per comparator, several per line.
pub(super) fn glsl(n: usize) -> String {
    let mut text = String::new();
    for comparators in odd_even_merge(n).chunks(8) {
        for (i, j) in comparators {
            text += &format!("X({i}, {j}) ");
        }
        text.push('\n');
    }
    text
}

/// Every element of an array of `n`, one `P(k)` each. This is an unrolled loop, because drivers unroll only small ones.
pub(super) fn elements(n: usize) -> String {
    let elements: Vec<String> = (0..n).map(|k| format!("P({k})")).collect();
    elements.join(" ") + "\n"
}

/// Every volume, one `V(i)` each, because a sampler's number has to be a constant.
pub(super) fn volumes(count: u32) -> String {
    let volumes: Vec<String> = (0..count).map(|i| format!("V({i})")).collect();
    volumes.join(" ") + "\n"
}

/// The jumps of a binary search among `count` sorted elements, a power of two: `H(count / 2)` to `H(1)`.
pub(super) fn halvings(count: u32) -> String {
    let halves = std::iter::successors(Some(count / 2), |half| Some(half / 2));
    let halves: Vec<String> = halves
        .take_while(|&half| half > 0)
        .map(|half| format!("H({half})"))
        .collect();
    halves.join(" ") + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Knuth's 0-1 principle: a network that sorts every sequence of zeros and ones sorts every sequence.
    #[test]
    fn every_sequence_of_zeros_and_ones_is_sorted() {
        for n in [1, 2, 4, 8, 16] {
            let network = odd_even_merge(n);
            for bits in 0..1_u32 << n {
                assert!(sorts(&network, n, bits), "{n}: {bits:b}");
            }
        }
    }

    #[test]
    fn a_network_that_lacks_any_comparator_is_noticed() {
        let network = odd_even_merge(8);
        for left_out in 0..network.len() {
            let mut broken = network.clone();
            broken.remove(left_out);
            assert!(!(0..256).all(|bits| sorts(&broken, 8, bits)), "{left_out}");
        }
    }

    /// Too many sequences to try all: every one with a single one, a single zero, and every sorted pair of halves,
    /// which is all that the last merge ever sees.
    #[test]
    fn larger_networks_merge_every_pair_of_sorted_halves() {
        for n in [32, 64, 128] {
            let network = odd_even_merge(n);
            let half = odd_even_merge(n / 2).len();
            // The network begins with those of its halves, interleaved; what is left is the merge.
            let merge = &network[2 * half..];
            for low in 0..=n / 2 {
                for high in 0..=n / 2 {
                    let mut values: Vec<bool> = (0..n)
                        .map(|i| i % (n / 2) >= if i < n / 2 { low } else { high })
                        .collect();
                    apply(merge, &mut values);
                    assert!(values.is_sorted(), "{n}: {low} {high}");
                }
            }
        }
    }

    #[test]
    fn sizes_are_batcher_s() {
        let sizes: Vec<_> = [8, 16, 32, 64, 128].map(|n| odd_even_merge(n).len()).into();
        // (p² - p + 4) 2^(p-2) - 1 comparators for 2^p elements (Knuth, volume 3, 5.3.4).
        assert_eq!(sizes, [19, 63, 191, 543, 1471]);
    }

    fn sorts(network: &[(usize, usize)], n: usize, bits: u32) -> bool {
        let mut values: Vec<bool> = (0..n).map(|i| bits >> i & 1 == 1).collect();
        apply(network, &mut values);
        values.is_sorted()
    }

    fn apply(network: &[(usize, usize)], values: &mut [bool]) {
        for &(i, j) in network {
            if values[i] && !values[j] {
                values.swap(i, j);
            }
        }
    }
}
