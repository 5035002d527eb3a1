//! Calls that go to one of several draw buffers, as OpenGL 4.0 has them: each target of a framebuffer blends and is
//! cleared in a way of its own.

use super::call::BlendFactor;

/// How a blend combines source and destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlendEquation {
    /// Their sum, each times its factor.
    FuncAdd,
    /// The larger of the two, channel by channel; factors play no part.
    Max,
}

/// A call that names a draw buffer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)] // OpenGL's calls and its parameters' names
pub enum DrawBufferCall {
    /// `glBlendEquationi`
    BlendEquation { buf: u32, mode: BlendEquation },
    /// `glBlendFunci`
    BlendFunc {
        buf: u32,
        src: BlendFactor,
        dst: BlendFactor,
    },
    /// `glClearBufferfv` with `GL_COLOR`.
    Clear { drawbuffer: u32, value: [f32; 4] },
}

impl DrawBufferCall {
    /// The call's name in GL, and its arguments' names and values.
    pub(super) fn signature(&self) -> (&'static str, Vec<(&'static str, String)>) {
        match *self {
            Self::BlendEquation { buf, mode } => {
                let mode = match mode {
                    BlendEquation::FuncAdd => "GL_FUNC_ADD",
                    BlendEquation::Max => "GL_MAX",
                };
                let arguments = vec![("buf", buf.to_string()), ("mode", mode.into())];
                ("glBlendEquationi", arguments)
            }
            Self::BlendFunc { buf, src, dst } => {
                let gl = |factor| format!("GL_{}", super::signature::factor(factor));
                let arguments = vec![("buf", buf.to_string()), ("src", gl(src)), ("dst", gl(dst))];
                ("glBlendFunci", arguments)
            }
            Self::Clear { drawbuffer, value } => {
                let [r, g, b, a] = value;
                let arguments = vec![
                    ("buffer", "GL_COLOR".into()),
                    ("drawbuffer", drawbuffer.to_string()),
                    ("value", format!("{{{r:?}, {g:?}, {b:?}, {a:?}}}")),
                ];
                ("glClearBufferfv", arguments)
            }
        }
    }
}
