//! A method that is watched at some pixels while it draws a frame.

use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;

use super::compare::Bounds;
use super::composite::Composite;
use super::drawn_order::Numbering;
use super::exact::Exact;
use super::fates::Ends;
use super::follower::{Followed, Follower, Preparations};
use super::fragments::fragments;
use super::history::{FragmentHistory, History, ListCosts, Pass, RaySegment};
use super::recording::{Done, Place};
use crate::emulator::{FragmentOutcome, Group, Surface};
use crate::error::Result;
use crate::fragment::{Fragment, Rgba};
use crate::gl::{CapturedFragment, GlMachine};
use crate::methods::{Algorithm, DrawOrder, Drawn, Entry, Frame, Setup, Technique};
use crate::oracle::DepthBuffer;
use crate::oracle::surfaces::Surfaces;
use crate::oracle::volumes::Segment;
use crate::scene::{Mesh, Scene};
use crate::steps::{Call, Machine, Texel};

/// The method.
pub(super) struct Watched<'m> {
    method: &'m dyn Technique,
    /// Columns from the left, rows from the bottom.
    pixels: Vec<[u32; 2]>,
    seen: Rc<RefCell<Vec<Seen>>>,
}

/// What was seen at a pixel, but for the image.
struct Seen {
    scene: String,
    fragments: Vec<FragmentHistory>,
    exact: Composite,
    ray: Vec<RaySegment>,
    composited: Option<Composite>,
    followed: Followed,
}

impl<'m> Watched<'m> {
    pub(super) fn new(method: &'m dyn Technique, pixels: Vec<[u32; 2]>) -> Self {
        Self {
            method,
            pixels,
            seen: Rc::default(),
        }
    }

    /// The histories, once the frame is there.
    pub(super) fn histories(&self, frame: &Frame) -> Vec<History> {
        let seen = self.seen.take();
        let pixels = self.pixels.iter().zip(seen);
        pixels
            .map(|(&pixel, seen)| seen.history(pixel, frame))
            .collect()
    }
}

impl Seen {
    fn history(self, [x, from_below]: [u32; 2], frame: &Frame) -> History {
        let size = [frame.image.width, frame.image.height];
        let y = size[1] - 1 - from_below;
        let image = frame.image.pixel(x, y).to_array();
        let channels = image.iter().zip(self.exact.color);
        let error = channels.map(|(a, b)| (f64::from(*a) - b).abs());
        let parts_at = self.composited.as_ref();
        History {
            scene: self.scene,
            method: frame.stats.method.to_string(),
            chosen: frame.stats.chosen.as_ref().map(|it| it.method.to_string()),
            size,
            pixel: [x, y],
            parts_at: parts_at.and_then(|it| self.exact.parts_from(it)),
            error: error.fold(0.0, f64::max),
            fragments: self.fragments,
            list: list_costs(&self.followed.passes),
            passes: self.followed.passes,
            exact: self.exact,
            ray: self.ray,
            composited: self.composited,
            image,
            stopped: frame.stats.stopped,
            not_followed: self.followed.not_followed,
        }
    }
}

impl fmt::Debug for Watched<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}, watched at {:?}", self.method, self.pixels)
    }
}

impl Technique for Watched<'_> {
    fn entry(&self) -> &'static Entry {
        self.method.entry()
    }

    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm> {
        Box::new(WatchedAlgorithm {
            algorithm: self.method.algorithm(setup),
            setup: *setup,
            pixels: self.pixels.clone(),
            order: DrawOrder::Submission,
            preparations: Preparations::default(),
            seen: Rc::clone(&self.seen),
        })
    }

    fn check(&self) -> Result<()> {
        self.method.check()
    }

    fn needs_window_depth(&self) -> Option<&'static str> {
        self.method.needs_window_depth()
    }
}

struct WatchedAlgorithm {
    algorithm: Box<dyn Algorithm>,
    setup: Setup,
    pixels: Vec<[u32; 2]>,
    order: DrawOrder,
    preparations: Preparations,
    seen: Rc<RefCell<Vec<Seen>>>,
}

impl Algorithm for WatchedAlgorithm {
    fn order(&mut self, scene: &Scene) -> DrawOrder {
        self.order = self.algorithm.order(scene);
        self.order.clone()
    }

    fn prepare(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<()> {
        machine.set_witness(Some(Box::new(self.preparations.clone())));
        let prepared = self.algorithm.prepare(machine, scene);
        machine.set_witness(None);
        prepared
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        let numbering = Numbering::of(scene);
        let captured = fragments(machine, scene, &numbering, &self.order, &self.pixels)?;
        let planes = [scene.camera.near, scene.camera.far];
        let (color, depth) = (self.setup.color, self.setup.depth);
        let mut before = Done::stage(color, depth, scene.background);
        before.extend(self.preparations.done());
        let pixels = self.pixels.iter().zip(&captured);
        let followed = pixels.map(|(&pixel, fragments)| {
            let triangles = fragments
                .iter()
                .map(|it| numbering.triangle(scene, it.order));
            let triangles: Vec<_> = triangles.collect();
            let meshes = triangles
                .iter()
                .map(|it| &scene.meshes[it.place[0] as usize]);
            let surfaces = (0..).zip(fragments.iter().zip(meshes));
            let surfaces = surfaces.map(|(number, (it, mesh))| surface(number, it, mesh));
            let place = Place { pixel, planes };
            let mut followed = Followed::new(place, surfaces.collect(), triangles, before.clone());
            if !scene.volumes.is_empty() {
                followed.not_followed.push(RAYS.into());
            }
            followed
        });
        let quirks = machine.context().driver().quirks();
        let bounds = Bounds::of(self.setup.color, quirks, planes);
        let follower = Follower::new(followed.collect(), bounds);
        machine.set_witness(Some(Box::new(follower.clone())));
        // This says the order of drawing, too.
        machine.begin_frame();
        machine.save_and_restore(|machine| {
            machine.bind_volumes()?;
            machine.perform(&background(scene))
        })?;
        let drawn = self.algorithm.draw(machine, scene);
        machine.set_witness(None);
        let followed = follower.pixels.take();
        self.tell(machine, scene, &numbering, &captured, followed);
        drawn
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        self.algorithm.account(machine, drawn)
    }
}

impl WatchedAlgorithm {
    fn tell(
        &self,
        machine: &GlMachine<'_>,
        scene: &Scene,
        numbering: &Numbering,
        captured: &[Vec<CapturedFragment>],
        followed: Vec<Followed>,
    ) {
        let size = machine.size();
        let surfaces = Surfaces::of(scene, size);
        let buffer = DepthBuffer::float(&scene.camera, size);
        let buffer = match machine.has_inverse_w() {
            true => buffer.of_inverse_w(),
            false => buffer,
        };
        let pixels = self.pixels.iter().zip(captured).zip(followed);
        let seen = pixels.map(|((&pixel, captured), mut followed)| {
            let exact = Exact::of(scene, &surfaces, &buffer, size, pixel, captured);
            let behind = exact.opaque.map(|it| captured[it as usize].color);
            let behind = behind.unwrap_or(Rgba::opaque(scene.background));
            let weights = followed.weights();
            let composited = followed.composited().map(|numbers| {
                let color = |number: u32| (number, captured[number as usize].color);
                Composite::of(numbers.into_iter().map(color), behind)
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
                let [mesh, triangle] = numbering.triangle(scene, it.order).place;
                let mesh = &scene.meshes[mesh as usize];
                FragmentHistory {
                    mesh: mesh.name.clone(),
                    triangle,
                    opaque: mesh.opaque,
                    depth,
                    stored_depth: it.depth,
                    color: it.color,
                    pass: last_pass(&followed.passes, number),
                    exact_weight: exact.composite.weight(number),
                    weight: weights.as_ref().map(|weights| weights[number as usize]),
                    fate,
                }
            });
            Seen {
                scene: scene.name.clone(),
                fragments: fragments.collect(),
                exact: exact.composite,
                ray: exact.ray.iter().map(|it| ray_segment(scene, it)).collect(),
                composited,
                followed,
            }
        });
        *self.seen.borrow_mut() = seen.collect();
    }
}

/// The reason for which a pixel with volumes is not followed.
const RAYS: &str =
    "the method casts rays through volumes; the exact ray is told, and OpenGL's values are";

/// The call that says the background's colour, before a frame begins.
fn background(scene: &Scene) -> Call {
    let [red, green, blue] = scene.background;
    Call::ClearColor {
        red,
        green,
        blue,
        alpha: 1.0,
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

/// The last pass in which a fragment passed every test.
fn last_pass(passes: &[Pass], number: u32) -> Option<usize> {
    let passed = |pass: &Pass| {
        let mut events = pass.events.iter();
        events.any(|it| it.fragment == number && it.outcome == FragmentOutcome::Pass)
    };
    passes.iter().rposition(passed)
}

fn surface(number: u32, captured: &CapturedFragment, mesh: &Mesh) -> Surface {
    Surface {
        fragment: fragment(number, captured),
        group: match (mesh.opaque, mesh.sorted) {
            (true, _) => Group::Opaque,
            (false, true) => Group::Sorted,
            (false, false) => Group::Unsorted,
        },
    }
}

fn fragment(number: u32, captured: &CapturedFragment) -> Fragment {
    Fragment {
        depth: captured.depth,
        color: captured.color,
        order: number,
    }
}
