//! What was seen at a pixel, put together: its fragments, the oracle's answer, the method's passes.

use super::composite::Composite;
use super::drawn_order::Numbering;
use super::exact::Exact;
use super::fates::{Ends, Fate};
use super::follower::Followed;
use super::history::{FragmentHistory, History, ListCosts, Loss, Pass, RaySegment};
use crate::emulator::{FragmentOutcome, InList};
use crate::fragment::{Fragment, Rgba};
use crate::gl::{CapturedFragment, GlMachine};
use crate::methods::Frame;
use crate::oracle::DepthBuffer;
use crate::oracle::surfaces::Surfaces;
use crate::oracle::volumes::Segment;
use crate::scene::{Mesh, Scene, Shading};
use crate::steps::{Reason, Texel};

/// What was seen at a pixel, but for the image.
pub(super) struct Seen {
    scene: String,
    by_distance: bool,
    of_slices: bool,
    fragments: Vec<FragmentHistory>,
    exact: Composite,
    ray: Vec<RaySegment>,
    composited: Option<Composite>,
    followed: Followed,
}

impl Seen {
    pub(super) fn history(self, [x, from_below]: [u32; 2], frame: &Frame) -> History {
        let size = [frame.image.width, frame.image.height];
        let y = size[1] - 1 - from_below;
        let image = frame.image.pixel(x, y).to_array();
        let stopped = frame.stats.stopped;
        let mut fragments = self.fragments;
        for (number, fragment) in (0..).zip(&mut fragments) {
            let is_lost = fragment.fate == Fate::Lost;
            fragment.loss = is_lost.then(|| loss(&self.followed.passes, number, stopped));
        }
        let channels = image.iter().zip(self.exact.color);
        let error = channels.map(|(a, b)| (f64::from(*a) - b).abs());
        let parts_at = self.composited.as_ref();
        History {
            scene: self.scene,
            method: frame.stats.method.to_string(),
            chosen: frame.stats.chosen.as_ref().map(|it| it.method.to_string()),
            size,
            pixel: [x, y],
            by_distance: self.by_distance,
            of_slices: self.of_slices,
            parts_at: parts_at.and_then(|it| self.exact.parts_from(it)),
            error: error.fold(0.0, f64::max),
            fragments,
            list: list_costs(&self.followed.passes),
            marked: is_marked(&self.followed.passes),
            passes: self.followed.passes,
            exact: self.exact,
            ray: self.ray,
            composited: self.composited,
            image,
            stopped,
            not_followed: self.followed.not_followed,
        }
    }
}

/// A scene as a frame sees it.
pub(super) struct View<'s> {
    scene: &'s Scene,
    numbering: &'s Numbering,
    size: [u32; 2],
    surfaces: Surfaces<'s>,
    buffer: DepthBuffer,
    /// Whether 1/w is stored, and the distance is told.
    by_distance: bool,
}

impl<'s> View<'s> {
    pub(super) fn of(machine: &GlMachine<'_>, scene: &'s Scene, numbering: &'s Numbering) -> Self {
        let size = machine.size();
        let buffer = DepthBuffer::float(&scene.camera, size);
        Self {
            scene,
            numbering,
            size,
            surfaces: Surfaces::of(scene, size),
            buffer: match machine.has_inverse_w() {
                true => buffer.of_inverse_w(),
                false => buffer,
            },
            by_distance: machine.has_inverse_w(),
        }
    }

    /// A stored depth as it is told: as it is, or the distance of which it is the 1/w (`common/fragment_depth.glsl`). A depth
    /// of 1 is infinitely far away.
    fn told(&self, stored: f32) -> f32 {
        if !self.by_distance {
            return stored;
        }
        if stored >= 1.0 {
            return f32::INFINITY;
        }
        let bits = 1.0_f32.to_bits() + f32::MIN_POSITIVE.to_bits() - stored.to_bits();
        (self.scene.camera.near / f64::from(f32::from_bits(bits))) as f32
    }

    fn tell_by_distance(&self, pass: &mut Pass) {
        for event in &mut pass.events {
            event.depth = event.depth.map(|depth| self.told(depth));
        }
        for held in [Some(&mut pass.held), pass.emulated.as_mut()] {
            let depth = held.and_then(|held| held.depth.as_mut());
            depth
                .into_iter()
                .for_each(|depth| *depth = self.told(*depth));
        }
    }

    /// What was seen at a pixel: in column x from the left and row y from the bottom, with these fragments.
    pub(super) fn seen(
        &self,
        pixel: [u32; 2],
        captured: &[CapturedFragment],
        mut followed: Followed,
    ) -> Seen {
        let scene = self.scene;
        let exact = Exact::of(
            scene,
            &self.surfaces,
            &self.buffer,
            self.size,
            pixel,
            captured,
        );
        let behind = exact.opaque.map(|it| captured[it as usize].color);
        let behind = behind.unwrap_or(Rgba::opaque(scene.background));
        let weights = followed.weights();
        let composited = followed.composited().map(|numbers| {
            let color = |number: u32| (number, captured[number as usize].color);
            Composite::of(numbers.into_iter().map(color), behind)
        });
        // Between the fragments there is light of volumes.
        let composited = composited.map(|composite| Composite {
            color: match scene.volumes.is_empty() {
                true => composite.color,
                false => followed.image().unwrap_or(composite.color),
            },
            ..composite
        });
        let list: Vec<_> = (0..).zip(captured).map(|(n, it)| fragment(n, it)).collect();
        let ends = Ends {
            exact: &exact.composite,
            opaque: exact.opaque,
            composited: composited.as_ref(),
            weights: weights.as_deref(),
        };
        let fates = ends.fates(&list);
        let rows = captured.iter().zip(&exact.depths).zip(fates);
        let fragments = (0..).zip(rows).map(|(number, ((it, &depth), fate))| {
            let [mesh, triangle] = self.numbering.triangle(scene, it.order).place;
            let mesh = &scene.meshes[mesh as usize];
            FragmentHistory {
                mesh: mesh.name.clone(),
                triangle,
                opaque: mesh.opaque,
                depth: match self.by_distance {
                    true => scene.camera.near * depth.exp(),
                    false => depth,
                },
                stored_depth: self.told(it.depth),
                color: it.color,
                pass: last_pass(&followed.passes, number),
                exact_weight: exact.composite.weight(number),
                weight: weights.as_ref().map(|weights| weights[number as usize]),
                fate,
                loss: None,
            }
        });
        let fragments = fragments.collect();
        if self.by_distance {
            let passes = followed.passes.iter_mut();
            passes.for_each(|pass| self.tell_by_distance(pass));
        }
        let is_slice = |mesh: &Mesh| mesh.shading == Shading::Slice;
        Seen {
            scene: scene.name.clone(),
            by_distance: self.by_distance,
            of_slices: scene.meshes.iter().any(is_slice),
            fragments,
            exact: exact.composite,
            ray: exact.ray.iter().map(|it| ray_segment(scene, it)).collect(),
            composited,
            followed,
        }
    }
}

fn ray_segment(scene: &Scene, segment: &Segment) -> RaySegment {
    let names = segment.volumes.iter();
    let names = names.map(|&number| scene.volumes[number].name.clone());
    RaySegment {
        distances: segment.distances,
        volumes: names.collect(),
        light: segment.light,
        stopped: segment.stopped,
    }
}

/// The costs that the resolve pass has stored beside the image ([`COST`](crate::papers::lindholm_2015::COST)).
fn list_costs(passes: &[Pass]) -> Option<ListCosts> {
    let resolving = passes.iter().rev();
    let mut resolving = resolving.filter(|pass| pass.program.starts_with("a_buffer/resolve"));
    match *resolving.next()?.held.colors {
        [
            _,
            Texel::Integers([records_read, composited, subpasses, slots]),
        ] => Some(ListCosts {
            records_read,
            composited,
            subpasses,
            slots: [slots >> 16, slots & 0xFFFF],
        }),
        _ => None,
    }
}

/// Whether the verified painter marked the pixel: whether its stencil value is not 0 after the pass that proves.
fn is_marked(passes: &[Pass]) -> Option<bool> {
    let proves = |pass: &&Pass| ["verified/surface", "verified/pieces"].contains(&&*pass.program);
    let held = &passes.iter().find(proves)?.held;
    held.stencil.map(|stencil| stencil > 0)
}

/// Why a fragment is lost, if the method's loop ended for this reason.
fn loss(passes: &[Pass], number: u32, stopped: Option<Reason>) -> Loss {
    let events = || passes.iter().flat_map(|pass| &pass.events);
    let resolves = passes.iter().filter_map(|pass| pass.resolve.as_ref());
    let mut subpasses = resolves.flat_map(|resolve| &resolve.resolved.passes);
    let mut of_it = events().filter(|event| event.fragment == number);
    if of_it.any(|event| event.list == Some(InList::NoRoom)) {
        return Loss::NoRoom;
    }
    if subpasses.any(|subpass| subpass.dropped.contains(&number)) {
        return Loss::Dropped;
    }
    match stopped {
        Some(reason @ (Reason::OcclusionRatio | Reason::PeelLimit | Reason::NoEnd)) => {
            Loss::Ended(reason)
        }
        _ if last_pass(passes, number).is_none() => Loss::NeverDrawn,
        _ => Loss::Replaced,
    }
}

/// The last pass in which a fragment passed every test.
fn last_pass(passes: &[Pass], number: u32) -> Option<usize> {
    let passed = |pass: &Pass| {
        let mut events = pass.events.iter();
        events.any(|it| it.fragment == number && it.outcome == FragmentOutcome::Pass)
    };
    passes.iter().rposition(passed)
}

/// A fragment by its number at the pixel.
pub(super) fn fragment(number: u32, captured: &CapturedFragment) -> Fragment {
    Fragment {
        depth: captured.depth,
        color: captured.color,
        order: number,
    }
}
