//! The occlusion ratio.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio};
use crate::methods::Method;
use crate::methods::options::DepthPeelingOptions;

pub(super) const FIGURE: Figure = Figure {
    key: "vtk-ratio",
    source: "VTK, Depth Peeling: the occlusion ratio",
    title: "Stopping when few pixels change",
    make,
};

const RATIOS: [f64; 9] = [0.0, 0.001, 0.003, 0.01, 0.03, 0.05, 0.1, 0.2, 0.3];

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("molecule", [384, 288])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let (mut rows, mut errors, mut peels) = (Vec::new(), Vec::new(), Vec::new());
    for occlusion_ratio in RATIOS {
        let method = Method::DepthPeeling(DepthPeelingOptions {
            occlusion_ratio,
            ..Default::default()
        });
        let frame = renderer.render(&scene, &method)?;
        let rms = Comparison::new(&frame.image, &exact, 0.0)?.rms;
        let stats = &frame.stats;
        errors.push([occlusion_ratio, rms]);
        peels.push([occlusion_ratio, f64::from(stats.iterations)]);
        rows.push(vec![
            occlusion_ratio.to_string(),
            stats.iterations.to_string(),
            format!("{rms:.6}"),
            stats.lost.unwrap_or_default().to_string(),
            stats.stopped_text(),
        ]);
    }
    let columns = [
        "occlusion ratio",
        "peels",
        "rms error",
        "fragments left",
        "why it stopped",
    ];
    let across = "occlusion ratio";
    Ok(Drawn::new(
        "The loop ends when a peel has found no more pixels than this part of the image. Few pixels are not little difference: \
         where they lie on top of each other, as in a molecule's middle, much is left.",
    )
    .chart(Chart::new("Peels", across, "peels").line("depth peeling", peels))
    .chart(Chart::new("Error", across, "rms error, channels of 0 to 1").line("depth peeling", errors))
    .table("By occlusion ratio", &columns, rows))
}
