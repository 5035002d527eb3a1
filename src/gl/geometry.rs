//! A scene's meshes in the driver's memory.

use glam::{DMat4, DVec3, Mat4, Vec3};
use glow::HasContext;

use super::context::Context;
use super::corner::{Corner, corners, expect_indices};
use super::making::Making;
use super::merged::Merged;
use super::program::{Program, Surface, Surfaces};
use super::proxy::proxy;
use super::runs::{Ordered, Run};
use super::uploading::{Bound, fill};
use super::window::window_of_transparent;
use super::witness::DrawnOrder;
use crate::error::{Error, Result};
use crate::scene::{Mesh, Scene};
use crate::steps::Objects;

/// A scene, uploaded. Its buffers live as long as it does.
pub struct Geometry<'c> {
    context: &'c Context,
    meshes: Vec<Uploaded>,
    /// The transparent meshes, if they are drawn as one. Then `meshes` has only the opaque ones.
    merged: Option<Merged>,
    /// The runs of each order.
    orders: Vec<Vec<Run>>,
    /// The orders as they were given: each triangle as mesh and number. Empty if the only order is that of submission.
    given: Vec<Vec<[u32; 2]>>,
    /// The order that is drawn.
    order: usize,
    /// The place in the world to which drawn positions are relative: [`origin_of`].
    origin: DVec3,
    /// From positions relative to the origin to clip space.
    view_projection: Mat4,
    /// From positions relative to the origin to eye space, and eye to clip space.
    pub(super) view: DMat4,
    pub(super) projection: DMat4,
    /// Relative to the origin.
    eye: Vec3,
    /// The rectangle in which transparent surfaces may be: x, y, width, height, from the lower left.
    window: [i32; 4],
}

/// The buffers from which the fixed functions draw.
pub(super) struct Buffers {
    pub(super) vertices: glow::Buffer,
    pub(super) indices: glow::Buffer,
    pub(super) first: i32,
    pub(super) count: i32,
}

impl Buffers {
    /// Bytes from one vertex to the next, and from a vertex's beginning, which is its position, to its colour.
    pub(super) const STRIDE: usize = size_of::<Corner>();
    pub(super) const COLOR: usize = Corner::COLOR_OFFSET;
}

/// A mesh with the data for its draw calls.
struct Uploaded {
    vertices: glow::Buffer,
    indices: glow::Buffer,
    array: glow::VertexArray,
    opaque: bool,
    sorted: bool,
    surface: Surface,
    /// The number of the volume whose box it is.
    volume: Option<u32>,
}

/// Surfaces have no volume (`glsl/a_buffer/box.glsl`).
const NO_VOLUME: u32 = u32::MAX;

impl<'c> Geometry<'c> {
    /// Uploads the scene's meshes, to be drawn in the order of submission.
    ///
    /// # Errors
    /// If the driver has too little memory, or a mesh is too large for a draw call.
    pub fn upload(context: &'c Context, scene: &Scene, size: [u32; 2]) -> Result<Self> {
        let _bound = Bound::keep(context)?;
        let mut geometry = Self::empty(context, scene, size);
        let mut runs = Vec::new();
        let mut place = 0;
        for mesh in &scene.meshes {
            runs.push(geometry.add(mesh, &mesh.triangles, place)?);
            place += mesh.triangles.len() as u32;
        }
        for (number, volume) in scene.volumes.iter().enumerate() {
            let proxy = proxy(volume);
            let run = geometry.add(&proxy, &proxy.triangles, 0)?;
            geometry.meshes[run.mesh].volume = Some(number as u32);
            runs.push(run);
        }
        geometry.orders = vec![runs];
        Ok(geometry)
    }

    /// Uploads the scene's meshes, to be drawn in other orders: each has its triangles as mesh and number, and need not
    /// have all of them. The first order is drawn until
    /// [`GlMachine::choose_order`](crate::gl::GlMachine::choose_order) chooses another.
    ///
    /// # Errors
    /// As [`Geometry::upload`].
    pub fn upload_in_orders(
        context: &'c Context,
        scene: &Scene,
        size: [u32; 2],
        orders: &[Vec<[u32; 2]>],
    ) -> Result<Self> {
        let _bound = Bound::keep(context)?;
        let mut geometry = Self::empty(context, scene, size);
        let ordered = Ordered::new(scene, orders);
        for (mesh, triangles) in scene.meshes.iter().zip(&ordered.triangles) {
            geometry.add(mesh, triangles, 0)?;
        }
        geometry.orders = ordered.runs;
        geometry.given = orders.to_vec();
        Ok(geometry)
    }

    /// Uploads the scene's meshes, the transparent ones as one, whose triangles are drawn as
    /// [`submit`](Self::submit) says. Until then, none of them is.
    ///
    /// # Errors
    /// As [`Geometry::upload`].
    pub(crate) fn upload_merged(
        context: &'c Context,
        scene: &Scene,
        size: [u32; 2],
    ) -> Result<Self> {
        let _bound = Bound::keep(context)?;
        let mut geometry = Self::empty(context, scene, size);
        let mut runs = Vec::new();
        let mut place = 0;
        for mesh in &scene.meshes {
            if mesh.opaque {
                runs.push(geometry.add(mesh, &mesh.triangles, place)?);
            }
            place += mesh.triangles.len() as u32;
        }
        geometry.orders = vec![runs];
        let transparent = scene.meshes.iter().filter(|mesh| !mesh.opaque);
        let origin = geometry.origin;
        geometry.merged = Some(Merged::new(context, transparent, origin)?);
        Ok(geometry)
    }

    /// Has these triangles of the transparent meshes drawn, in this order, if they were uploaded as one.
    pub(super) fn submit(&mut self, triangles: &[[u32; 3]]) -> Result<()> {
        let _bound = Bound::keep(self.context)?;
        match &mut self.merged {
            Some(merged) => merged.submit(self.context, triangles),
            None => Err(Error::out_of_order(
                "triangles are submitted to meshes that were not uploaded as one",
                "have the method draw in DrawOrder::Own",
            )),
        }
    }

    /// The order in which triangles are drawn.
    pub(super) fn drawn(&self) -> DrawnOrder<'_> {
        match self.given.get(self.order) {
            Some(triangles) => DrawnOrder::Triangles(triangles),
            None => DrawnOrder::Submission,
        }
    }

    /// Whether programs need a shader for mixed surfaces.
    pub(super) fn is_mixed(&self) -> bool {
        self.merged.as_ref().is_some_and(Merged::is_mixed)
    }

    /// Has the scene that was uploaded in orders drawn in others. Its vertices are not uploaded again.
    pub(super) fn reorder(&mut self, scene: &Scene, orders: &[Vec<[u32; 2]>]) -> Result<()> {
        let _bound = Bound::keep(self.context)?;
        let ordered = Ordered::new(scene, orders);
        let meshes = scene.meshes.iter().zip(&self.meshes);
        for ((mesh, uploaded), triangles) in meshes.zip(&ordered.triangles) {
            uploaded.fill_indices(self.context, mesh, triangles)?;
        }
        self.orders = ordered.runs;
        self.given = orders.to_vec();
        self.order = 0;
        Ok(())
    }

    /// Has the first order drawn.
    pub(super) fn begin_frame(&mut self) {
        self.order = 0;
    }

    /// Has an order drawn by its number. The first one is number 0.
    pub(super) fn choose(&mut self, order: usize) -> Result<()> {
        if order >= self.orders.len() {
            return Err(Error::out_of_order(
                format!("order {order} is to be drawn, of {}", self.orders.len()),
                "upload the scene in so many orders",
            ));
        }
        self.order = order;
        Ok(())
    }

    /// Adds a mesh, and returns the run of all of its triangles.
    fn add(&mut self, mesh: &Mesh, triangles: &[[u32; 3]], place: u32) -> Result<Run> {
        let uploaded = Uploaded::new(self.context, mesh, triangles, self.origin)?;
        self.meshes.push(uploaded);
        Ok(Run {
            mesh: self.meshes.len() - 1,
            first: 0,
            // `Uploaded::new` has checked that the count fits.
            count: triangles.len() as i32 * 3,
            place,
        })
    }

    fn empty(context: &'c Context, scene: &Scene, size: [u32; 2]) -> Self {
        let mut geometry = Self {
            context,
            meshes: Vec::with_capacity(scene.meshes.len()),
            merged: None,
            orders: vec![Vec::new()],
            given: Vec::new(),
            order: 0,
            origin: origin_of(scene),
            view_projection: Mat4::IDENTITY,
            view: DMat4::IDENTITY,
            projection: DMat4::IDENTITY,
            eye: Vec3::ZERO,
            window: [0; 4],
        };
        geometry.look(scene, size);
        geometry
    }

    /// Has the scene that was uploaded seen by the camera that it has now.
    pub(super) fn look(&mut self, scene: &Scene, size: [u32; 2]) {
        let camera = &scene.camera;
        self.view = camera.view() * DMat4::from_translation(self.origin);
        self.projection = camera.projection(size[0], size[1]);
        self.view_projection = (self.projection * self.view).as_mat4();
        self.eye = (camera.eye - self.origin).as_vec3();
        self.window = window_of_transparent(scene, self.projection * camera.view(), size);
    }

    /// # Errors
    /// If it was uploaded to another context, where the same names are other objects.
    pub(super) fn expect_context(&self, context: &Context) -> Result<()> {
        if self.context.is(context) {
            return Ok(());
        }
        Err(Error::out_of_order(
            "the geometry was uploaded to another OpenGL context than the one that draws it",
            "upload it with the context of the machine",
        ))
    }

    /// The place to which drawn positions are relative.
    pub(super) fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The rectangle of the image outside of which there is no transparent surface.
    pub(super) fn window(&self) -> [i32; 4] {
        self.window
    }

    /// The buffers of the meshes that are among `objects`, in the order of submission.
    pub(super) fn buffers(&self, objects: Objects) -> impl Iterator<Item = Buffers> {
        let runs = self.orders[self.order].iter();
        let meshes = runs.map(|run| (run, &self.meshes[run.mesh]));
        let among = meshes.filter(move |(_, mesh)| mesh.is_among(objects));
        among.map(|(run, mesh)| Buffers {
            vertices: mesh.vertices,
            indices: mesh.indices,
            first: run.first,
            count: run.count,
        })
    }

    /// Draws the objects, each mesh with the program for its shading. Returns the number of triangles, or `None` if there
    /// was nothing to draw.
    pub(super) fn draw(&self, surfaces: &Surfaces, objects: Objects) -> Option<u64> {
        let gl = self.context.glow();
        let mut current = None;
        let mut triangles = None;
        for run in &self.orders[self.order] {
            let mesh = &self.meshes[run.mesh];
            if !mesh.is_among(objects) {
                continue;
            }
            let program = surfaces.of(mesh.surface);
            self.use_program(program, mesh.surface, &mut current);
            // SAFETY: the context is current; every index is below the number of vertices, which `Uploaded::new`
            // checked; the locations are this program's, and GL ignores a uniform that a program does not have.
            unsafe {
                gl.uniform_1_u32(program.volume.as_ref(), mesh.volume.unwrap_or(NO_VOLUME));
                gl.bind_vertex_array(Some(mesh.array));
                *triangles.get_or_insert(0) += run.draw(gl, program);
            }
        }
        if let (Some(merged), Objects::Scene | Objects::Transparent) = (&self.merged, objects) {
            let choose = |surface| self.use_program(surfaces.of(surface), surface, &mut current);
            if let Some(more) = merged.draw(gl, surfaces, choose) {
                *triangles.get_or_insert(0) += more;
            }
        }
        triangles
    }

    /// Makes a surface's program current, and sets its uniforms. `current` is the one that is.
    fn use_program(
        &self,
        program: &Program,
        surface: Surface,
        current: &mut Option<glow::Program>,
    ) {
        let gl = self.context.glow();
        // SAFETY: the context is current; the locations are this program's, and GL ignores a uniform that a program does
        // not have.
        unsafe {
            if *current != Some(program.raw) {
                *current = Some(program.raw);
                gl.use_program(Some(program.raw));
                gl.uniform_matrix_4_f32_slice(
                    program.view_projection.as_ref(),
                    false,
                    &self.view_projection.to_cols_array(),
                );
                gl.uniform_3_f32(program.eye.as_ref(), self.eye.x, self.eye.y, self.eye.z);
            }
            gl.uniform_1_u32(program.volume.as_ref(), NO_VOLUME);
            let inside = match surface {
                Surface::Lit(inside) => inside,
                _ => None,
            };
            gl.uniform_1_i32(program.two_sided.as_ref(), i32::from(inside.is_some()));
            gl.uniform_3_f32_slice(program.inside.as_ref(), &inside.unwrap_or_default());
        }
    }
}

impl Uploaded {
    fn new(context: &Context, mesh: &Mesh, triangles: &[[u32; 3]], origin: DVec3) -> Result<Self> {
        expect_indices(mesh)?;
        let corners = corners(mesh, origin);
        let gl = context.glow();
        let mut making = Making::new(gl);
        // SAFETY: the context is current; the slices are read before the calls return; the three attributes lie within
        // the stride, as Corner is laid out in C's way.
        let uploaded = unsafe {
            let array = making.vertex_array()?;
            gl.bind_vertex_array(Some(array));
            let vertices = making.buffer()?;
            gl.bind_buffer(glow::ARRAY_BUFFER, Some(vertices));
            let bytes = bytemuck::cast_slice(&corners);
            let what = format!("the vertices of mesh '{}'", mesh.name);
            fill(context, glow::ARRAY_BUFFER, &what, bytes)?;
            let indices = making.buffer()?;
            gl.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, Some(indices));
            Corner::set_attributes(gl);
            Self {
                vertices,
                indices,
                array,
                opaque: mesh.opaque,
                sorted: mesh.sorted,
                surface: Surface::of(mesh),
                volume: None,
            }
        };
        uploaded.fill_indices(context, mesh, triangles)?;
        making.finish();
        Ok(uploaded)
    }

    /// Fills the index buffer with triangles of the mesh.
    fn fill_indices(&self, context: &Context, mesh: &Mesh, triangles: &[[u32; 3]]) -> Result<()> {
        // Offsets into the index buffer are 31 bits wide.
        if i32::try_from(triangles.len().saturating_mul(12)).is_err() {
            let what = format!(
                "mesh '{}' has {} triangles, more than one draw call takes",
                mesh.name,
                triangles.len()
            );
            return Err(Error::scene(
                what,
                "split it into meshes of at most 178 million triangles",
            ));
        }
        // SAFETY: the context is current, and the array is this mesh's own.
        unsafe { context.glow().bind_vertex_array(Some(self.array)) };
        let what = format!("the triangles of mesh '{}'", mesh.name);
        let bytes = bytemuck::cast_slice(triangles);
        fill(context, glow::ELEMENT_ARRAY_BUFFER, &what, bytes)
    }

    fn is_among(&self, objects: Objects) -> bool {
        if self.volume.is_some() {
            return objects == Objects::Proxies;
        }
        match objects {
            Objects::Scene => true,
            Objects::Opaque => self.opaque,
            Objects::Transparent => !self.opaque,
            Objects::Sorted => !self.opaque && self.sorted,
            Objects::Unsorted => !self.opaque && !self.sorted,
            Objects::Proxies | Objects::Screen => false,
        }
    }
}

/// The place to which drawn positions are relative. It is the middle of a scene that is so far from the world's origin
/// that 32 bits would lose digits of its shape, as with map coordinates. Otherwise it is the origin itself.
fn origin_of(scene: &Scene) -> DVec3 {
    /// A scene that is this many of its own sizes away loses as many times f32's rounding, and gains by moving.
    const FAR: f64 = 8.0;
    match scene.bounds() {
        Some(bounds) if bounds.centre().length() > FAR * bounds.size().length() => bounds.centre(),
        _ => DVec3::ZERO,
    }
}

impl Drop for Geometry<'_> {
    fn drop(&mut self) {
        // In another context the names would be someone else's objects.
        let Ok(_away) = self.context.enter() else {
            return;
        };
        let gl = self.context.glow();
        if let Some(merged) = &self.merged {
            merged.delete(gl);
        }
        for mesh in &self.meshes {
            // SAFETY: the objects are this mesh's own, and the context outlives the borrow.
            unsafe {
                gl.delete_vertex_array(mesh.array);
                gl.delete_buffer(mesh.vertices);
                gl.delete_buffer(mesh.indices);
            }
        }
    }
}

impl std::fmt::Debug for Geometry<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Geometry({} meshes)", self.meshes.len())
    }
}
