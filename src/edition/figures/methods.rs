//! Every method on the same scenes, for the methods' pages.

use super::drawn::Drawn;
use super::figure::Figure;
use super::studio::Studio;
use crate::error::Result;
use crate::image::{Comparison, Image, differences_alone};
use crate::methods::{Frame, Listed, Method, registry};
use crate::scene::Scene;

/// The pictures of a method are `exact`, its file's name ([`file`]), and the latter with `-difference`. Its rows are those whose
/// first cell is its name.
pub(super) const FIGURES: &[Figure] = &[Figure {
    key: "methods",
    source: "onionskin, all methods",
    title: "Three knots by every method",
    make,
}];

/// How many times a difference is enlarged.
const GAIN: f32 = 4.0;
/// The scenes on which is counted, each with what is said of it.
const SCENES: [(&str, &str); 3] = [
    ("knots", "three knots"),
    ("soup", "a soup of triangles"),
    ("teapot", "a teapot over a plane"),
];
const COUNTED: [u32; 2] = [160, 120];

/// The name of a method in names of files.
pub(in crate::low_level::edition) fn file(name: &str) -> String {
    name.replace('+', "-")
}

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [480, 360])?;
    let mut renderer = studio.renderer(&scene)?;
    let exact = renderer.render(&scene, &Method::Exact)?.image;
    let alt = "three translucent knots through each other, exact";
    let mut drawn = Drawn::new("").flipped("exact", &exact, "exact", alt);
    let methods = || {
        let driver = studio.context.driver();
        registry().iter().filter(move |row| row.runs_on(driver))
    };
    for row in methods() {
        let image = renderer.render(&scene, &row.method)?.image;
        drawn = pair(drawn, row, &image, &exact)?;
    }
    let mut rows = Vec::new();
    for (name, label) in SCENES {
        let scene = studio.scene_of_size(name, COUNTED)?;
        let mut renderer = studio.renderer(&scene)?;
        let exact = renderer.render(&scene, &Method::Exact)?.image;
        for row in methods() {
            let frame = renderer.render(&scene, &row.method)?;
            rows.push(counts(row, label, &scene, &frame, &exact)?);
        }
    }
    let columns = [
        "method",
        "scene",
        "triangles",
        "times that geometry is drawn",
        "fragments not in the image",
        "memory, KiB",
        "largest error",
    ];
    Ok(drawn.table("Counted at 160 x 120 pixels", &columns, rows))
}

fn pair(drawn: Drawn, row: &Listed, image: &Image, exact: &Image) -> Result<Drawn> {
    if row.method == Method::Exact {
        return Ok(drawn);
    }
    let (name, file) = (row.name, file(row.name));
    let difference = differences_alone(image, exact, GAIN)?;
    let alt = format!("three translucent knots through each other, by {name}");
    let label = format!("the difference, times {GAIN}");
    let of = format!("the difference of {name} and exact: black where there is none");
    Ok(drawn.flipped(&file, image, name, &alt).flipped(
        &format!("{file}-difference"),
        &difference,
        &label,
        &of,
    ))
}

fn counts(
    row: &Listed,
    label: &str,
    scene: &Scene,
    frame: &Frame,
    exact: &Image,
) -> Result<Vec<String>> {
    let error = Comparison::new(&frame.image, exact, 0.0)?.max;
    let stats = &frame.stats;
    let lost = stats
        .lost
        .map_or_else(|| "not counted".into(), |lost| lost.to_string());
    Ok(vec![
        row.name.into(),
        label.into(),
        scene.triangle_count().to_string(),
        stats.geometry_passes.to_string(),
        lost,
        stats.bytes.div_ceil(1024).to_string(),
        format!("{error:.1e}"),
    ])
}
