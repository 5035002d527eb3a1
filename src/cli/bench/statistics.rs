//! The middle and the ends of some times.

/// Times in milliseconds, in order.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Times(Vec<f64>);

impl Times {
    /// `None` if there are no times.
    pub(super) fn of(mut times: Vec<f64>) -> Option<Self> {
        times.sort_unstable_by(f64::total_cmp);
        (!times.is_empty()).then_some(Self(times))
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// Between two middle ones, the mean of both.
    pub(super) fn median(&self) -> f64 {
        let upper = self.0.len() / 2;
        let lower = (self.0.len() - 1) / 2;
        (self.0[lower] + self.0[upper]) / 2.0
    }

    pub(super) fn min(&self) -> f64 {
        self.0[0]
    }

    pub(super) fn max(&self) -> f64 {
        self.0[self.0.len() - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_has_as_many_times_below_as_above() {
        let odd = Times::of(vec![9.0, 1.0, 4.0]).unwrap();
        assert_eq!(
            (odd.count(), odd.min(), odd.median(), odd.max()),
            (3, 1.0, 4.0, 9.0)
        );
        let even = Times::of(vec![8.0, 2.0, 4.0, 1.0]).unwrap();
        assert_eq!(even.median(), 3.0);
        assert_eq!(Times::of(vec![5.0]).unwrap().median(), 5.0);
        assert_eq!(Times::of(Vec::new()), None);
    }
}
