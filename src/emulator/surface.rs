//! Surfaces at a pixel, and the groups of objects that they belong to.

use crate::fragment::{Fragment, Rgba};
use crate::steps::Objects;

/// The group of objects to which a surface belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Opaque geometry.
    Opaque,
    /// Transparent geometry whose triangles are exactly sorted.
    Sorted,
    /// All other transparent geometry.
    Unsorted,
    /// The boxes around volumes. A face's depth is clamped to 0..1, and its `order` is its id
    /// ([`Source::id`](crate::fragment::Source::id)).
    Proxy,
}

impl Group {
    /// Whether a draw of these objects draws this group. The quad that covers the screen belongs to no group.
    pub(super) fn is_among(self, objects: Objects) -> bool {
        match objects {
            Objects::Scene => self != Self::Proxy,
            Objects::Opaque => self == Self::Opaque,
            Objects::Transparent => matches!(self, Self::Sorted | Self::Unsorted),
            Objects::Sorted => self == Self::Sorted,
            Objects::Unsorted => self == Self::Unsorted,
            Objects::Proxies => self == Self::Proxy,
            Objects::Screen => false,
        }
    }
}

/// A surface at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Colour (straight alpha), depth, and place in the order of submission.
    pub fragment: Fragment,
    /// The group of objects to which it belongs.
    pub group: Group,
}

/// The fragment of the quad over the screen, at one pixel.
pub(super) const SCREEN: Surface = Surface {
    fragment: Fragment {
        // The quad's vertices are at z = 0 in clip space.
        depth: 0.5,
        color: Rgba::new(0.0, 0.0, 0.0, 0.0),
        order: 0,
    },
    group: Group::Unsorted,
};
