//! The values that one pixel of a framebuffer holds, whichever machine has drawn there.

/// The values of a pixel.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Held {
    /// The depth, 0 to 1, or `None` without a depth map. A fixed-point depth is a quotient.
    pub depth: Option<f32>,
    /// The stencil value, or `None` if the depth map has none.
    pub stencil: Option<u8>,
    /// The texels of the color maps, in the order of the shaders' locations.
    pub colors: Vec<Texel>,
}

/// A texel of a color map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Texel {
    /// Red, green, blue and alpha. Of channels that the format lacks, alpha is 1 and the others are 0, as lookups have it.
    Color([f32; 4]),
    /// The same of a format of whole numbers.
    Integers([u32; 4]),
}

impl Texel {
    /// The channels of a colour. Those of whole numbers are 0.
    pub fn color(self) -> [f32; 4] {
        match self {
            Self::Color(color) => color,
            Self::Integers(_) => [0.0; 4],
        }
    }

    /// The whole numbers. Those of a colour are 0.
    pub fn integers(self) -> [u32; 4] {
        match self {
            Self::Color(_) => [0; 4],
            Self::Integers(integers) => integers,
        }
    }
}
