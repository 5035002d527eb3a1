//! Figures 4 and 5, whose models are not at hand: the meshes that stand in for them, semi-transparent.

use super::table_1::{VIEWS, models, seen_from};
use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::{Method, Variant};

pub(super) const FIGURE_4: Figure = Figure {
    key: "carr-4",
    source: "Carr et al. 2008, figure 4",
    title: "Semi-transparent meshes, in place of the engine, the car and the Siebel Center",
    make: figure_4,
};

pub(super) const FIGURE_5: Figure = Figure {
    key: "carr-5",
    source: "Carr et al. 2008, figure 5",
    title: "Semi-transparent meshes, in place of the Sponza atrium, Lucy and the dragon",
    make: figure_5,
};

const SIZE: [u32; 2] = [288, 216];

fn figure_4(studio: &Studio) -> Result<Drawn> {
    draw(
        studio,
        ["surface", "ribbon", "ligand"],
        "Three parts of a molecule: its surface, its ribbon and its ligand. The surface is folded and closed, so that a ray meets \
         it many times, as it meets an engine's or a building's walls. The ligand is many small closed meshes in one.",
    )
}

fn figure_5(studio: &Studio) -> Result<Drawn> {
    draw(
        studio,
        ["teapot", "torus knot", "potential +"],
        "A teapot, a torus knot and an isosurface of a molecule's potential. They are shallow from most sides, as Lucy and the \
         dragon are.",
    )
}

fn draw(studio: &Studio, names: [&str; 3], caption: &str) -> Result<Drawn> {
    let mut drawn = Drawn::new(format!(
        "{caption} Coherent layer peeling A has drawn them. Table 1 counts what it takes."
    ));
    for (name, mesh) in models(&studio.scene("molecule", SIZE)?)? {
        if !names.contains(&name.as_str()) {
            continue;
        }
        let scene = seen_from(&mesh, VIEWS[0].1, studio.size(SIZE));
        let mut renderer = studio.renderer(&scene)?;
        let method = Method::CoherentLayerPeeling(Variant::A.into());
        let frame = renderer.render(&scene, &method)?;
        let file = name.replace(' ', "-").replace('+', "positive");
        drawn = drawn.picture(
            &file,
            &frame.image,
            &format!("{name}, {} triangles", mesh.triangles.len()),
            &format!("the {name}, semi-transparent, from the front"),
        );
    }
    Ok(drawn)
}
