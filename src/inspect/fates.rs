//! What became of each fragment in the end.

use super::composite::Composite;
use crate::fragment::Fragment;

/// What became of a fragment.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fate {
    /// An opaque surface hides it.
    Hidden,
    /// It is the opaque surface that is seen.
    Opaque,
    /// It is in the image, at this place from the front.
    Composited(u32),
    /// It belongs in the image, and is not in it, because a fragment of the same depth, with this number, is there instead.
    Tied(u32),
    /// It belongs in the image, and is not in it.
    Lost,
    /// It is hidden in the exact image, but here it is in the image, at this place from the front.
    Wrong(u32),
    /// It is in the image, but the method does not composite fragments one by one.
    Mixed,
    /// The method's steps cannot be followed.
    Unknown,
}

/// How things end at a pixel.
pub(super) struct Ends<'a> {
    /// The fragments that belong in the image.
    pub(super) exact: &'a Composite,
    /// The opaque one that is seen.
    pub(super) opaque: Option<u32>,
    /// The fragments in the method's image, if it composites them one by one.
    pub(super) composited: Option<&'a Composite>,
    /// The weight of each fragment in the method's image, if that is known.
    pub(super) weights: Option<&'a [f64]>,
}

impl Ends<'_> {
    /// The fate of each fragment.
    pub(super) fn fates(&self, fragments: &[Fragment]) -> Vec<Fate> {
        let numbers = 0..fragments.len() as u32;
        numbers.map(|number| self.fate(fragments, number)).collect()
    }

    fn fate(&self, fragments: &[Fragment], number: u32) -> Fate {
        if self.opaque == Some(number) {
            return Fate::Opaque;
        }
        let belongs = place(self.exact, number).is_some();
        let Some(composited) = self.composited else {
            let weight = self.weights.map(|weights| weights[number as usize]);
            return match weight {
                _ if !belongs => Fate::Hidden,
                None => Fate::Unknown,
                Some(0.0) if self.exact.weight(number) > 0.0 => Fate::Lost,
                Some(_) => Fate::Mixed,
            };
        };
        match (place(composited, number), belongs) {
            (Some(place), true) => Fate::Composited(place),
            (Some(place), false) => Fate::Wrong(place),
            (None, false) => Fate::Hidden,
            (None, true) => {
                let depth = fragments[number as usize].depth;
                let mut layers = composited.layers.iter();
                let tied = layers.find(|it| fragments[it.fragment as usize].depth == depth);
                tied.map_or(Fate::Lost, |layer| Fate::Tied(layer.fragment))
            }
        }
    }
}

/// A fragment's place from the front.
fn place(composite: &Composite, number: u32) -> Option<u32> {
    let mut layers = (0..).zip(&composite.layers);
    let layer = layers.find(|(_, layer)| layer.fragment == number);
    layer.map(|(place, _)| place)
}
