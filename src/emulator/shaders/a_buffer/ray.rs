//! `a_buffer/ray.glsl`: the ray so far, front to back.

use crate::low_level::emulator::invocation::Inputs;
use crate::low_level::fragment::Fragment;

pub(super) struct Ray {
    pub(super) color: [f32; 3],
    pub(super) transparency: f32,
    pub(super) composited: u32,
    termination: f32,
}

impl Ray {
    pub(super) fn new(i: &Inputs<'_>) -> Self {
        Self {
            color: [0.0; 3],
            transparency: 1.0,
            composited: 0,
            termination: f32::from_bits(i.define("TERMINATION")),
        }
    }

    pub(super) fn ended(&self) -> bool {
        self.transparency < self.termination
    }

    pub(super) fn composite(&mut self, fragment: &Fragment) {
        let [r, g, b, a] = fragment.color.to_array();
        for (sum, channel) in self.color.iter_mut().zip([r, g, b]) {
            *sum += self.transparency * a * channel;
        }
        self.transparency *= 1.0 - a;
        self.composited += 1;
    }
}
