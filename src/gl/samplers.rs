//! The samplers of the texture units: texel by texel, and on unit 0 with the comparison of a shadow lookup.

use glow::HasContext;

use super::host::UNITS;
use super::making::Making;
use crate::error::Result;

#[derive(Debug)]
pub(super) struct Samplers {
    /// With compare mode, of texture unit 0.
    shadow: glow::Sampler,
    /// Without, of the other units.
    pub(super) plain: glow::Sampler,
}

impl Samplers {
    /// The context is current.
    pub(super) fn new(making: &mut Making<'_>) -> Result<Self> {
        let samplers = Self {
            shadow: making.sampler()?,
            plain: making.sampler()?,
        };
        let gl = making.gl();
        take_the_nearest(gl, samplers.plain);
        take_the_nearest(gl, samplers.shadow);
        compare_to_reference(gl, samplers.shadow);
        Ok(samplers)
    }

    /// Binds them to the units of a machine. The context is current.
    pub(super) fn bind(&self, gl: &glow::Context) {
        for unit in 0..UNITS {
            let sampler = match unit {
                0 => Some(self.shadow),
                1..8 => Some(self.plain),
                // Volumes are fetched texel by texel, and classic calls bind their own.
                _ => None,
            };
            // SAFETY: the context is current, and the samplers are its own.
            unsafe { gl.bind_sampler(unit, sampler) };
        }
    }

    /// Sets the shadow lookup's comparison. The context is current.
    pub(super) fn set_comparison(&self, gl: &glow::Context, func: u32) {
        // SAFETY: the context is current, and the constant is OpenGL's own.
        unsafe {
            gl.sampler_parameter_i32(self.shadow, glow::TEXTURE_COMPARE_FUNC, func as i32);
        }
    }

    pub(super) fn delete(&self, gl: &glow::Context) {
        // SAFETY: the samplers are its own, and its owner lets go of it.
        unsafe {
            gl.delete_sampler(self.shadow);
            gl.delete_sampler(self.plain);
        }
    }
}

/// Has a sampler answer the nearest texel. The context is current.
pub(super) fn take_the_nearest(gl: &glow::Context, sampler: glow::Sampler) {
    for (name, value) in [
        (glow::TEXTURE_MIN_FILTER, glow::NEAREST),
        (glow::TEXTURE_MAG_FILTER, glow::NEAREST),
        (glow::TEXTURE_WRAP_S, glow::CLAMP_TO_EDGE),
        (glow::TEXTURE_WRAP_T, glow::CLAMP_TO_EDGE),
    ] {
        // SAFETY: the context is current, and the sampler exists.
        unsafe { gl.sampler_parameter_i32(sampler, name, value as i32) };
    }
}

/// Has a sampler compare a texel to a reference. The context is current.
pub(super) fn compare_to_reference(gl: &glow::Context, sampler: glow::Sampler) {
    let mode = glow::COMPARE_REF_TO_TEXTURE as i32;
    // SAFETY: the context is current, and the sampler exists.
    unsafe { gl.sampler_parameter_i32(sampler, glow::TEXTURE_COMPARE_MODE, mode) };
}
