//! The maximum number of peels.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio};
use crate::methods::Method;
use crate::methods::options::{DepthPeelingOptions, DualDepthPeelingOptions};

pub(super) const FIGURE: Figure = Figure {
    key: "vtk-peels",
    source: "VTK, Depth Peeling: the maximum number of peels",
    title: "A molecule after a number of peels",
    make,
};

/// The numbers of peels that are shown.
const SHOWN: [u32; 3] = [1, 4, 12];

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("molecule", [384, 288])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let all = renderer.render(&scene, &single(0))?.stats.iterations;
    let mut drawn = Drawn::new(
        "Each peel takes the nearest layer that is left. Dual peeling, which VTK does today, takes the nearest and the farthest \
         one in each peel, so it ends after half as many. Stopped early, it still shows what lies far behind, and lacks the \
         middle. 0 means no limit.",
    );
    let mut errors = [Vec::new(), Vec::new()];
    let mut left = [Vec::new(), Vec::new()];
    // At first every number of peels is tried, then fewer and fewer.
    let some = (1..all).filter(|it| *it <= 4 || (*it <= 12 && it % 2 == 0) || it % 4 == 0);
    for peels in some.chain([all]) {
        let ways = [
            ("depth peeling", single(peels)),
            ("dual peeling", dual(peels)),
        ];
        for (number, (name, method)) in ways.into_iter().enumerate() {
            let frame = renderer.render(&scene, &method)?;
            let rms = Comparison::new(&frame.image, &exact, 0.0)?.rms;
            errors[number].push([f64::from(peels), rms]);
            let lost = frame.stats.lost.unwrap_or_default();
            left[number].push([f64::from(peels), lost as f64]);
            if SHOWN.contains(&peels) {
                let label = format!("{name}, peels: {peels}");
                let file = format!("{}-{peels}", name.replace(' ', "-"));
                let alt = format!("the molecule, {label}");
                drawn = drawn.flipped(&file, &frame.image, &label, &alt);
            }
        }
    }
    let chart = |title: &str, up: &str, [one, two]: [Vec<[f64; 2]>; 2]| {
        let chart = Chart::new(title, "maximum number of peels", up).logarithmic();
        chart.line("depth peeling", one).line("dual peeling", two)
    };
    Ok(drawn
        .flipped("exact", &exact, "exact", "the molecule, exact")
        .chart(chart("Error", "rms error, channels of 0 to 1", errors))
        .chart(chart("What is not in the image", "fragments left", left)))
}

fn single(maximum_number_of_peels: u32) -> Method {
    Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels,
        ..Default::default()
    })
}

fn dual(maximum_number_of_peels: u32) -> Method {
    Method::DualDepthPeeling(DualDepthPeelingOptions {
        maximum_number_of_peels,
        ..Default::default()
    })
}
