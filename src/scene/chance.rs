//! Random numbers from a seed. A seed gives the same numbers for ever.
//!
//! PCG-XSH-RR 64/32 is fixed by its definition. How its words become numbers is written out here. A library may change
//! this from one version to the next, and then every picture that was made from a seed would change.

use rand::Rng;
use rand_pcg::Pcg32;

/// A sequence of random numbers, given by a seed.
pub(super) struct Chance(Pcg32);

impl Chance {
    pub(super) fn new(seed: u64) -> Self {
        const STREAM: u64 = 54;
        Self(Pcg32::new(seed, STREAM))
    }

    /// A number from 0 to 1, 1 excluded, in steps of 2^-24, so that each is exact in an f32.
    pub(super) fn unit(&mut self) -> f32 {
        (self.0.next_u32() >> 8) as f32 / (1 << 24) as f32
    }

    /// A number from `low` to `high`.
    pub(super) fn between(&mut self, low: f32, high: f32) -> f32 {
        // Rounding may lead past the end by one unit in the last place.
        (low + (high - low) * self.unit()).clamp(low, high)
    }

    /// A whole number less than `count`, each with the same probability. `count` must not be 0.
    fn below(&mut self, count: u32) -> u32 {
        // The last words would make small numbers more likely, so they are thrown away.
        let fair = u32::MAX - u32::MAX % count;
        loop {
            let word = self.0.next_u32();
            if word < fair {
                return word % count;
            }
        }
    }

    /// Shuffles the items. Every order has the same probability.
    pub(super) fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            let count = u32::try_from(i + 1).expect("no list here has more than u32::MAX items");
            items.swap(i, self.below(count) as usize);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_words_are_those_of_the_published_generator() {
        // The first outputs that pcg-random.org's own check program prints for pcg32 with state 42, stream 54.
        let mut chance = Chance::new(42);
        let words = [0; 6].map(|_: u32| chance.0.next_u32());
        let published = [
            0xa15c_02b7,
            0x7b47_f409,
            0xba1d_3330,
            0x83d2_f293,
            0xbfa4_784b,
            0xcbed_606e,
        ];
        assert_eq!(words, published);
    }

    #[test]
    fn every_number_below_the_bound_is_as_likely() {
        let mut chance = Chance::new(1);
        let mut counts = [0_i32; 7];
        for _ in 0..70_000 {
            counts[chance.below(7) as usize] += 1;
        }
        // Six standard deviations of a binomial count with n = 70000 and p = 1/7 are 556.
        assert!(
            counts.iter().all(|count| (count - 10_000).abs() < 556),
            "{counts:?}"
        );
    }

    #[test]
    fn between_keeps_its_ends() {
        let mut chance = Chance::new(2);
        for _ in 0..1000 {
            let x = chance.between(0.1, 0.3);
            assert!((0.1..=0.3).contains(&x));
        }
    }
}
