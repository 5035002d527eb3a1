//! The exact image: every fragment read back, found on its pixel's ray, sorted and composited by the
//! [oracle](crate::oracle) in f64.
//!
//! The driver determines which triangles cover a pixel, and their colours there, so that images can be compared pixel
//! by pixel. The oracle determines everything else: the triangles' distances, their order, which of them are coplanar,
//! and which an opaque surface hides. Volumes are sampled between the surfaces and are not rasterised.

use std::thread;

use super::algorithm::{Algorithm, Drawn, Setup};
use super::entry::{EXACT_BY_RAYS, Entry, Memory, Ties, Volumes};
use super::hanging::Hanging;
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::{Captured, CapturedFragment, Format, GlMachine, Piece, capture_in_pieces};
use crate::image::Image;
use crate::oracle::DepthBuffer;
use crate::oracle::pixel::{Covering, Visible, hangs, sorted};
use crate::oracle::surfaces::Surfaces;
use crate::oracle::volumes::Ray;
use crate::papers::stage::OPAQUE_DEPTH;
use crate::scene::{Camera, Scene};
use crate::steps::{Compare, Objects};

/// The number of fragments in memory at a time, which take 64 MiB.
const AT_A_TIME: u32 = 2 << 20;

/// The largest change of a channel that does not count as depending on depths: the bound for methods in 32-bit float.
const BOUND: f64 = 1e-5;

/// The exact image, which has no options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Exact;

struct ExactImage {
    setup: Setup,
    /// The depth buffer of the other methods, and that of another renderer, between the clip planes that the scene's camera
    /// was given.
    buffers: [DepthBuffer; 2],
}

impl Algorithm for ExactImage {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        let size = machine.size();
        let drawn = match machine.has_inverse_w() {
            true => DepthBuffer::float(&scene.camera, size).of_inverse_w(),
            false => depth_buffer(&scene.camera, size, self.setup.depth),
        };
        let quirks = machine.context().driver().quirks();
        self.buffers = [
            match quirks.interpolates_true_corners {
                true => drawn,
                false => drawn.with_snapped_corners(),
            },
            // Nobody knows on which driver another renderer draws.
            depth_buffer(&self.setup.given, size, self.setup.depth).with_snapped_corners(),
        ];
        Ok(())
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let size = machine.size();
        let surfaces = Surfaces::of(scene, size);
        let mut canvas = Canvas::of(size);
        let everything = Captured {
            objects: Objects::Scene,
            depth: OPAQUE_DEPTH,
            passes: Compare::Always,
        };
        capture_in_pieces(machine, &everything, AT_A_TIME, |piece, fragments| {
            let lists = Lists::of(piece, fragments);
            let pixel = |number: usize| self.pixel(scene, size, &surfaces, &lists, number);
            canvas.add(piece, &every(lists.ranges.len(), pixel));
            Ok(())
        })?;
        Ok(Drawn {
            iterations: 1,
            image: Some(Image::from_bottom_up(size[0], size[1], &canvas.colors)),
            hanging: Some(canvas.hanging),
            ..Drawn::default()
        })
    }
}

/// A pixel's colour, and whether it depends on differences that the depth buffer as drawn, and as given, cannot hold.
type Pixel = ([f32; 4], [bool; 2]);

impl ExactImage {
    /// Gives a pixel of a piece to the oracle.
    fn pixel(
        &self,
        scene: &Scene,
        size: [u32; 2],
        surfaces: &Surfaces<'_>,
        lists: &Lists,
        number: usize,
    ) -> Pixel {
        let place = lists.place(number);
        let list = sorted(surfaces, place, lists.list(number));
        let ray = Ray::through(&scene.camera, size, place);
        let color = Visible::of(&list).composite(scene.background, &ray, &scene.volumes);
        let hang = |buffer| hangs(surfaces, &list, buffer, BOUND);
        (
            color.map(|channel| channel as f32),
            self.buffers.each_ref().map(hang),
        )
    }
}

/// The fragments of a piece of the image, pixel by pixel.
struct Lists {
    piece: Piece,
    ranges: Vec<[usize; 2]>,
    fragments: Vec<Covering>,
}

impl Lists {
    /// A counting sort by pixel: the end of each pixel's fragments, then the fragments at their places.
    fn of(piece: Piece, captured: &[CapturedFragment]) -> Self {
        let width = piece.width as usize;
        let pixel_of = |fragment: &CapturedFragment| {
            (fragment.y - piece.y) as usize * width + (fragment.x - piece.x) as usize
        };
        let mut ends = vec![0_usize; width * piece.height as usize];
        captured
            .iter()
            .for_each(|fragment| ends[pixel_of(fragment)] += 1);
        let mut sum = 0;
        for end in &mut ends {
            let count = *end;
            *end = sum;
            sum += count;
        }
        let nothing = Covering {
            triangle: 0,
            depth: 0.0,
            color: Default::default(),
        };
        let mut fragments = vec![nothing; captured.len()];
        for fragment in captured {
            let place = &mut ends[pixel_of(fragment)];
            fragments[*place] = Covering {
                triangle: fragment.order,
                depth: fragment.depth,
                color: fragment.color,
            };
            *place += 1;
        }
        let begins = std::iter::once(0).chain(ends.iter().copied());
        let ranges = begins.zip(ends.iter().copied()).map(|(a, b)| [a, b]);
        Self {
            piece,
            ranges: ranges.collect(),
            fragments,
        }
    }

    fn list(&self, number: usize) -> &[Covering] {
        let [begin, end] = self.ranges[number];
        &self.fragments[begin..end]
    }

    /// Column and row in the image, from the lower left.
    fn place(&self, number: usize) -> [u32; 2] {
        let number = number as u32;
        [
            self.piece.x + number % self.piece.width,
            self.piece.y + number / self.piece.width,
        ]
    }
}

/// The image so far, with the bottom row first, and the pixels that depend on depths, with the top row first, as in
/// images.
struct Canvas {
    size: [u32; 2],
    colors: Vec<[f32; 4]>,
    hanging: Hanging,
}

impl Canvas {
    fn of(size: [u32; 2]) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        Self {
            size,
            colors: vec![[0.0; 4]; pixels],
            hanging: Hanging {
                drawn: vec![false; pixels],
                given: vec![false; pixels],
            },
        }
    }

    fn add(&mut self, piece: Piece, pixels: &[Pixel]) {
        let [width, height] = self.size.map(|side| side as usize);
        let rows = pixels.chunks_exact(piece.width as usize);
        for (row, pixels) in (piece.y as usize..).zip(rows) {
            for (x, &(color, [drawn, given])) in (piece.x as usize..).zip(pixels) {
                self.colors[row * width + x] = color;
                let from_top = (height - 1 - row) * width + x;
                self.hanging.drawn[from_top] = drawn;
                self.hanging.given[from_top] = given;
            }
        }
    }
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
        // A panic in a part is passed on.
        parts
            .flat_map(|part| part.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}

fn depth_buffer(camera: &Camera, size: [u32; 2], format: Format) -> DepthBuffer {
    let float = DepthBuffer::float(camera, size);
    match format {
        Format::Depth24 | Format::Depth24Stencil8 => float.with_bits(24),
        Format::Depth16 => float.with_bits(16),
        _ => float,
    }
}

const ENTRY: Entry = Entry {
    name: "exact",
    source: "the oracle",
    exact: true,
    exactness: EXACT_BY_RAYS,
    ties: Ties::InOrder,
    memory: Memory::Fragments,
    volumes: Volumes::Rays,
    keeps: None,
    needs: &[],
};

impl Technique for Exact {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(ExactImage {
            setup: *setup,
            buffers: [setup.given, setup.given].map(|camera| DepthBuffer::float(&camera, [1; 2])),
        })
    }
}

impl Published for Exact {}
