//! Methods and scenes of the claims of Carr, Měch and Miller 2008.

use super::render::example;
use onionskin::generate::{Slices, SubmissionOrder, slices};
use onionskin::low_level::methods::Technique;
use onionskin::options::{
    HybridLayerPeelingOptions, IdealOptions, LayerPeelingOptions, TriangleSort,
};
use onionskin::{Comparison, Context, Frame, Method, Scene};

pub fn ideal(sorting: TriangleSort) -> Method {
    Method::IdealCoherentLayerPeeling(IdealOptions {
        sorting,
        ..IdealOptions::default()
    })
}

pub const LAYERS: Method = Method::LayerPeeling(LayerPeelingOptions {
    reading: onionskin::options::Reading::Amended,
});
pub const HYBRID: Method = Method::HybridLayerPeeling(HybridLayerPeelingOptions {
    reading: onionskin::options::Reading::Amended,
});

pub fn error(frame: &Frame, exact: &Frame) -> f64 {
    Comparison::new(&frame.image, &exact.image, 0.0)
        .unwrap()
        .max
}

/// Figure 1: slices through a volume, front to back, and a cone that goes through them.
pub fn figure_1(count: u32, size: [u32; 2]) -> Scene {
    let mut scene = example("slices", size);
    let parameters = Slices {
        count,
        size: 2.0,
        cells: 1,
        alpha: 0.02,
        order: SubmissionOrder::FrontToBack,
        ..Slices::default()
    };
    let mut volume = slices(&parameters).unwrap();
    volume.sorted = true;
    scene.meshes[0] = volume;
    scene
}

/// Whether the driver is an ideal GPU, by framebuffer fetch or by interlocked images. Says aloud if it is not.
pub fn is_ideal(context: &Context) -> bool {
    let entry = Technique::entry(&IdealOptions::default());
    let runs = entry.runs_on(context.driver());
    if !runs {
        println!("skipped: the ideal GPU (none of {:?})", entry.needs);
    }
    runs
}
