//! The leaves of a listing: one call each, with its arguments.
//!
//! The spelling is OpenGL's wherever OpenGL has the call. Resources are named rather than numbered: a [`Map`] is a
//! texture that a paper has a name for, and the machine keeps the table of names.

use std::fmt;

use super::classic::ClassicCall;
use super::draw_buffer::DrawBufferCall;

/// A comparison, as in `glDepthFunc`, `glStencilFunc` and `GL_TEXTURE_COMPARE_FUNC`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // the names say it
pub enum Compare {
    Never,
    Less,
    Equal,
    Lequal,
    Greater,
    Notequal,
    Gequal,
    Always,
}

/// What a stencil test does to the stored value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StencilOp {
    /// Keep it.
    Keep,
    /// Set it to 0.
    Zero,
    /// Set it to the reference.
    Replace,
    /// Add one, at most 255.
    Incr,
    /// Add one, 255 becomes 0.
    IncrWrap,
    /// Subtract one, at least 0.
    Decr,
    /// Subtract one, 0 becomes 255.
    DecrWrap,
    /// Flip every bit.
    Invert,
}

/// A factor of the blend equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // OpenGL's names
pub enum BlendFactor {
    Zero,
    One,
    SrcAlpha,
    OneMinusSrcAlpha,
    DstAlpha,
    OneMinusDstAlpha,
}

/// What `glEnable` turns on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // OpenGL's names
pub enum Capability {
    DepthTest,
    StencilTest,
    Blend,
    DepthClamp,
}

/// What `glClear` clears.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)] // the names say it
pub struct Buffers {
    pub color: bool,
    pub depth: bool,
    pub stencil: bool,
}

/// A texture by the name that the text has for it, with a number where there is a row of them (`layer 3`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Map {
    /// The text's name.
    pub name: &'static str,
    /// Which of them.
    pub index: Index,
}

/// Which of a row of maps.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Index {
    /// There is only one.
    Only,
    /// This one.
    Number(u32),
    /// The one a variable says; [`run`](crate::steps::run) resolves it before a machine sees it.
    Variable(&'static str),
}

impl Map {
    /// The only one of that name.
    pub const fn named(name: &'static str) -> Self {
        Self {
            name,
            index: Index::Only,
        }
    }

    /// One of a row.
    pub const fn numbered(name: &'static str, number: u32) -> Self {
        Self {
            name,
            index: Index::Number(number),
        }
    }

    /// The one of a row that `variable` says.
    pub const fn at(name: &'static str, variable: &'static str) -> Self {
        Self {
            name,
            index: Index::Variable(variable),
        }
    }
}

impl fmt::Display for Map {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            Index::Only => write!(f, "{}", self.name),
            Index::Number(number) => write!(f, "{} {number}", self.name),
            Index::Variable(variable) => write!(f, "{} {variable}", self.name),
        }
    }
}

/// A framebuffer by name. Which maps it draws to is state, set by [`Call::AttachColor`] and [`Call::AttachDepth`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Target(pub &'static str);

/// A program by the name of its fragment shader's file in `glsl/`, without the ending.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shader(pub &'static str);

/// A shader storage buffer by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Storage(pub &'static str);

/// An occlusion query by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Query(pub &'static str);

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Objects {
    /// Everything, in the order of submission.
    Scene,
    /// What is opaque.
    Opaque,
    /// What is not.
    Transparent,
    /// What is not opaque, of meshes whose triangles are exactly sorted.
    Sorted,
    /// What is not opaque, of all other meshes.
    Unsorted,
    /// The boxes around the volumes.
    Proxies,
    /// Two triangles over the whole viewport.
    Screen,
}

/// One call.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // OpenGL's calls and its parameters' names; what OpenGL does not have is documented
pub enum Call {
    ClearColor {
        red: f32,
        green: f32,
        blue: f32,
        alpha: f32,
    },
    ClearDepth {
        depth: f64,
    },
    ClearStencil {
        s: i32,
    },
    Clear {
        mask: Buffers,
    },
    Enable {
        cap: Capability,
    },
    Disable {
        cap: Capability,
    },
    DepthFunc {
        func: Compare,
    },
    DepthMask {
        flag: bool,
    },
    ColorMask {
        red: bool,
        green: bool,
        blue: bool,
        alpha: bool,
    },
    /// `glColorMask` for one of several color maps.
    ColorMaski {
        buf: u32,
        red: bool,
        green: bool,
        blue: bool,
        alpha: bool,
    },
    StencilMask {
        mask: u32,
    },
    StencilFunc {
        func: Compare,
        reference: i32,
        mask: u32,
    },
    StencilOp {
        sfail: StencilOp,
        dpfail: StencilOp,
        dppass: StencilOp,
    },
    BlendFunc {
        sfactor: BlendFactor,
        dfactor: BlendFactor,
    },
    BlendFuncSeparate {
        src_rgb: BlendFactor,
        dst_rgb: BlendFactor,
        src_alpha: BlendFactor,
        dst_alpha: BlendFactor,
    },
    /// Listing 1's 'depth unit n': the calls that follow go to that unit, as after ARB_multitexture's
    /// `glActiveTexture`. No OpenGL has it; [`DepthUnits`](crate::steps::DepthUnits) lowers it.
    ActiveDepthUnit {
        unit: u8,
    },
    /// Listing 1's 'bind buffer': gives the active depth unit its buffer. Lowered likewise.
    BindDepthBuffer {
        buffer: Map,
    },
    ActiveTexture {
        unit: u32,
    },
    BindTexture {
        texture: Map,
    },
    /// `glSamplerParameteri` with `GL_TEXTURE_COMPARE_FUNC`, on the sampler of texture unit 0, whose compare mode is
    /// always on: the shadow lookup. A sampler rather than the texture, so that the same depth buffer can be looked
    /// up as plain numbers by another unit.
    SamplerCompareFunc {
        func: Compare,
    },
    UseProgram {
        program: Shader,
    },
    /// `glUseProgram` with that one of a row of programs whose Local Array has so many elements (Lindholm et al. 2015,
    /// section 5.1: "the individual instances only differ by a single number").
    UseProgramOfSize {
        program: Shader,
        size: Index,
    },
    /// `glStencilFunc` with a reference that is computed.
    StencilReference {
        func: Compare,
        reference: Index,
        mask: u32,
    },
    /// `glClearBufferuiv` with `GL_COLOR` and zeros.
    ClearIntegers {
        drawbuffer: u32,
    },
    /// `glBindImageTexture`, for reading and writing.
    BindImage {
        unit: u32,
        texture: Map,
    },
    /// `glBindBufferBase` with `GL_SHADER_STORAGE_BUFFER`.
    BindStorage {
        index: u32,
        buffer: Storage,
    },
    /// `glMemoryBarrier` with `GL_ALL_BARRIER_BITS`.
    MemoryBarrier,
    BindFramebuffer {
        framebuffer: Target,
    },
    /// `glFramebufferTexture2D` with `GL_COLOR_ATTACHMENT0`.
    AttachColor {
        texture: Map,
    },
    /// `glFramebufferTexture2D` with `GL_DEPTH_STENCIL_ATTACHMENT`.
    AttachDepth {
        texture: Map,
    },
    BeginQuery {
        query: Query,
    },
    EndQuery {
        query: Query,
    },
    /// `glCopyImageSubData` of a whole image, every aspect. A destination that does not exist yet is made.
    CopyImage {
        from: Map,
        to: Map,
    },
    /// `swap(a, b)`: from here on each of two maps goes by the other's name. What is bound or attached stays so.
    Swap {
        a: Map,
        b: Map,
    },
    Draw {
        objects: Objects,
    },
    /// `glUniform1f` of the current program; the listing's variable of the uniform's name is its value.
    Uniform {
        name: &'static str,
        /// Nothing until the listing runs.
        value: Option<f32>,
    },
    /// One of the OpenGL of 2001.
    Classic(ClassicCall),
    /// One that names a draw buffer.
    DrawBuffer(DrawBufferCall),
}
