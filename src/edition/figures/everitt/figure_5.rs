//! The first figure 5, the depth replace shader: why two ways of making a depth must not be compared.

use crate::error::Result;
use crate::image::Image;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::Method;
use crate::methods::invariance::{SOURCES, Verdict, perspective_soup, run_experiment};
use crate::methods::options::Experiment;
use crate::scene::Scene;
use crate::steps::Format;

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-5",
    source: "Everitt 2001, figure 5 (the first of this number) and \"An Invariance Issue\"",
    title: "Depths that were made in one way, compared with depths made in another",
    make,
};

const RATIOS: [f64; 3] = [10.0, 100.0, 1000.0];
const SIZE: [u32; 2] = [192, 144];

fn make(studio: &Studio) -> Result<Drawn> {
    let mut drawn = Drawn::new(
        "200 random triangles in perspective, depths in 32-bit floats. Left of the colon is what a pass stores, right of it \
         what the next pass compares. Light grey pixels are right, coloured ones are wrong. With the rasteriser's window z on one side and the quotient \
         r/q on the other, a surface can lie behind itself by one last bit: the peel then finds it again and again. Depth \
         replace makes both sides the same quotient.",
    );
    let mut rows: Vec<Vec<String>> = SOURCES.map(|(name, ..)| vec![name.to_owned()]).into();
    for ratio in RATIOS {
        let (scene, exact) = study(studio, ratio)?;
        for (row, (name, stored, compared)) in rows.iter_mut().zip(SOURCES) {
            let experiment = Experiment {
                stored,
                compared,
                ..Experiment::default()
            };
            let finding =
                run_experiment(studio.context, &scene, &exact, experiment, Format::Depth32F)?;
            row.push(format!(
                "{} ({})",
                finding.wrong(),
                finding.count(Verdict::Stuck)
            ));
            if ratio == RATIOS[2] {
                let file = name.replace(" : ", "-").replace([' ', '/'], "-");
                let alt = format!("the verdict of each pixel, {name}, far/near {ratio}");
                drawn = drawn.flipped(&file, &finding.picture(), name, &alt);
            }
        }
    }
    let columns = ["stored : compared", "far/near = 10", "100", "1000"];
    let caption = format!(
        "Wrong pixels of {} (of these, pixels that repeat a layer for ever)",
        SIZE[0] * SIZE[1]
    );
    Ok(drawn.table(&caption, &columns, rows))
}

/// Random triangles in perspective, and their exact image.
fn study(studio: &Studio, ratio: f64) -> Result<(Scene, Image)> {
    let scene = perspective_soup(1, 200, ratio, SIZE)?;
    let exact = studio.renderer(&scene)?.render(&scene, &Method::Exact)?;
    Ok((scene, exact.image))
}
