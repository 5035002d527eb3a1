//! `generate = "NAME"` of a volume and the parameters of each generator.

use super::keys::Keys;
use super::limits::ANY;
use crate::error::Result;
use crate::scene::Volume;
use crate::scene::generate::{
    Atom, Ball, Constant, Ejection, Field, Gradient, Lattice, Potential, Refusal, SheppLogan,
    Swirl, bytes_of_samples, sampled,
};

/// Reads the parameters of one generator. A parameter that is left out has the default that the generator documents.
type Reader = fn(&Keys) -> Result<Box<dyn Field>>;

/// All generators: name, parameters of their own, reader.
const GENERATORS: [(&str, &[&str], Reader); 7] = [
    ("constant", &["value"], constant),
    ("ball", &["radius", "softness", "value"], ball),
    ("gradient", &["from", "to"], gradient),
    ("shepp-logan", &["softness"], shepp_logan),
    ("potential", &["atoms", "softness"], potential),
    ("ejection", &["part", "front", "spread"], ejection),
    ("swirl", &["core", "winding", "turns", "jet"], swirl),
];

/// The parameters of every generator.
const LATTICE: [&str; 2] = ["size", "samples"];

/// The generated volume; `common` are the keys that every volume may have.
pub(super) fn read(keys: &Keys, common: &[&str]) -> Result<Volume> {
    let choices = GENERATORS.each_ref().map(|entry| (entry.0, entry));
    let Some((_, parameters, reader)) = keys.choice("generate", &choices)? else {
        unreachable!("called for volumes with this key only")
    };
    keys.expect_only(&[&["generate"], *parameters, &LATTICE, common].concat())?;
    let field = reader(keys)?;
    let refused = |refusal: Refusal| keys.wrong(refusal.key, refusal.what, refusal.remedy);
    let bytes = bytes_of_samples(field.as_ref()).map_err(refused)?;
    let room = keys.document.memory.take(bytes);
    room.map_err(|shortage| shortage.at(keys.place("samples"), "the samples"))?;
    sampled(field.as_ref()).map_err(refused)
}

/// The names of all generators, for messages.
pub(super) fn names() -> String {
    GENERATORS.map(|(name, ..)| name).join(", ")
}

fn lattice(keys: &Keys, default: Lattice) -> Result<Lattice> {
    Ok(Lattice {
        size: keys.number32("size", &ANY)?.unwrap_or(default.size),
        samples: keys.integer32("samples")?.unwrap_or(default.samples),
    })
}

fn constant(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = Constant::default();
    Ok(Box::new(Constant {
        lattice: lattice(keys, default.lattice)?,
        value: keys.number32("value", &ANY)?.unwrap_or(default.value),
    }))
}

fn ball(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = Ball::default();
    let softness = keys.number32("softness", &ANY)?;
    Ok(Box::new(Ball {
        lattice: lattice(keys, default.lattice)?,
        radius: keys.number32("radius", &ANY)?.unwrap_or(default.radius),
        softness: softness.unwrap_or(default.softness),
        value: keys.number32("value", &ANY)?.unwrap_or(default.value),
    }))
}

fn gradient(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = Gradient::default();
    Ok(Box::new(Gradient {
        lattice: lattice(keys, default.lattice)?,
        from: keys.number32("from", &ANY)?.unwrap_or(default.from),
        to: keys.number32("to", &ANY)?.unwrap_or(default.to),
    }))
}

fn shepp_logan(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = SheppLogan::default();
    let softness = keys.number32("softness", &ANY)?;
    Ok(Box::new(SheppLogan {
        lattice: lattice(keys, default.lattice)?,
        softness: softness.unwrap_or(default.softness),
    }))
}

fn potential(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = Potential::default();
    let atoms = keys.fours32("atoms", &ANY)?.map(|atoms| {
        let atom = |[x, y, z, charge]: [f32; 4]| Atom {
            position: [x, y, z],
            charge,
        };
        atoms.into_iter().map(atom).collect()
    });
    let softness = keys.number32("softness", &ANY)?;
    Ok(Box::new(Potential {
        lattice: lattice(keys, default.lattice)?,
        atoms: atoms.unwrap_or(default.atoms),
        softness: softness.unwrap_or(default.softness),
    }))
}

fn ejection(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = Ejection::default();
    Ok(Box::new(Ejection {
        lattice: lattice(keys, default.lattice)?,
        part: keys.word("part")?.unwrap_or(default.part),
        front: keys.number32("front", &ANY)?.unwrap_or(default.front),
        spread: keys.number32("spread", &ANY)?.unwrap_or(default.spread),
    }))
}

fn swirl(keys: &Keys) -> Result<Box<dyn Field>> {
    let default = Swirl::default();
    Ok(Box::new(Swirl {
        lattice: lattice(keys, default.lattice)?,
        core: keys.number32("core", &ANY)?.unwrap_or(default.core),
        winding: keys.number32("winding", &ANY)?.unwrap_or(default.winding),
        turns: keys.number32("turns", &ANY)?.unwrap_or(default.turns),
        jet: keys.number32("jet", &ANY)?.unwrap_or(default.jet),
    }))
}
