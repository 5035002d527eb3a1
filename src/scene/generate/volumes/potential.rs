//! The electrostatic potential of charges.

use glam::DVec3;

use super::{Field, Lattice, VALUE, checked};
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::Refusal;
use crate::scene::generate::limits::{COORDINATE, LENGTH, all_within, refusal, within};

/// A charged atom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Atom {
    /// The atom's position, coordinates -1e6 to 1e6.
    pub position: [f32; 3],
    /// The atom's charge, -1e6 to 1e6.
    pub charge: f32,
}

/// The electrostatic potential of atoms: the sum of charge / sqrt(distance^2 + `softness`^2), in charges per unit of
/// length. Without a softness it would be unbounded at the atoms.
#[derive(Clone, Debug, PartialEq)]
pub struct Potential {
    /// The lattice on which it is sampled.
    pub lattice: Lattice,
    /// The atoms, at least one. The product of the numbers of atoms and samples is at most 4e9.
    pub atoms: Vec<Atom>,
    /// The length below which a charge is smoothed, 1e-3 to 1e6.
    pub softness: f32,
}

impl Default for Potential {
    /// A molecule of water, in angstroms and elementary charges (TIP3P: Jorgensen et al. 1983).
    fn default() -> Self {
        let atom = |x, y, charge| Atom {
            position: [x, y, 0.0],
            charge,
        };
        Self {
            lattice: Lattice {
                size: 6.0,
                samples: 64,
            },
            atoms: vec![
                atom(0.0, 0.0, -0.834),
                atom(0.7570, -0.5859, 0.417),
                atom(-0.7570, -0.5859, 0.417),
            ],
            softness: 0.5,
        }
    }
}

/// The potential, sampled.
///
/// # Errors
/// A parameter is out of its range.
pub fn potential(parameters: &Potential) -> Result<Volume> {
    checked(parameters)
}

/// The most atoms times samples: some ten seconds of work.
const MOST_WORK: u64 = 4_000_000_000;

impl Field for Potential {
    fn check(&self) -> Result<(), Refusal> {
        within("softness", self.softness, [1e-3, LENGTH[1]])?;
        for atom in &self.atoms {
            all_within("atoms", &atom.position, COORDINATE)?;
            within("atoms", atom.charge, VALUE)?;
        }
        if self.atoms.is_empty() {
            let remedy = "Give at least one: x, y, z and charge.";
            return Err(refusal("atoms", "there are no atoms", remedy));
        }
        let samples = u64::from(self.lattice.samples).pow(3);
        let work = samples.saturating_mul(self.atoms.len() as u64);
        if work > MOST_WORK {
            let what = format!("{} atoms times {samples} samples", self.atoms.len());
            let remedy = "Give fewer `samples`, or fewer atoms: the product is at most 4e9.";
            return Err(refusal("samples", what, remedy));
        }
        Ok(())
    }

    fn lattice(&self) -> Lattice {
        self.lattice
    }

    fn name(&self) -> &'static str {
        "potential"
    }

    fn value(&self, point: DVec3) -> f64 {
        let soft = f64::from(self.softness).powi(2);
        let part = |atom: &Atom| {
            let away = point - DVec3::from_array(atom.position.map(f64::from));
            f64::from(atom.charge) / (away.length_squared() + soft).sqrt()
        };
        self.atoms.iter().map(part).sum()
    }
}
