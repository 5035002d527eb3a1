//! Section 5's six passes on a small scene: what the first iteration leaves in the buffers.

use super::figure_2::PASSES;
use crate::error::Result;
use crate::fragment::Rgba;
use crate::gl::{Geometry, GlMachine};
use crate::image::Image;
use crate::low_level::edition::figures::buffers::{grey_depths, over};
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::low_level::report::Measure;
use crate::methods::{allocate_maps, begin_batch};
use crate::papers::carr_2008::{DEPTH_BUFFER, coherent};
use crate::papers::stage;
use crate::steps::{Format, Variables, run};

pub(super) const FIGURE: Figure = Figure {
    key: "carr-buffers",
    source: "Carr et al. 2008, section 5",
    title: "The buffers after each pass of the first iteration",
    make,
};

const SIZE: [u32; 2] = [288, 216];
const GAP: u32 = 3;
/// The greatest stencil value that pass 3 counts on from.
const INVERTED: u8 = 128;
const ORANGE: Rgba = Rgba::opaque([0.95, 0.45, 0.05]);

/// The figures of single passes.
pub(super) const PASS: [Figure; 6] = [
    pass("carr-pass-1", "After pass 1", after::<0>),
    pass("carr-pass-2", "After pass 2", after::<1>),
    pass("carr-pass-3", "After pass 3", after::<2>),
    pass("carr-pass-4", "After pass 4", after::<3>),
    pass("carr-pass-5", "After pass 5", after::<4>),
    pass("carr-pass-6", "After pass 6", after::<5>),
];

const fn pass(
    key: &'static str,
    title: &'static str,
    make: fn(&Studio) -> Result<Drawn>,
) -> Figure {
    Figure {
        key,
        source: "Carr et al. 2008, section 5",
        title,
        make,
    }
}

/// What is to be seen after each pass.
const SEEN: [&str; 6] = [
    "Stencil: the brighter, the more often a surface came that lay before all earlier ones. Depth: D(s_n), the nearest surface of \
     all.",
    "Stencil: counted back to 1 wherever a surface is. Depth: z_min_prev, the nearest surface that came before s_n. It is white \
     where s_n came first.",
    "Stencil: the brighter, the longer the run. Orange pixels have an inverted count, because a surface broke the run. Depth: \
     the last surface of the run.",
    "Stencil: orange is 255, where the run was skipped. Depth: z_min_post, which exists only where a surface broke a run.",
    "Colour: the run of each pixel, blended front to back. Where a run has all layers of its pixel, the pixel is finished.",
    "Colour: one layer more, where something had ended the run. The next iteration goes on behind it.",
];

/// What a pass has left.
struct Left {
    title: &'static str,
    stencil: Image,
    depth: Image,
    color: Image,
    counts: Vec<u32>,
    /// Pixels with a depth, and with a colour.
    drawn_to: [usize; 2],
}

fn make(studio: &Studio) -> Result<Drawn> {
    let passes = passes(studio)?;
    let mut drawn = Drawn::new(
        "From the left: stencil, depth, colour. A stencil value is dark violet if it is 0, and the greater the brighter. Orange \
         is over 128: something has broken the run, and the count is inverted. Depths are dark near the eye, and white where \
         nothing was drawn. Step through the six passes: colour appears in pass 5, and pass 6 adds one layer to it.",
    );
    let mut rows = Vec::new();
    for (number, left) in passes.iter().enumerate() {
        let number = number + 1;
        let three = [&left.stencil, &left.depth, &left.color];
        drawn = drawn.flipped(
            &format!("pass-{number}"),
            &Image::beside(&three, GAP, Rgba::opaque([0.5; 3])),
            left.title,
            &format!("stencil, depth and colour after pass {number}"),
        );
        let [least, most] = [left.counts.iter().min(), left.counts.iter().max()];
        rows.push(vec![
            number.to_string(),
            format!("{} to {}", least.unwrap_or(&0), most.unwrap_or(&0)),
            left.drawn_to[0].to_string(),
            left.drawn_to[1].to_string(),
        ]);
    }
    let [width, height] = studio.size(SIZE);
    Ok(drawn.table(
        &format!("Three knots in the order of their files, {width} x {height} pixels"),
        &[
            "pass",
            "stencil values",
            "pixels with a depth",
            "pixels with a colour",
        ],
        rows,
    ))
}

fn after<const PASS: usize>(studio: &Studio) -> Result<Drawn> {
    let left = &passes(studio)?[PASS];
    let drawn = Drawn::new(SEEN[PASS]);
    let alt = |what: &str| format!("{what} of the three knots after pass {}", PASS + 1);
    Ok(match PASS {
        0..4 => drawn
            .picture(
                "stencil",
                &left.stencil,
                "stencil",
                &alt("the stencil values"),
            )
            .picture("depth", &left.depth, "depth", &alt("the depths")),
        _ => drawn.picture("color", &left.color, "colour", &alt("the colours")),
    })
}

/// The first iteration, pass by pass.
fn passes(studio: &Studio) -> Result<Vec<Left>> {
    let scene = studio.scene("knots", SIZE)?;
    let size @ [width, height] = scene.size;
    let mut gl = GlMachine::new(studio.context, size)?;
    gl.set_geometry(Geometry::upload(studio.context, &scene, size)?);
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut gl, &[&stage::RESOURCES], color, depth)?;
    allocate_maps(&mut gl, &coherent::RESOURCES_A, color, depth)?;
    gl.begin_frame();
    for listing in [&stage::OPAQUE_FIRST, &stage::CLEAR_ACCUMULATION] {
        run(listing, &[], Variables::new(), &mut gl)?;
    }
    begin_batch(&mut gl, 0.0, 1.0)?;
    let mut found = Vec::new();
    for (title, pass) in PASSES {
        run(&pass, &[], Variables::new(), &mut gl)?;
        let colors = gl.read_colors(stage::ACCUMULATED)?;
        found.push((
            title.split(" (").next().unwrap_or(title),
            gl.read_stencils(DEPTH_BUFFER)?,
            gl.read_depths(DEPTH_BUFFER)?,
            Image::from_bottom_up(width, height, &colors),
        ));
    }
    let depths = found.iter().flat_map(|(_, _, depths, _)| depths);
    let inside = || {
        depths
            .clone()
            .copied()
            .filter(|&depth| depth > 0.0 && depth < 1.0)
    };
    let range = [inside().fold(1.0, f32::min), inside().fold(0.0, f32::max)];
    let stencils = found.iter().flat_map(|(_, stencils, ..)| stencils);
    let most = stencils
        .filter(|&&count| count <= INVERTED)
        .max()
        .copied()
        .unwrap_or(0);
    let left = found.iter().map(|(title, stencils, depths, accumulated)| {
        let counts = from_top(stencils, width);
        let drawn_to = depths
            .iter()
            .filter(|&&depth| depth > 0.0 && depth < 1.0)
            .count();
        let colored = accumulated
            .pixels
            .iter()
            .filter(|pixel| pixel.a > 0.0)
            .count();
        Left {
            title,
            stencil: stencil_picture(size, &counts, most),
            depth: grey_depths(width, depths, range),
            color: over(accumulated, scene.background),
            counts,
            drawn_to: [drawn_to, colored],
        }
    });
    Ok(left.collect())
}

/// Counts as brightness, and those that pass 3 has inverted in orange.
fn stencil_picture([width, height]: [u32; 2], counts: &[u32], most: u8) -> Image {
    let ahead: Vec<u32> = counts
        .iter()
        .map(|&count| if count > INVERTED.into() { 0 } else { count })
        .collect();
    let end = f64::from(most.max(1));
    let mut picture = Measure::of_counts(width, height, &ahead).up_to(end).image();
    for (pixel, &count) in picture.pixels.iter_mut().zip(counts) {
        if count > INVERTED.into() {
            *pixel = ORANGE;
        }
    }
    picture
}

/// Counts row by row from the top.
fn from_top(stencils: &[u8], width: u32) -> Vec<u32> {
    let rows = stencils.chunks_exact(width as usize).rev();
    rows.flatten().map(|&stencil| u32::from(stencil)).collect()
}
