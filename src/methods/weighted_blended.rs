//! Weighted blended transparency (McGuire and Bavoil 2013). One pass adds up all fragments, in any order. Then each sum is
//! divided by the sum of the weights.
//!
//! [`WEIGHTED_BLENDED`] is the algorithm. The light that comes through to the opaque image is always right. So a pixel is
//! exact if it has one fragment, or if all of its fragments have one colour. Any other pixel has a weighted mean of the
//! fragments' colours. No channel of it can be further off than the colours are apart.
//!
//! Equations 7 to 9 weigh fragments by their distance along the view direction, in units of the scene. They are made for
//! distances of a few units to some hundreds. Equation 10 weighs fragments by window-space depth, so its image depends on the
//! clip planes.
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

/// The paper's weights, by the numbers of its equations. Each weight is proportional to the opacity, and falls with the
/// distance. The paper has no others, so a caller may match on all of them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weight {
    /// It falls with the second power of the distance, and far away with the sixth.
    #[default]
    Equation7 = 7,
    /// It falls with the third power of the distance, and far away with the sixth.
    Equation8 = 8,
    /// It falls with the fourth power of the distance.
    Equation9 = 9,
    /// It is the third power of 1 minus the window-space depth.
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
