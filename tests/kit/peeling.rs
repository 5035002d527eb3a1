//! One frame by depth peeling, and how far it may be off.

use onionskin::options::DepthPeelingOptions;
use onionskin::{Context, Frame, Method, Renderer, Scene};

pub fn peel(context: &Context, scene: &Scene, options: DepthPeelingOptions) -> Frame {
    let mut renderer = Renderer::new(context, scene.size[0], scene.size[1]).unwrap();
    renderer
        .render(scene, &Method::DepthPeeling(options))
        .unwrap()
}
