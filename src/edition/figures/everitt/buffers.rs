//! Listing 1's buffers, pass by pass.

use crate::error::Result;
use crate::image::Image;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::options::{Compositing, DepthPeelingOptions};
use crate::methods::{Layer, Method};
use crate::report::{depths, opaque};

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-buffers",
    source: "Everitt 2001, Listing 1",
    title: "What the buffers hold after each pass",
    make,
};

/// The passes that are shown.
const PASSES: usize = 4;

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("teapot", [320, 240])?;
    let options = DepthPeelingOptions {
        compositing: Compositing::KeepLayers,
        ..Default::default()
    };
    let mut renderer = studio.renderer(&scene)?;
    let layers = renderer
        .render(&scene, &Method::DepthPeeling(options))?
        .layers;
    let mut drawn = Drawn::new(
        "Darker is nearer, and white is the far plane. In pass 0 unit 0 does not test. From then on it reads the depths that \
         the pass before has written. So each pass keeps the nearest of what lies behind the last one. The two buffers \
         exchange their places from pass to pass: i % 2 and (i + 1) % 2.",
    );
    let mut rows = Vec::new();
    for (pass, layer) in layers.iter().enumerate().take(PASSES) {
        let before = pass.checked_sub(1).map(|before| &layers[before]);
        rows.push(row(pass, layer, before));
        drawn = three(drawn, pass, layer, before);
    }
    let columns = [
        "pass",
        "tested against",
        "written",
        "pixels with a fragment",
    ];
    Ok(drawn.table("The buffers of each pass", &columns, rows))
}

fn row(pass: usize, layer: &Layer, before: Option<&Layer>) -> Vec<String> {
    let [a, b] = [pass % 2, (pass + 1) % 2];
    let tested = match before {
        Some(_) => format!("buffer {a}, GREATER"),
        None => "nothing".into(),
    };
    let samples = layer.depth.iter().filter(|&&depth| depth < 1.0).count();
    vec![
        pass.to_string(),
        tested,
        format!("buffer {b}, LESS"),
        samples.to_string(),
    ]
}

/// A pass's two depth buffers and its colours.
fn three(drawn: Drawn, pass: usize, layer: &Layer, before: Option<&Layer>) -> Drawn {
    let grey = |layer: &Layer| depths(layer.color.width, &layer.depth);
    let tested = match before {
        Some(before) => grey(before),
        None => Image::filled(layer.color.width, layer.color.height, [1.0; 4].into()),
    };
    drawn
        .picture(
            &format!("pass-{pass}-tested"),
            &tested,
            &format!("pass {pass}, unit 0: what it tests against"),
            &format!("the depths of the layer before layer {pass}, darker is nearer"),
        )
        .picture(
            &format!("pass-{pass}-written"),
            &grey(layer),
            &format!("pass {pass}, unit 1: the depths that it writes"),
            &format!("the depths of layer {pass}, darker is nearer"),
        )
        .picture(
            &format!("pass-{pass}-color"),
            &opaque(layer),
            &format!("pass {pass}: the colours, saved as layer {pass}"),
            &format!("layer {pass} of a teapot over a plane, drawn opaque"),
        )
}
