//! Random numbers whose cases need no shrinking. A seed gives the same numbers on every run; it is printed, so that a
//! failed test says it.

use glam::DVec3;
use rand::Rng;
use rand_pcg::Pcg32;

pub struct Chance(Pcg32);

impl Chance {
    pub fn new(seed: u64) -> Self {
        println!("random numbers of seed {seed}");
        Self(Pcg32::new(seed, 54))
    }

    /// From 0 to 1, 1 excluded, in steps of 2^-32.
    pub fn unit(&mut self) -> f64 {
        f64::from(self.0.next_u32()) / 2_f64.powi(32)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A whole number less than `count`, which is far less than 2^32.
    pub fn below(&mut self, count: usize) -> usize {
        self.0.next_u32() as usize % count
    }

    /// In a box of twice `half` around the origin.
    pub fn vector(&mut self, half: f64) -> DVec3 {
        DVec3::from_array([(); 3].map(|()| self.between(-half, half)))
    }

    pub fn color(&mut self) -> [f32; 3] {
        [(); 3].map(|()| self.unit() as f32)
    }

    /// The numbers below `count`, in an order of which each is as likely.
    pub fn shuffled(&mut self, count: usize) -> Vec<usize> {
        let mut numbers: Vec<usize> = (0..count).collect();
        for i in (1..count).rev() {
            numbers.swap(i, self.below(i + 1));
        }
        numbers
    }
}
