//! The machine: pixels, maps and framebuffers, and the effect of each call on them.

use std::collections::HashMap;

use super::invocation::Inputs;
use super::place::{Attached, Place, Plane, texel, write_masked};
use super::record::{Draw, Fate, FragmentOutcome, Record};
use super::shaders::twin;
use super::state::State;
use super::{color, depth};
use crate::error::{Error, Result};
use crate::fragment::{Fragment, Rgba};
use crate::steps::{Call, Format, Machine, Map, Objects, Query, Shader, Target, Workspace};

/// The group of objects to which a surface belongs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Group {
    /// Opaque geometry.
    Opaque,
    /// Transparent geometry whose triangles are exactly sorted.
    Sorted,
    /// All other transparent geometry.
    Unsorted,
}

impl Group {
    /// Whether a draw of these objects draws this group. The quad that covers the screen belongs to no group.
    pub(super) fn is_among(self, objects: Objects) -> bool {
        match objects {
            Objects::Scene => true,
            Objects::Opaque => self == Self::Opaque,
            Objects::Transparent => self != Self::Opaque,
            Objects::Sorted => self == Self::Sorted,
            Objects::Unsorted => self == Self::Unsorted,
            Objects::Proxies | Objects::Screen => false,
        }
    }
}

/// A surface at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Colour (straight alpha), depth, and place in the order of submission.
    pub fragment: Fragment,
    /// The group of objects to which it belongs.
    pub group: Group,
}

/// Runs listings on pixels whose surfaces are given. Maps and framebuffers are made as on the GL machine.
#[derive(Debug)]
pub struct Emulator {
    /// Each pixel's surfaces in the order of submission.
    pixels: Vec<Vec<Surface>>,
    state: State,
    planes: Vec<Plane>,
    names: HashMap<Map, usize>,
    targets: HashMap<Target, Attached>,
    bound: [Option<usize>; 16],
    active_texture: usize,
    target: Option<Target>,
    program: Option<Shader>,
    queries: HashMap<Query, u64>,
    counting: Option<Query>,
    composited: Vec<Vec<u32>>,
    watched: Option<usize>,
    record: Record,
}

/// The window depth of the quad over the screen, whose vertices are at z = 0 in clip space.
const SCREEN_DEPTH: f32 = 0.5;

impl Emulator {
    /// A machine in GL's initial state for pixels with these surfaces. Each pixel's surfaces are in the order of
    /// submission.
    pub fn new(pixels: Vec<Vec<Surface>>) -> Self {
        Self {
            composited: vec![Vec::new(); pixels.len()],
            pixels,
            state: State::INITIAL,
            planes: Vec::new(),
            names: HashMap::new(),
            targets: HashMap::new(),
            bound: [None; 16],
            active_texture: 0,
            target: None,
            program: None,
            queries: HashMap::new(),
            counting: None,
            watched: None,
            record: Record::default(),
        }
    }

    /// The same, but it also records what happens to every surface of one pixel.
    ///
    /// # Panics
    /// If there is no such pixel.
    #[must_use]
    pub fn watching(mut self, pixel: usize) -> Self {
        assert!(pixel < self.pixels.len(), "there is no pixel {pixel}");
        self.watched = Some(pixel);
        self
    }

    /// The record of the watched pixel's surfaces so far.
    pub fn record(&self) -> &Record {
        &self.record
    }

    /// For each pixel, the surfaces that were composited front to back (blended under earlier ones), in their order of
    /// compositing. A surface is given by its place in the order of submission.
    pub fn composited(&self) -> &[Vec<u32>] {
        &self.composited
    }

    /// A color map's texels.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn colors(&self, map: Map) -> Result<&[[f32; 4]]> {
        Ok(&self.planes[self.plane(map)?].colors)
    }

    /// A depth map's depths as its format stores them, which for fixed point are raw integers.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn depths(&self, map: Map) -> Result<&[f32]> {
        Ok(&self.planes[self.plane(map)?].depths)
    }

    /// A depth map's stencil values.
    ///
    /// # Errors
    /// If there is no such map.
    pub fn stencils(&self, map: Map) -> Result<&[u8]> {
        Ok(&self.planes[self.plane(map)?].stencils)
    }

    fn plane(&self, map: Map) -> Result<usize> {
        self.names.get(&map).copied().ok_or_else(|| {
            let allocated = self.names.keys().map(Map::to_string);
            Error::unknown_map(map.to_string(), allocated)
        })
    }

    fn attached(&self) -> Result<Attached> {
        let target = self.target.ok_or_else(|| {
            Error::out_of_order(
                "the listing draws or clears before it chooses a framebuffer",
                "glBindFramebuffer comes first",
            )
        })?;
        Ok(self.targets.get(&target).copied().unwrap_or_default())
    }

    fn clear(&mut self, mask: crate::steps::Buffers) -> Result<()> {
        let Attached {
            color: color_plane,
            depth: depth_plane,
        } = self.attached()?;
        let state = self.state;
        if let (true, Some(plane)) = (mask.color, color_plane) {
            let plane = &mut self.planes[plane];
            let cleared = state.clear_color.map(|c| color::stored(plane.format, c));
            for texel in &mut plane.colors {
                write_masked(texel, cleared, state.color_mask);
            }
        }
        let Some(plane) = depth_plane else {
            return Ok(());
        };
        let plane = &mut self.planes[plane];
        if mask.depth && state.depth_mask {
            let cleared = depth::stored(plane.format, state.clear_depth as f32);
            plane.depths.fill(cleared);
        }
        if mask.stencil && plane.format.has_stencil() {
            let mask = state.stencil_mask as u8;
            for stencil in &mut plane.stencils {
                *stencil = (*stencil & !mask) | (state.clear_stencil as u8 & mask);
            }
        }
        Ok(())
    }

    fn draw(&mut self, objects: Objects) -> Result<()> {
        let program = self.program.ok_or_else(|| {
            Error::out_of_order(
                "the listing draws before it chooses a program",
                "glUseProgram comes first",
            )
        })?;
        let shader = twin(program)?;
        let attached = self.attached()?;
        for pixel in 0..self.pixels.len() {
            let watched = self.watched == Some(pixel) && objects != Objects::Screen;
            let mut fates = Vec::new();
            let surfaces = match objects {
                Objects::Screen => &[SCREEN],
                _ => &self.pixels[pixel][..],
            };
            for surface in surfaces {
                if objects != Objects::Screen && !surface.group.is_among(objects) {
                    continue;
                }
                let texel = |unit: u32| texel(&self.planes, self.bound[unit as usize], pixel);
                let shadow = |reference| self.state.compare_func.holds(reference, texel(0)[0]);
                let inputs = Inputs {
                    fragment: surface.fragment,
                    lookup: &texel,
                    comparison: &shadow,
                };
                let mut place = Place::at(&self.planes, attached, pixel);
                let before = place;
                let outcome = match shader(&inputs) {
                    None => FragmentOutcome::Discarded,
                    Some(kept) => {
                        let z = kept.depth.unwrap_or(surface.fragment.depth);
                        place.send(&self.state, z, kept.color)
                    }
                };
                place.write(&mut self.planes, attached, pixel);
                if outcome == FragmentOutcome::Pass {
                    if let Some(query) = self.counting {
                        *self.queries.entry(query).or_default() += 1;
                    }
                    let goes_under = self.state.blend.is_some_and(|blend| blend.is_under())
                        && self.state.color_mask != [false; 4]
                        && attached.color.is_some();
                    if goes_under && objects != Objects::Screen {
                        self.composited[pixel].push(surface.fragment.order);
                    }
                }
                if watched {
                    fates.push(Fate {
                        order: surface.fragment.order,
                        depth: surface.fragment.depth,
                        outcome,
                        stencil: [before.stencil, place.stencil],
                        stored_depth: [before.depth, place.depth],
                        color: [before.color, place.color],
                    });
                }
            }
            if watched {
                let place = Place::at(&self.planes, attached, pixel);
                self.record.draws.push(Draw {
                    program: program.0,
                    fates,
                    left: (place.stencil, place.depth),
                });
            }
        }
        Ok(())
    }

    fn allocate_plane(&mut self, format: Format) -> usize {
        let count = self.pixels.len();
        let (colors, depths) = match format.has_depth() {
            true => (0, count),
            false => (count, 0),
        };
        self.planes.push(Plane {
            format,
            colors: vec![[0.0; 4]; colors],
            depths: vec![0.0; depths],
            stencils: vec![0; depths],
        });
        self.planes.len() - 1
    }

    fn copy(&mut self, from: Map, to: Map) -> Result<()> {
        let source = self.planes[self.plane(from)?].clone();
        self.allocate(to, source.format)?;
        let destination = self.plane(to)?;
        self.planes[destination] = source;
        Ok(())
    }

    fn target_mut(&mut self) -> Result<&mut Attached> {
        self.attached()?;
        let target = self.target.expect("attached() has seen it");
        Ok(self.targets.entry(target).or_default())
    }
}

/// The fragment of the quad over the screen, at one pixel.
const SCREEN: Surface = Surface {
    fragment: Fragment {
        depth: SCREEN_DEPTH,
        color: Rgba::new(0.0, 0.0, 0.0, 0.0),
        order: 0,
    },
    group: Group::Unsorted,
};

impl Machine for Emulator {
    fn perform(&mut self, call: &Call) -> Result<()> {
        if self.state.set(call) {
            return Ok(());
        }
        match *call {
            Call::Clear { mask } => self.clear(mask)?,
            Call::ActiveTexture { unit } if (unit as usize) < self.bound.len() => {
                self.active_texture = unit as usize;
            }
            Call::BindTexture { texture } => {
                self.bound[self.active_texture] = Some(self.plane(texture)?);
            }
            Call::UseProgram { program } => {
                twin(program)?;
                self.program = Some(program);
            }
            Call::BindFramebuffer { framebuffer } => self.target = Some(framebuffer),
            Call::AttachColor { texture } => {
                let plane = self.plane(texture)?;
                self.target_mut()?.color = Some(plane);
            }
            Call::AttachDepth { texture } => {
                let plane = self.plane(texture)?;
                self.target_mut()?.depth = Some(plane);
            }
            Call::BeginQuery { query } => {
                self.queries.insert(query, 0);
                self.counting = Some(query);
            }
            Call::EndQuery { .. } => self.counting = None,
            Call::CopyImage { from, to } => self.copy(from, to)?,
            Call::Swap { a, b } => {
                let (of_a, of_b) = (self.plane(a)?, self.plane(b)?);
                self.names.insert(a, of_b);
                self.names.insert(b, of_a);
            }
            Call::Draw { objects } => self.draw(objects)?,
            _ => {
                return Err(Error::CannotPerform {
                    machine: "the emulated pixel",
                    call: call.to_string(),
                    why: "it leaves that out",
                    remedy: "its module says what else it leaves out; a GlMachine performs every call",
                });
            }
        }
        Ok(())
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.queries.get(&query).copied().ok_or_else(|| {
            let what = format!("the listing asks the query '{}' before it is made", query.0);
            Error::out_of_order(what, "glBeginQuery and glEndQuery come first")
        })
    }
}

impl Workspace for Emulator {
    fn allocate(&mut self, map: Map, format: Format) -> Result<()> {
        let same = |&plane: &usize| self.planes[plane].format == format;
        if self.names.get(&map).is_none_or(|plane| !same(plane)) {
            let plane = self.allocate_plane(format);
            self.names.insert(map, plane);
        }
        Ok(())
    }

    fn framebuffer_with(
        &mut self,
        target: Target,
        colors: &[Map],
        depth: Option<Map>,
    ) -> Result<()> {
        let color = match colors {
            [] => None,
            [color] => Some(self.plane(*color)?),
            _ => {
                return Err(Error::usage(
                    "the emulated pixel draws into one color map at a time",
                    "algorithms that need several run as pseudocode",
                ));
            }
        };
        let depth = depth.map(|map| self.plane(map)).transpose()?;
        self.targets.insert(target, Attached { color, depth });
        Ok(())
    }
}
