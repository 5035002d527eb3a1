//! One pixel of a framebuffer: the values that a fragment finds there, and those that it leaves.

use super::color::{self, Texel};
use super::depth;
use super::maps::{Attached, Plane};
use super::record::FragmentOutcome;
use super::stages;
use super::state::State;
use crate::steps::Format;

/// One pixel of a framebuffer.
#[derive(Clone)]
pub(super) struct Place {
    depth_format: Option<Format>,
    pub(super) depth: f32,
    pub(super) stencil: u8,
    /// Each color map's format, and what it has at the pixel.
    pub(super) colors: Vec<(Format, Texel)>,
}

impl Place {
    pub(super) fn at(planes: &[Plane], attached: &Attached, pixel: usize) -> Self {
        let depth = attached.depth.map(|plane| &planes[plane]);
        let colors = attached.colors.iter().map(|&plane| &planes[plane]);
        Self {
            depth_format: depth.map(|plane| plane.format),
            depth: depth.map_or(1.0, |plane| plane.depths[pixel]),
            stencil: depth.map_or(0, |plane| plane.stencils[pixel]),
            colors: colors
                .map(|plane| (plane.format, plane.texel(pixel)))
                .collect(),
        }
    }

    /// Tests a fragment. This writes the stencil value, and if the fragment passes, the depth.
    pub(super) fn test(&mut self, state: &State, z: f32) -> FragmentOutcome {
        let stencil_test = state
            .stencil_test
            .filter(|_| self.depth_format.is_some_and(Format::has_stencil));
        let stencil = self.stencil;
        let stencil_after = |op| match &stencil_test {
            Some(test) => stages::stencil_op(op, test, state.stencil_mask, stencil),
            None => stencil,
        };
        // Stencil test.
        if stencil_test.is_some_and(|test| !stages::stencil_test(&test, stencil)) {
            self.stencil = stencil_after(state.stencil_ops.sfail);
            return FragmentOutcome::StencilFail;
        }
        // Depth test.
        let depth_test = state.depth_test && self.depth_format.is_some();
        let z = self
            .depth_format
            .map_or(z, |format| depth::stored(format, z));
        if depth_test && !state.depth_func.holds(z, self.depth) {
            self.stencil = stencil_after(state.stencil_ops.dpfail);
            return FragmentOutcome::DepthFail;
        }
        self.stencil = stencil_after(state.stencil_ops.dppass);
        // Without a depth test, nothing is written to the depth buffer.
        if depth_test && state.depth_mask {
            self.depth = z;
        }
        FragmentOutcome::Pass
    }

    /// Blends and writes what a shader has for each color map. A map for which it has nothing, or nothing of the map's
    /// kind, is left as it is. OpenGL leaves that open.
    pub(super) fn write_colors(&mut self, state: &State, sources: &[Texel]) {
        let places = self.colors.iter_mut().zip(sources).zip(&state.buffers);
        for (((format, here), source), buffer) in places {
            match (here, *source) {
                (Texel::Color(here), Texel::Color(source)) => {
                    let source = color::blended(*format, source);
                    let new = match state.blend {
                        true => stages::blend(&buffer.blend, source, *here),
                        false => source,
                    };
                    write_masked(here, color::stored(*format, new), buffer.color_mask);
                }
                // Whole numbers are never blended.
                (Texel::Integers(here), Texel::Integers(source)) => {
                    write_masked(
                        here,
                        color::stored_integers(*format, source),
                        buffer.color_mask,
                    );
                }
                _ => {}
            }
        }
    }

    pub(super) fn write(&self, planes: &mut [Plane], attached: &Attached, pixel: usize) {
        if let Some(plane) = attached.depth {
            planes[plane].depths[pixel] = self.depth;
            planes[plane].stencils[pixel] = self.stencil;
        }
        for (&plane, (_, texel)) in attached.colors.iter().zip(&self.colors) {
            planes[plane].set(pixel, *texel);
        }
    }
}

pub(super) fn write_masked<T>(texel: &mut [T; 4], new: [T; 4], mask: [bool; 4]) {
    for ((texel, new), mask) in texel.iter_mut().zip(new).zip(mask) {
        if mask {
            *texel = new;
        }
    }
}
