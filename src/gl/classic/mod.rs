//! The OpenGL of 2001: emulated in GLSL ([`GlMachine`](super::GlMachine) takes the calls as they are), and the real one, where a
//! compatibility profile still has it ([`FixedFunction`]), to hold the emulation against.
//!
//! NV_texture_shader exists on no driver of today, so what Listing 2 does with it is emulated only, and held against the
//! paper's equations instead.
//!
//! Excludes: texture coordinates other than generated ones, fixed-function lighting (a surface's own colour is the
//! primary colour), the environment modes other than REPLACE and MODULATE, filtering.

mod emulation;
mod fixed_function;
mod state;

pub use fixed_function::FixedFunction;
pub use state::{ClassicState, TextureUnit, UNITS};

use std::collections::HashMap;

use super::texture::Texture;
use crate::steps::{Format, Map};

/// What a machine keeps for classic calls.
#[derive(Debug, Default)]
pub(super) struct Classic {
    /// Nothing before the first call of a frame.
    pub(super) state: Option<ClassicState>,
    /// Rectangle textures; in a table of their own, because nothing draws into them.
    pub(super) rectangles: HashMap<Map, (glow::Texture, Format)>,
    /// One sampler with compare mode for each unit.
    samplers: Vec<glow::Sampler>,
    hilo: Option<Texture>,
}
