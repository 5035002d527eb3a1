//! Table 1: the four scenes.

use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::CountBy;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-table-1",
    source: "Lindholm et al. 2015, table 1",
    title: "Four scenes, and what is in them",
    make,
};

/// Each scene's file, its name in the paper, and the paper's static array for it (section 7.2).
pub const SCENES: [(&str, &str, u32); 4] = [
    ("molecule_fused", "protein", 64),
    ("space", "space", 32),
    ("medical", "medical", 128),
    ("flow", "cfd", 128),
];

/// The paper's sources.
const PAPER: [&str; 4] = [
    "volumes of 127³ and 71³ samples; 868k and 36k triangles",
    "two volumes of 256³ samples; 162k, 100k and 67k triangles",
    "volumes of 415 x 487 x 176 and 367 x 395 x 150 samples; 363k triangles and 1678 fibres",
    "a volume of 76 x 49 x 45 samples; 7.5k streamlines and some 100 arrows",
];

/// The size of the scenes' pictures, too: so each scene is loaded once.
pub(super) const SIZE: [u32; 2] = [336, 252];

fn make(studio: &Studio) -> Result<Drawn> {
    let mut rows = Vec::new();
    for ((file, name, _), paper) in SCENES.into_iter().zip(PAPER) {
        let scene = studio.scene(file, SIZE)?;
        let complexity = studio
            .renderer(&scene)?
            .complexity(&scene, CountBy::AllGeometry)?;
        let volumes: Vec<String> = scene
            .volumes
            .iter()
            .map(|volume| volume.dims().map(|side| side.to_string()).join(" x "))
            .collect();
        rows.push(vec![
            name.into(),
            paper.into(),
            volumes.join(", "),
            scene.triangle_count().to_string(),
            complexity.max().to_string(),
            complexity.percentile(0.5).to_string(),
        ]);
    }
    let size = studio.size(SIZE);
    Ok(Drawn::new(
        "The scenes here are after the paper's, and have the same kinds of sources. Half of the covered pixels have at most the \
         median's layers, which is far below the most.",
    )
    .table(
        &format!("Sources, and layers as the paper counts them, {} x {} pixels", size[0], size[1]),
        &["scene", "the paper's data", "volumes here", "triangles here", "most layers", "median"],
        rows,
    ))
}
