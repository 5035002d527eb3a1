//! What a rasteriser makes of a surface at one pixel: a colour, a depth, and its place in the order of submission.

use bytemuck::{Pod, Zeroable};

/// A colour with straight (not premultiplied) alpha. Linear, blended as it is: nothing here converts to or from sRGB.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Rgba {
    /// Red, 0 to 1.
    pub r: f32,
    /// Green, 0 to 1.
    pub g: f32,
    /// Blue, 0 to 1.
    pub b: f32,
    /// Opacity, 0 (nothing) to 1 (opaque).
    pub a: f32,
}

impl Rgba {
    /// A colour from its four channels.
    pub const fn new(r: f32, g: f32, b: f32, a: f32) -> Self {
        Self { r, g, b, a }
    }

    /// An opaque colour.
    pub const fn opaque([r, g, b]: [f32; 3]) -> Self {
        Self { r, g, b, a: 1.0 }
    }

    /// The four channels, red first.
    pub const fn to_array(self) -> [f32; 4] {
        [self.r, self.g, self.b, self.a]
    }
}

impl From<[f32; 4]> for Rgba {
    fn from([r, g, b, a]: [f32; 4]) -> Self {
        Self { r, g, b, a }
    }
}

/// One surface at one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragment {
    /// Window-space depth, 0 at the near plane and 1 at the far plane. Smaller is nearer.
    pub depth: f32,
    /// What the surface adds, straight alpha.
    pub color: Rgba,
    /// Place in the order of submission; of two fragments of equal depth the one submitted first lies in front.
    pub order: u32,
}
