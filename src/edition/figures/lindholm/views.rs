//! Figures 1, 8, 9 and 10: a scene, its surfaces, its volumes, its depth complexity, and the histogram of that.

use super::table_1::SIZE;
use crate::error::Result;
use crate::low_level::edition::figures::plots::svg_of_plot;
use crate::low_level::edition::figures::printed::printed;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::low_level::report::{self, PlotKind};
use crate::methods::{ABufferOptions, Complexity, CountBy, Manager, Method, Renderer};
use crate::papers::lindholm_2015::PAPER;
use crate::scene::Scene;

pub(super) const FIGURE_1: Figure = Figure {
    key: "lindholm-1",
    source: "Lindholm et al. 2015, figure 1",
    title: "A protein among its electrostatic potential, and how many layers each pixel has",
    make: figure_1,
};

pub(super) const FIGURE_8: Figure = Figure {
    key: "lindholm-8",
    source: "Lindholm et al. 2015, figure 8",
    title: "An ejection of the sun's corona",
    make: figure_8,
};

pub(super) const FIGURE_9: Figure = Figure {
    key: "lindholm-9",
    source: "Lindholm et al. 2015, figure 9",
    title: "Fibres and a tumour in a head",
    make: figure_9,
};

pub(super) const FIGURE_10: Figure = Figure {
    key: "lindholm-10",
    source: "Lindholm et al. 2015, figure 10",
    title: "A flow",
    make: figure_10,
};

/// The opening of the zoomed view's camera, in parts of the whole view's.
const ZOOM: f64 = 0.35;

/// Every layer of a scene with volumes.
const RAYS: Method = Method::ABuffer(ABufferOptions {
    manager: Manager::Dfb,
    pp_dp: true,
    ..ABufferOptions::DEFAULT
});

fn figure_1(studio: &Studio) -> Result<Drawn> {
    let drawn = Drawn::new(
        "The paper's protein is human carbonic anhydrase II. This one is HIV-1 protease with a drug in it, from the Protein Data \
         Bank. Flip through (a) to (d), then look at the histogram (e): the longest bars are those of few layers, and each step \
         upwards is ten times as many pixels. Even counts are higher than odd ones, because the surfaces are closed.",
    );
    let scene = studio.scene("molecule_fused", SIZE)?;
    let (drawn, complexity) = views(studio, &scene, drawn)?;
    let percent = |part: f64| format!("{:.1}%", 100.0 * part);
    Ok(drawn.table(
        "What the paper says of its protein, and what is counted here (other molecules, other sizes)",
        &["", "the paper", "here"],
        vec![
            vec![
                "most layers".into(),
                printed(&PAPER, "L03", 0).into(),
                complexity.max().to_string(),
            ],
            vec![
                "8 layers or fewer, of all pixels".into(),
                printed(&PAPER, "L03", 1).into(),
                percent(complexity.part_of_image_up_to(8)),
            ],
            vec![
                "more than 17 layers, of all pixels".into(),
                printed(&PAPER, "L03", 2).into(),
                percent(1.0 - complexity.part_of_image_up_to(17)),
            ],
        ],
    ))
}

fn figure_8(studio: &Studio) -> Result<Drawn> {
    let drawn = Drawn::new(
        "Charged particles and energy are two volumes in one another, and three isosurfaces of the energy stand in them. The \
         boxes of the volumes are most of what there is: a ray through both has four layers before it meets a surface. Volumes \
         and surfaces are made by rule, after the paper's simulation.",
    );
    let scene = studio.scene("space", SIZE)?;
    Ok(views(studio, &scene, drawn)?.0)
}

fn figure_9(studio: &Studio) -> Result<Drawn> {
    let drawn = Drawn::new(
        "Two scans of a head, a tumour in gold, and 1678 fibres as thin tubes. Most fibres are in bundles, and there a ray meets \
         hundreds of surfaces. The histogram has a long tail of few pixels, for which a static array would have to be very \
         large. The scans are Shepp and Logan's phantom, after the data of the IEEE Visualization Contest 2010.",
    );
    zoomed(studio, "medical", drawn)
}

fn figure_10(studio: &Studio) -> Result<Drawn> {
    let drawn = Drawn::new(
        "7500 thin streamlines, a hundred arrows, and the speed as a volume. The streamlines are nearly transparent, so that the \
         arrows and the fast core can be seen through them. The flow is a vortex that is made by rule, after the paper's blood in \
         a carotid artery.",
    );
    zoomed(studio, "flow", drawn)
}

/// The views of a scene, and one more from nearby.
fn zoomed(studio: &Studio, name: &str, drawn: Drawn) -> Result<Drawn> {
    let mut scene = studio.scene(name, SIZE)?;
    let (drawn, _) = views(studio, &scene, drawn)?;
    scene.camera.fov *= ZOOM;
    let near = studio.renderer(&scene)?.render(&scene, &RAYS)?.image;
    Ok(drawn.flipped(
        "zoomed",
        &near,
        "zoomed",
        "the middle of the scene, enlarged",
    ))
}

fn views(studio: &Studio, scene: &Scene, drawn: Drawn) -> Result<(Drawn, Complexity)> {
    let mut renderer = studio.renderer(scene)?;
    let (frame, complexity) = renderer.render_and_count(scene, &RAYS, CountBy::AllGeometry)?;
    let [surfaces, volumes] = parts(scene).map(|part| image(&mut renderer, &part));
    let drawn = drawn
        .flipped(
            "a",
            &frame.image,
            "(a) surfaces and volumes",
            "surfaces and volumes in one image",
        )
        .flipped(
            "b",
            &surfaces?,
            "(b) the surfaces",
            "the same scene without its volumes",
        )
        .flipped(
            "c",
            &volumes?,
            "(c) the volumes",
            "the same scene without its surfaces",
        )
        .flipped(
            "d",
            &report::picture(&complexity),
            "(d) depth complexity: the darker, the more layers",
            "a grey picture, darkest where most layers are",
        )
        .drawing(
            svg_of_plot(report::plot("(e)", &complexity, 1, PlotKind::Svg)?),
            "a histogram: many pixels have few layers, and ever fewer have more",
        );
    Ok((drawn, complexity))
}

/// The surfaces alone, and the volumes alone.
fn parts(scene: &Scene) -> [Scene; 2] {
    let [mut surfaces, mut volumes] = [scene.clone(), scene.clone()];
    surfaces.volumes.clear();
    volumes.meshes.clear();
    [surfaces, volumes]
}

fn image(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<crate::image::Image> {
    Ok(renderer.render(scene, &RAYS)?.image)
}
