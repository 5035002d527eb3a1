//! Section 9: the order of submission, and what coherent layer peeling takes for it.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Drawn, Figure, Studio, printed};
use crate::methods::{CoherentOptions, Method, TriangleSort, Variant};

pub(super) const FIGURE: Figure = Figure {
    key: "carr-sorting",
    source: "Carr et al. 2008, section 9",
    title: "Four orders of submission, and one image",
    make,
};

fn make(studio: &Studio) -> Result<Drawn> {
    let mut scene = studio.scene("molecule", [288, 216])?;
    // In the order of the scene file: ligand, ribbon, two isosurfaces, surface. The surface takes long.
    let shown = studio.number(&[1, 4][..], &[1][..]);
    scene.meshes = shown
        .iter()
        .map(|&mesh| scene.meshes[mesh].clone())
        .collect();
    let mut shuffled = scene.clone();
    for mesh in &mut shuffled.meshes {
        *mesh = mesh.shuffled(7);
    }
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let layers = renderer
        .render(&scene, &Method::LayerPeeling(Default::default()))?
        .stats;
    let mut drawn = Drawn::new(
        "A molecule's ribbon, and its surface in the whole edition. Sorted front to back, a few iterations are enough. The image is the same in each \
         order. What a bad order costs is iterations. In the worst one an iteration finds two layers, where layer peeling finds \
         one, but draws everything five times instead of twice.",
    );
    let mut rows = vec![vec![
        "layer peeling, in any order".into(),
        layers.iterations.to_string(),
        layers.geometry_passes.to_string(),
        String::new(),
    ]];
    for (name, scene, sorting) in [
        ("sorted front to back", &scene, TriangleSort::Buckets(4096)),
        ("as in the files", &scene, TriangleSort::Submission),
        ("shuffled", &shuffled, TriangleSort::Submission),
        ("sorted back to front", &scene, TriangleSort::Reversed(4096)),
    ] {
        let method = Method::CoherentLayerPeeling(CoherentOptions {
            sorting,
            ..Variant::B.into()
        });
        let frame = renderer.render(scene, &method)?;
        let error = Comparison::new(&frame.image, &exact, 0.0)?.max;
        if rows.len() == 1 {
            drawn = drawn.picture(
                "molecule",
                &frame.image,
                "in any order",
                "a translucent, folded ribbon",
            );
        }
        rows.push(vec![
            name.into(),
            frame.stats.iterations.to_string(),
            frame.stats.geometry_passes.to_string(),
            printed::error(error),
        ]);
    }
    Ok(drawn.table(
        "Coherent layer peeling B",
        &["order", "iterations", "geometry passes", "largest error"],
        rows,
    ))
}
