//! Methods and scenes of the claims of Carr, Měch and Miller 2008.

use onionskin::Method;
use onionskin::image::Comparison;
use onionskin::methods::{
    Frame, HybridLayerPeelingOptions, IdealOptions, LayerPeelingOptions, TriangleSort,
};

pub fn ideal(sorting: TriangleSort) -> Method {
    Method::IdealCoherentLayerPeeling(IdealOptions {
        sorting,
        ..IdealOptions::default()
    })
}

pub const LAYERS: Method = Method::LayerPeeling(LayerPeelingOptions { as_printed: false });
pub const HYBRID: Method =
    Method::HybridLayerPeeling(HybridLayerPeelingOptions { as_printed: false });

pub fn error(frame: &Frame, exact: &Frame) -> f64 {
    Comparison::new(&frame.image, &exact.image, 0.0)
        .unwrap()
        .max
}
