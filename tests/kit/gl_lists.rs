//! What an A-buffer leaves on OpenGL: its buffers, read back after the frame, and the lists that are in them.

use std::cell::RefCell;
use std::rc::Rc;

use half::f16;
use onionskin::low_level::gl::GlMachine;
use onionskin::low_level::methods::{Algorithm, Drawn, Entry, Setup, Technique};
use onionskin::low_level::papers::lindholm_2015 as paper;
use onionskin::low_level::papers::stage;
use onionskin::options::{ABufferOptions, Fill, Manager, RecordColor};
use onionskin::{Fragment, Renderer, Result, Scene};

use super::changed::Change;

/// Everything by pixels, row by row from the bottom, and the pool.
#[derive(Clone, Debug, Default)]
pub struct Left {
    options: ABufferOptions,
    width: usize,
    /// The image is one band.
    layers: usize,
    records: Vec<u8>,
    next: Vec<u8>,
    offsets: Vec<u8>,
    anchors: Vec<u32>,
    /// What each pixel's counter says.
    pub counters: Vec<u32>,
    /// Records read, fragments composited, subpasses, and the elements of Local Arrays.
    pub costs: Vec<[u32; 4]>,
    pub image: Vec<[f32; 4]>,
}

/// An A-buffer that hands out what it leaves.
#[derive(Debug)]
struct Watched {
    options: ABufferOptions,
    change: Option<Change>,
    left: Rc<RefCell<Left>>,
}

struct Watching {
    inner: Box<dyn Algorithm>,
    options: ABufferOptions,
    change: Option<Change>,
    left: Rc<RefCell<Left>>,
}

impl Technique for Watched {
    fn entry(&self) -> &'static Entry {
        self.options.entry()
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(Watching {
            inner: self.options.algorithm(setup),
            options: self.options,
            change: self.change,
            left: self.left.clone(),
        })
    }
}

impl Algorithm for Watching {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        if let Some(change) = self.change {
            super::both::change_shader(machine, change);
        }
        self.inner.prepare(machine, scene)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let drawn = self.inner.draw(machine, scene)?;
        let counters = machine.read_counts(paper::COUNTER)?;
        let storage = |storage| machine.read_storage(storage);
        *self.left.borrow_mut() = Left {
            options: self.options,
            width: machine.size()[0] as usize,
            layers: self.options.fixed_layers.unwrap_or(0) as usize,
            records: storage(paper::RECORDS)?,
            next: storage(paper::NEXT)?,
            offsets: storage(paper::OFFSETS)?,
            anchors: machine.read_counts(paper::ANCHOR)?,
            counters,
            costs: machine.read_integers(paper::COST)?,
            image: machine.read_colors(stage::IMAGE_COLOR)?,
        };
        Ok(drawn)
    }
}

/// What a frame of one band leaves, drawn by a shader with another word if so said.
pub fn left(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    options: ABufferOptions,
    change: Option<Change>,
) -> Left {
    let left = Rc::default();
    let watched = Watched {
        options,
        change,
        left: Rc::clone(&left),
    };
    renderer.render(scene, &watched).unwrap();
    let mut left = left.take();
    if left.layers == 0 {
        // A fixed buffer has room for the deepest pixel.
        left.layers = left.counters.iter().copied().max().unwrap_or(0) as usize;
    }
    left
}

impl Left {
    /// Where a pixel's records begin, by the base offsets.
    fn offset(&self, pixel: usize) -> usize {
        match self.has_offsets() {
            true => word(&self.offsets, pixel) as usize,
            false => 0,
        }
    }

    fn has_offsets(&self) -> bool {
        match (self.options.manager, self.options.fill) {
            (Manager::Ffb, _) | (Manager::Ppll, Fill::Atomics) => false,
            (Manager::Dfb | Manager::Ppll, _) => true,
        }
    }

    /// How many fragments a pixel's counter has counted.
    pub fn counted(&self, pixel: usize) -> usize {
        self.counters[pixel] as usize - self.offset(pixel)
    }

    /// A pixel's list in the order of filling, as its links or its place in the pool say.
    pub fn list(&self, pixel: usize) -> Vec<Fragment> {
        let count = self.counted(pixel);
        let places: Vec<usize> = match self.options.manager {
            Manager::Ffb => {
                // Groups of sixteen pixels of a row share their layers.
                let (row, x) = (pixel / self.width * self.width, pixel % self.width);
                let group = x / 16 * 16;
                let stride = (self.width - group).min(16);
                let first = (row + group) * self.layers + x - group;
                let count = count.min(self.layers);
                (0..count).map(|layer| first + layer * stride).collect()
            }
            Manager::Dfb => (0..count).map(|at| self.offset(pixel) + at).collect(),
            Manager::Ppll => {
                let newest = match self.has_offsets() {
                    true => self.counters[pixel],
                    false => self.anchors[pixel],
                };
                let mut link = newest;
                let walk = (0..count).map(|_| {
                    let at = link as usize - 1;
                    link = word(&self.next, at);
                    at
                });
                let mut places: Vec<_> = walk.collect();
                places.reverse();
                places
            }
        };
        places.into_iter().map(|at| self.record(at)).collect()
    }

    fn record(&self, at: usize) -> Fragment {
        let float = self.options.color == RecordColor::Float;
        let words = if float { 8 } else { 4 };
        let word = |number: usize| word(&self.records, at * words + number);
        let half =
            |number: usize| f16::from_bits((word(2 + number / 2) >> (16 * (number % 2))) as u16);
        let color: [f32; 4] = std::array::from_fn(|number| match float {
            true => f32::from_bits(word(4 + number)),
            false => half(number).to_f32(),
        });
        Fragment {
            depth: f32::from_bits(word(0)),
            order: word(1),
            color: color.into(),
        }
    }
}

fn word(bytes: &[u8], number: usize) -> u32 {
    let at = 4 * number;
    u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"))
}
