//! One frame by depth peeling, and how far it may be off.

use onionskin::methods::{DepthPeelingOptions, Frame};
use onionskin::{Context, Method, Renderer, Scene};

/// f32 colours composited in at most 64 roundings of 2^-24 each, and the oracle's own rounding to f32: 4e-6. The issue
/// that asked for exactness allows 1e-5.
pub const F32: f64 = 1e-5;

pub fn peel(context: &Context, scene: &Scene, options: DepthPeelingOptions) -> Frame {
    let mut renderer = Renderer::new(context, scene.size[0], scene.size[1]).unwrap();
    renderer
        .render(scene, &Method::DepthPeeling(options))
        .unwrap()
}
