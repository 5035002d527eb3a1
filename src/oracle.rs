//! The oracle: sort, then composite in f64. It knows neither steps nor GL, and every exact method has to equal it.
//!
//! Everywhere in onionskin there is one policy for equal depths: the fragment that was submitted first lies in front.
//!
//! [`composite`] takes the depths of a list of fragments as they are. The exact image does not trust the driver's
//! depths: [`surfaces`] computes in f64 where a pixel's ray meets each triangle, and [`pixel`] sorts by these
//! distances.

mod coplanar;
mod depth_buffer;
pub mod pixel;
pub mod surfaces;
pub mod volumes;

pub use depth_buffer::DepthBuffer;

use crate::fragment::{Fragment, Rgba};

/// Composites the fragments of one pixel over an opaque background, in f64.
///
/// The fragments are sorted by depth, and by order of submission if their depths are equal. Fragments at or behind
/// `opaque_depth` are left out. Each fragment then goes under those before it: `C += (1 - A) a c`, `A += (1 - A) a`.
///
/// ```
/// use onionskin::{Fragment, Rgba, composite};
///
/// let glass = |depth, color, order| Fragment { depth, color, order };
/// let mut fragments = vec![
///     glass(0.5, Rgba::new(0.0, 1.0, 0.0, 0.5), 0),
///     glass(0.25, Rgba::new(1.0, 0.0, 0.0, 0.5), 1),
/// ];
/// let color = composite(&mut fragments, 1.0, Rgba::opaque([1.0; 3]));
/// assert_eq!(color, [0.75, 0.5, 0.25, 1.0]);
/// ```
pub fn composite(fragments: &mut Vec<Fragment>, opaque_depth: f32, background: Rgba) -> [f64; 4] {
    fragments.retain(|fragment| fragment.depth < opaque_depth);
    fragments.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order)));
    let mut image = [0.0; 3];
    let mut visible = 1.0;
    for Fragment { color, .. } in fragments.iter() {
        under(&mut image, &mut visible, *color);
    }
    under(&mut image, &mut visible, background);
    [image[0], image[1], image[2], 1.0 - visible]
}

/// Puts `color` under the fragments composited so far. `visible` is the part of the light that they let through.
fn under(image: &mut [f64; 3], visible: &mut f64, color: Rgba) {
    let alpha = f64::from(color.a);
    for (channel, value) in image.iter_mut().zip([color.r, color.g, color.b]) {
        *channel += *visible * alpha * f64::from(value);
    }
    *visible *= 1.0 - alpha;
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;

    const WHITE: Rgba = Rgba::opaque([1.0; 3]);

    fn fragment(depth: f32, color: [f32; 3], alpha: f32, order: u32) -> Fragment {
        let [r, g, b] = color;
        Fragment {
            depth,
            color: Rgba::new(r, g, b, alpha),
            order,
        }
    }

    #[test]
    fn no_fragment_shows_the_background() {
        assert_eq!(composite(&mut vec![], 1.0, WHITE), [1.0; 4]);
    }

    #[test]
    fn half_red_before_half_green_before_white() {
        let mut list = vec![
            fragment(0.5, [0.0, 1.0, 0.0], 0.5, 0),
            fragment(0.25, [1.0, 0.0, 0.0], 0.5, 1),
        ];
        // By hand: red 1/2 + 0 + 1/4, green 0 + 1/4 + 1/4, blue 1/4.
        assert_eq!(composite(&mut list, 1.0, WHITE), [0.75, 0.5, 0.25, 1.0]);
    }

    #[test]
    fn of_equal_depths_the_first_submitted_lies_in_front() {
        let red = fragment(0.5, [1.0, 0.0, 0.0], 1.0, 0);
        let green = fragment(0.5, [0.0, 1.0, 0.0], 1.0, 1);
        assert_eq!(
            composite(&mut vec![green, red], 1.0, WHITE),
            [1.0, 0.0, 0.0, 1.0]
        );
    }

    #[test]
    fn what_is_at_or_behind_the_opaque_depth_is_not_seen() {
        let mut list = vec![
            fragment(0.5, [1.0, 0.0, 0.0], 1.0, 0),
            fragment(0.75, [0.0; 3], 1.0, 1),
        ];
        assert_eq!(composite(&mut list, 0.5, WHITE), [1.0; 4]);
        assert!(list.is_empty());
    }

    #[test]
    fn n_equal_layers_follow_the_closed_form() {
        let mut list: Vec<_> = (0..50)
            .map(|i| fragment(i as f32 / 64.0, [0.0; 3], 0.25, i))
            .collect();
        let [red, ..] = composite(&mut list, 1.0, WHITE);
        // n layers of opacity a let (1 - a)^n of the light through. Bound: 50 roundings of 2^-53.
        assert_abs_diff_eq!(red, 0.75_f64.powi(50), epsilon = 50.0 * f64::EPSILON);
    }
}
