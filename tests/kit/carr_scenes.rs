//! Methods and scenes of the claims of Carr, Měch and Miller 2008.

use onionskin::options::{
    HybridLayerPeelingOptions, IdealOptions, LayerPeelingOptions, TriangleSort,
};
use onionskin::{Comparison, Frame, Method};

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
