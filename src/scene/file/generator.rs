//! `generate = "NAME"` and the parameters of each generator.

use super::flow_generator::{ARROWS, STREAMLINES, arrows, streamlines};
use super::isosurface;
use super::keys::Keys;
use super::limits::ANY;
use super::seed::seed;
use super::volume::NamedVolume;
use crate::error::Result;
use crate::scene::generate::{Cone, Generator, Plane, Quads, Slices, Soup, Teapot, TorusKnot};

/// Reads the parameters of one generator. A parameter that is left out has the default that the generator documents.
type Reader = fn(&Keys) -> Result<Box<dyn Generator>>;

/// The generator that takes a volume of the file.
const ISOSURFACE: &str = "isosurface";

/// All other generators: name, parameters, reader.
const GENERATORS: [(&str, &[&[&str]], Reader); 9] = [
    ("teapot", &[&["cells", "color", "opacity"]], teapot),
    ("plane", &[&["size", "cells", "color", "opacity"]], plane),
    (
        "quads",
        &[&[
            "count", "size", "spacing", "depths", "colors", "alpha", "order", "seed",
        ]],
        quads,
    ),
    (
        "slices",
        &[&["count", "size", "cells", "alpha", "order", "seed"]],
        slices,
    ),
    (
        "cone",
        &[&["bottom", "top", "height", "sides", "color", "opacity"]],
        cone,
    ),
    (
        "torus-knot",
        &[&[
            "p", "q", "radius", "winding", "tube", "segments", "sides", "color", "opacity",
        ]],
        torus_knot,
    ),
    (
        "soup",
        &[&["count", "extent", "triangle_size", "alpha", "seed"]],
        soup,
    ),
    ("streamlines", &STREAMLINES, streamlines),
    ("arrows", &ARROWS, arrows),
];

/// The generator of a mesh, with its keys and parameters checked. An isosurface is generated from one of the file's
/// volumes.
pub(super) fn read<'v>(
    keys: &Keys,
    common: &[&'static str],
    volumes: &'v [NamedVolume],
) -> Result<Box<dyn Generator + 'v>> {
    let own = GENERATORS.iter().map(|entry| (entry.0, Some(entry)));
    let choices: Vec<_> = own.chain([(ISOSURFACE, None)]).collect();
    let Some(choice) = keys.choice("generate", &choices)? else {
        unreachable!("called for meshes with this key only")
    };
    let known = |own: &[&[&'static str]]| [&["generate"], &own.concat()[..], common].concat();
    let generator: Box<dyn Generator + 'v> = match choice {
        Some((_, parameters, reader)) => {
            keys.expect_only(&known(parameters))?;
            reader(keys)?
        }
        None => {
            keys.expect_only(&known(&[&isosurface::PARAMETERS]))?;
            Box::new(isosurface::read(keys, volumes)?)
        }
    };
    match generator.check() {
        Ok(()) => Ok(generator),
        Err(refusal) => Err(keys.wrong(refusal.key, refusal.what, refusal.remedy)),
    }
}

/// The names of all generators, for messages.
pub(super) fn names() -> String {
    let own = GENERATORS.map(|(name, ..)| name).join(", ");
    format!("{own}, {ISOSURFACE}")
}

fn teapot(keys: &Keys) -> Result<Box<dyn Generator>> {
    let cells = keys.integer32("cells")?;
    Ok(Box::new(Teapot {
        cells: cells.unwrap_or(Teapot::default().cells),
    }))
}

fn plane(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Plane::default();
    Ok(Box::new(Plane {
        size: keys.pair32("size", &ANY)?.unwrap_or(default.size),
        cells: keys.integer32("cells")?.unwrap_or(default.cells),
    }))
}

fn quads(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Quads::default();
    let depths = keys.numbers32("depths", &ANY)?.unwrap_or(default.depths);
    let count = if depths.is_empty() {
        default.count
    } else {
        depths.len() as u32
    };
    Ok(Box::new(Quads {
        count: keys.integer32("count")?.unwrap_or(count),
        size: keys.pair32("size", &ANY)?.unwrap_or(default.size),
        spacing: keys.number32("spacing", &ANY)?.unwrap_or(default.spacing),
        depths,
        colors: keys.vectors32("colors", &ANY)?.unwrap_or(default.colors),
        alpha: keys.number32("alpha", &ANY)?.unwrap_or(default.alpha),
        order: keys.word("order")?.unwrap_or_default(),
        seed: seed(keys)?,
    }))
}

fn slices(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Slices::default();
    Ok(Box::new(Slices {
        count: keys.integer32("count")?.unwrap_or(default.count),
        size: keys.number32("size", &ANY)?.unwrap_or(default.size),
        cells: keys.integer32("cells")?.unwrap_or(default.cells),
        alpha: keys.number32("alpha", &ANY)?.unwrap_or(default.alpha),
        order: keys.word("order")?.unwrap_or_default(),
        seed: seed(keys)?,
    }))
}

fn cone(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Cone::default();
    Ok(Box::new(Cone {
        bottom: keys.number32("bottom", &ANY)?.unwrap_or(default.bottom),
        top: keys.number32("top", &ANY)?.unwrap_or(default.top),
        height: keys.number32("height", &ANY)?.unwrap_or(default.height),
        sides: keys.integer32("sides")?.unwrap_or(default.sides),
    }))
}

fn torus_knot(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = TorusKnot::default();
    Ok(Box::new(TorusKnot {
        p: keys.integer32("p")?.unwrap_or(default.p),
        q: keys.integer32("q")?.unwrap_or(default.q),
        radius: keys.number32("radius", &ANY)?.unwrap_or(default.radius),
        winding: keys.number32("winding", &ANY)?.unwrap_or(default.winding),
        tube: keys.number32("tube", &ANY)?.unwrap_or(default.tube),
        segments: keys.integer32("segments")?.unwrap_or(default.segments),
        sides: keys.integer32("sides")?.unwrap_or(default.sides),
    }))
}

fn soup(keys: &Keys) -> Result<Box<dyn Generator>> {
    let default = Soup::default();
    let sizes = keys.pair32("triangle_size", &ANY)?;
    Ok(Box::new(Soup {
        count: keys.integer32("count")?.unwrap_or(default.count),
        extent: keys.number32("extent", &ANY)?.unwrap_or(default.extent),
        triangle_size: sizes.unwrap_or(default.triangle_size),
        alpha: keys.pair32("alpha", &ANY)?.unwrap_or(default.alpha),
        seed: seed(keys)?,
    }))
}
