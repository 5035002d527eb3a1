//! The OpenGL of 2001. [`GlMachine`](super::GlMachine) emulates its calls in GLSL. [`FixedFunction`] makes the real
//! calls, on a compatibility profile that still has them, so that tests can compare the emulation with them.
//!
//! NV_texture_shader exists on no driver of today, so Listing 2's use of it is only emulated, and compared with the
//! paper's equations. So are the register combiners that carry a comparison into alpha.
//!
//! Excludes: texture coordinates other than generated ones, fixed-function lighting (a surface's own colour is the
//! primary colour), the environment modes other than REPLACE and MODULATE, filtering.

mod emulation;
mod fixed_function;
mod state;

pub(super) use emulation::{Around, Classic};
pub use fixed_function::FixedFunction;
pub use state::{ClassicState, CombinerInput, TextureUnit, UNITS};
