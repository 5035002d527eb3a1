//! What shaders are compiled with, and what they are told besides maps.

use std::collections::HashMap;
use std::sync::Arc;

use glam::DVec3;

use crate::scene::Volume;
use crate::steps::Compare;

/// The ray through a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PixelRay {
    /// The eye, in the world.
    pub origin: DVec3,
    /// The vector along the ray for a distance of 1 along the view direction.
    pub direction: DVec3,
}

#[derive(Clone, Debug)]
pub(super) struct Settings {
    /// The `#define`s.
    pub(super) defines: HashMap<&'static str, u32>,
    /// The size of the Local Array of a program that is one of a row.
    pub(super) size: u32,
    /// The number of records that every pixel has room for, where buffers are fixed.
    pub(super) layers: u32,
    /// The distances of the near and the far plane.
    pub(super) planes: [f64; 2],
    /// Whether depths are 1/w.
    pub(super) inverse_w: bool,
    /// The scene's volumes, by their numbers.
    pub(super) volumes: Arc<[Volume]>,
    /// Each pixel's ray, if there are volumes.
    pub(super) rays: Vec<PixelRay>,
    /// The comparison of texture unit 0's shadow lookup.
    pub(super) compare_func: Compare,
}

impl Settings {
    pub(super) fn new() -> Self {
        Self {
            defines: HashMap::new(),
            size: 0,
            layers: u32::MAX,
            planes: [1.0, f64::INFINITY],
            inverse_w: false,
            volumes: Arc::new([]),
            rays: Vec::new(),
            compare_func: Compare::Lequal,
        }
    }
}

/// The distance along the view direction at which a fragment has this depth.
pub(super) fn distance([near, far]: [f64; 2], inverse_w: bool, depth: f32) -> f64 {
    if inverse_w {
        // `common/fragment_depth.glsl` counts down the bits of near / w from those of 1.
        let bits = 1.0_f32.to_bits() + f32::MIN_POSITIVE.to_bits() - depth.to_bits();
        return near / f64::from(f32::from_bits(bits));
    }
    // At 1/far = 0 the far plane is infinitely far away.
    near / (1.0 - f64::from(depth) * (1.0 - near / far))
}
