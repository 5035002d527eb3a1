//! A method that is watched at some pixels while it draws a frame.

use std::cell::RefCell;
use std::fmt;
use std::rc::Rc;
use std::sync::Arc;

use super::compare::Bounds;
use super::drawn_order::Numbering;
use super::follower::{Followed, Follower, Preparations};
use super::fragments::{faces, fragments};
use super::history::History;
use super::recording::{Done, Place};
use super::seen::{Seen, View, fragment};
use crate::emulator::{Group, PixelRay, Surface};
use crate::error::Result;
use crate::gl::{CapturedFragment, GlMachine};
use crate::methods::{Algorithm, DrawOrder, Drawn, Entry, Frame, Setup, Technique};
use crate::oracle::volumes::Ray;
use crate::scene::{Mesh, Scene};
use crate::steps::Machine;
use crate::steps::gl::glClearColor;

/// The method.
pub(super) struct Watched<'m> {
    method: &'m dyn Technique,
    /// Columns from the left, rows from the bottom.
    pixels: Vec<[u32; 2]>,
    seen: Rc<RefCell<Vec<Seen>>>,
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
        let faces = faces(machine, scene, &self.pixels)?;
        let planes = [scene.camera.near, scene.camera.far];
        let volumes: Arc<[_]> = scene.volumes.clone().into();
        let (color, depth) = (self.setup.color, self.setup.depth);
        let mut before = Done::stage(color, depth, scene.background);
        before.extend(self.preparations.done());
        let pixels = self.pixels.iter().zip(captured.iter().zip(faces));
        let followed = pixels.map(|(&pixel, (fragments, faces))| {
            let triangles = fragments
                .iter()
                .map(|it| numbering.triangle(scene, it.order));
            let triangles: Vec<_> = triangles.collect();
            let meshes = triangles
                .iter()
                .map(|it| &scene.meshes[it.place[0] as usize]);
            let surfaces = (0..).zip(fragments.iter().zip(meshes));
            let surfaces = surfaces.map(|(number, (it, mesh))| surface(number, it, mesh));
            let ray = Ray::through(&scene.camera, machine.size(), pixel);
            let place = Place {
                pixel,
                planes,
                inverse_w: machine.has_inverse_w(),
                volumes: Arc::clone(&volumes),
                ray: PixelRay {
                    origin: ray.origin,
                    direction: ray.direction,
                },
            };
            let surfaces = surfaces.chain(faces.iter().map(face));
            Followed::new(place, surfaces.collect(), triangles, before.clone())
        });
        let quirks = machine.context().driver().quirks();
        let bounds = Bounds::of(self.setup.color, quirks, planes);
        let follower = Follower::new(followed.collect(), bounds);
        machine.set_witness(Some(Box::new(follower.clone())));
        let drawn = self.draw_watched(machine, scene);
        machine.set_witness(None);
        let drawn = drawn?;
        let view = View::of(machine, scene, &numbering);
        let pixels = self.pixels.iter().zip(&captured);
        let seen = pixels.zip(follower.pixels.take());
        let seen = seen.map(|((&pixel, captured), followed)| view.seen(pixel, captured, followed));
        *self.seen.borrow_mut() = seen.collect();
        Ok(drawn)
    }

    fn account(&mut self, machine: &mut GlMachine<'_>, drawn: &mut Drawn) -> Result<()> {
        self.algorithm.account(machine, drawn)
    }
}

impl WatchedAlgorithm {
    /// Draws a frame from its beginning, which says the order of drawing, too.
    fn draw_watched(&mut self, machine: &mut GlMachine<'_>, scene: &Scene) -> Result<Drawn> {
        machine.begin_frame();
        machine.save_and_restore(|machine| {
            machine.bind_volumes()?;
            let [red, green, blue] = scene.background;
            machine.perform(&glClearColor(red, green, blue, 1.0))
        })?;
        self.algorithm.draw(machine, scene)
    }
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

/// A face of the box around a volume, whose `order` is its id.
fn face(captured: &CapturedFragment) -> Surface {
    Surface {
        fragment: fragment(captured.order, captured),
        group: Group::Proxy,
    }
}
