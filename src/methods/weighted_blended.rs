//! Weighted blended transparency (McGuire and Bavoil 2013): one pass in whatever order, and a quotient.
//!
//! [`WEIGHTED_BLENDED`] is the algorithm. It is exact where a pixel has one fragment, and where all of its fragments have
//! one colour, because what comes through to the opaque image is always right. Elsewhere the image has a weighted mean of
//! the colours, so that no channel can be further off than the fragments' colours are apart.
//!
//! Equations 7 to 9 weigh by the distance along the view direction, in units of the scene, for scenes of a few to some
//! hundreds of them. Equation 10 weighs by window-space depth, so its image depends on the clip planes.
//!
//! Excludes: multisampling; depths at or beyond the far plane, which GL clips.

use super::algorithm::{Algorithm, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::choice::{Choice, Setter, Takes};
use super::entry::{Entry, Memory, Ties, Volumes};
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::mcguire_2013::{RESOURCES, WEIGHTED_BLENDED};
use crate::scene::Scene;
use crate::steps::{Variables, run};
use crate::words::{Words, words};

/// What can be chosen about weighted blended transparency.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WeightedBlendedOptions {
    /// How fragments are weighted.
    pub weight: Weight,
}

/// The paper's weights, by its equations: each falls with the distance, and is proportional to the opacity.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// With the second power of the distance, then with the sixth.
    #[default]
    Equation7 = 7,
    /// With the third power of the distance, then with the sixth.
    Equation8 = 8,
    /// With the fourth power of the distance.
    Equation9 = 9,
    /// With the third power of what window-space depth lacks to 1.
    Equation10 = 10,
}

struct WeightedBlended {
    options: WeightedBlendedOptions,
    setup: Setup,
}

impl Algorithm for WeightedBlended {
    fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        machine.set_defines(&[("EQUATION", self.options.weight as u32)]);
        allocate_maps(machine, &[&RESOURCES], self.setup.color, self.setup.depth)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        run(&WEIGHTED_BLENDED, &[], Variables::new(), machine)?;
        Ok(Drawn {
            iterations: 1,
            ..Drawn::default()
        })
    }
}

const ENTRY: Entry = Entry {
    name: "weighted-blended",
    source: "McGuire and Bavoil 2013",
    exact: false,
    exactness: "no, but for one layer, or one colour",
    ties: Ties::Unordered,
    memory: Memory::Pixels,
    volumes: Volumes::Refused,
    keeps: None,
    needs: &[],
};

impl Technique for WeightedBlendedOptions {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(WeightedBlended {
            options: *self,
            setup: *setup,
        })
    }
}

const WEIGHT: Choice = Choice {
    name: "weight",
    takes: Takes::Word(Weight::WORDS),
    help: "Which of the paper's equations weighs fragments",
};
words! { Weight, "weight",
    Equation7 "7" "Falls with the distance's second power, then its sixth",
    Equation8 "8" "Falls with the distance's third power, then its sixth",
    Equation9 "9" "Falls with the distance's fourth power",
    Equation10 "10" "Falls with window-space depth",
}

impl Published for WeightedBlendedOptions {
    const CHOICES: &'static [Setter<Self>] = &[WEIGHT.of(|o| &mut o.weight)];
}
