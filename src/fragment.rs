//! Fragments: what a rasteriser makes from a surface at one pixel. A fragment has a colour, a depth, and a place in the
//! order of submission.

use bytemuck::{Pod, Zeroable};

/// A colour with straight (not premultiplied) alpha. It is linear and blended as it is: nothing here converts to or
/// from sRGB.
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
    /// The colour of the surface, with straight alpha.
    pub color: Rgba,
    /// The place in the order of submission. Of two fragments of equal depth, the one submitted first lies in front.
    pub order: u32,
}

/// The source of a record in a fragment list, which its id encodes (Lindholm et al. 2015, section 6.1). Bits 31 and 30
/// are the kind of source, the other bits are its number. `glsl/a_buffer/id.glsl` has the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// A surface, with its place in the order of submission, below 2^30.
    Surface(u32),
    /// A face of the box around a volume.
    Proxy {
        /// The volume's number, 0 to 31.
        volume: u32,
        /// Whether the ray leaves the volume at this face, or enters it.
        leaves: bool,
    },
}

impl Source {
    const VOLUME: u32 = 1 << 30;
    const LEAVES: u32 = 1 << 29;
    const NUMBER: u32 = 31;

    /// The id. Of two records of equal depth, the one with the smaller id comes first.
    pub const fn id(self) -> u32 {
        match self {
            Self::Surface(place) => place,
            Self::Proxy { volume, leaves } => {
                let leaves = if leaves { Self::LEAVES } else { 0 };
                Self::VOLUME | leaves | volume & Self::NUMBER
            }
        }
    }

    /// The source that has this id.
    pub const fn of(id: u32) -> Self {
        if id & Self::VOLUME == 0 {
            return Self::Surface(id);
        }
        Self::Proxy {
            volume: id & Self::NUMBER,
            leaves: id & Self::LEAVES != 0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_id_says_what_its_source_is() {
        let proxies =
            (0..32).flat_map(|volume| [false, true].map(|leaves| Source::Proxy { volume, leaves }));
        for source in proxies.chain([0, 1, (1 << 30) - 1].map(Source::Surface)) {
            assert_eq!(Source::of(source.id()), source);
        }
    }

    #[test]
    fn the_shaders_have_the_same_bits() {
        let glsl = include_str!("../glsl/a_buffer/id.glsl");
        let has = |line: &str| assert!(glsl.contains(line), "no '{line}'");
        has(&format!("VOLUME = 1u << {};", Source::VOLUME.ilog2()));
        has(&format!("LEAVES = 1u << {};", Source::LEAVES.ilog2()));
        has(&format!("NUMBER = {}u;", Source::NUMBER));
    }
}
