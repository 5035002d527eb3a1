//! Figure 3: the A-buffer's three steps, and what each leaves.

use super::left;
use crate::error::Result;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::ABufferOptions;

pub(super) const FIGURE: Figure = Figure {
    key: "lindholm-3",
    source: "Lindholm et al. 2015, figure 3",
    title: "Clear, fill, resolve: what each step leaves",
    make,
};

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = studio.scene("knots", [384, 288])?;
    let mut renderer = studio.renderer(&scene)?;
    let (frame, left) = left::render(&mut renderer, &scene, ABufferOptions::default())?;
    let lists = frame.stats.a_buffer.unwrap_or_default();
    let size = scene.size;
    let most = left.counters.iter().max().copied().unwrap_or(0);
    let pixels = left.counters.len();
    let stored: u64 = left.counters.iter().map(|&count| u64::from(count)).sum();
    let nothing = vec![0; pixels];
    let drawn = Drawn::new(format!(
        "The counters of the pixels are read back from OpenGL. After the Clear Step all are 0. After the Fill Step each says how \
         many fragments its pixel's list has: 0 is dark violet, {most} is yellow. The Resolve Step reads each list, sorts it in an \
         array of {}, and blends it. Then the lists have done their work.",
        ABufferOptions::DEFAULT.array
    ))
    .picture(
        "clear",
        &left::counts(size, &nothing),
        "Clear Step: every counter is 0",
        "an even dark picture",
    )
    .picture(
        "fill",
        &left::counts(size, &left.counters),
        "Fill Step: the counters",
        "three knots as counts of layers, brightest where they cross",
    )
    .picture(
        "resolve",
        &frame.image,
        "Resolve Step: the image",
        "three translucent knots, blended in the right order",
    );
    let number = |value: u64| value.to_string();
    Ok(drawn.table(
        &format!(
            "Global and local memory, {} x {} pixels, fixed buffers",
            size[0], size[1]
        ),
        &["step", "global memory", "local memory"],
        vec![
            vec![
                "Clear".into(),
                format!("{pixels} counters are set to 0"),
                "none".into(),
            ],
            vec![
                "Fill".into(),
                format!(
                    "{} fragments are written into {} bytes",
                    number(stored),
                    lists.list_bytes
                ),
                "none".into(),
            ],
            vec![
                "Resolve".into(),
                format!("{} fragments are read", number(lists.records_read)),
                format!(
                    "{} array elements are reserved, {} are used",
                    number(lists.slots_reserved),
                    number(lists.slots_used)
                ),
            ],
        ],
    ))
}
