//! The GL machine: the tables that give listings' names their GL objects, put together. What the calls do is in
//! `interpreter`, what a method makes beforehand in `resources`.

use glam::DVec3;
use glow::HasContext;

use super::classic::Classic;
use super::context::Context;
use super::framebuffers::Framebuffers;
use super::geometry::Geometry;
use super::host::known_state;
use super::making::{Making, expect_no_error};
use super::maps::Maps;
use super::program::Define;
use super::programs::Programs;
use super::queries::Queries;
use super::samplers::Samplers;
use super::scan::Scan;
use super::step_times::{StepTime, StepTimes};
use super::storage::Storages;
use super::volumes::Volumes;
use super::witness::{DrawnOrder, Setting, Watch};
use crate::error::{Error, Result};
use crate::scene::Scene;

/// Runs listings on OpenGL.
///
/// It keeps the tables that give the listings' names their GL objects. Maps and framebuffers are made by
/// [`allocate`](Self::allocate) and [`framebuffer`](Self::framebuffer) before a listing runs; programs and queries are made when
/// they are first named.
pub struct GlMachine<'c> {
    pub(super) context: &'c Context,
    pub(super) maps: Maps,
    pub(super) framebuffers: Framebuffers,
    pub(super) storages: Storages,
    pub(super) programs: Programs,
    pub(super) queries: Queries,
    pub(super) samplers: Samplers,
    /// Draws without attributes need an array of none.
    pub(super) no_attributes: glow::VertexArray,
    pub(super) geometry: Option<Geometry<'c>>,
    pub(super) volumes: Volumes<'c>,
    pub(super) scan: Scan,
    pub(super) classic: Classic,
    /// First row and number of rows that are drawn to, if not all.
    pub(super) band: Option<[u32; 2]>,
    /// The pixels that draws over the screen cover, if a method has said it: x, y, width and height.
    pub(super) screen: Option<[u32; 4]>,
    pub(super) geometry_passes: u64,
    pub(super) triangles: u64,
    pub(super) step_times: StepTimes,
    pub(super) watch: Watch,
}

/// Counts of a machine's work since [`GlMachine::begin_frame`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// The draws of the scene, or of its transparent part.
    pub geometry_passes: u64,
    /// The triangles of all these draws together.
    pub triangles: u64,
    /// The bytes of all textures and buffers that the machine holds for the method.
    pub bytes: u64,
}

impl<'c> GlMachine<'c> {
    /// A machine for images of one size.
    ///
    /// # Errors
    /// If the size is 0 or over the driver's limit.
    pub fn new(context: &'c Context, [width, height]: [u32; 2]) -> Result<Self> {
        let largest = context.driver().largest_image();
        if width == 0 || height == 0 || width > largest || height > largest {
            return Err(Error::ImageSize {
                width,
                height,
                largest,
            });
        }
        context.begin_making()?;
        let mut making = Making::new(context.glow());
        let samplers = Samplers::new(&mut making)?;
        let no_attributes = making.vertex_array()?;
        making.finish();
        Ok(Self {
            context,
            maps: Maps::new([width, height]),
            framebuffers: Framebuffers::default(),
            storages: Storages::default(),
            programs: Programs::default(),
            queries: Queries::default(),
            samplers,
            no_attributes,
            geometry: None,
            volumes: Volumes::default(),
            scan: Scan::default(),
            classic: Classic::default(),
            band: None,
            screen: None,
            geometry_passes: 0,
            triangles: 0,
            step_times: StepTimes::default(),
            watch: Watch::default(),
        })
    }

    /// The context in which it works.
    pub fn context(&self) -> &'c Context {
        self.context
    }

    /// Width and height of its images.
    pub fn size(&self) -> [u32; 2] {
        self.maps.size
    }

    /// Sets the geometry that draw calls draw.
    pub fn set_geometry(&mut self, geometry: Geometry<'c>) {
        self.programs.mixed = geometry.is_mixed();
        self.watch.set(Setting::Order(geometry.drawn()));
        self.geometry = Some(geometry);
    }

    /// Has these triangles of the transparent meshes drawn, in this order, if the method draws in an order of its own
    /// ([`DrawOrder::Own`](crate::low_level::methods::DrawOrder::Own)). Their corners are numbers of vertices, which are
    /// numbered through all transparent meshes in the order of submission.
    ///
    /// # Errors
    /// If there is no scene, if it is drawn in another order, if a corner is no vertex, or if the driver has no room.
    pub fn submit_triangles(&mut self, triangles: &[[u32; 3]]) -> Result<()> {
        self.context.expect_current()?;
        let no_scene = || {
            Error::out_of_order(
                "triangles are submitted before there is a scene",
                "set_geometry first",
            )
        };
        let geometry = self.geometry.as_mut().ok_or_else(no_scene)?;
        geometry.submit(triangles)?;
        self.watch
            .set(Setting::Order(DrawnOrder::Corners(triangles)));
        Ok(())
    }

    /// The place to which drawn positions are relative.
    pub(crate) fn origin(&self) -> DVec3 {
        self.geometry.as_ref().map_or(DVec3::ZERO, Geometry::origin)
    }

    /// Has draw calls draw another of the orders in which the geometry was uploaded
    /// ([`Geometry::upload_in_orders`]), until the next frame begins.
    ///
    /// # Errors
    /// If there is no geometry, or it was not uploaded in so many orders.
    pub fn choose_order(&mut self, order: usize) -> Result<()> {
        let no_scene = || {
            Error::out_of_order(
                "an order is chosen before there is a scene",
                "set_geometry first",
            )
        };
        let geometry = self.geometry.as_mut().ok_or_else(no_scene)?;
        geometry.choose(order)?;
        self.watch.set(Setting::Order(geometry.drawn()));
        Ok(())
    }

    /// Draws the scene that was uploaded in other orders, and keeps its vertices where they are.
    ///
    /// # Errors
    /// If the driver has too little memory.
    pub(crate) fn reorder(&mut self, scene: &Scene, orders: &[Vec<[u32; 2]>]) -> Result<()> {
        match &mut self.geometry {
            Some(geometry) => {
                geometry.reorder(scene, orders)?;
                self.watch.set(Setting::Order(geometry.drawn()));
                Ok(())
            }
            None => Ok(()),
        }
    }

    /// Draws the scene that was uploaded as the camera sees it that it has now; its meshes and volumes are the same.
    pub fn look(&mut self, scene: &Scene) {
        let size = self.size();
        if let Some(geometry) = &mut self.geometry {
            geometry.look(scene, size);
        }
    }

    /// GL's initial state, as a fresh context has it, a viewport of the machine's size, and every count at 0. Listings
    /// take it from there. What the state was before is lost, unless a [`Visit`](super::Visit) of the context is going on.
    pub fn begin_frame(&mut self) {
        let gl = self.context.glow();
        self.queries.end_counting(gl);
        known_state(self.context, self.size());
        // SAFETY: the context is current.
        unsafe { gl.active_texture(glow::TEXTURE0) };
        self.samplers.bind(gl);
        self.programs.forget_current();
        self.classic.begin_frame();
        self.band = None;
        self.screen = None;
        (self.geometry_passes, self.triangles) = (0, 0);
        if let Some(geometry) = &mut self.geometry {
            geometry.begin_frame();
            self.watch.set(Setting::Order(geometry.drawn()));
            let window = geometry.window().map(|side| side.max(0) as u32);
            self.watch.set(Setting::Window(window));
        }
    }

    /// Asks OpenGL for errors since it was last asked. Release builds do not ask after each step.
    ///
    /// # Errors
    /// OpenGL's error, after any call.
    pub fn expect_no_error(&self, when: &str) -> Result<()> {
        expect_no_error(self.context.glow(), when)
    }

    /// Gives the machine a shader's file of one's own. Listings name a fragment shader by its file's name without the
    /// ending: `Shader("mine/glow")` is `mine/glow.frag`. A file of this name in `glsl/` is replaced, for this machine.
    ///
    /// The text is read as those in `glsl/` are. A shader that draws surfaces calls `vec4 surface_color()`, which the
    /// machine adds for each kind of shading. These lines are read, too:
    ///
    /// | line | in | says |
    /// | --- | --- | --- |
    /// | `#include "common/volume.glsl"` | any file | the file stands here, one of `glsl/` or one's own |
    /// | `// vertex: screen.vert` | a fragment shader | its vertex shader; without the line `geometry.vert` |
    /// | `// draws: screen` | a vertex shader | its programs cover the screen; without the line they draw surfaces |
    /// | `// looks at: classic state` | a vertex shader | its programs are given what classic calls have set |
    /// | `// defines: method` | any file | whatever includes it is compiled with [`set_defines`](Self::set_defines) |
    ///
    /// Programs are linked when a listing names them. An error of the text comes then, as [`Error::Shader`], with the file
    /// and the line. As OpenGL leaves it open what happens if a shader writes outside of a buffer, a text must not do that.
    ///
    /// # Errors
    /// If the name does not end in `.frag`, `.vert`, `.comp` or `.glsl`, if a file that is not a `.glsl` does not begin with
    /// `#version`, or if the context cannot be made current.
    pub fn set_shader_file(&mut self, name: &str, text: &str) -> Result<()> {
        if self.programs.files.text(name) == Some(text) {
            return Ok(());
        }
        let _away = self.context.enter()?;
        self.programs.files.set(name, text)?;
        // Any of the programs may include it.
        let gl = self.context.glow();
        self.programs.delete(gl);
        self.scan.delete(gl);
        Ok(())
    }

    /// The names of all shaders that listings may name: those in `glsl/`, and those of one's own.
    pub fn shaders(&self) -> impl Iterator<Item = &str> {
        self.programs.files.shaders()
    }

    /// Sets the `#define`s, names and values, of programs that are used from now on. Only shaders that ask for them
    /// (`// defines: method`) have them.
    pub fn set_defines(&mut self, defines: &[Define]) {
        self.programs.defines = defines.to_vec();
        self.watch.set(Setting::Defines(defines));
    }

    /// Has surfaces tested, stored and compared by 1/w from now on, with the near plane at this distance. With `None`
    /// they are tested, stored and compared by window-space depth. `glsl/common/fragment_depth.glsl` explains the stored
    /// value. Depth maps must be in 32-bit float. Classic calls and the shaders of the invariance experiment go by
    /// window-space depth all the same.
    pub(crate) fn set_inverse_w(&mut self, near: Option<f32>) {
        self.programs.inverse_w = near.map(f32::to_bits);
    }

    /// Whether depths are 1/w.
    pub(crate) fn has_inverse_w(&self) -> bool {
        self.programs.inverse_w.is_some()
    }

    /// Draws and clears only so many rows from `first` on, counted from the bottom. With `None`, all rows.
    pub(crate) fn set_band(&mut self, band: Option<[u32; 2]>) {
        self.band = band;
        self.watch.set(Setting::Band(band));
        self.scissor_to_band();
    }

    /// Has draws over the screen cover these pixels: x, y, width and height. With `None` they cover those where
    /// transparent surfaces may be.
    pub(crate) fn set_screen(&mut self, screen: Option<[u32; 4]>) {
        self.screen = screen;
        self.watch.set(Setting::Screen(screen));
    }

    /// The scissor of the band, or `None` for the whole image.
    pub(super) fn scissor_to_band(&self) {
        let gl = self.context.glow();
        // SAFETY: the context is current.
        unsafe {
            match self.band {
                Some([first, rows]) => {
                    gl.enable_draw_buffer(glow::SCISSOR_TEST, 0);
                    let [width, rows] = [self.size()[0], rows].map(|side| side as i32);
                    gl.scissor_slice(0, 1, &[[0, first as i32, width, rows]]);
                }
                None => gl.disable_draw_buffer(glow::SCISSOR_TEST, 0),
            }
        }
    }

    /// The counts since the frame began.
    pub fn counts(&self) -> Counts {
        Counts {
            geometry_passes: self.geometry_passes,
            triangles: self.triangles,
            bytes: self.maps.bytes() + self.storages.bytes() + self.volumes.bytes(),
        }
    }

    /// Does work whose draws are not the method's. They are left out of [`counts`](Self::counts).
    ///
    /// # Errors
    /// The errors of `work`.
    pub fn save_and_restore<T>(&mut self, work: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        let counts = (self.geometry_passes, self.triangles);
        let result = self.unwatched(work);
        (self.geometry_passes, self.triangles) = counts;
        result
    }

    /// Has each step that clears, copies or draws timed from now on, until [`step_times`](Self::step_times) is asked. Frames
    /// take longer then, because OpenGL is waited for before and after each of these steps.
    pub fn time_steps(&mut self) {
        self.step_times.begin();
    }

    /// The times of the steps since [`time_steps`](Self::time_steps), in the order in which they were first performed.
    pub fn step_times(&mut self) -> Vec<StepTime> {
        self.step_times.take(self.context.glow())
    }

    /// Waits until all commands have been executed.
    pub fn finish(&self) {
        // SAFETY: the context is current.
        unsafe { self.context.glow().finish() };
    }
}

impl Drop for GlMachine<'_> {
    fn drop(&mut self) {
        // In another context the names would be someone else's objects.
        let Ok(_away) = self.context.enter() else {
            return;
        };
        let gl = self.context.glow();
        self.queries.end_counting(gl);
        self.queries.delete(gl);
        self.step_times.take(gl);
        self.classic.delete(gl);
        self.framebuffers.delete(gl);
        self.maps.delete(gl);
        self.storages.delete(gl);
        self.programs.delete(gl);
        self.scan.delete(gl);
        self.samplers.delete(gl);
        // SAFETY: the array is the machine's own, and the context outlives the borrow.
        unsafe { gl.delete_vertex_array(self.no_attributes) };
    }
}

impl std::fmt::Debug for GlMachine<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GlMachine")
            .field("size", &self.size())
            .field("maps", &self.maps.names().collect::<Vec<_>>())
            .finish()
    }
}
