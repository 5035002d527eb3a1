//! `common/ideal.glsl`, `common/ideal_pass_1.glsl` and `common/ideal_surface.glsl`: what Algorithm 2 keeps at a pixel.

use super::color::premultiplied;
use crate::low_level::emulator::color::Texel;
use crate::low_level::emulator::invocation::{Inputs, Kept, Outputs};

/// What a fragment reads and writes in its turn.
pub(in super::super) struct Pixel {
    /// z1, z2, z3, zPostFlag
    pub(in super::super) depths: [f32; 4],
    /// Premultiplied, front to back.
    image: [f32; 4],
    /// zPeel
    pub(in super::super) peel: [f32; 4],
}

impl Pixel {
    pub(in super::super) fn load(i: &Inputs<'_>) -> Self {
        let [depths, image, peel] = [0, 1, 2].map(|number| match i.is("IMAGES") {
            true => i.image(number).color(),
            false => i.fetched(number as usize).color(),
        });
        Self {
            depths,
            image,
            peel,
        }
    }

    pub(in super::super) fn store(self, i: &Inputs<'_>) -> Outputs {
        let all = [self.depths, self.image, self.peel].map(Texel::Color);
        let mut kept = Kept::default();
        match i.is("IMAGES") {
            true => kept.images = (0..).zip(all).collect(),
            false => kept.colors = all.to_vec(),
        }
        Some(kept)
    }

    /// Where a run ends: at what interrupts it, or at the nearest surface submitted before it.
    pub(in super::super) fn tight_bound(&self) -> f32 {
        let [_, z2, z3, post] = self.depths;
        if post != 0.0 { z3 } else { z2 }
    }

    /// Lines 14 to 30. Returns whether the fragment lies in the range.
    pub(in super::super) fn peel_fragment(&mut self, z: f32) -> bool {
        let [z1, z2, z3, post] = self.depths;
        if !(self.peel[0] < z && z < z2) {
            return false;
        }
        self.depths = if z < z1 {
            [z, z1, z, 0.0]
        } else if post != 0.0 {
            [z1, z2, z3.min(z), post]
        } else {
            [z1, z2, z, if z < z3 { 1.0 } else { 0.0 }]
        };
        true
    }

    /// 'Composite fragment into color buffer', front to back.
    pub(in super::super) fn composite_fragment(&mut self, i: &Inputs<'_>) {
        let fragment = premultiplied(i.surface_color());
        let visible = 1.0 - self.image[3];
        for (image, fragment) in self.image.iter_mut().zip(fragment) {
            *image += fragment * visible;
        }
    }
}

pub(in super::super) fn opaque_depth(i: &Inputs<'_>) -> f32 {
    i.texel(4)[0]
}
