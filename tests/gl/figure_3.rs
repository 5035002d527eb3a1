//! Figure 3 of Carr, Měch and Miller (2008) in work instead of time (C27): how many slices are drawn in all, by how many there
//! are. Iterations are in `gl/claims_carr_work.rs` (C04), and `examples/24_figure_3.rs` draws both.

use crate::kit::carr_scenes::{HYBRID, LAYERS, figure_1};
use crate::kit::render::render;
use onionskin::options::Variant;
use onionskin::{Context, Method};

/// The triangles of slices that a frame draws. The cone's are as many whatever the number of slices, and are left out: each
/// geometry pass draws all of the slices, all of the cone, or both.
fn drawn(context: &Context, count: u32, method: &Method) -> f64 {
    let scene = figure_1(count, [16, 12]);
    let [slices, cone] = [0, 1].map(|mesh| scene.meshes[mesh].triangles.len() as f64);
    let stats = render(context, &scene, method).stats;
    assert_eq!(stats.lost, Some(0), "{method}");
    let triangles = stats.triangles as f64;
    match method {
        // A pass draws one of the two: the sorted slices or the cone.
        Method::HybridLayerPeeling(_) => {
            let passes = stats.geometry_passes as f64;
            (triangles - passes * cone) / (slices - cone) * slices
        }
        _ => triangles * slices / (slices + cone),
    }
}

#[test]
pub(crate) fn c27_work_grows_with_the_square_of_the_slices_for_layer_peeling_only() {
    let context = Context::headless().unwrap();
    let [a, b] =
        [Variant::A, Variant::B].map(|variant| Method::CoherentLayerPeeling(variant.into()));
    for (method, growth) in [
        (LAYERS, 3.7..4.0),
        (HYBRID, 2.0..2.01),
        (a, 2.0..2.01),
        (b, 2.0..2.01),
    ] {
        let work = [32, 64, 128].map(|count| drawn(&context, count, &method));
        println!("{method}: {work:?}");
        for pair in work.windows(2) {
            let factor = pair[1] / pair[0];
            assert!(growth.contains(&factor), "{method}: {factor}");
        }
    }
}
