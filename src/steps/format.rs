//! Formats of maps.

use crate::words::words;

/// The format of a map's texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// Four bytes, each 0 to 1 in 256 steps.
    Rgba8,
    /// Three numbers of 10 bits, and two bits of alpha.
    Rgb10A2,
    /// Four 16-bit floats.
    Rgba16F,
    /// Four 32-bit floats.
    Rgba32F,
    /// One 32-bit float.
    R32F,
    /// Two 32-bit floats.
    Rg32F,
    /// Two 16-bit fixed-point numbers.
    Rg16,
    /// One 32-bit whole number.
    R32Ui,
    /// Four 32-bit whole numbers.
    Rgba32Ui,
    /// 32-bit float depth with 8 bits of stencil.
    Depth32FStencil8,
    /// 24-bit fixed-point depth with 8 bits of stencil. On llvmpipe, a sampled depth differs from the stored one.
    Depth24Stencil8,
    /// 16-bit fixed-point depth. OpenGL has no such format with a stencil.
    Depth16,
    /// 24-bit fixed-point depth alone.
    Depth24,
    /// 32-bit float depth alone.
    Depth32F,
}

words! { Format, "format",
    Rgba8 "rgba8" "8 bits, rounded after every layer",
    Rgb10A2 "rgb10a2" "10 bits, and 2 bits of alpha",
    Rgba16F "rgba16f" "16-bit float",
    Rgba32F "rgba32f" "32-bit float",
    R32F "r32f" "One 32-bit float",
    Rg32F "rg32f" "Two 32-bit floats",
    Rg16 "rg16" "Two 16-bit fixed-point numbers",
    R32Ui "r32ui" "One 32-bit whole number",
    Rgba32Ui "rgba32ui" "Four 32-bit whole numbers",
    Depth32FStencil8 "d32f" "32-bit float",
    Depth24Stencil8 "d24" "24 bits, which show what goes wrong when they are sampled",
    Depth16 "d16-alone" "16 bits, without a stencil",
    Depth24 "d24-alone" "24 bits, without a stencil",
    Depth32F "d32f-alone" "32-bit float, without a stencil",
}

impl Format {
    /// Bytes per texel, as GL counts them.
    pub const fn bytes(self) -> u64 {
        match self {
            Self::Depth16 => 2,
            Self::Rgba8
            | Self::Rgb10A2
            | Self::R32F
            | Self::R32Ui
            | Self::Rg16
            | Self::Depth24
            | Self::Depth32F
            | Self::Depth24Stencil8 => 4,
            Self::Rgba16F | Self::Rg32F | Self::Depth32FStencil8 => 8,
            Self::Rgba32F | Self::Rgba32Ui => 16,
        }
    }

    /// Bits of alpha per texel.
    pub const fn alpha_bits(self) -> u32 {
        match self {
            Self::Rgb10A2 => 2,
            Self::Rgba8 => 8,
            Self::Rgba16F => 16,
            Self::Rgba32F => 32,
            _ => 0,
        }
    }

    /// Whether it stores depths.
    pub const fn has_depth(self) -> bool {
        matches!(
            self,
            Self::Depth32FStencil8
                | Self::Depth24Stencil8
                | Self::Depth16
                | Self::Depth24
                | Self::Depth32F
        )
    }

    /// Whether it stores depths as floats, without rounding them to steps.
    pub const fn has_float_depth(self) -> bool {
        matches!(self, Self::Depth32FStencil8 | Self::Depth32F)
    }

    /// Whether it stores stencil values.
    pub const fn has_stencil(self) -> bool {
        matches!(self, Self::Depth32FStencil8 | Self::Depth24Stencil8)
    }
}
