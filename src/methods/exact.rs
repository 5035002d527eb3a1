//! The exact image: every fragment read back, sorted and composited by the [oracle](crate::oracle) in f64.
//!
//! The rasteriser is the driver's, so that an image can be compared pixel by pixel; everything after it is not.

use super::renderer::IMAGE;
use super::{Algorithm, Drawn};
use crate::error::Result;
use crate::fragment::{Fragment, Rgba};
use crate::gl::{CapturedFragment, GlMachine, capture};
use crate::image::Image;
use crate::oracle;
use crate::papers::vtk::{OPAQUE_DEPTH, OPAQUE_FIRST};
use crate::scene::Scene;
use crate::steps::{Variables, run};

/// Fragments in GL's memory at a time: 64 MiB of them.
const AT_A_TIME: u32 = 2 << 20;

pub(super) struct Exact;

impl Algorithm for Exact {
    fn prepare(&mut self, _: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        Ok(())
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        run(&OPAQUE_FIRST, &[], Variables::new(), machine)?;
        let fragments = capture(machine, OPAQUE_DEPTH, AT_A_TIME)?;
        let size = machine.size();
        let image = composite(
            size,
            &machine.read_colors(IMAGE)?,
            &machine.read_depths(OPAQUE_DEPTH)?,
            &fragments,
        );
        Ok(Drawn {
            iterations: 1,
            image: Some(image),
            ..Drawn::default()
        })
    }
}

/// Gives each pixel to the oracle. All of `opaque_colors` and `opaque_depths` are bottom row first, as captured
/// fragments count their rows.
fn composite(
    [width, height]: [u32; 2],
    opaque_colors: &[[f32; 4]],
    opaque_depths: &[f32],
    fragments: &[CapturedFragment],
) -> Image {
    let pixel_of =
        |fragment: &CapturedFragment| fragment.y as usize * width as usize + fragment.x as usize;
    // A counting sort by pixel: where each pixel's fragments end, then the fragments at their places.
    let mut ends = vec![0_usize; opaque_depths.len()];
    fragments
        .iter()
        .for_each(|fragment| ends[pixel_of(fragment)] += 1);
    let mut sum = 0;
    for end in &mut ends {
        let count = *end;
        *end = sum;
        sum += count;
    }
    let nothing = Fragment {
        depth: 0.0,
        color: Rgba::default(),
        order: 0,
    };
    let mut by_pixel = vec![nothing; fragments.len()];
    for captured in fragments {
        let place = &mut ends[pixel_of(captured)];
        by_pixel[*place] = Fragment {
            depth: captured.depth,
            color: captured.color,
            order: captured.order,
        };
        *place += 1;
    }
    let mut start = 0;
    let mut list = Vec::new();
    let mut texels = Vec::with_capacity(ends.len());
    for (pixel, &end) in ends.iter().enumerate() {
        list.clear();
        list.extend_from_slice(&by_pixel[start..end]);
        start = end;
        let color = oracle::composite(&mut list, opaque_depths[pixel], opaque_colors[pixel].into());
        texels.push(color.map(|channel| channel as f32));
    }
    Image::from_bottom_up(width, height, &texels)
}
