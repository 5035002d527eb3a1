//! Figure 7: 64 quads that grow until they fill the screen, the worst case for ppAO.

use glam::DVec3;

use super::figure_5::{LOCAL, costs};
use crate::error::Result;
use crate::low_level::edition::figures::plots::times_taken_on;
use crate::low_level::edition::figures::{Chart, Drawn, Figure, Studio};
use crate::methods::{
    ABufferCounts, ABufferOptions, Complexity, CountBy, Manager, Method, Renderer,
};
use crate::scene::{Scene, Transform};

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-7",
    source: "Lindholm et al. 2015, figure 7",
    title: "64 quads that fill the screen in the middle of an animation",
    make,
};

const SIZE: [u32; 2] = [96, 72];
/// How large the quads are in each frame, in parts of their size. From 0.4 on even the farthest fills the screen.
const SCALES: [f64; 11] = [
    0.03, 0.06, 0.1, 0.16, 0.25, 0.5, 0.25, 0.16, 0.1, 0.06, 0.03,
];
const FULL: usize = 5;
/// The frames that are shown as pictures.
const SNAPSHOTS: [usize; 3] = [0, 3, FULL];
/// Static, ppAO and ppDP.
const SHOWN: usize = 3;

/// What a frame costs for each pixel of the image, by each of the ways.
struct Frame {
    counted: Vec<(&'static str, ABufferCounts)>,
    /// Only in the whole edition.
    ms: Vec<f64>,
    complexity: Complexity,
}

fn make(studio: &Studio) -> Result<Drawn> {
    let sheets = studio.scene("sheets64", SIZE)?;
    let mut renderer = studio.renderer(&sheets)?;
    let mut drawn = Drawn::new(
        "64 translucent quads in random order of depth. In the middle frame every pixel has 64 layers, and a static array of 64 is \
         just right for all of them: ppAO cannot save an element, and reserves as many. ppDP reserves 8, and reads each list 8 \
         times. The paper's graph shows that ppDP is 3.6 times as fast there. On a CPU it is not, because there is no small fast \
         memory to spare.",
    );
    let mut frames = Vec::new();
    for (number, scale) in SCALES.into_iter().enumerate() {
        let scene = scaled(&sheets, scale);
        frames.push(frame(studio, &mut renderer, &scene)?);
        if SNAPSHOTS.contains(&number) {
            let image = renderer.render(&scene, &Method::Exact)?.image;
            drawn = drawn.picture(
                &format!("frame-{number}"),
                &image,
                &format!("frame {number}"),
                "translucent quads over each other",
            );
        }
    }
    let pixels = f64::from(sheets.size[0] * sheets.size[1]);
    drawn = drawn
        .chart(chart(
            "Array elements reserved",
            "elements a pixel of the image",
            &frames,
            |it, way| it.counted[way].1.slots_reserved as f64 / pixels,
        ))
        .chart(chart(
            "Records read",
            "records a pixel of the image",
            &frames,
            |it, way| it.counted[way].1.records_read as f64 / pixels,
        ));
    if !studio.quick {
        let middle = frames[FULL].ms[0];
        let title = times_taken_on("Time of a frame", studio);
        let up = "static array in the middle frame = 1";
        drawn = drawn.chart(chart(&title, up, &frames, |it, way| it.ms[way] / middle));
    }
    let Frame {
        counted,
        complexity,
        ..
    } = &frames[FULL];
    let each = |number: u64| (number as f64 / pixels).to_string();
    let rows = counted.iter().map(|(name, counts)| {
        vec![
            (*name).to_owned(),
            each(counts.slots_reserved),
            each(counts.records_read),
            each(counts.subpasses),
            format!("{} to {}", complexity.percentile(0.0), complexity.max()),
        ]
    });
    Ok(drawn.table(
        "The middle frame, for each pixel",
        &[
            "",
            "elements reserved",
            "records read",
            "subpasses",
            "layers",
        ],
        rows.collect(),
    ))
}

fn frame(studio: &Studio, renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Frame> {
    let mut ms = Vec::new();
    for (_, pp_ao, pp_dp) in LOCAL.into_iter().take(SHOWN) {
        if studio.quick {
            break;
        }
        let method = Method::ABuffer(ABufferOptions {
            manager: Manager::Dfb,
            pp_ao,
            pp_dp,
            ..ABufferOptions::default()
        });
        ms.push(renderer.measure(scene, &method, 3)?.stats.ms);
    }
    Ok(Frame {
        counted: costs(renderer, scene, 64, 0.0)?,
        ms,
        complexity: renderer.complexity(scene, CountBy::Blending)?,
    })
}

/// A line for each way that is shown.
fn chart(title: &str, up: &str, frames: &[Frame], value: impl Fn(&Frame, usize) -> f64) -> Chart {
    let ways = LOCAL.iter().take(SHOWN).enumerate();
    ways.fold(
        Chart::new(title, "frame", up),
        |chart, (way, (name, ..))| {
            let points = frames.iter().enumerate();
            chart.line(
                name,
                points.map(|(number, it)| [number as f64, value(it, way)]),
            )
        },
    )
}

fn scaled(sheets: &Scene, scale: f64) -> Scene {
    let mut scene = sheets.clone();
    let smaller = Transform {
        scale: DVec3::new(scale, scale, 1.0),
        ..Transform::default()
    };
    scene.meshes = sheets
        .meshes
        .iter()
        .map(|mesh| mesh.clone().transformed(&smaller))
        .collect();
    scene
}
