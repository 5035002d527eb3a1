//! Rendering: setting a method up for a scene, running it, and finishing the frame.

mod finish;

use std::borrow::Cow;
use std::time::{Duration, Instant};

use super::algorithm::{Algorithm, DrawOrder, Drawn, Setup};
use super::allocate_maps::allocate_maps;
use super::frame::Frame;
use super::technique::Technique;
use super::{inverse_w, slicing};
use crate::error::Result;
use crate::gl::{Context, Format, Geometry, GlMachine};
use crate::papers::stage;
use crate::scene::{Camera, Scene};
use crate::steps::{Call, Machine};

/// Renders scenes at one size.
///
/// ```no_run
/// use onionskin::{Context, Method, Renderer, Scene};
/// let context = Context::headless()?;
/// let scene = Scene::load("engine.toml")?;
/// let frame = Renderer::new(&context, 1024, 768)?.render(&scene, &Method::Automatic)?;
/// frame.image.save("engine.png")?;
/// println!("{}", frame.stats);
/// # Ok::<(), onionskin::Error>(())
/// ```
#[derive(Debug)]
pub struct Renderer<'c> {
    pub(super) machine: GlMachine<'c>,
    color: Format,
    depth: Format,
    slices: Option<u32>,
    counts_costs: bool,
    fits_planes: bool,
    inverse_w: bool,
}

/// A scene in the form in which a method draws it.
pub(super) struct Shown<'s> {
    pub(super) scene: Cow<'s, Scene>,
    /// How many slices to draw the volumes as, or `None` if the method casts rays or there are no volumes.
    pub(super) slices: Option<u32>,
    /// The scene with the volumes that the slices stand for, and the distance from slice to slice.
    sliced: Option<(Cow<'s, Scene>, f64)>,
    /// The scene's camera as it was given, whatever planes it is drawn with.
    given: Camera,
}

/// The time since then.
fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

/// After this time no further frame is measured.
const PATIENCE: Duration = Duration::from_secs(2);

impl<'c> Renderer<'c> {
    /// A renderer for images of `width` x `height` pixels, with 32-bit float colours and depths.
    ///
    /// # Errors
    /// If the size is 0 or over the driver's limit.
    pub fn new(context: &'c Context, width: u32, height: u32) -> Result<Self> {
        let machine = GlMachine::new(context, [width, height])?;
        Ok(Self {
            machine,
            color: Format::Rgba32F,
            depth: Format::Depth32FStencil8,
            slices: None,
            counts_costs: true,
            fits_planes: true,
            inverse_w: false,
        })
    }

    /// The width and height of its images.
    pub fn size(&self) -> [u32; 2] {
        self.machine.size()
    }

    /// The renderer with other formats for the image and the layers, and for every depth.
    #[must_use]
    pub fn with_formats(mut self, color: Format, depth: Format) -> Self {
        (self.color, self.depth) = (color, depth);
        self
    }

    /// Makes methods that know only surfaces draw a scene's volumes as so many slices, 1 to
    /// [`MOST_SLICES`](super::MOST_SLICES). Slices are planes across the view, at equal distances through all volumes
    /// together. Each is as opaque as the slab in whose middle it stands. Hybrid layer peeling does so by default, with
    /// [`DEFAULT_SLICES`](super::DEFAULT_SLICES). Methods that cast rays through volumes still do that.
    ///
    /// # Errors
    /// If the number is out of its range.
    pub fn with_slices(mut self, count: u32) -> Result<Self> {
        slicing::check(count)?;
        self.slices = Some(count);
        Ok(self)
    }

    /// Frames no longer record values that only their statistics need: the costs of an A-buffer's lists, and the number
    /// of lost fragments. A time that is compared with another method's should not contain this work, which also takes
    /// another program to compile.
    #[must_use]
    pub fn without_costs(mut self) -> Self {
        self.counts_costs = false;
        self
    }

    /// Makes the renderer draw with the near and the far plane of the scene's camera as they are.
    ///
    /// Otherwise the planes are moved close around the geometry between them
    /// ([`Camera::close_around`](crate::scene::Camera::close_around)). Nothing more is cut off, and depths have a finer
    /// resolution. With a near plane at 0.1 and a far plane at 1000, a 32-bit depth buffer cannot tell apart two panes
    /// at a distance of 100 that are 1 cm apart.
    #[must_use]
    pub fn with_given_planes(mut self) -> Self {
        self.fits_planes = false;
        self
    }

    /// Makes methods test, store and compare 1/w instead of window-space depth, whose values crowd together far from
    /// the near plane. The error of 1/w is some 1e-6 of the distance everywhere. No line of a listing changes: the
    /// stored value grows with the distance from 0 to 1. The cost is that drivers can no longer test depths before they
    /// shade.
    #[must_use]
    pub fn with_inverse_w(mut self) -> Self {
        self.inverse_w = true;
        self
    }

    /// The renderer with a shader's file of one's own, for a method of one's own, or in place of one of onionskin's:
    /// [`GlMachine::set_shader_file`] says what it may contain.
    ///
    /// # Errors
    /// As [`GlMachine::set_shader_file`].
    pub fn with_shader_file(mut self, name: &str, text: &str) -> Result<Self> {
        self.machine.set_shader_file(name, text)?;
        Ok(self)
    }

    /// Renders one frame.
    ///
    /// # Errors
    /// If the method or the driver fails.
    pub fn render(&mut self, scene: &Scene, method: &dyn Technique) -> Result<Frame> {
        let _visit = self.machine.context().visit()?;
        let shown = self.shown(self.with_planes(scene), scene.camera, method)?;
        self.render_shown(&shown, method, &mut None)
    }

    /// Renders a frame of a scene that `held` says is uploaded, and in which order; it is uploaded if that is nothing.
    pub(super) fn render_shown(
        &mut self,
        shown: &Shown<'_>,
        method: &dyn Technique,
        held: &mut Option<DrawOrder>,
    ) -> Result<Frame> {
        let scene = &*shown.scene;
        let begun = Instant::now();
        let mut algorithm = self.prepare(shown, method, held)?;
        self.machine.finish();
        let set_up = milliseconds(begun);
        let (drawn, ms) = self.draw(scene, algorithm.as_mut())?;
        self.finish(shown, method, algorithm.as_mut(), drawn, [set_up, ms])
    }

    /// Renders a frame to warm up, and then `frames` more, or as many as begin within two seconds, but at least one.
    /// The time is their median.
    ///
    /// # Errors
    /// As [`Renderer::render`].
    pub fn measure(
        &mut self,
        scene: &Scene,
        method: &dyn Technique,
        frames: usize,
    ) -> Result<Frame> {
        let _visit = self.machine.context().visit()?;
        let shown = self.shown(self.with_planes(scene), scene.camera, method)?;
        let scene = &*shown.scene;
        let begun = Instant::now();
        let mut algorithm = self.prepare(&shown, method, &mut None)?;
        self.machine.finish();
        let set_up = milliseconds(begun);
        self.draw(scene, algorithm.as_mut())?;
        let start = Instant::now();
        let (mut drawn, ms) = self.draw(scene, algorithm.as_mut())?;
        let mut times = vec![ms];
        while times.len() < frames && start.elapsed() < PATIENCE {
            let (again, ms) = self.draw(scene, algorithm.as_mut())?;
            drawn = again;
            times.push(ms);
        }
        times.sort_unstable_by(f64::total_cmp);
        let times = [set_up, times[times.len() / 2]];
        self.finish(&shown, method, algorithm.as_mut(), drawn, times)
    }

    /// Copies the last frame's image into the default framebuffer, which a window shows; the lower left corners meet.
    /// Not for [`Method::Exact`](super::Method::Exact), whose image is made outside of GL.
    ///
    /// # Errors
    /// If nothing has been rendered yet.
    pub fn present(&mut self) -> Result<()> {
        self.machine.copy_to_window(stage::IMAGE)
    }

    /// Makes the image and the opaque depth, and uploads the scene.
    pub(super) fn set_up(&mut self, scene: &Scene, order: &DrawOrder) -> Result<()> {
        self.machine.free_every_map();
        self.allocate_stage()?;
        let machine = &mut self.machine;
        let (context, size) = (machine.context(), machine.size());
        machine.set_geometry(match orders(order) {
            _ if *order == DrawOrder::Own => Geometry::upload_merged(context, scene, size)?,
            [] => Geometry::upload(context, scene, size)?,
            orders => Geometry::upload_in_orders(context, scene, size, orders)?,
        });
        Ok(())
    }

    /// Makes the image and the opaque depth for a scene that is uploaded, but may be drawn in another order now.
    fn set_up_again(&mut self, scene: &Scene, held: &DrawOrder, order: &DrawOrder) -> Result<()> {
        self.machine.free_every_map_but_the_volumes();
        self.allocate_stage()?;
        self.machine.look(scene);
        match order == held {
            true => Ok(()),
            false => self.machine.reorder(scene, orders(order)),
        }
    }

    /// Makes the image and the opaque depth, unless they are there.
    pub(super) fn allocate_stage(&mut self) -> Result<()> {
        let machine = &mut self.machine;
        allocate_maps(machine, &[&stage::RESOURCES], self.color, self.depth)
    }

    /// The scene as the method draws it: with slices instead of volumes, if it does not cast rays. It is seen between the
    /// planes that it is drawn with; `given` is the camera as it was given.
    pub(super) fn shown<'s>(
        &self,
        scene: Cow<'s, Scene>,
        given: Camera,
        method: &dyn Technique,
    ) -> Result<Shown<'s>> {
        let slices = slicing::slices(&scene, method.entry(), self.slices)?;
        if self.inverse_w {
            inverse_w::check(method, self.depth)?;
        }
        let (scene, sliced) = match slices {
            None => (scene, None),
            Some(count) => {
                let stack = scene.as_slices(count);
                (Cow::Owned(stack.scene), Some((scene, stack.spacing)))
            }
        };
        Ok(Shown {
            scene,
            slices,
            sliced,
            given,
        })
    }

    /// The scene, seen between the planes that it is drawn with.
    fn with_planes<'s>(&self, scene: &'s Scene) -> Cow<'s, Scene> {
        let camera = self.camera(scene);
        if camera == scene.camera {
            return Cow::Borrowed(scene);
        }
        Cow::Owned(Scene {
            camera,
            ..scene.clone()
        })
    }

    /// The scene's camera with the planes that it is drawn with.
    pub(super) fn camera(&self, scene: &Scene) -> Camera {
        match scene.bounds() {
            Some(bounds) if self.fits_planes => scene.camera.close_around(bounds),
            _ => scene.camera,
        }
    }

    /// Sets the method up for the scene, which is uploaded once, in the order in which the method draws it, unless `held`
    /// says that it is. Slices are other geometry for every camera.
    pub(super) fn prepare(
        &mut self,
        shown: &Shown<'_>,
        method: &dyn Technique,
        held: &mut Option<DrawOrder>,
    ) -> Result<Box<dyn Algorithm>> {
        let mut algorithm = method.algorithm(&Setup {
            size: self.machine.size(),
            color: self.color,
            depth: self.depth,
            counts_costs: self.counts_costs,
            given: shown.given,
        });
        let order = algorithm.order(&shown.scene);
        match held.take() {
            Some(held) if shown.slices.is_none() => {
                self.set_up_again(&shown.scene, &held, &order)?;
            }
            _ => self.set_up(&shown.scene, &order)?,
        }
        *held = Some(order);
        if let Some((volumes, spacing)) = &shown.sliced {
            self.machine.upload_slices(volumes, *spacing)?;
        }
        let near = shown.scene.camera.near as f32;
        self.machine.set_inverse_w(self.inverse_w.then_some(near));
        algorithm.prepare(&mut self.machine, &shown.scene)?;
        Ok(algorithm)
    }

    pub(super) fn draw(
        &mut self,
        scene: &Scene,
        algorithm: &mut dyn Algorithm,
    ) -> Result<(Drawn, f64)> {
        self.begin(scene)?;
        self.machine.finish();
        let start = Instant::now();
        let drawn = algorithm.draw(&mut self.machine, scene)?;
        self.machine.finish();
        Ok((drawn, milliseconds(start)))
    }

    /// GL's initial state and the background's colour.
    pub(super) fn begin(&mut self, scene: &Scene) -> Result<()> {
        self.machine.begin_frame();
        self.machine.bind_volumes()?;
        let [red, green, blue] = scene.background;
        self.machine.perform(&Call::ClearColor {
            red,
            green,
            blue,
            alpha: 1.0,
        })
    }
}

/// The orders other than the scene's own.
pub(super) fn orders(order: &DrawOrder) -> &[Vec<[u32; 2]>] {
    match order {
        DrawOrder::Submission | DrawOrder::Own => &[],
        DrawOrder::Sorted(order) => std::slice::from_ref(order),
        DrawOrder::InTurn(orders) => orders,
    }
}
