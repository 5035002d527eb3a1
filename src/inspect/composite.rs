//! Compositing a pixel's fragments one by one, in f64.

use crate::fragment::Rgba;

/// Fragments in the order in which they lie before one another, nearest first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Composite {
    /// The fragments, each with the composite so far.
    pub layers: Vec<Layer>,
    /// The pixel's colour at the end, over what is behind the fragments.
    pub color: [f64; 4],
}

/// A fragment of a composite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layer {
    /// The fragment's number.
    pub fragment: u32,
    /// The composite up to and with this fragment: premultiplied colour, and the part of the light that is stopped.
    pub so_far: [f64; 4],
}

impl Composite {
    /// These fragments, each given by its number and colour, over an opaque colour.
    pub(super) fn of(fragments: impl Iterator<Item = (u32, Rgba)>, behind: Rgba) -> Self {
        let mut so_far = [0.0; 4];
        let layers = fragments
            .map(|(fragment, color)| {
                put_under(&mut so_far, color);
                Layer { fragment, so_far }
            })
            .collect();
        put_under(&mut so_far, behind);
        Self {
            layers,
            color: so_far,
        }
    }

    /// The part of a fragment's colour that is in the composite: by how much the part of the light that is stopped grows with
    /// it.
    pub(super) fn weight(&self, fragment: u32) -> f64 {
        let stopped = |at: usize| self.layers[at].so_far[3];
        let mut layers = self.layers.iter();
        match layers.position(|layer| layer.fragment == fragment) {
            Some(0) => stopped(0),
            Some(at) => stopped(at) - stopped(at - 1),
            None => 0.0,
        }
    }

    /// The first place at which another composite has another fragment.
    pub(super) fn parts_from(&self, other: &Self) -> Option<usize> {
        let numbers = |composite: &Self| {
            let layers = composite.layers.iter();
            layers.map(|layer| layer.fragment).collect::<Vec<_>>()
        };
        let (ours, theirs) = (numbers(self), numbers(other));
        let common = ours.iter().zip(&theirs).take_while(|(a, b)| a == b).count();
        (common < ours.len().max(theirs.len())).then_some(common)
    }
}

fn put_under(so_far: &mut [f64; 4], color: Rgba) {
    let part = (1.0 - so_far[3]) * f64::from(color.a);
    for (channel, value) in so_far.iter_mut().zip([color.r, color.g, color.b, 1.0]) {
        *channel += part * f64::from(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WHITE: Rgba = Rgba::opaque([1.0; 3]);

    fn composite(numbers: &[u32]) -> Composite {
        let half_black = Rgba::new(0.0, 0.0, 0.0, 0.5);
        Composite::of(numbers.iter().map(|&number| (number, half_black)), WHITE)
    }

    #[test]
    fn each_layer_stops_a_part_of_the_light_that_is_left() {
        let composite = composite(&[4, 2]);
        let stopped: Vec<_> = composite.layers.iter().map(|l| l.so_far[3]).collect();
        assert_eq!(stopped, [0.5, 0.75]);
        assert_eq!(composite.color, [0.25, 0.25, 0.25, 1.0]);
    }

    #[test]
    fn weights_are_what_each_layer_stops() {
        let composite = composite(&[4, 2]);
        assert_eq!([4, 2, 0].map(|it| composite.weight(it)), [0.5, 0.25, 0.0]);
    }

    #[test]
    fn composites_part_where_a_fragment_differs_or_is_missing() {
        let of = |numbers: [&[u32]; 2]| {
            let [a, b] = numbers.map(composite);
            a.parts_from(&b)
        };
        assert_eq!(of([&[1, 2], &[1, 2]]), None);
        assert_eq!(of([&[1, 2], &[2, 1]]), Some(0));
        assert_eq!(of([&[1, 2], &[1]]), Some(1));
        assert_eq!(of([&[], &[7]]), Some(0));
    }
}
