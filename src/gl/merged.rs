//! All transparent meshes of a scene in one buffer of vertices, so that their triangles can be drawn in whatever order with
//! a single call.

use glam::DVec3;
use glow::HasContext;

use super::bindings::INSIDE;
use super::context::Context;
use super::corner::{Corner, corners, expect_indices};
use super::making::Making;
use super::program::{Surface, Surfaces};
use super::runs::Run;
use super::uploading::fill;
use crate::error::{Error, Result};
use crate::scene::{Mesh, Shading};

/// The transparent meshes. Their vertices are numbered through, mesh by mesh in the order of submission.
pub(super) struct Merged {
    vertices: glow::Buffer,
    /// How each vertex's mesh is shaded, if meshes differ in that.
    insides: Option<glow::Buffer>,
    indices: glow::Buffer,
    array: glow::VertexArray,
    /// The first vertices of the meshes whose surface is another than that of the mesh before, and that surface.
    surfaces: Vec<(u32, Surface)>,
    count: u32,
    /// Of the triangles as they are drawn. A run's mesh is a number among `surfaces`.
    runs: Vec<Run>,
}

/// What the shader of mixed surfaces knows about a vertex's mesh: the colour of back faces, and whether there is light,
/// 0 for none, 1 for the same on both sides, 2 for a colour on each.
type Inside = [f32; 4];

impl Merged {
    /// Uploads the meshes' vertices, relative to `origin`. There are no triangles yet.
    pub(super) fn new<'m>(
        context: &Context,
        meshes: impl Iterator<Item = &'m Mesh> + Clone,
        origin: DVec3,
    ) -> Result<Self> {
        let mut all: Vec<Corner> = Vec::new();
        let mut insides: Vec<Inside> = Vec::new();
        let mut surfaces: Vec<(u32, Surface)> = Vec::new();
        let is_mixed = is_mixed(meshes.clone());
        for mesh in meshes {
            expect_indices(mesh)?;
            let surface = match mesh.shading {
                Shading::Slice => Surface::of(mesh),
                _ if is_mixed => Surface::Mixed,
                _ => Surface::of(mesh),
            };
            let first = u32::try_from(all.len()).map_err(|_| too_many())?;
            if surfaces.last().is_none_or(|(_, last)| *last != surface) {
                surfaces.push((first, surface));
            }
            all.extend(corners(mesh, origin));
            if is_mixed {
                insides.extend(std::iter::repeat_n(inside(mesh), mesh.vertices.len()));
            }
        }
        let count = u32::try_from(all.len()).map_err(|_| too_many())?;
        let gl = context.glow();
        let mut making = Making::new(gl);
        // SAFETY: the context is current; the slices are read before the calls return; the attributes lie within their
        // strides.
        let merged = unsafe {
            let array = making.vertex_array()?;
            gl.bind_vertex_array(Some(array));
            let vertices = making.buffer()?;
            gl.bind_buffer(glow::ARRAY_BUFFER, Some(vertices));
            let what = "the vertices of the transparent meshes";
            fill(
                context,
                glow::ARRAY_BUFFER,
                what,
                bytemuck::cast_slice(&all),
            )?;
            Corner::set_attributes(gl);
            let insides = match is_mixed {
                false => None,
                true => {
                    let buffer = making.buffer()?;
                    gl.bind_buffer(glow::ARRAY_BUFFER, Some(buffer));
                    let what = "the shading of the transparent meshes";
                    fill(
                        context,
                        glow::ARRAY_BUFFER,
                        what,
                        bytemuck::cast_slice(&insides),
                    )?;
                    gl.enable_vertex_attrib_array(INSIDE);
                    gl.vertex_attrib_pointer_f32(INSIDE, 4, glow::FLOAT, false, 0, 0);
                    Some(buffer)
                }
            };
            let indices = making.buffer()?;
            gl.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, Some(indices));
            Self {
                vertices,
                insides,
                indices,
                array,
                surfaces,
                count,
                runs: Vec::new(),
            }
        };
        making.finish();
        Ok(merged)
    }

    /// Whether some of its surfaces are mixed, for which programs have a shader of their own.
    pub(super) fn is_mixed(&self) -> bool {
        self.insides.is_some()
    }

    /// Has these triangles drawn, in this order.
    ///
    /// # Errors
    /// If an index is that of no vertex, or the driver has no room.
    pub(super) fn submit(&mut self, context: &Context, triangles: &[[u32; 3]]) -> Result<()> {
        // Offsets into the index buffer are 31 bits wide.
        if i32::try_from(triangles.len().saturating_mul(12)).is_err() {
            return Err(too_many());
        }
        let largest = triangles.as_flattened().iter().copied().fold(0, u32::max);
        if !triangles.is_empty() && largest >= self.count {
            return Err(Error::usage(
                format!("a triangle has vertex {largest} of {}", self.count),
                "number the vertices of the transparent meshes through, in the order of submission",
            ));
        }
        let gl = context.glow();
        // SAFETY: the context is current, and the array is this one's own.
        unsafe { gl.bind_vertex_array(Some(self.array)) };
        let bytes = bytemuck::cast_slice(triangles);
        fill(context, glow::ELEMENT_ARRAY_BUFFER, "the triangles", bytes)?;
        self.runs = match self.surfaces.len() {
            0 | 1 => vec![Run {
                mesh: 0,
                first: 0,
                count: triangles.len() as i32 * 3,
                place: 0,
            }],
            _ => self.runs_of(triangles),
        };
        Ok(())
    }

    /// A run for each change of surface.
    fn runs_of(&self, triangles: &[[u32; 3]]) -> Vec<Run> {
        let surface_of =
            |vertex: u32| self.surfaces.partition_point(|(first, _)| *first <= vertex) - 1;
        let mut runs: Vec<Run> = Vec::new();
        for (place, triangle) in triangles.iter().enumerate() {
            let surface = surface_of(triangle[0]);
            match runs.last_mut() {
                Some(run) if run.mesh == surface => run.count += 3,
                _ => runs.push(Run {
                    mesh: surface,
                    first: place as i32 * 3,
                    count: 3,
                    place: place as u32,
                }),
            }
        }
        runs
    }

    /// Draws the triangles. `choose` makes the program of a surface current. Returns their number, or `None` if there was
    /// nothing to draw.
    pub(super) fn draw(
        &self,
        gl: &glow::Context,
        surfaces: &Surfaces,
        mut choose: impl FnMut(Surface),
    ) -> Option<u64> {
        let mut triangles = None;
        // SAFETY: the context is current; `submit` has checked that every index is below the number of vertices; the
        // location is the program's.
        unsafe {
            gl.bind_vertex_array(Some(self.array));
            for run in self.runs.iter().filter(|run| run.count > 0) {
                let surface = self.surfaces[run.mesh].1;
                choose(surface);
                *triangles.get_or_insert(0) += run.draw(gl, surfaces.of(surface));
            }
        }
        triangles
    }

    pub(super) fn delete(&self, gl: &glow::Context) {
        // SAFETY: the objects are its own, and the caller lets go of it.
        unsafe {
            gl.delete_vertex_array(self.array);
            gl.delete_buffer(self.vertices);
            gl.delete_buffer(self.indices);
            if let Some(insides) = self.insides {
                gl.delete_buffer(insides);
            }
        }
    }
}

/// Whether there are several surfaces besides those of slices, which have programs of their own.
fn is_mixed<'m>(meshes: impl Iterator<Item = &'m Mesh>) -> bool {
    let mut surfaces = meshes
        .filter(|mesh| mesh.shading != Shading::Slice)
        .map(Surface::of);
    surfaces
        .next()
        .is_some_and(|first| surfaces.any(|surface| surface != first))
}

fn inside(mesh: &Mesh) -> Inside {
    let [red, green, blue] = mesh.inside;
    let light = match mesh.shading {
        Shading::None | Shading::Slice => 0.0,
        Shading::Flat | Shading::Lit => 1.0,
        Shading::TwoSided => 2.0,
    };
    [red, green, blue, light]
}

fn too_many() -> Error {
    Error::scene(
        "the transparent meshes together have more vertices or triangles than one draw call takes",
        "render at most 178 million triangles",
    )
}
