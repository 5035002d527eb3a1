//! Peeling as in 2001, with and without Listing 2.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::Method;
use crate::methods::options::{Compositing, DepthPeelingOptions, DepthUnit0};

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-replace",
    source: "Everitt 2001, Listing 2",
    title: "Peeled by a shadow map, with and without depth replace",
    make,
};

/// Without Listing 2 the loop would never end.
const MOST_PEELS: u32 = 16;

const WAYS: [(&str, DepthUnit0, &str); 3] = [
    ("today", DepthUnit0::Sampler, "today's shadow sampler"),
    (
        "replaced",
        DepthUnit0::ClassicDepthReplace,
        "2001, with Listing 2",
    ),
    ("classic", DepthUnit0::Classic, "2001, without Listing 2"),
];

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("teapot", [480, 360])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let mut drawn = Drawn::new(
        "Unit 0 is a shadow map with the camera's own orientation and resolution. With Listing 2 both sides of its comparison \
         are r/q, and the image is right. Without it the surfaces come back in layer after layer, and the image falls apart.",
    );
    let mut rows = Vec::new();
    for (file, depth_unit_0, label) in WAYS {
        let options = DepthPeelingOptions {
            compositing: Compositing::KeepLayers,
            depth_unit_0,
            maximum_number_of_peels: MOST_PEELS,
            ..Default::default()
        };
        let frame = renderer.render(&scene, &Method::DepthPeeling(options))?;
        let error = Comparison::new(&frame.image, &exact, 1.0 / 255.0)?;
        rows.push(vec![
            label.into(),
            frame.stats.iterations.to_string(),
            format!("{:.6}", error.max),
            error.over.to_string(),
        ]);
        let alt = format!("a translucent teapot over a plane, depth unit 0 as {label}");
        drawn = drawn.flipped(file, &frame.image, label, &alt);
    }
    let columns = [
        "depth unit 0",
        "peels",
        "largest error",
        "pixels off by more than 1/255",
    ];
    Ok(drawn.table("Against the exact image, at most 16 peels", &columns, rows))
}
