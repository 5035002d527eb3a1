//! Section 6 beside Carr et al. 2008: rays between the fragments of lists, and slices between peels.

use crate::error::Result;
use crate::gl::Context;
use crate::image::{Comparison, Image};
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio, printed};
use crate::methods::{ABufferOptions, Manager, Method, RecordColor, Renderer};
use crate::scene::Scene;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-fog",
    source: "Lindholm et al. 2015, section 6",
    title: "Two volumes and a glass ring, by rays and by slices",
    make,
};

/// Lists of any length and colours in 32 bits, so that only the slices make a difference.
const RAYS: Method = Method::ABuffer(ABufferOptions {
    manager: Manager::Dfb,
    color: RecordColor::Float,
    pp_dp: true,
    ..ABufferOptions::DEFAULT
});
const HYBRID: Method = Method::HybridLayerPeeling(crate::methods::HybridLayerPeelingOptions {
    reading: crate::steps::Reading::Amended,
});

/// A scene with its volumes as slices.
#[derive(Clone, Debug)]
pub struct InSlices {
    /// The number of slices.
    pub count: u32,
    /// The image by hybrid layer peeling.
    pub image: Image,
    /// How far it is from the image by rays.
    pub off: Comparison,
    /// Its iterations.
    pub iterations: u32,
    /// Those of layer peeling, if the slices are few enough for it.
    pub of_layers: Option<u32>,
}

/// The image of a scene with volumes by rays, and the same by slices, so many of them at a time. Layer peeling peels at most
/// `most_for_layers`.
///
/// # Errors
/// If the driver fails.
pub fn slices_against_rays(
    context: &Context,
    scene: &Scene,
    counts: &[u32],
    most_for_layers: u32,
) -> Result<(Image, Vec<InSlices>)> {
    let renderer = |slices| -> Result<Renderer<'_>> {
        Renderer::new(context, scene.size[0], scene.size[1])?.with_slices(slices)
    };
    let rays = renderer(1)?.render(scene, &RAYS)?.image;
    let mut rows = Vec::new();
    for &count in counts {
        let mut renderer = renderer(count)?;
        let frame = renderer.render(scene, &HYBRID)?;
        let of_layers = match count <= most_for_layers {
            true => {
                let layers = Method::LayerPeeling(Default::default());
                Some(renderer.render(scene, &layers)?.stats.iterations)
            }
            false => None,
        };
        rows.push(InSlices {
            count,
            off: Comparison::new(&frame.image, &rays, 0.0)?,
            image: frame.image,
            iterations: frame.stats.iterations,
            of_layers,
        });
    }
    Ok((rays, rows))
}

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("fog", [384, 288])?;
    let counts = studio.number(&[8, 16, 32, 64, 128, 256, 512][..], &[8, 16, 32, 64][..]);
    let (rays, rows) = slices_against_rays(studio.context, &scene, counts, 0)?;
    let exact = studio
        .renderer(&scene)?
        .render(&scene, &Method::Exact)?
        .image;
    let off = Comparison::new(&rays, &exact, 0.0)?;
    let mut drawn = Drawn::new(format!(
        "A vortex in a ball of fog, and a glass ring through both. Rays are cast between the fragments of each pixel's list, and \
         are off by {:.0e} at most from a caster in 64-bit floats. The other pictures draw the same volumes as slices, and peel the \
         ring (Carr et al. 2008, Algorithm 1). A slice stands for a whole slab, so twice as many slices halve the difference.",
        off.max
    ))
    .flipped("rays", &rays, "rays", "a vortex in a ball of fog with a glass ring through both");
    for row in rows.iter().filter(|row| [8, 64].contains(&row.count)) {
        drawn = drawn.flipped(
            &format!("slices-{}", row.count),
            &row.image,
            &format!("{} slices", row.count),
            "the same scene, with the volumes in slices",
        );
    }
    let points = |value: fn(&InSlices) -> f64| -> Vec<[f64; 2]> {
        let point = |row: &InSlices| [f64::from(row.count), value(row)];
        rows.iter().map(point).collect()
    };
    let chart = Chart::new(
        "Difference of slices from rays",
        "slices",
        "difference of a channel",
    )
    .logarithmic()
    .line("largest", points(|row| row.off.max))
    .line("root of the mean square", points(|row| row.off.rms));
    let table = rows.iter().map(|row| {
        vec![
            row.count.to_string(),
            printed::error(row.off.rms),
            printed::error(row.off.max),
            row.iterations.to_string(),
        ]
    });
    Ok(drawn.chart(chart).table(
        "Slices against rays, and the iterations of hybrid layer peeling",
        &[
            "slices",
            "root of the mean square",
            "largest difference",
            "iterations",
        ],
        table.collect(),
    ))
}
