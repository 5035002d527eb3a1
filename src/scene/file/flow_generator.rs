//! `generate = "streamlines"` and `"arrows"`, which show a flow.

use super::keys::Keys;
use super::limits::ANY;
use super::seed::seed;
use crate::error::Result;
use crate::scene::generate::{Arrows, Flow, Generator, Seeds, Streamlines, Swirl};

/// The keys of a flow and its seeds.
const SEEDS: [&str; 10] = [
    "flow", "size", "core", "winding", "turns", "jet", "count", "centre", "extent", "seed",
];

/// The keys of streamlines.
pub(super) const STREAMLINES: [&[&str]; 2] = [
    &SEEDS,
    &["length", "steps", "tube", "sides", "color", "opacity"],
];

/// The keys of arrows.
pub(super) const ARROWS: [&[&str]; 2] = [&SEEDS, &["length", "sides", "color", "opacity"]];

pub(super) fn streamlines(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Streamlines::default();
    Ok(Box::new(Streamlines {
        seeds: seeds(keys, default.seeds)?,
        length: keys.number32("length", &ANY)?.unwrap_or(default.length),
        steps: keys.integer32("steps")?.unwrap_or(default.steps),
        tube: keys.number32("tube", &ANY)?.unwrap_or(default.tube),
        sides: keys.integer32("sides")?.unwrap_or(default.sides),
    }))
}

pub(super) fn arrows(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Arrows::default();
    Ok(Box::new(Arrows {
        seeds: seeds(keys, default.seeds)?,
        length: keys.number32("length", &ANY)?.unwrap_or(default.length),
        sides: keys.integer32("sides")?.unwrap_or(default.sides),
    }))
}

fn flow(keys: &Keys) -> Result<Flow> {
    let mut swirl = Swirl::default();
    let size = keys.number32("size", &ANY)?;
    swirl.lattice.size = size.unwrap_or(swirl.lattice.size);
    swirl.core = keys.number32("core", &ANY)?.unwrap_or(swirl.core);
    swirl.winding = keys.number32("winding", &ANY)?.unwrap_or(swirl.winding);
    swirl.turns = keys.number32("turns", &ANY)?.unwrap_or(swirl.turns);
    swirl.jet = keys.number32("jet", &ANY)?.unwrap_or(swirl.jet);
    let flows = [
        ("swirl", Flow::Swirl(swirl)),
        ("rotation", Flow::Rotation),
        ("bundle", Flow::Bundle),
    ];
    Ok(keys.choice("flow", &flows)?.unwrap_or(Flow::Swirl(swirl)))
}

fn seeds(keys: &Keys, default: Seeds) -> Result<Seeds> {
    Ok(Seeds {
        flow: flow(keys)?,
        count: keys.integer32("count")?.unwrap_or(default.count),
        centre: keys.vector32("centre", &ANY)?.unwrap_or(default.centre),
        extent: keys.vector32("extent", &ANY)?.unwrap_or(default.extent),
        seed: seed(keys)?,
    })
}
