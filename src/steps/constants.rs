//! OpenGL's constants, as far as listings use them: one enum for each set that a call chooses from.

use super::argument::Argument;

/// An enum of constants, each with OpenGL's name for it, without the `GL_`.
macro_rules! constants {
    ($(
        $(#[$about:meta])*
        $name:ident { $($(#[$doc:meta])* $constant:ident = $text:literal,)* }
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

constants! {
    /// A comparison, as in `glDepthFunc`, `glStencilFunc` and `GL_TEXTURE_COMPARE_FUNC`.
    Compare {
        Never = "NEVER",
        Less = "LESS",
        Equal = "EQUAL",
        Lequal = "LEQUAL",
        Greater = "GREATER",
        Notequal = "NOTEQUAL",
        Gequal = "GEQUAL",
        Always = "ALWAYS",
    }

    /// The operation of a stencil test on the stored value.
    StencilOp {
        /// Keep it.
        Keep = "KEEP",
        /// Set it to 0.
        Zero = "ZERO",
        /// Set it to the reference.
        Replace = "REPLACE",
        /// Add one, at most 255.
        Incr = "INCR",
        /// Add one, 255 becomes 0.
        IncrWrap = "INCR_WRAP",
        /// Subtract one, at least 0.
        Decr = "DECR",
        /// Subtract one, 0 becomes 255.
        DecrWrap = "DECR_WRAP",
        /// Flip every bit.
        Invert = "INVERT",
    }

    /// A factor of the blend equation.
    BlendFactor {
        Zero = "ZERO",
        One = "ONE",
        SrcAlpha = "SRC_ALPHA",
        OneMinusSrcAlpha = "ONE_MINUS_SRC_ALPHA",
        DstAlpha = "DST_ALPHA",
        OneMinusDstAlpha = "ONE_MINUS_DST_ALPHA",
    }

    /// How a blend combines source and destination.
    BlendEquation {
        /// Their sum, each times its factor.
        FuncAdd = "FUNC_ADD",
        /// The larger of the two, channel by channel, without factors.
        Max = "MAX",
    }

    /// The capabilities of `glEnable`.
    Capability {
        DepthTest = "DEPTH_TEST",
        StencilTest = "STENCIL_TEST",
        Blend = "BLEND",
        DepthClamp = "DEPTH_CLAMP",
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

impl Argument for Buffers {
    fn text(&self) -> String {
        let names = [
            (self.color, "GL_COLOR_BUFFER_BIT"),
            (self.depth, "GL_DEPTH_BUFFER_BIT"),
            (self.stencil, "GL_STENCIL_BUFFER_BIT"),
        ];
        let set = names.into_iter().filter(|(set, _)| *set);
        set.map(|(_, name)| name).collect::<Vec<_>>().join(" | ")
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
