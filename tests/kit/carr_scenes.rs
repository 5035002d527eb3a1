//! Methods and scenes of the claims of Carr, Měch and Miller 2008.

use onionskin::image::Comparison;
use onionskin::methods::{Frame, IdealOptions, LayerPeelingOptions, Sorting};
use onionskin::{Context, Method, Renderer, Scene};

pub fn ideal(sorting: Sorting) -> Method {
    Method::IdealCoherentLayerPeeling(IdealOptions {
        sorting,
        ..IdealOptions::default()
    })
}

pub const LAYERS: Method = Method::LayerPeeling(LayerPeelingOptions { as_printed: false });
pub const HYBRID: Method = Method::HybridLayerPeeling(LayerPeelingOptions { as_printed: false });

pub fn render(context: &Context, scene: &Scene, method: &Method) -> Frame {
    let [width, height] = scene.size;
    Renderer::new(context, width, height)
        .unwrap()
        .render(scene, method)
        .unwrap()
}

pub fn error(frame: &Frame, exact: &Frame) -> f64 {
    Comparison::new(&frame.image, &exact.image, 0.0)
        .unwrap()
        .max
}

pub fn example(name: &str, size: [u32; 2]) -> Scene {
    Scene::load_at(format!("examples/scenes/{name}.toml"), Some(size)).unwrap()
}
