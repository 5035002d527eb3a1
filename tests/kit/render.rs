//! Frames of a scene at its own size.

use onionskin::{Context, Frame, Method, Renderer, Scene};

pub fn render(context: &Context, scene: &Scene, method: &Method) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, method).unwrap()
}

/// A bundled scene at a size of its own.
pub fn example(name: &str, size: [u32; 2]) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
    Scene::load_at(format!("{folder}/{name}.toml"), Some(size)).unwrap()
}
