//! What the shaders are told when they are compiled.

use super::ABuffer;
use super::array_sort::network_size;
use super::options::{Keep, LARGEST_NETWORK, Manager, RecordColor, SMALLEST_SEGMENT};
use crate::gl::GlMachine;
use crate::steps::Reading;

/// More subpasses than a pixel can have, and a number that GLSL takes as an integer.
const NO_LIMIT: u32 = i32::MAX as u32;

impl ABuffer {
    /// The shaders' defines.
    pub(super) fn defines(
        &self,
        machine: &GlMachine<'_>,
        insertion: bool,
    ) -> Vec<(&'static str, u32)> {
        let options = &self.options;
        let quirks = machine.context().driver().quirks();
        let yes = u32::from;
        let deepest = match insertion {
            true => options.array,
            false => network_size(options, self.layers),
        };
        let mut defines = self.volumes.to_vec();
        defines.extend([
            ("MARKED", yes(self.marked)),
            ("OPAQUE", yes(self.opaque)),
            ("FFB", Manager::Ffb as u32),
            ("DFB", Manager::Dfb as u32),
            ("PPLL", Manager::Ppll as u32),
            ("MANAGER", options.manager as u32),
            ("OFFSETS", yes(options.has_offsets())),
            // Ordered fragments leave lists in the order of submission.
            ("IN_ORDER", yes(self.in_order(machine))),
            ("KEYS_AS_DOUBLES", yes(quirks.quick_doubles)),
            ("FLOAT_COLOR", yes(options.color == RecordColor::Float)),
            ("FIXED_COLOR", yes(options.color == RecordColor::Fixed)),
            ("TERMINATION", options.termination.to_bits()),
            // What differs is ppDP alone: without it, all readings are one program.
            ("AS_PRINTED", yes(options.pp_dp && options.is_printed())),
            (
                "LITERAL",
                yes(options.pp_dp && options.reading == Reading::Literal),
            ),
            ("PEEL_ALWAYS", yes(options.pp_dp && !options.pp_ao)),
            ("PP_DP", yes(options.pp_dp)),
            ("MOST_SUBPASSES", options.most_subpasses.unwrap_or(NO_LIMIT)),
            ("FIRST_SEGMENT", SMALLEST_SEGMENT),
            ("LAST_SEGMENT", options.array),
            ("KEEP_NEAREST", yes(options.keep == Keep::Nearest)),
            ("SORT_BY_INSERTION", yes(insertion)),
            ("LARGEST_NETWORK", LARGEST_NETWORK),
            ("DEEPEST", deepest),
        ]);
        defines
    }
}
