//! What each method has composited after so many iterations.

use super::slices_and_cone::with_slices;
use crate::error::Result;
use crate::fragment::Rgba;
use crate::gl::{Geometry, GlMachine};
use crate::image::Image;
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio};
use crate::methods::allocate_maps;
use crate::papers::carr_2008::{coherent, hybrid};
use crate::papers::stage;
use crate::scene::Scene;
use crate::steps::{Amendment, Call, Format, Listing, Machine, Resources, Variables, run};

pub(super) const HYBRID: Figure = Figure {
    key: "carr-hybrid-buffers",
    source: "Carr et al. 2008, Algorithm 1",
    title: "The image after each iteration of hybrid layer peeling",
    make: after_each_of_hybrid,
};

pub(super) const COHERENT: Figure = Figure {
    key: "carr-iterations",
    source: "Carr et al. 2008, sections 1 and 5",
    title: "Layer by layer, and run by run",
    make: layers_and_runs,
};

/// More iterations than any method takes here.
const MOST: u32 = 64;
/// The iterations after which layers and runs are shown.
const SHOWN: [u32; 3] = [1, 2, 4];

fn after_each_of_hybrid(studio: &Studio) -> Result<Drawn> {
    let scene = with_slices(studio.scene("slices", [288, 216])?, 12, 8)?;
    let steps = iterate(
        studio,
        &scene,
        &hybrid::HYBRID,
        &hybrid::AMENDMENTS,
        &hybrid::RESOURCES,
    )?;
    let mut drawn = Drawn::new(
        "Twelve slices, and a cone of two layers. The first iteration finds the near side of the cone, and blends the slices \
         before it, then that side. The second does the same up to the far side. The third finds no side any more, and blends \
         what is left.",
    );
    let mut rows = Vec::new();
    for (number, step) in steps.iter().enumerate() {
        let number = number + 1;
        drawn = drawn.flipped(
            &format!("iteration-{number}"),
            &step.image,
            &format!("after iteration {number}"),
            &format!("slices and cone, composited by {number} iterations"),
        );
        rows.push(vec![number.to_string(), format!("{:.0}", step.composited)]);
    }
    Ok(drawn.table("Fragments in the image", &["iterations", "fragments"], rows))
}

fn layers_and_runs(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [288, 216])?;
    let methods = [
        iterate(
            studio,
            &scene,
            &hybrid::LAYER_PEELING,
            &hybrid::AMENDMENTS,
            &hybrid::RESOURCES,
        )?,
        iterate(
            studio,
            &scene,
            &coherent::VARIANT_A,
            &coherent::AMENDMENTS,
            &coherent::RESOURCES_A,
        )?,
    ];
    let names = ["layer peeling", "coherent layer peeling A"];
    let mut drawn = Drawn::new(
        "Three knots that cut each other, in the order of their files. The pictures show 1, 2 and 4 iterations. A run has many \
         layers where the file's order fits, so coherent layer peeling is soon finished with most pixels. Its last iterations \
         are for the few pixels whose order is worst.",
    );
    let mut chart = Chart::new(
        "Fragments in the image after so many iterations",
        "iterations",
        "part of all fragments, %",
    );
    for (name, steps) in names.into_iter().zip(&methods) {
        let shown: Vec<&Image> = SHOWN
            .iter()
            .filter_map(|&number| steps.get(number as usize - 1))
            .map(|step| &step.image)
            .collect();
        drawn = drawn.flipped(
            name.split(' ').next().unwrap_or(name),
            &Image::beside(&shown, 3, Rgba::opaque([0.5; 3])),
            &format!("{name}, after 1, 2 and 4 iterations"),
            &format!("three pictures of the knots, ever more complete, by {name}"),
        );
        let all = steps.last().map_or(1.0, |step| step.composited).max(1.0);
        let points = (1..)
            .zip(steps)
            .map(|(number, step)| [f64::from(number), 100.0 * step.composited / all]);
        chart = chart.line(name, points);
    }
    Ok(drawn.chart(chart))
}

struct Step {
    image: Image,
    composited: f64,
}

/// Runs a listing of a loop with one iteration, with two, and so on, until one more finds nothing more.
fn iterate(
    studio: &Studio,
    scene: &Scene,
    listing: &Listing,
    amendments: &[Amendment],
    resources: &[&Resources],
) -> Result<Vec<Step>> {
    let mut gl = GlMachine::new(studio.context, scene.size)?;
    gl.set_geometry(Geometry::upload(studio.context, scene, scene.size)?);
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut gl, &[&stage::RESOURCES], color, depth)?;
    allocate_maps(&mut gl, resources, color, depth)?;
    let mut steps = Vec::new();
    for limit in 1..=MOST {
        begin(&mut gl, scene)?;
        let limit = Variables::new().with("iteration_limit", f64::from(limit));
        let outcome = run(listing, amendments, limit, &mut gl)?;
        let [width, height] = scene.size;
        let texels = gl.read_colors(stage::IMAGE_COLOR)?;
        steps.push(Step {
            image: Image::from_bottom_up(width, height, &texels),
            composited: outcome.variables.get("composited").unwrap_or(0.0),
        });
        if outcome.stopped.is_some() {
            break;
        }
    }
    Ok(steps)
}

/// OpenGL's initial state, and the background's colour, with which the opaque image begins.
fn begin(gl: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
    gl.begin_frame();
    let [red, green, blue] = scene.background;
    gl.perform(&Call::ClearColor {
        red,
        green,
        blue,
        alpha: 1.0,
    })
}
