//! The second figure 5: few layers are a good approximation.

use crate::error::Result;
use crate::image::Comparison;
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio};
use crate::methods::Method;
use crate::methods::options::DepthPeelingOptions;

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-6",
    source: "Everitt 2001, figure 5 (the second of this number)",
    title: "One, two, three, four layers",
    make,
};

/// The scenes, each with the number of layers up to which it is measured.
const SCENES: [(&str, &str); 3] = [
    ("teapot", "teapot over a plane"),
    ("knots", "three knots"),
    ("molecule", "molecule"),
];
const MOST: u32 = 8;
/// As many as the paper shows.
const SHOWN: u32 = 4;

fn make(studio: &Studio) -> Result<Drawn> {
    let drawn = Drawn::new(
        "Three layers are good enough for a teapot over a plane, as the paper says: a fourth hardly changes it. They are not \
         for a molecule. How many layers are enough depends on the scene's depth complexity.",
    );
    let drawn = pictures(studio, drawn)?;
    let title = "Error against the exact image, 160 x 120 pixels";
    let mut chart = Chart::new(title, "layers", "rms error, channels of 0 to 1").logarithmic();
    let mut rows = Vec::new();
    for (name, label) in SCENES {
        let errors = errors(studio, name)?;
        let mut row = vec![label.to_owned()];
        let first = errors.iter().take(SHOWN as usize);
        row.extend(first.map(|[_, rms]| format!("{rms:.3}")));
        rows.push(row);
        chart = chart.line(label, errors);
    }
    let columns = ["scene", "1 layer", "2 layers", "3 layers", "4 layers"];
    let caption = "Root mean square error (the paper gives no numbers)";
    Ok(drawn.chart(chart).table(caption, &columns, rows))
}

fn pictures(studio: &Studio, mut drawn: Drawn) -> Result<Drawn> {
    let scene = studio.scene("teapot", [480, 360])?;
    let mut renderer = studio.renderer(&scene)?;
    for layers in 1..=SHOWN {
        let image = renderer.render(&scene, &peeled(layers))?.image;
        let label = match layers {
            1 => "1 layer".to_owned(),
            _ => format!("{layers} layers"),
        };
        let alt = format!("a translucent teapot over a plane, of its nearest {label}");
        drawn = drawn.flipped(&format!("layers-{layers}"), &image, &label, &alt);
    }
    Ok(drawn)
}

/// The numbers of layers, each with its error.
fn errors(studio: &Studio, name: &str) -> Result<Vec<[f64; 2]>> {
    let scene = studio.scene_of_size(name, [160, 120])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let mut errors = Vec::new();
    for layers in 1..=MOST {
        let image = renderer.render(&scene, &peeled(layers))?.image;
        errors.push([f64::from(layers), Comparison::new(&image, &exact, 0.0)?.rms]);
    }
    Ok(errors)
}

fn peeled(layers: u32) -> Method {
    Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels: layers,
        ..Default::default()
    })
}
