//! OpenGL's constants, as far as listings use them: one enum for each set that a call chooses from.

use super::argument::Argument;

/// An enum of constants, each with OpenGL's name for it, without the `GL_`.
macro_rules! constants {
    ($(
        $(#[$about:meta])*
        $name:ident { $($(#[$doc:meta])* $constant:ident = $text:expr,)* }
    )*) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $name {
            $($(#[$doc])* #[doc = concat!("`GL_", $text, "`")] $constant,)*
        }

        impl $name {
            /// OpenGL's name for it, without the `GL_`.
            #[allow(dead_code)] // not every set is printed without it
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$constant => $text,)*
                }
            }
        }

        impl Argument for $name {
            fn text(&self) -> String {
                format!("GL_{}", self.name())
            }
        }
    )*};
}
pub(super) use constants;

/// Such enums of OpenGL's core, each constant with OpenGL's number for it, too. [`named`] has them under OpenGL's names, for
/// listings, but for those that are `unnamed` because another set has the name.
macro_rules! numbered {
    ($(
        $(#[$about:meta])*
        $name:ident { $($(#[$doc:meta])* $variant:ident = $constant:ident $number:literal $($unnamed:ident)?,)* }
    )*) => {
        constants! {$(
            $(#[$about])*
            $name { $($(#[$doc])* $variant = stringify!($constant),)* }
        )*}

        $(impl $name {
            /// OpenGL's number for it.
            pub const fn number(self) -> u32 {
                match self {
                    $(Self::$variant => $number,)*
                }
            }
        })*

        /// Every constant with its number.
        #[cfg(test)]
        pub const NUMBERS: &[(&str, u32)] = &[$($((stringify!($constant), $number),)*)*];

        /// The constants under OpenGL's names.
        #[allow(missing_docs)] // as above
        pub(super) mod named {
            use super::*;

            $($(numbered! { @named $name $variant $constant $($unnamed)? })*)*
        }
    };
    (@named $name:ident $variant:ident $constant:ident) => {
        pub const $constant: $name = $name::$variant;
    };
    (@named $name:ident $variant:ident $constant:ident unnamed) => {};
}

numbered! {
    /// A comparison, as in `glDepthFunc`, `glStencilFunc` and `GL_TEXTURE_COMPARE_FUNC`.
    Compare {
        Never = NEVER 0x0200,
        Less = LESS 0x0201,
        Equal = EQUAL 0x0202,
        Lequal = LEQUAL 0x0203,
        Greater = GREATER 0x0204,
        Notequal = NOTEQUAL 0x0205,
        Gequal = GEQUAL 0x0206,
        Always = ALWAYS 0x0207,
    }

    /// The operation of a stencil test on the stored value.
    StencilOp {
        /// Keep it.
        Keep = KEEP 0x1E00,
        /// Set it to 0.
        Zero = ZERO 0 unnamed,
        /// Set it to the reference.
        Replace = REPLACE 0x1E01,
        /// Add one, at most 255.
        Incr = INCR 0x1E02,
        /// Add one, 255 becomes 0.
        IncrWrap = INCR_WRAP 0x8507,
        /// Subtract one, at least 0.
        Decr = DECR 0x1E03,
        /// Subtract one, 0 becomes 255.
        DecrWrap = DECR_WRAP 0x8508,
        /// Flip every bit.
        Invert = INVERT 0x150A,
    }

    /// A factor of the blend equation.
    BlendFactor {
        Zero = ZERO 0,
        One = ONE 1,
        SrcAlpha = SRC_ALPHA 0x0302,
        OneMinusSrcAlpha = ONE_MINUS_SRC_ALPHA 0x0303,
        DstAlpha = DST_ALPHA 0x0304,
        OneMinusDstAlpha = ONE_MINUS_DST_ALPHA 0x0305,
    }

    /// How a blend combines source and destination.
    BlendEquation {
        /// Their sum, each times its factor.
        FuncAdd = FUNC_ADD 0x8006,
        /// The smaller of the two, channel by channel, without factors.
        Min = MIN 0x8007,
        /// The larger of the two, channel by channel, without factors.
        Max = MAX 0x8008,
    }

    /// The capabilities of `glEnable`.
    Capability {
        DepthTest = DEPTH_TEST 0x0B71,
        StencilTest = STENCIL_TEST 0x0B90,
        Blend = BLEND 0x0BE2,
        DepthClamp = DEPTH_CLAMP 0x864F,
    }
}

/// The bits of `glClear`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // the names say it
pub struct Buffers {
    pub color: bool,
    pub depth: bool,
    pub stencil: bool,
}

impl Buffers {
    /// The buffers' bits with their names.
    fn set(self) -> impl Iterator<Item = (&'static str, u32)> {
        let bits = [
            (self.color, "GL_COLOR_BUFFER_BIT", 0x4000),
            (self.depth, "GL_DEPTH_BUFFER_BIT", 0x0100),
            (self.stencil, "GL_STENCIL_BUFFER_BIT", 0x0400),
        ];
        let set = bits.into_iter().filter(|(set, ..)| *set);
        set.map(|(_, name, bit)| (name, bit))
    }

    /// OpenGL's number for them together.
    pub fn number(self) -> u32 {
        self.set().map(|(_, bit)| bit).sum()
    }
}

impl Argument for Buffers {
    fn text(&self) -> String {
        let names = self.set().map(|(name, _)| name);
        names.collect::<Vec<_>>().join(" | ")
    }
}

/// The objects of a draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Objects {
    /// Everything, in the order of submission.
    Scene,
    /// Opaque objects.
    Opaque,
    /// Objects that are not opaque.
    Transparent,
    /// Objects that are not opaque, in meshes whose triangles are sorted exactly.
    Sorted,
    /// Objects that are not opaque, in all other meshes.
    Unsorted,
    /// The boxes around the volumes.
    Proxies,
    /// Two triangles over the whole viewport.
    Screen,
}

impl Objects {
    /// The call that draws them.
    pub(super) const fn drawn_by(self) -> &'static str {
        match self {
            Self::Scene => "drawScene",
            Self::Opaque => "drawOpaqueObjects",
            Self::Transparent => "drawTransparentObjects",
            Self::Sorted => "drawSortedObjects",
            Self::Unsorted => "drawUnsortedObjects",
            Self::Proxies => "drawProxies",
            Self::Screen => "drawScreen",
        }
    }
}

impl Argument for Objects {
    fn text(&self) -> String {
        self.drawn_by().into()
    }
}
