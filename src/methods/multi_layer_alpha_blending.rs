//! Multi-layer alpha blending (Salvi and Vaidyanathan 2014). One pass takes the fragments in any order, and keeps a few nodes
//! for each pixel.
//!
//! [`FOUR_NODES`] and [`EIGHT_NODES`] are the algorithm. A pixel is exact if it has no more fragments than nodes. If it has
//! more, every fragment is still in the image, and the light that comes through to the opaque image is still right. But the
//! two farthest nodes were merged. A later fragment between them is then taken to lie behind both, so the image depends on
//! the order of submission.
//!
//! A node stores its colours and its transmittance in 24 bits each, from 0 to 1, whatever format the image has.
//!
//! The shader reads and writes several buffers, and a pixel's fragments must do so in the order of submission. The driver
//! has `GL_EXT_shader_framebuffer_fetch` for that (Mesa's llvmpipe), or images with `GL_ARB_fragment_shader_interlock`
//! (NVIDIA's and Intel's drivers).
//!
//! Excludes: multisampling; depths at or beyond the far plane, which GL clips; colours beyond 1, which are stored as 1.

use super::algorithm::{Algorithm, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::buffer_access::{BufferAccess, FETCH, INTERLOCK};
use super::choice::{Choice, Setter, Takes};
use super::entry::{Entry, Memory, Ties, Volumes};
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::salvi_2014::{
    COUNT_TAKEN, EIGHT_IMAGES, EIGHT_NODES, FOUR_IMAGES, FOUR_NODES, RESOURCES_OF_EIGHT,
    RESOURCES_OF_FOUR,
};
use crate::scene::Scene;
use crate::steps::{Variables, run};
use crate::words::{Words, words};

/// What can be chosen about multi-layer alpha blending.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct MultiLayerOptions {
    /// How many nodes a pixel has.
    pub nodes: Nodes,
    /// The way in which the nodes are read and written.
    pub access: BufferAccess,
}

/// The nodes of a pixel, 16 bytes each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Nodes {
    /// Four of them.
    #[default]
    Four = 4,
    /// Eight of them.
    Eight = 8,
}

struct MultiLayerAlphaBlending {
    options: MultiLayerOptions,
    setup: Setup,
    by_images: bool,
}

impl Algorithm for MultiLayerAlphaBlending {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        let driver = machine.context().driver();
        let instead = "weighted-blended takes one pass, too, and runs everywhere";
        self.by_images = self.options.access.is_by_images(driver, instead)?;
        machine.set_defines(&[
            ("NODES", self.options.nodes as u32),
            ("IMAGES", u32::from(self.by_images)),
        ]);
        let resources = match self.options.nodes {
            Nodes::Four => &RESOURCES_OF_FOUR,
            Nodes::Eight => &RESOURCES_OF_EIGHT,
        };
        allocate_maps(machine, &[resources], self.setup.color, self.setup.depth)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let (listing, by_images) = match self.options.nodes {
            Nodes::Four => (&FOUR_NODES, &FOUR_IMAGES),
            Nodes::Eight => (&EIGHT_NODES, &EIGHT_IMAGES),
        };
        let amendments = match self.by_images {
            true => std::slice::from_ref(by_images),
            false => &[],
        };
        run(listing, amendments, Variables::new(), machine)?;
        // No fragment is lost: merged ones are in the image, too.
        Ok(Drawn {
            iterations: 1,
            ..Drawn::default()
        })
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        if self.setup.counts_costs {
            let nodes = f64::from(self.options.nodes as u32);
            let variables = Variables::new().with("nodes", nodes);
            let outcome = run(&COUNT_TAKEN, &[], variables, machine)?;
            // A count of pixels, which is exact in f64.
            drawn.unmerged = outcome.variables.get("taken").map(|taken| taken as u64);
        }
        Ok(())
    }
}

const ENTRY: Entry = Entry {
    name: "multi-layer-alpha-blending",
    source: "Salvi and Vaidyanathan 2014",
    exact: false,
    exactness: "no, but for pixels with at most as many fragments as nodes, 4 or 8",
    ties: Ties::InOrder,
    memory: Memory::Pixels,
    volumes: Volumes::Refused,
    keeps: None,
    needs: &[FETCH, INTERLOCK],
};

impl Technique for MultiLayerOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(MultiLayerAlphaBlending {
            options: *self,
            setup: *setup,
            by_images: false,
        })
    }
}

const NODES: Choice = Choice {
    name: "nodes",
    takes: Takes::Word(Nodes::WORDS),
    help: "How many nodes a pixel has; further fragments are merged",
};
words! { Nodes, "number of nodes",
    Four "4" "64 bytes for each pixel",
    Eight "8" "128 bytes for each pixel",
}

impl Published for MultiLayerOptions {
    const CHOICES: &'static [Setter<Self>] = &[NODES.of(|o| &mut o.nodes)];
}
