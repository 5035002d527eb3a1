//! What an A-buffer leaves at each pixel: its counter, and what its list has cost.

use std::cell::RefCell;
use std::rc::Rc;

use crate::error::Result;
use crate::gl::GlMachine;
use crate::image::Image;
use crate::methods::{
    ABufferOptions, Algorithm, DrawOrder, Drawn, Entry, Frame, Renderer, Setup, Technique,
};
use crate::papers::lindholm_2015 as paper;
use crate::scene::Scene;

/// What a frame of one band has left, pixel by pixel, row by row from the top.
#[derive(Clone, Debug, Default)]
pub(super) struct Left {
    /// The fragments that were counted.
    pub(super) counters: Vec<u32>,
    /// Records read, fragments composited, subpasses, and the elements of the Local Arrays (reserved, and used).
    pub(super) costs: Vec<[u32; 5]>,
}

/// Renders a frame by fixed buffers, whose counters are the counts, and reads what it leaves.
///
/// # Errors
/// As [`Renderer::render`].
pub(super) fn render(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    options: ABufferOptions,
) -> Result<(Frame, Left)> {
    let left = Rc::default();
    let watched = Watched {
        options: ABufferOptions {
            manager: crate::methods::Manager::Ffb,
            budget: Some(u64::MAX),
            ..options
        },
        left: Rc::clone(&left),
    };
    let frame = renderer.render(scene, &watched)?;
    Ok((frame, left.take()))
}

/// An A-buffer that hands out what it leaves.
#[derive(Debug)]
struct Watched {
    options: ABufferOptions,
    left: Rc<RefCell<Left>>,
}

struct Watching {
    inner: Box<dyn Algorithm>,
    left: Rc<RefCell<Left>>,
}

impl Technique for Watched {
    fn entry(&self) -> &'static Entry {
        self.options.entry()
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(Watching {
            inner: self.options.algorithm(setup),
            left: Rc::clone(&self.left),
        })
    }
}

impl Algorithm for Watching {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        self.inner.order(scene)
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        self.inner.prepare(machine, scene)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let drawn = self.inner.draw(machine, scene)?;
        let width = machine.size()[0] as usize;
        let counters = machine.read_counts(paper::COUNTER)?;
        let costs = machine.read_integers(paper::COST)?;
        let cost = |[read, composited, subpasses, slots]: [u32; 4]| {
            [read, composited, subpasses, slots >> 16, slots & 0xFFFF]
        };
        *self.left.borrow_mut() = Left {
            counters: from_top(&counters, width),
            costs: from_top(&costs, width).into_iter().map(cost).collect(),
        };
        Ok(drawn)
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        self.inner.account(machine, drawn)
    }
}

/// The rows from the top, instead of from the bottom.
fn from_top<T: Copy>(texels: &[T], width: usize) -> Vec<T> {
    texels
        .chunks_exact(width)
        .rev()
        .flatten()
        .copied()
        .collect()
}

impl Left {
    /// One of the costs of each pixel.
    pub(super) fn cost(&self, which: usize) -> Vec<u32> {
        self.costs.iter().map(|costs| costs[which]).collect()
    }
}

/// Counts as a picture, dark violet for 0 and yellow for the greatest.
pub(super) fn counts(size: [u32; 2], counts: &[u32]) -> Image {
    crate::low_level::report::Measure::of_counts(size[0], size[1], counts).image()
}
