//! What drivers do otherwise than others, as far as OpenGL has no question for it. It is known by a driver's name. What can
//! be tried out is a [`Trap`](super::Trap), and what can be asked for is in [`Driver`](super::Driver).

/// What a driver does otherwise than OpenGL says, or than most drivers do. The default is a driver without a quirk.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Quirks {
    /// The loops of a shader end early, without an error. A pixel that reaches the limit loses fragments or samples, so
    /// methods must stay below it.
    pub loop_limit: Option<LoopLimit>,
    /// The driver bins all triangles of a pass, and then draws tile by tile on the CPU. If a pass writes lists of at
    /// most so many bytes, the part that a tile needs stays in a core's cache, and the pass is quicker. On 64 quads with
    /// lists of 8 MiB, llvmpipe took three quarters of the time that it took with 128 MiB.
    pub cached_bytes: Option<u64>,
    /// The shader's invocations of a pixel run in the order of submission, without an interlock. OpenGL does not promise
    /// that of atomics and images. Llvmpipe keeps the order, because one thread draws all of a tile.
    pub runs_in_order: bool,
    /// Doubles are compared and exchanged many at a time, and faster than pairs of words. Most GPUs have few units for
    /// doubles, and NVIDIA's driver (580.159) composites other fragments if keys are doubles
    /// (`glsl/a_buffer/local_array.glsl`).
    pub quick_doubles: bool,
    /// A fixed-point depth of n bits is sampled as its whole number times the f32 that is nearest to 1/(2^n - 1), and
    /// a fragment's depth is compared before it is rounded to such a number. OpenGL says a quotient, and the same
    /// rounding for both. So a sampled depth may differ from the one that was stored.
    pub fixed_depths_are_products: bool,
    /// A blend in 32-bit float rounds each of its two products and their sum, as the emulated pixel does. OpenGL leaves
    /// that open: a GPU may round a product and the sum together.
    pub blends_in_three_roundings: bool,
    /// Depths are interpolated between the corners where they are. GPUs interpolate between the corners as they were snapped
    /// to a grid of 1/256 pixel: on 160 x 120 pixels an H100's depths were up to 20 times as far from the true ones as
    /// llvmpipe's may be.
    pub interpolates_true_corners: bool,
    /// The environment variable `MESA_GL_VERSION_OVERRIDE` makes the driver offer less than it has.
    pub obeys_version_override: bool,
}

/// The most iterations of a shader's loops.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LoopLimit {
    /// The iterations of all loops of an invocation together.
    pub iterations: u64,
    /// So many pixels are shaded together. They share their loops, which go on as long as any of them does.
    pub pixels: u64,
}

impl Quirks {
    /// By `GL_RENDERER` and `GL_VERSION`.
    pub(super) fn of(renderer: &str, version: &str) -> Self {
        let is_mesa = version.contains("Mesa");
        let none = Self {
            obeys_version_override: is_mesa,
            ..Self::default()
        };
        // By way of Vulkan, too.
        if !renderer.contains("llvmpipe") {
            return none;
        }
        Self {
            // LP_MAX_TGSI_LOOP_ITERATIONS, in Mesa 22.3 to 25, and vectors of 8 pixels.
            loop_limit: Some(LoopLimit {
                iterations: 65_535,
                pixels: 8,
            }),
            cached_bytes: Some(8 << 20),
            runs_in_order: true,
            quick_doubles: true,
            fixed_depths_are_products: true,
            blends_in_three_roundings: true,
            interpolates_true_corners: true,
            ..none
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn llvmpipe_has_its_quirks_whatever_its_llvm_and_its_mesa() {
        for (renderer, version) in [
            (
                "llvmpipe (LLVM 15.0.6, 256 bits)",
                "4.5 (Core Profile) Mesa 22.3.6",
            ),
            (
                "llvmpipe (LLVM 19.1.0, 128 bits)",
                "4.5 (Compatibility Profile) Mesa 25.0.1-1",
            ),
            (
                "zink Vulkan 1.3 (llvmpipe (LLVM 15.0.6, 256 bits))",
                "4.6 (Core Profile) Mesa 23.1.0",
            ),
        ] {
            let quirks = Quirks::of(renderer, version);
            let limit = quirks.loop_limit.unwrap();
            assert_eq!([limit.iterations, limit.pixels], [65_535, 8]);
            assert_eq!(quirks.cached_bytes, Some(8_388_608));
            assert!(
                quirks.runs_in_order && quirks.quick_doubles && quirks.fixed_depths_are_products
            );
            assert!(quirks.obeys_version_override);
        }
    }

    #[test]
    fn other_drivers_of_mesa_have_only_its_variables() {
        for renderer in [
            "softpipe",
            "AMD Radeon RX 6600 (radeonsi, navi23, LLVM 15.0.6, DRM 3.49)",
            "Mesa Intel(R) UHD Graphics 620 (KBL GT2)",
            "",
        ] {
            let expected = Quirks {
                obeys_version_override: true,
                ..Quirks::default()
            };
            let found = Quirks::of(renderer, "4.6 (Core Profile) Mesa 23.1.0");
            assert_eq!(found, expected, "{renderer}");
        }
    }

    #[test]
    fn a_driver_that_is_not_mesa_has_none() {
        for (renderer, version) in [
            ("NVIDIA H100 PCIe/PCIe/SSE2", "4.6.0 NVIDIA 535.129.03"),
            ("Apple M1", "4.1 Metal - 88"),
        ] {
            assert_eq!(Quirks::of(renderer, version), Quirks::default());
        }
    }
}
