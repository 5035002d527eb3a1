//! Depth peeling (Everitt 2001), bounded, stopped and composited as VTK's page describes.
//!
//! The loop is Everitt's [Listing 1](LISTING_1); [`vtk::KEEP_LAYERS`] and [`vtk::ON_THE_FLY`] are the algorithms around
//! it. Each pass peels away the fragments at or before the previous layer, and an ordinary depth test finds the nearest
//! of the others. So a layer holds *one* fragment of each depth ("each unique depth"). Of several fragments of a pixel
//! with exactly the same depth, the one submitted first is kept and the others are lost. The frame says how many are
//! lost.
//!
//! Excludes: multisampling; depths at or beyond the far plane, which GL clips.

mod culled;

use super::algorithm::{Algorithm, Composited, DrawOrder, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::choice::{self, Choice, IMPROVE, LITERAL, Setter, Takes, one_of_both, read};
use super::depth_unit_0::DepthUnit0;
use super::entry::{Entry, Memory, Ties, Volumes};
use super::expect_known::expect_known;
use super::iteration_bound::iteration_bound;
use super::requirements;
use super::sorting::TriangleSort;
use super::stats::Peeling;
use super::technique::{Published, Technique};
use crate::error::{Error, Result};
use crate::gl::{Format, GlMachine};
use crate::papers::everitt_2001::{self, LISTING_1};
use crate::papers::{stage, vtk};
use crate::scene::Scene;
use crate::steps;
use crate::steps::{
    Amendment, Call, DepthUnits, Dialect, Listing, Machine, Outcome, Reading, Reason, Variables,
    gl::*, run,
};
use crate::words::{Words, words};

use culled::Culled;

/// The way in which layers become an image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Compositing {
    /// Each layer goes under those before it as soon as it is found. No layer is kept.
    #[default]
    OnTheFly,
    /// Every layer is kept with its depth, and the frame has the layers. They are composited back to front at the end.
    /// Memory grows with the number of layers.
    KeepLayers,
}

/// Options of depth peeling.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DepthPeelingOptions {
    /// The loop ends after so many peels. 0, the default, means no limit, so that the image is exact. VTK documents 0
    /// in the same way, and its single pass conforms to that, but its dual pass, which is its default (9.7.2), then
    /// peels nothing. VTK's default is 4.
    pub maximum_number_of_peels: u32,
    /// The loop ends after a peel that changed fewer pixels than this part of the image, 0 to 1. That last peel is
    /// still composited. 0, the default, is exact.
    pub occlusion_ratio: f64,
    /// The way in which layers become an image.
    pub compositing: Compositing,
    /// An improvement: what counts a layer's pixels is read after the next peel was submitted, so that nothing waits for
    /// it. It takes a peel more ([`vtk::LATE_QUERY`]), and composites on the fly.
    pub late_query: bool,
    /// An improvement: a pixel whose last peel was empty is peeled no more ([`vtk::ALIVE`]). It composites on the fly, and
    /// needs depths that are floats.
    pub alive: bool,
    /// An improvement: from the second peel on, triangles that lie before the last layer wherever they are seen, or where
    /// nothing is left to peel, are culled, and layers are composited in the rectangle of the last layer's pixels.
    pub cull: bool,
    /// How Listing 1 and the blending function are read. Without amendments all objects, opaque or not, are peeled in
    /// `maximum_number_of_peels` passes, which must be at least one.
    pub reading: Reading,
    /// Depth unit 0, which peels: as OpenGL has it today, or as it was made in 2001.
    pub depth_unit_0: DepthUnit0,
    /// More amendments to the listings that run, to try the effect of a changed word.
    pub amendments: &'static [Amendment],
}

impl DepthPeelingOptions {
    /// Whether Listing 1 runs as it stands. It is silent nowhere, so there is nothing to be filled, unlike in the texts on
    /// the depth unit 0 of 2001.
    fn is_printed(&self) -> bool {
        self.reading != Reading::Amended
    }

    /// Whether the frame has the layers.
    fn keeps_layers(&self) -> bool {
        self.is_printed() || self.compositing == Compositing::KeepLayers
    }
}

struct DepthPeeling {
    options: DepthPeelingOptions,
    color: Format,
    depth: Format,
    /// The number of peels that a loop without a limit may need.
    bound: f64,
}

impl Algorithm for DepthPeeling {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        match self.options.cull {
            true => DrawOrder::Sorted(TriangleSort::Submission.order(scene)),
            false => DrawOrder::Submission,
        }
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        self.options.check()?;
        requirements::check(machine.context().driver(), self.color)?;
        if self.options.alive && !self.depth.has_float_depth() {
            return Err(Error::option(
                "depth",
                "with the improvement alive, depths go through a shader, which may round those of a fixed-point format",
                "choose a depth format with floats, or leave the improvement out",
            ));
        }
        if self.options.maximum_number_of_peels == 0 && self.may_get_stuck() {
            self.bound = iteration_bound(machine)?;
            if self.options.late_query {
                self.bound += 1.0;
            }
        }
        allocate_maps(machine, &[&vtk::PEELING], self.color, self.depth)?;
        if !self.options.keeps_layers() {
            allocate_maps(machine, &[&stage::ACCUMULATING], self.color, self.depth)?;
        }
        self.expect_known(machine)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        if self.options.is_printed() {
            return self.draw_as_printed(machine);
        }
        if scene.meshes.iter().all(|mesh| mesh.opaque) {
            run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
            return Ok(Drawn {
                iterations: 0,
                peeling: Peeling::NothingTransparent,
                ..Drawn::default()
            });
        }
        let [width, height] = machine.size();
        let variables = self
            .variables()
            .with("occlusion_ratio", self.options.occlusion_ratio)
            .with("window_area", f64::from(width) * f64::from(height));
        let outcome = self.run(machine, scene, variables)?;
        let mut drawn = drawn(&outcome);
        drawn.keeps_layers = self.options.keeps_layers();
        if self.may_get_stuck() && outcome.stopped != Some(Reason::EmptyLayer) {
            // Layers may have been counted twice.
            drawn.composited = Composited::Unknown;
            if outcome.stopped.is_none() && self.options.maximum_number_of_peels == 0 {
                drawn.stopped = Some(Reason::NoEnd);
            }
        }
        Ok(drawn)
    }
}

impl DepthPeeling {
    fn new(options: DepthPeelingOptions, setup: &Setup) -> Self {
        Self {
            options,
            color: setup.color,
            depth: setup.depth,
            bound: f64::INFINITY,
        }
    }

    /// The caller's, then the improvements that are chosen.
    fn amendments(&self) -> Vec<Amendment> {
        let mut amendments = self.options.amendments.to_vec();
        if self.options.late_query {
            amendments.extend(vtk::LATE_QUERY);
        }
        if self.options.alive {
            amendments.extend(vtk::ALIVE);
        }
        amendments
    }

    fn run(
        &self,
        machine: &mut GlMachine<'_>,
        scene: &Scene,
        variables: Variables,
    ) -> Result<Outcome> {
        let (listing, amendments) = (self.listing(), self.amendments());
        if !self.options.cull {
            let reading = self.options.reading;
            let unit_0 = self.options.depth_unit_0;
            return unit_0.run(machine, reading, listing, &amendments, variables);
        }
        let mut culled = Culled::new(machine, scene);
        let units = &mut DepthUnits::new(&mut culled);
        let outcome = run(listing, &amendments, variables, units)?;
        culled.finish()?;
        Ok(outcome)
    }

    /// Not as printed.
    fn listing(&self) -> &'static Listing {
        match self.options.compositing {
            Compositing::OnTheFly => &vtk::ON_THE_FLY,
            Compositing::KeepLayers => &vtk::KEEP_LAYERS,
        }
    }

    fn expect_known(&self, machine: &GlMachine<'_>) -> Result<()> {
        let amendments = self.options.amendments;
        if self.options.is_printed() {
            expect_known(machine, &LISTING_1_AND_STATE, amendments, &[&vtk::PEELING])?;
            let resources = [&vtk::PEELING, &everitt_2001::COMPOSITING];
            return expect_known(machine, &everitt_2001::COMPOSITE, amendments, &resources);
        }
        let resources = [&stage::ACCUMULATING, &vtk::PEELING, &everitt_2001::TRIED];
        expect_known(machine, self.listing(), &self.amendments(), &resources)
    }

    /// Whether a fragment may pass the comparison with its own depth again and again. This is possible if the compared
    /// depth is not the rasteriser's, or if the stored depth was rounded.
    fn may_get_stuck(&self) -> bool {
        self.options.depth_unit_0 != DepthUnit0::Sampler || !self.depth.has_float_depth()
    }

    fn variables(&self) -> Variables {
        let peels = match self.options.maximum_number_of_peels {
            0 => self.bound,
            peels => f64::from(peels),
        };
        Variables::new().with("num_passes", peels)
    }

    fn draw_as_printed(&self, machine: &mut GlMachine<'_>) -> Result<Drawn> {
        let outcome = self.options.depth_unit_0.run(
            machine,
            self.options.reading,
            &LISTING_1_AND_STATE,
            self.options.amendments,
            self.variables(),
        )?;
        machine.perform(&Call::BindFramebuffer {
            framebuffer: stage::COMPOSITE,
        })?;
        let layers = self.options.maximum_number_of_peels;
        let variables = outcome.variables.with("num_layers", f64::from(layers));
        run(
            &everitt_2001::COMPOSITE,
            self.options.amendments,
            variables,
            machine,
        )?;
        Ok(Drawn {
            iterations: layers,
            layers: Some(layers),
            keeps_layers: true,
            composited: Composited::Unknown,
            stopped: Some(Reason::PeelLimit),
            peeling: Peeling::Used,
            ..Drawn::default()
        })
    }
}

/// Listing 1 with the state that it takes for granted: the image has its background, the scene has a program, and a cleared
/// layer covers nothing.
pub(crate) const LISTING_1_AND_STATE: Listing = Listing {
    title: "Listing 1 as printed",
    source: "onionskin",
    dialect: Dialect::Calls,
    steps: steps! {
        edition "Listing 1 takes a framebuffer and a program for granted";
        glBindFramebuffer(stage::COMPOSITE);
        glClear(COLOR_BUFFER_BIT);
        glBindFramebuffer(stage::PEEL);
        glClearColor(0.0, 0.0, 0.0, 0.0);
        glUseProgram(stage::PEEL_SURFACE);
        run LISTING_1;
    },
};

fn drawn(outcome: &Outcome) -> Drawn {
    let number = |name| outcome.variables.get(name).unwrap_or(0.0);
    let layers = number("num_layers") as u32;
    Drawn {
        iterations: number("peels") as u32,
        layers: Some(layers),
        composited: Composited::Some(number("composited") as u64),
        stopped: Some(outcome.stopped.unwrap_or(Reason::PeelLimit)),
        peeling: Peeling::Used,
        ..Drawn::default()
    }
}

const ENTRY: Entry = Entry {
    name: "depth-peeling",
    source: "Everitt 2001; VTK",
    exact: true,
    exactness: "yes, but for ties; volumes as slices: no, an error of order 1 in the slices' distance",
    ties: Ties::FirstKept,
    memory: Memory::PixelsOrLayers,
    volumes: Volumes::SlicesWhenAsked,
    keeps: None,
    needs: &[],
};

impl Technique for DepthPeelingOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(DepthPeeling::new(*self, setup))
    }

    fn check(&self) -> Result<()> {
        if !(0.0..=1.0).contains(&self.occlusion_ratio) {
            let what = format!(
                "the occlusion ratio {} is not between 0 and 1",
                self.occlusion_ratio
            );
            return Err(Error::option(
                "occlusion-ratio",
                what,
                "0 is exact; 0.01 ignores peels that change less than 1% of the image",
            ));
        }
        if self.is_printed() && matches!(self.depth_unit_0, DepthUnit0::Experiment(_)) {
            return Err(Error::option(
                "depth-unit-0",
                "the invariance experiment amends Listing 1",
                "leave it out, or let the listing be amended",
            ));
        }
        let on_the_fly = self.late_query || self.alive;
        one_of_both(self.reading, on_the_fly || self.cull)?;
        if self.cull && self.depth_unit_0 != DepthUnit0::default() {
            return Err(Error::option(
                "improve",
                "culling holds triangles against the depths that a sampler compares",
                "leave cull out, or let depth unit 0 be a sampler",
            ));
        }
        if on_the_fly && self.compositing == Compositing::KeepLayers {
            return Err(Error::option(
                "improve",
                "late-query and alive are improvements of compositing on the fly, which keeps no layers",
                "leave them out, or do not ask for the layers",
            ));
        }
        if self.is_printed() && self.maximum_number_of_peels == 0 {
            return Err(Error::option(
                "peels",
                "Listing 1 as printed has no way to find out when to stop",
                "say how many passes it makes: 4 give the four layers of its figure 3",
            ));
        }
        Ok(())
    }

    fn needs_window_depth(&self) -> Option<&'static str> {
        if self.cull {
            return Some("culling compares triangles with window-space depth");
        }
        (self.depth_unit_0 != DepthUnit0::default())
            .then_some("this way of comparing with depth unit 0 asks for window-space depth")
    }
}

pub(super) const PEELS: Choice = Choice {
    name: "peels",
    takes: Takes::Value("N"),
    help: "At most this many peels, nearest first. 0 means no limit, as VTK documents it",
};

pub(super) const OCCLUSION_RATIO: Choice = Choice {
    name: "occlusion-ratio",
    takes: Takes::Value("0..1"),
    help: "Stop after a peel that changed fewer pixels than this part of the image. 0 is exact",
};

const LAYERS: Choice = Choice {
    name: "layers",
    takes: Takes::Nothing,
    help: "Keep every layer and write it beside the image: FILE-layer-0.png is the nearest, and so on",
};

const DEPTH_UNIT_0: Choice = Choice {
    name: "depth-unit-0",
    takes: Takes::Word(DepthUnit0::WORDS),
    help: "Depth unit 0, which peels: a shadow sampler, or the alpha test of 2001 with or without Listing 2's depth \
           replace",
};
words! { DepthUnit0, "depth unit",
    Sampler "sampler" "The rasteriser's depth, compared by the sampler",
    Classic "classic" "r/q, compared into alpha",
    ClassicDepthReplace "classic-depth-replace" "The same, with r/q stored as the depth",
    ClassicRectangle "classic-rectangle" "The same, looked up in a rectangle texture, as in VTK",
    ClassicSgix "classic-sgix" "With r/q stored, too, and compared by SGIX_shadow and register combiners, as a GeForce3 had them",
}

fn improve(options: &mut DepthPeelingOptions, improvement: &str) -> Result<()> {
    match improvement {
        "late-query" => options.late_query = true,
        "alive" => options.alive = true,
        "cull" => options.cull = true,
        _ => {
            return Err(Error::unknown(
                "improvement",
                improvement,
                &["late-query", "alive", "cull"],
            ));
        }
    }
    Ok(())
}

impl Published for DepthPeelingOptions {
    const CHOICES: &'static [Setter<Self>] = &[
        PEELS.of(|o| &mut o.maximum_number_of_peels),
        OCCLUSION_RATIO.of(|o| &mut o.occlusion_ratio),
        LAYERS.by(|o, _| {
            o.compositing = Compositing::KeepLayers;
            Ok(())
        }),
        IMPROVE.by(|o, list| list.split(',').try_for_each(|text| improve(o, text))),
        DEPTH_UNIT_0.of(|o| &mut o.depth_unit_0),
        choice::AS_PRINTED.by(|o, _| read(&mut o.reading, Reading::AsPrinted)),
        LITERAL.by(|o, _| read(&mut o.reading, Reading::Literal)),
    ];
}
