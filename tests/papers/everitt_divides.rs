//! "The left side of the expression interpolates three quantities and performs four divides while the right simply
//! interpolates one quantity" (Everitt 2001, An Invariance Issue, equation 4; E15), counted.
//!
//! The equations are pictures in the paper. They are written here as the sentences around them describe them: r and q
//! interpolated hyperbolically in window space from zc and wc, and window z interpolated linearly.

use std::cell::Cell;
use std::ops::{Add, Div, Mul, Sub};

thread_local! {
    static DIVIDES: Cell<u32> = const { Cell::new(0) };
    static INTERPOLATED: Cell<u32> = const { Cell::new(0) };
}

/// A 32-bit number that counts divides.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Counted(f32);

macro_rules! operator {
    ($($trait:ident $name:ident $operator:tt),*) => {$(
        impl $trait for Counted {
            type Output = Self;
            fn $name(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    )*};
}
operator!(Add add +, Sub sub -, Mul mul *);

impl Div for Counted {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        DIVIDES.set(DIVIDES.get() + 1);
        Self(self.0 / other.0)
    }
}

/// A vertex after the projection: zc and wc. What is divided once a vertex is not a fragment's work.
#[derive(Clone, Copy)]
struct Clip {
    z: f32,
    w: f32,
}

/// Linear in window space, once a fragment.
fn interpolate(ends: [f32; 2], t: f32) -> Counted {
    INTERPOLATED.set(INTERPOLATED.get() + 1);
    let [a, b] = ends.map(Counted);
    a * Counted(1.0 - t) + b * Counted(t)
}

/// Equation 1: zw.
fn window_z(ends: [Clip; 2], t: f32) -> Counted {
    interpolate(ends.map(|end| end.z / end.w), t)
}

/// Equations 2 and 3: r and q, each with the same denominator.
fn r_and_q(ends: [Clip; 2], t: f32) -> [Counted; 2] {
    let one_over_w = interpolate(ends.map(|end| 1.0 / end.w), t);
    let r = interpolate(ends.map(|end| end.z / end.w), t) / one_over_w;
    // wc / wc.
    let q = interpolate([1.0; 2], t) / one_over_w;
    [r, q]
}

/// The left side of equation 4.
fn quotient(ends: [Clip; 2], t: f32) -> Counted {
    let [r, q] = r_and_q(ends, t);
    r / q
}

/// Quantities and divides of a side.
fn cost(side: impl Fn([Clip; 2], f32) -> Counted) -> [u32; 2] {
    DIVIDES.set(0);
    INTERPOLATED.set(0);
    side([Clip { z: 1.0, w: 2.0 }, Clip { z: 5.0, w: 6.0 }], 0.25);
    [INTERPOLATED.get(), DIVIDES.get()]
}

/// Three quantities, as the paper counts, and one. Of the four divides three are in the equation; a fourth is there if the
/// other coordinates of the lookup are divided, too, by one reciprocal of q.
#[test]
pub(crate) fn e15_the_left_side_interpolates_three_quantities_and_divides_three_times() {
    assert_eq!(cost(quotient), [3, 3]);
    assert_eq!(cost(window_z), [1, 0]);
    let with_a_reciprocal = |ends, t| {
        let [r, q] = r_and_q(ends, t);
        let s = interpolate([0.0, 1.0], t);
        let reciprocal = Counted(1.0) / q;
        let _ = s * reciprocal;
        r / q
    };
    assert_eq!(cost(with_a_reciprocal)[1], 4);
}

/// What they cost: the two sides differ in their last bits. Depth replace saves a depth from that, because it stores the
/// quotient, too (`e07_with_depth_replace_every_pixel_left_over_is_a_tie_or_beyond_the_far_plane`).
#[test]
pub(crate) fn e15_the_divides_cost_the_last_bits() {
    let mut differ = 0;
    let mut largest = 0.0_f32;
    for n in 0..1000_u16 {
        let part = f32::from(n) / 1000.0;
        let [near, far] = [0.5 + part, 3.0 + 40.0 * part];
        // A projection with planes at 0.4 and 50, depths from 0 to 1.
        let clip = |w: f32| Clip {
            z: (w - 0.4) * 50.0 / 49.6,
            w,
        };
        let (ends, t) = ([clip(near), clip(far)], (f32::from(n % 97) + 0.5) / 97.0);
        let [left, right] = [quotient(ends, t), window_z(ends, t)];
        differ += u32::from(left != right);
        largest = largest.max((left.0 - right.0).abs());
    }
    // The last bit of numbers up to 1.
    assert_eq!((differ, largest), (331, 2.0_f32.powi(-24)));
}
