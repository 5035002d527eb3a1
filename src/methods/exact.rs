//! The exact image: every fragment read back, sorted and composited by the [oracle](crate::oracle) in f64.
//!
//! Volumes are sampled between the fragments, on the ray through each pixel's centre; they take no part in the
//! rasterisation.
//!
//! The rasteriser is the driver's, so that an image can be compared pixel by pixel; everything after it is not.

use std::thread;

use super::renderer::IMAGE;
use super::{Algorithm, Drawn};
use crate::error::Result;
use crate::fragment::{Fragment, Rgba};
use crate::gl::{CapturedFragment, GlMachine, capture};
use crate::image::Image;
use crate::oracle;
use crate::oracle::volumes::Ray;
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

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        run(&OPAQUE_FIRST, &[], Variables::new(), machine)?;
        let fragments = capture(machine, OPAQUE_DEPTH, AT_A_TIME)?;
        let size = machine.size();
        let image = composite(
            scene,
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
    scene: &Scene,
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
    let begins = std::iter::once(0).chain(ends.iter().copied());
    let ranges: Vec<_> = begins.zip(ends.iter().copied()).collect();
    let color_of = |pixel: usize| {
        let (begin, end) = ranges[pixel];
        let mut list = by_pixel[begin..end].to_vec();
        let (depth, background) = (opaque_depths[pixel], opaque_colors[pixel].into());
        let color = if scene.volumes.is_empty() {
            oracle::composite(&mut list, depth, background)
        } else {
            let place = [pixel as u32 % width, pixel as u32 / width];
            let ray = Ray::through(&scene.camera, [width, height], place);
            oracle::volumes::composite(&mut list, depth, background, &ray, &scene.volumes)
        };
        color.map(|channel| channel as f32)
    };
    Image::from_bottom_up(width, height, &every(ranges.len(), color_of))
}

/// A function's results for 0 up to `count`, computed on all processors.
fn every<T: Send>(count: usize, result: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    let share = count.div_ceil(threads).max(1);
    let result = &result;
    thread::scope(|scope| {
        let starts = (0..count).step_by(share);
        let parts: Vec<_> = starts
            .map(|start| {
                let part = start..(start + share).min(count);
                scope.spawn(move || part.map(result).collect::<Vec<T>>())
            })
            .collect();
        let parts = parts.into_iter().map(|part| part.join());
        // A panic in a part goes on here.
        parts
            .flat_map(|part| part.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}
