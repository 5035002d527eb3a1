//! Finding a pixel that is worth looking at.

use std::cell::RefCell;
use std::cmp::Reverse;
use std::collections::HashSet;
use std::fmt;
use std::rc::Rc;

use super::fates::Fate;
use super::{History, histories};
use crate::error::{Error, Result};
use crate::gl::{Captured, GlMachine, capture_in_pieces};
use crate::image::difference;
use crate::methods::{
    Algorithm, Blend, CountBy, DrawOrder, Drawn, Entry, Exact, Renderer, Setup, Technique,
    VerifiedPainter,
};
use crate::papers::edition::PROOF_DEPTH;
use crate::papers::stage::OPAQUE_DEPTH;
use crate::scene::Scene;
use crate::steps::{Compare, Objects};
use crate::words::words;

/// Where something happens that is worth looking at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Where {
    /// A fragment that belongs in the image is not in it.
    Lost,
    /// The verified painter could not prove the order.
    Marked,
    /// Two fragments that are not hidden have the same depth.
    Tied,
}

words! { Where, "place",
    Lost "lost" "a pixel with a fragment that belongs in the image and is not in it",
    Marked "marked" "a pixel whose order the verified painter could not prove",
    Tied "tied" "a pixel with two visible fragments of the same depth",
}

/// The number of fragments in memory at a time, which take 64 MiB.
const AT_A_TIME: u32 = 2 << 20;

/// How many pixels are watched in a frame, to find one at which something is lost.
const WATCHED: usize = 64;
/// How many pixels of a kind are watched if nothing says that there is one to be found.
const CANDIDATES: usize = 64;

/// The pixel at which the method's image is farthest from the exact one, if any is. The pixel is column from the left and row
/// from the top.
///
/// Pixels whose colour hangs on a difference of depth that the depth buffer cannot hold count only if no other differs.
///
/// # Errors
/// If the method or the driver fails.
pub fn worst(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
) -> Result<Option<[u32; 2]>> {
    Ok(farthest(renderer, scene, method)?.into_iter().next())
}

/// The pixel with the most transparent fragments before the opaque surfaces, if any has one: column from the left and row
/// from the top.
///
/// # Errors
/// If the driver fails.
pub fn deepest(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Option<[u32; 2]>> {
    Ok(deepest_first(renderer, scene)?.into_iter().next())
}

/// The pixels that have transparent fragments before the opaque surfaces, those with the most first.
fn deepest_first(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Vec<[u32; 2]>> {
    let complexity = renderer.complexity(scene, CountBy::Blending)?;
    let counts = (0..).zip(&complexity.counts);
    let mut pixels: Vec<(u32, u32)> = counts
        .filter(|(_, count)| **count > 0)
        .map(|(pixel, count)| (pixel, *count))
        .collect();
    pixels.sort_by_key(|(_, count)| Reverse(*count));
    let width = complexity.width;
    let places = pixels
        .iter()
        .map(|(pixel, _)| [pixel % width, pixel / width]);
    Ok(places.collect())
}

/// A pixel at which this happens, if one is found: column from the left and row from the top. For [`Where::Lost`], by a method
/// that does not count what it loses, the pixels that are farthest from the exact image are looked at, those with ties, and the
/// deepest ones, 64 of each.
///
/// # Errors
/// If the method or the driver fails, or the method marks no pixels.
pub fn find(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
    place: Where,
) -> Result<Option<[u32; 2]>> {
    match place {
        Where::Marked => Ok(marked(renderer, scene, method)?.into_iter().next()),
        Where::Tied => Ok(tied(renderer, scene)?.into_iter().next()),
        Where::Lost => lost(renderer, scene, method),
    }
}

/// A pixel with a fragment that belongs in the image and is not in it. What the method counts as lost says whether to look. The
/// pixels that are farthest from the exact image, those with ties, and the deepest ones are looked at in turn, until one of
/// them has lost something.
fn lost(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
) -> Result<Option<[u32; 2]>> {
    let candidates = match renderer.render(scene, method)?.stats.lost {
        Some(0) => return Ok(None),
        Some(_) => usize::MAX,
        None => CANDIDATES,
    };
    let kinds = [
        farthest(renderer, scene, method)?,
        tied(renderer, scene)?,
        deepest_first(renderer, scene)?,
    ];
    let most = kinds.iter().map(Vec::len).max().unwrap_or(0);
    let most = most.min(candidates);
    let in_turn = (0..most).flat_map(|place| kinds.iter().filter_map(move |kind| kind.get(place)));
    let mut seen = HashSet::new();
    let in_turn: Vec<_> = in_turn.copied().filter(|it| seen.insert(*it)).collect();
    for pixels in in_turn.chunks(WATCHED) {
        let histories = histories(renderer, scene, method, pixels)?;
        if let Some(found) = histories.iter().find(|it| has_lost(it)) {
            return Ok(Some(found.pixel));
        }
    }
    Ok(None)
}

fn has_lost(history: &History) -> bool {
    let mut fragments = history.fragments.iter();
    fragments.any(|it| matches!(it.fate, Fate::Lost | Fate::Tied(_)))
}

/// The pixels that differ from the exact image by more than 32-bit floats explain, the farthest first. Those that hang on
/// depth come last.
fn farthest(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
) -> Result<Vec<[u32; 2]>> {
    /// The bound that exact methods keep in 32-bit float.
    const BOUND: f64 = 1e-5;
    let frame = renderer.render(scene, method)?;
    let exact = renderer.render(scene, &Exact)?;
    let hanging = exact.hanging.unwrap_or_default().drawn;
    let hangs = |pixel: usize| hanging.get(pixel).copied().unwrap_or(false);
    let mut pixels: Vec<(bool, f64, u32)> = Vec::new();
    let pairs = frame.image.pixels.iter().zip(&exact.image.pixels);
    for (pixel, (a, b)) in pairs.enumerate() {
        let off = difference(*a, *b);
        if off > BOUND {
            pixels.push((hangs(pixel), off, pixel as u32));
        }
    }
    pixels.sort_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)));
    let width = frame.image.width;
    let places = pixels
        .iter()
        .map(|&(_, _, pixel)| [pixel % width, pixel / width]);
    Ok(places.collect())
}

/// The pixels with two visible transparent fragments of the same depth.
fn tied(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Vec<[u32; 2]>> {
    pixels_after(renderer, scene, &Blend, |machine| {
        let visible = Captured {
            objects: Objects::Transparent,
            depth: OPAQUE_DEPTH,
            passes: Compare::Less,
        };
        let mut tied = Vec::new();
        capture_in_pieces(machine, &visible, AT_A_TIME, |_, fragments| {
            let keys = fragments.iter().map(|it| (it.y, it.x, it.depth.to_bits()));
            let mut keys: Vec<_> = keys.collect();
            keys.sort_unstable();
            let pairs = keys.windows(2).filter(|pair| pair[0] == pair[1]);
            tied.extend(pairs.map(|pair| [pair[0].1, pair[0].0]));
            Ok(())
        })?;
        Ok(tied)
    })
}

/// The pixels that the verified painter marks.
fn marked(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
) -> Result<Vec<[u32; 2]>> {
    let frame = renderer.render(scene, method)?;
    if frame.stats.verified.is_none() {
        return Err(Error::usage(
            format!("{} marks no pixels", frame.stats.method),
            "ask verified-painter, or auto where it chooses that",
        ));
    }
    pixels_after(renderer, scene, &VerifiedPainter, |machine| {
        let width = machine.size()[0];
        let stencils = machine.read_stencils(PROOF_DEPTH)?;
        let marked = (0..).zip(stencils).filter(|(_, stencil)| *stencil > 0);
        Ok(marked
            .map(|(pixel, _)| [pixel % width, pixel / width])
            .collect())
    })
}

/// Looks for pixels on a machine, in columns from the left and rows from the bottom.
type Look = fn(&mut GlMachine<'_>) -> Result<Vec<[u32; 2]>>;

/// The pixels that `look` finds after the method has drawn a frame, each once, the topmost row first.
fn pixels_after(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
    look: Look,
) -> Result<Vec<[u32; 2]>> {
    let looked_at = LookedAt {
        method,
        look,
        found: Rc::default(),
    };
    renderer.render(scene, &looked_at)?;
    let height = renderer.size()[1];
    let found = looked_at.found.take();
    let mut found: Vec<_> = found.iter().map(|&[x, y]| [x, height - 1 - y]).collect();
    found.sort_unstable_by_key(|&[x, y]| [y, x]);
    found.dedup();
    Ok(found)
}

/// A method whose maps are looked at after its frame.
struct LookedAt<'m> {
    method: &'m dyn Technique,
    look: Look,
    found: Rc<RefCell<Vec<[u32; 2]>>>,
}

impl fmt::Debug for LookedAt<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}, looked at", self.method)
    }
}

impl Technique for LookedAt<'_> {
    fn entry(&self) -> &'static Entry {
        self.method.entry()
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(Looking {
            algorithm: self.method.algorithm(setup),
            look: self.look,
            found: Rc::clone(&self.found),
        })
    }
}

struct Looking {
    algorithm: Box<dyn Algorithm>,
    look: Look,
    found: Rc<RefCell<Vec<[u32; 2]>>>,
}

impl Algorithm for Looking {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        self.algorithm.order(scene)
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        self.algorithm.prepare(machine, scene)
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let drawn = self.algorithm.draw(machine, scene)?;
        *self.found.borrow_mut() = machine.save_and_restore(self.look)?;
        Ok(drawn)
    }
}
