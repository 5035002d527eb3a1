//! Coherent layer peeling on the ideal GPU (Carr et al. 2008, Algorithm 2), with two geometry passes per iteration.
//!
//! It needs a rasteriser whose shaders read and write several buffers in the order of submission. Drivers with
//! `GL_EXT_shader_framebuffer_fetch` (Mesa's llvmpipe) have one. Drivers with `GL_ARB_fragment_shader_interlock`
//! (NVIDIA's, Intel's) have one by images. The paper's pseudocode itself runs on the emulated pixel.

use super::algorithm::{Algorithm, Composited, DrawOrder, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::buffer_access::{BufferAccess, FETCH, INTERLOCK};
use super::choice::{AS_PRINTED, IMPROVE, LITERAL, Setter, one_of_both, read};
use super::entry::{EXACT_BUT_NOT_SLICES, Entry, Memory, Ties, Volumes};
use super::loop_guard::{LoopGuard, peeled};
use super::sorting::{SORT, TriangleSort};
use super::technique::{Published, Technique};
use crate::error::{Error, Result};
use crate::gl::GlMachine;
use crate::papers::carr_2008::ideal;
use crate::scene::Scene;
use crate::steps::{Format, Reading, Resources, run};

/// Options of coherent layer peeling on the ideal GPU.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct IdealOptions {
    /// The sorting of triangles beforehand.
    pub sorting: TriangleSort,
    /// An improvement: an unbroken run ends at the loose bound `z2` ([`ideal::TIGHT_BOUND`]).
    pub tight_bound: bool,
    /// How Algorithm 2 is read. Loops that go on for too long without its amendments are given up.
    pub reading: Reading,
    /// The way in which its buffers are read and written.
    pub access: BufferAccess,
}

struct IdealCoherentLayerPeeling {
    options: IdealOptions,
    peeled: LoopGuard,
    by_images: bool,
}

impl IdealCoherentLayerPeeling {
    fn new(options: IdealOptions) -> Self {
        Self {
            options,
            peeled: LoopGuard::new(options.reading),
            by_images: false,
        }
    }
}

impl Algorithm for IdealCoherentLayerPeeling {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        DrawOrder::Sorted(self.options.sorting.order(scene))
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        let driver = machine.context().driver();
        let instead = "coherent-layer-peeling-a runs everywhere";
        self.by_images = self.options.access.is_by_images(driver, instead)?;
        self.peeled.prepare(machine)?;
        machine.set_defines(&[("IMAGES", u32::from(self.by_images))]);
        let resources: &[&Resources] = match self.by_images {
            true => &[&ideal::RESOURCES, &ideal::NO_COLOR_RESOURCES],
            false => &[&ideal::RESOURCES],
        };
        // They say their formats themselves.
        allocate_maps(
            machine,
            resources,
            Format::Rgba32F,
            Format::Depth32FStencil8,
        )
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        let mut amendments = match self.options.tight_bound {
            true => self.peeled.amendments(&ideal::TIGHT_BOUND_ON_GL),
            false => self.peeled.amendments(&ideal::AMENDMENTS),
        };
        if self.by_images {
            amendments.extend(ideal::BY_IMAGES);
        }
        let outcome = run(&ideal::IDEAL, &amendments, self.peeled.variables(), machine)?;
        Ok(Drawn {
            // Its shaders composite without blending or discarding, so no query can count.
            composited: match self.options.reading {
                Reading::Amended => Composited::All,
                _ => Composited::Unknown,
            },
            ..peeled(&outcome)
        })
    }
}

const ENTRY: Entry = Entry {
    name: "ideal-coherent-layer-peeling",
    source: "Carr et al. 2008, Algorithm 2",
    exact: true,
    exactness: EXACT_BUT_NOT_SLICES,
    ties: Ties::InOrderAfterSorting,
    memory: Memory::PixelsAndTriangles,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[FETCH, INTERLOCK],
};

impl Technique for IdealOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, _: &Setup) -> Box<dyn Algorithm> {
        Box::new(IdealCoherentLayerPeeling::new(*self))
    }

    fn check(&self) -> Result<()> {
        one_of_both(self.reading, self.tight_bound)
    }
}

impl Published for IdealOptions {
    const CHOICES: &'static [Setter<Self>] = &[
        SORT.of(|o| &mut o.sorting),
        IMPROVE.by(|o, list| {
            const TIGHT_BOUND: &str = "tight-bound";
            let unknown = list.split(',').find(|&text| text != TIGHT_BOUND);
            if let Some(name) = unknown {
                return Err(Error::unknown("improvement", name, &[TIGHT_BOUND]));
            }
            o.tight_bound = true;
            Ok(())
        }),
        AS_PRINTED.by(|o, _| read(&mut o.reading, Reading::AsPrinted)),
        LITERAL.by(|o, _| read(&mut o.reading, Reading::Literal)),
    ];
}
