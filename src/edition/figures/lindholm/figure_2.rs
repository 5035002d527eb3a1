//! Figure 2: depth complexity along a camera path, and what frames cost.

use crate::error::Result;
use crate::low_level::edition::figures::plots::svg_of;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::low_level::report::{Moment, series};
use crate::methods::{ABufferOptions, CountBy, Method, Renderer};
use crate::scene::Animation;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-2",
    source: "Lindholm et al. 2015, figure 2",
    title: "Layers and costs along a camera path",
    make,
};

/// The names of a moment's values, each relative to frame 0. Time is the last.
pub const NAMES: [&str; 3] = ["list records read", "subpasses", "time"];

const SIZE: [u32; 2] = [192, 144];
/// The frames that are shown as pictures.
const SNAPSHOTS: [u32; 4] = [50, 150, 250, 350];

/// A linked list with ppDP.
const METHOD: Method = Method::ABuffer(ABufferOptions {
    pp_dp: true,
    ..ABufferOptions::DEFAULT
});

/// Every `step`-th frame's histogram, and what a linked list with ppDP costs for it, relative to frame 0. The time is a median
/// of three frames, and left out unless `timed`.
///
/// # Errors
/// If the driver fails.
pub fn moments(
    renderer: &mut Renderer<'_>,
    animation: &Animation,
    step: u32,
    timed: bool,
) -> Result<Vec<Moment>> {
    let mut moments = Vec::new();
    let mut first = None;
    for frame in (0..animation.path.frames).step_by(step as usize) {
        let scene = animation.frame(frame)?;
        let complexity = renderer.complexity(&scene, CountBy::Blending)?;
        let stats = match timed {
            true => renderer.measure(&scene, &METHOD, 3)?.stats,
            false => renderer.render(&scene, &METHOD)?.stats,
        };
        let lists = stats.a_buffer.unwrap_or_default();
        let counts = [lists.records_read, lists.subpasses].map(|count| count as f64);
        let costs = [counts[0], counts[1], stats.ms];
        let first = *first.get_or_insert(costs);
        let shown = if timed { 3 } else { 2 };
        let ratios = (0..shown).map(|n| costs[n] / first[n]).collect();
        moments.push(Moment::new(frame, &complexity, ratios));
    }
    Ok(moments)
}

fn make(studio: &Studio) -> Result<Drawn> {
    let animation = studio.animation("molecule_fused", SIZE)?;
    let mut renderer = studio.renderer(&animation.scene)?;
    let timed = !studio.quick;
    let moments = moments(&mut renderer, &animation, studio.number(10, 50), timed)?;
    let names = if timed { &NAMES[..] } else { &NAMES[..2] };
    let driver = &studio.context.driver().renderer;
    let times = match timed {
        true => format!(
            " The time is of this machine ({driver}), and also has the rays through the volumes, which end at frame 200."
        ),
        false => String::new(),
    };
    let mut drawn = Drawn::new(format!(
        "The camera comes nearer until frame 200, and goes away again. At frame 100 the molecule's surface leaves, at frame 200 \
         the volumes leave and the surface is back, at frame 300 the potential's isosurfaces enter. Each bar is the histogram of \
         one frame, the darkest part for the deepest pixels. The lines are costs. They follow the bars, not the number of \
         triangles.{times} The paper's path and molecule are others.",
    ));
    for frame in SNAPSHOTS {
        let scene = animation.frame(frame)?;
        let image = renderer.render(&scene, &METHOD)?.image;
        drawn = drawn.picture(
            &format!("frame-{frame}"),
            &image,
            &format!("frame {frame}"),
            &format!("the molecule in frame {frame}"),
        );
    }
    Ok(drawn.drawing(
        svg_of(series("", names, &moments)?),
        "stacked bars of pixels with few to many layers, frame by frame, and lines of costs that rise and fall with them",
    ))
}
