//! A call's name in GL, and its arguments with their names: what a trace and a listing print.

use std::fmt;

use super::call::*;

impl fmt::Display for Call {
    /// With its arguments named: `glDepthFunc(func = GL_LESS)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (name, arguments) = signature(self);
        let named: Vec<_> = arguments
            .iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        write!(f, "{name}({})", named.join(", "))
    }
}

/// The call's name in GL, and its arguments' names and values.
pub(super) fn signature(call: &Call) -> (&'static str, Vec<(&'static str, String)>) {
    macro_rules! call {
        ($name:literal $(, $argument:literal = $value:expr)*) => {
            ($name, vec![$(($argument, $value.to_string())),*])
        };
    }
    let gl = |constant: &str| format!("GL_{constant}");
    let bool = |flag: bool| if flag { "GL_TRUE" } else { "GL_FALSE" };
    match *call {
        Call::ClearColor {
            red,
            green,
            blue,
            alpha,
        } => call!(
            "glClearColor",
            "red" = format!("{red:?}"),
            "green" = format!("{green:?}"),
            "blue" = format!("{blue:?}"),
            "alpha" = format!("{alpha:?}")
        ),
        Call::ClearDepth { depth } => call!("glClearDepth", "depth" = format!("{depth:?}")),
        Call::ClearStencil { s } => call!("glClearStencil", "s" = s),
        Call::Clear { mask } => call!("glClear", "mask" = buffers(mask)),
        Call::Enable { cap } => call!("glEnable", "cap" = gl(capability(cap))),
        Call::Disable { cap } => call!("glDisable", "cap" = gl(capability(cap))),
        Call::DepthFunc { func } => call!("glDepthFunc", "func" = gl(compare(func))),
        Call::DepthMask { flag } => call!("glDepthMask", "flag" = bool(flag)),
        Call::ColorMask {
            red,
            green,
            blue,
            alpha,
        } => call!(
            "glColorMask",
            "red" = bool(red),
            "green" = bool(green),
            "blue" = bool(blue),
            "alpha" = bool(alpha)
        ),
        Call::ColorMaski {
            buf,
            red,
            green,
            blue,
            alpha,
        } => call!(
            "glColorMaski",
            "buf" = buf,
            "red" = bool(red),
            "green" = bool(green),
            "blue" = bool(blue),
            "alpha" = bool(alpha)
        ),
        Call::StencilMask { mask } => call!("glStencilMask", "mask" = format!("0x{mask:02X}")),
        Call::StencilFunc {
            func,
            reference,
            mask,
        } => call!(
            "glStencilFunc",
            "func" = gl(compare(func)),
            "ref" = reference,
            "mask" = format!("0x{mask:02X}")
        ),
        Call::StencilOp {
            sfail,
            dpfail,
            dppass,
        } => call!(
            "glStencilOp",
            "sfail" = gl(stencil_op(sfail)),
            "dpfail" = gl(stencil_op(dpfail)),
            "dppass" = gl(stencil_op(dppass))
        ),
        Call::BlendFunc { sfactor, dfactor } => {
            call!(
                "glBlendFunc",
                "sfactor" = gl(factor(sfactor)),
                "dfactor" = gl(factor(dfactor))
            )
        }
        Call::BlendFuncSeparate {
            src_rgb,
            dst_rgb,
            src_alpha,
            dst_alpha,
        } => call!(
            "glBlendFuncSeparate",
            "srcRGB" = gl(factor(src_rgb)),
            "dstRGB" = gl(factor(dst_rgb)),
            "srcAlpha" = gl(factor(src_alpha)),
            "dstAlpha" = gl(factor(dst_alpha))
        ),
        Call::ActiveDepthUnit { unit } => call!("activeDepthUnit", "unit" = unit),
        Call::BindDepthBuffer { buffer } => call!("bindDepthBuffer", "buffer" = buffer),
        Call::ActiveTexture { unit } => {
            call!("glActiveTexture", "texture" = format!("GL_TEXTURE{unit}"))
        }
        Call::BindTexture { texture } => {
            call!(
                "glBindTexture",
                "target" = "GL_TEXTURE_2D",
                "texture" = texture
            )
        }
        Call::SamplerCompareFunc { func } => call!(
            "glSamplerParameteri",
            "sampler" = "shadow",
            "pname" = "GL_TEXTURE_COMPARE_FUNC",
            "param" = gl(compare(func))
        ),
        Call::UseProgram { program } => call!("glUseProgram", "program" = program.0),
        Call::UseProgramOfSize { program, size } => {
            call!("glUseProgram", "program" = program.0, "N" = number(size))
        }
        Call::StencilReference {
            func,
            reference,
            mask,
        } => call!(
            "glStencilFunc",
            "func" = gl(compare(func)),
            "ref" = number(reference),
            "mask" = format!("0x{mask:02X}")
        ),
        Call::ClearIntegers { drawbuffer } => call!(
            "glClearBufferuiv",
            "buffer" = "GL_COLOR",
            "drawbuffer" = drawbuffer,
            "value" = "{0, 0, 0, 0}"
        ),
        Call::BindImage { unit, texture } => call!(
            "glBindImageTexture",
            "unit" = unit,
            "texture" = texture,
            "access" = "GL_READ_WRITE"
        ),
        Call::BindStorage { index, buffer } => call!(
            "glBindBufferBase",
            "target" = "GL_SHADER_STORAGE_BUFFER",
            "index" = index,
            "buffer" = buffer.0
        ),
        Call::MemoryBarrier => call!("glMemoryBarrier", "barriers" = "GL_ALL_BARRIER_BITS"),
        Call::BindFramebuffer { framebuffer } => {
            call!(
                "glBindFramebuffer",
                "target" = "GL_FRAMEBUFFER",
                "framebuffer" = framebuffer.0
            )
        }
        Call::AttachColor { texture } => attach("GL_COLOR_ATTACHMENT0", texture),
        Call::AttachDepth { texture } => attach("GL_DEPTH_STENCIL_ATTACHMENT", texture),
        Call::BeginQuery { query } => call!(
            "glBeginQuery",
            "target" = "GL_SAMPLES_PASSED",
            "id" = query.0
        ),
        Call::EndQuery { query } => {
            call!("glEndQuery", "target" = "GL_SAMPLES_PASSED", "id" = query.0)
        }
        Call::Swap { a, b } => call!("swap", "a" = a, "b" = b),
        Call::CopyImage { from, to } => call!("glCopyImageSubData", "src" = from, "dst" = to),
        Call::Draw {
            objects: Objects::Scene,
        } => call!("drawScene"),
        Call::Draw {
            objects: Objects::Opaque,
        } => call!("drawOpaqueObjects"),
        Call::Draw {
            objects: Objects::Transparent,
        } => call!("drawTransparentObjects"),
        Call::Draw {
            objects: Objects::Sorted,
        } => call!("drawSortedObjects"),
        Call::Draw {
            objects: Objects::Unsorted,
        } => call!("drawUnsortedObjects"),
        Call::Draw {
            objects: Objects::Proxies,
        } => call!("drawProxies"),
        Call::Draw {
            objects: Objects::Screen,
        } => call!("drawScreen"),
        Call::Uniform { name, value } => call!(
            "glUniform1f",
            "location" = name,
            "v0" = value.map_or_else(|| name.to_owned(), |value| value.to_string())
        ),
        Call::Classic(call) => call.signature(),
        Call::DrawBuffer(call) => call.signature(),
    }
}

fn number(index: Index) -> String {
    match index {
        Index::Only => "1".into(),
        Index::Number(number) => number.to_string(),
        Index::Variable(name) => name.into(),
    }
}

fn attach(attachment: &'static str, texture: Map) -> (&'static str, Vec<(&'static str, String)>) {
    let arguments = vec![
        ("target", "GL_FRAMEBUFFER".into()),
        ("attachment", attachment.into()),
        ("textarget", "GL_TEXTURE_2D".into()),
        ("texture", texture.to_string()),
    ];
    ("glFramebufferTexture2D", arguments)
}

fn buffers(mask: Buffers) -> String {
    let names = [
        (mask.color, "GL_COLOR_BUFFER_BIT"),
        (mask.depth, "GL_DEPTH_BUFFER_BIT"),
        (mask.stencil, "GL_STENCIL_BUFFER_BIT"),
    ];
    let set: Vec<_> = names
        .into_iter()
        .filter(|(set, _)| *set)
        .map(|(_, name)| name)
        .collect();
    set.join(" | ")
}

pub(super) const fn compare(func: Compare) -> &'static str {
    match func {
        Compare::Never => "NEVER",
        Compare::Less => "LESS",
        Compare::Equal => "EQUAL",
        Compare::Lequal => "LEQUAL",
        Compare::Greater => "GREATER",
        Compare::Notequal => "NOTEQUAL",
        Compare::Gequal => "GEQUAL",
        Compare::Always => "ALWAYS",
    }
}

const fn capability(cap: Capability) -> &'static str {
    match cap {
        Capability::DepthTest => "DEPTH_TEST",
        Capability::StencilTest => "STENCIL_TEST",
        Capability::Blend => "BLEND",
        Capability::DepthClamp => "DEPTH_CLAMP",
    }
}

const fn stencil_op(op: StencilOp) -> &'static str {
    match op {
        StencilOp::Keep => "KEEP",
        StencilOp::Zero => "ZERO",
        StencilOp::Replace => "REPLACE",
        StencilOp::Incr => "INCR",
        StencilOp::IncrWrap => "INCR_WRAP",
        StencilOp::Decr => "DECR",
        StencilOp::DecrWrap => "DECR_WRAP",
        StencilOp::Invert => "INVERT",
    }
}

pub(super) const fn factor(factor: BlendFactor) -> &'static str {
    match factor {
        BlendFactor::Zero => "ZERO",
        BlendFactor::One => "ONE",
        BlendFactor::SrcAlpha => "SRC_ALPHA",
        BlendFactor::OneMinusSrcAlpha => "ONE_MINUS_SRC_ALPHA",
        BlendFactor::DstAlpha => "DST_ALPHA",
        BlendFactor::OneMinusDstAlpha => "ONE_MINUS_DST_ALPHA",
    }
}
