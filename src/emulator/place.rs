//! Maps, and one pixel of a framebuffer: the values that a fragment finds there, and those that it leaves.

use super::record::FragmentOutcome;
use super::stages;
use super::state::State;
use super::{color, depth};
use crate::steps::Format;

/// A map's texels, one per pixel.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) format: Format,
    /// The texels of a color map. Channels that its format lacks are 0.
    pub(super) colors: Vec<[f32; 4]>,
    /// The depths of a depth map, as its format stores them.
    pub(super) depths: Vec<f32>,
    pub(super) stencils: Vec<u8>,
}

/// The maps into which a framebuffer draws.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Attached {
    pub(super) color: Option<usize>,
    pub(super) depth: Option<usize>,
}

/// The value that a lookup reads. An unbound unit reads 0.
pub(super) fn texel(planes: &[Plane], bound: Option<usize>, pixel: usize) -> [f32; 4] {
    let Some(plane) = bound.map(|plane| &planes[plane]) else {
        return [0.0; 4];
    };
    match plane.format.has_depth() {
        true => {
            let depth = depth::sampled_by_llvmpipe(plane.format, plane.depths[pixel]);
            [depth, 0.0, 0.0, 1.0]
        }
        false => plane.colors[pixel],
    }
}

pub(super) fn write_masked(texel: &mut [f32; 4], new: [f32; 4], mask: [bool; 4]) {
    for ((texel, new), mask) in texel.iter_mut().zip(new).zip(mask) {
        if mask {
            *texel = new;
        }
    }
}

/// One pixel of a framebuffer: the values that a fragment finds, and those that it leaves.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) depth_format: Option<Format>,
    pub(super) depth: f32,
    pub(super) stencil: u8,
    pub(super) color_format: Option<Format>,
    pub(super) color: [f32; 4],
}

impl Place {
    pub(super) fn at(planes: &[Plane], attached: Attached, pixel: usize) -> Self {
        let depth = attached.depth.map(|plane| &planes[plane]);
        let color = attached.color.map(|plane| &planes[plane]);
        Self {
            depth_format: depth.map(|plane| plane.format),
            depth: depth.map_or(1.0, |plane| plane.depths[pixel]),
            stencil: depth.map_or(0, |plane| plane.stencils[pixel]),
            color_format: color.map(|plane| plane.format),
            color: color.map_or([0.0; 4], |plane| plane.colors[pixel]),
        }
    }

    /// Sends a fragment through the stages.
    pub(super) fn send(&mut self, state: &State, z: f32, source: [f32; 4]) -> FragmentOutcome {
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
        // Writing. Without a depth test, nothing is written to the depth buffer.
        if depth_test && state.depth_mask {
            self.depth = z;
        }
        if let Some(format) = self.color_format {
            let source = source.map(|channel| color::blended(format, channel));
            let new = match &state.blend {
                Some(blend) => stages::blend(blend, source, self.color),
                None => source,
            };
            let new = new.map(|channel| color::stored(format, channel));
            write_masked(&mut self.color, new, state.color_mask);
        }
        FragmentOutcome::Pass
    }

    pub(super) fn write(self, planes: &mut [Plane], attached: Attached, pixel: usize) {
        if let Some(plane) = attached.depth {
            planes[plane].depths[pixel] = self.depth;
            planes[plane].stencils[pixel] = self.stencil;
        }
        if let Some(plane) = attached.color {
            planes[plane].colors[pixel] = self.color;
        }
    }
}
