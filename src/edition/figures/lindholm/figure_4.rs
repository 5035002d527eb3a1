//! Figure 4: what the three memory managers allocate.

use crate::error::Result;
use crate::low_level::edition::figures::plots::svg_of;
use crate::low_level::edition::figures::{Drawn, Figure, Studio, fragments};
use crate::low_level::report::memory_layout;
use crate::methods::{ABufferOptions, Manager, Method, Renderer};
use crate::scene::Scene;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-4",
    source: "Lindholm et al. 2015, figure 4",
    title: "Where three memory managers put six pixels' fragments",
    make,
};

/// The size of the row of pixels that is drawn, with the rows above and below it.
pub const SIX: [u32; 2] = [6, 5];

/// What a manager has allocated for an image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Allocated {
    /// The manager's name in the paper.
    pub name: &'static str,
    /// The bands in which the image was rendered.
    pub bands: u32,
    /// The bytes of the lists.
    pub bytes: u64,
    /// These bytes for one fragment.
    pub each: f64,
    /// Whether the image is the first manager's, bit for bit.
    pub same_image: bool,
}

/// What each manager allocates for a scene, and at last what FFB does with half of its bytes as the budget.
///
/// # Errors
/// If the driver fails.
pub fn managers(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Vec<Allocated>> {
    let mut rows: Vec<Allocated> = Vec::new();
    let mut first = None;
    for (name, manager, in_bands) in [
        ("FFB", Manager::Ffb, false),
        ("DFB", Manager::Dfb, false),
        ("PPLL", Manager::Ppll, false),
        ("FFB", Manager::Ffb, true),
    ] {
        let fixed = rows.first().map_or(u64::MAX, |row| row.bytes);
        let options = ABufferOptions {
            manager,
            // Without a budget, bands may be cut for speed.
            budget: Some(if in_bands { fixed / 2 } else { u64::MAX }),
            ..ABufferOptions::default()
        };
        let frame = renderer.render(scene, &Method::ABuffer(options))?;
        let counts = frame.stats.a_buffer.unwrap_or_default();
        let first = first.get_or_insert_with(|| frame.image.clone());
        rows.push(Allocated {
            name,
            bands: counts.bands,
            bytes: counts.list_bytes,
            each: counts.list_bytes as f64 / frame.stats.fragments.max(1) as f64,
            same_image: *first == frame.image,
        });
    }
    Ok(rows)
}

/// The pixel of each fragment in the middle row of the bundled scene `knots`, of size [`SIX`], in the order of submission.
///
/// # Errors
/// If the driver fails.
pub fn six_pixels(context: &crate::gl::Context, knots: &Scene) -> Result<Vec<u32>> {
    let all = fragments(context, knots)?;
    let row = all.iter().filter(|fragment| fragment.y == SIX[1] / 2);
    Ok(row.map(|fragment| fragment.x).collect())
}

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("molecule", [624, 468])?;
    let rows = managers(&mut studio.renderer(&scene)?, &scene)?;
    let mut knots = studio.scene("knots", SIX)?;
    knots.size = SIX;
    let figure = memory_layout("", SIX[0], &six_pixels(studio.context, &knots)?);
    let drawn = Drawn::new(
        "Each colour is a pixel, each box room for one fragment, and the number in it says when the fragment came. FFB has as much \
         room for every pixel as the deepest one needs, and what is grey is empty. DFB and PPLL have no empty box. PPLL's fragments \
         lie in the order in which they came, and each pixel's are linked. The images are the same.",
    )
    .drawing(
        svg_of(figure.draw()?),
        "rows of boxes: FFB's are mostly empty, DFB's and PPLL's are full",
    );
    let cells = |row: &Allocated| {
        vec![
            row.name.to_owned(),
            row.bands.to_string(),
            format!("{:.2} MiB", row.bytes as f64 / f64::from(1 << 20)),
            format!("{:.1}", row.each),
            if row.same_image { "yes" } else { "no" }.into(),
        ]
    };
    Ok(drawn.table(
        &format!(
            "The molecule's lists, {} x {} pixels; last, FFB with half of its memory, band by band",
            scene.size[0], scene.size[1]
        ),
        &[
            "manager",
            "bands",
            "lists",
            "bytes a fragment",
            "same image",
        ],
        rows.iter().map(cells).collect(),
    ))
}
