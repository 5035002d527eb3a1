//! The twelve methods that the options make: three managers, each with and without ppAO and ppDP.

use super::ABuffer;
use super::choices::CHOICES;
use super::options::{ABufferOptions, Keep, Manager, SMALLEST_SEGMENT};
use crate::error::{Error, Result};
use crate::methods::algorithm::{Algorithm, Setup};
use crate::methods::choice::Setter;
use crate::methods::entry::{EXACT_BY_RAYS, Entry, Memory, Ties, Volumes};
use crate::methods::technique::{Published, Technique};
use crate::words::Words;

const fn entry(name: &'static str, manager: Manager, pp_dp: bool) -> Entry {
    Entry {
        name,
        source: "Lindholm et al. 2015",
        exact: true,
        exactness: match pp_dp {
            true => EXACT_BY_RAYS,
            false => "yes, volumes by rays, too, up to 64 fragments a pixel (option array)",
        },
        ties: Ties::InOrder,
        memory: match manager {
            Manager::Ffb => Memory::PixelsTimesLayers,
            Manager::Dfb | Manager::Ppll => Memory::PixelsAndFragments,
        },
        volumes: Volumes::Rays,
        keeps: match (pp_dp, manager) {
            (true, _) => None,
            (false, Manager::Ffb | Manager::Dfb) => Some("the first submitted"),
            (false, Manager::Ppll) => Some("the last submitted"),
        },
        needs: &[],
    }
}

/// One entry each for neither of ppAO and ppDP, for one of them, for both. `static` is the paper's word for the array
/// without any.
static ENTRIES: [[Entry; 4]; 3] = [
    [
        entry("ffb", Manager::Ffb, false),
        entry("ffb+ppao", Manager::Ffb, false),
        entry("ffb+ppdp", Manager::Ffb, true),
        entry("ffb+ppao+ppdp", Manager::Ffb, true),
    ],
    [
        entry("dfb", Manager::Dfb, false),
        entry("dfb+ppao", Manager::Dfb, false),
        entry("dfb+ppdp", Manager::Dfb, true),
        entry("dfb+ppao+ppdp", Manager::Dfb, true),
    ],
    [
        entry("ppll", Manager::Ppll, false),
        entry("ppll+ppao", Manager::Ppll, false),
        entry("ppll+ppdp", Manager::Ppll, true),
        entry("ppll+ppao+ppdp", Manager::Ppll, true),
    ],
];

impl Technique for ABufferOptions {
    fn entry(&self) -> &'static Entry {
        let components = usize::from(self.pp_ao) + 2 * usize::from(self.pp_dp);
        &ENTRIES[self.manager as usize][components]
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(ABuffer::new(*self, setup.counts_costs))
    }

    fn check(&self) -> Result<()> {
        let array = self.array;
        if !(1..=256).contains(&array) || !array.is_power_of_two() {
            return Err(Error::option(
                "array",
                format!("a local array of {array} fragments is not to be had"),
                "choose 1, 2, 4, 8 ... 256; 64 is usual, and ppDP takes what is deeper",
            ));
        }
        if self.pp_ao && array < SMALLEST_SEGMENT {
            return Err(Error::option(
                "array",
                format!("ppAO's last segment cannot be {array}: its first is {SMALLEST_SEGMENT}"),
                "choose an array of 8, 16, 32 ...",
            ));
        }
        if !(1..=64).contains(&self.peel) {
            return Err(Error::option(
                "peel",
                format!("ppDP cannot peel {} fragments at a time", self.peel),
                "choose 1 to 64; 8 is usual",
            ));
        }
        if self.keep == Keep::Nearest && (self.pp_dp || self.is_printed()) {
            return Err(Error::option(
                "keep",
                match self.pp_dp {
                    true => {
                        "ppDP drops no fragment, so there are none of which the nearest could be kept"
                    }
                    false => {
                        "the paper does not say that the nearest fragments are kept, so as printed they are not"
                    }
                },
                "leave out one of the two",
            ));
        }
        if !(0.0..=1.0).contains(&self.termination) {
            return Err(Error::option(
                "termination",
                format!(
                    "the transparency {} at which a ray ends is not between 0 and 1",
                    self.termination
                ),
                "0 is exact; 0.02 is the paper's",
            ));
        }
        if self.most_subpasses.is_some() && !self.pp_dp {
            return Err(Error::option(
                "most-subpasses",
                "without ppDP a pixel has one pass, and its number cannot be limited",
                "choose a method with ppDP, or leave the limit out",
            ));
        }
        if self.most_subpasses == Some(0) {
            return Err(Error::option(
                "most-subpasses",
                "ppDP cannot resolve anything in 0 subpasses",
                "choose 1 or more",
            ));
        }
        if self.fixed_layers.is_some() && self.manager != Manager::Ffb {
            return Err(Error::option(
                "fixed-layers",
                "only a fixed buffer has the same number of layers at every pixel; dfb and ppll are as large as the \
                 counted fragments",
                "choose ffb, or leave the number out",
            ));
        }
        if self
            .fixed_layers
            .is_some_and(|layers| !(1..=65_536).contains(&layers))
        {
            return Err(Error::option(
                "fixed-layers",
                "a fixed buffer cannot have this number of layers",
                "choose 1 to 65536",
            ));
        }
        if self.budget == Some(0) {
            return Err(Error::option(
                "budget",
                "no fragment fits into a budget of 0 bytes",
                "leave the budget out, or give it some megabytes",
            ));
        }
        Ok(())
    }
}

impl Published for ABufferOptions {
    const CHOICES: &'static [Setter<Self>] = CHOICES;

    fn variants() -> Vec<Self> {
        let mut all = Vec::new();
        for &manager in Manager::VALUES {
            for [pp_dp, pp_ao] in [[false, false], [false, true], [true, false], [true, true]] {
                all.push(Self {
                    manager,
                    pp_ao,
                    pp_dp,
                    ..Self::DEFAULT
                });
            }
        }
        all
    }
}
