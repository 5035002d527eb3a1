//! Wavefront models: OBJ and its MTL.
//!
//! `tobj` is the reader. It says what is wrong without saying where, and takes some of what models hold for something
//! else: lines (`l`) for polygons, colours or normals that only some vertices have for those of other vertices, a
//! `Kd` of one number for a reason to panic. So every file is first gone through line by line ([`check`],
//! [`materials`]): what is wrong is reported with its line, and what goes on to `tobj` is plain.

mod assemble;
mod check;
mod face;
mod materials;
mod numbers;
mod skipped;
mod words;

use std::path::Path;

use super::mesh::Mesh;
use super::source;
use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;
use materials::Materials;

/// What a scene file says about a model's looks; it comes before the materials and after vertex colours.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Paint {
    pub(super) color: Option<[f32; 3]>,
    pub(super) opacity: Option<f32>,
}

/// A model and what there is to say about it.
pub(super) struct Model {
    /// One for each run of faces with the same object, group and material, in the order of the file.
    pub(super) meshes: Vec<Mesh>,
    /// What was skipped or assumed.
    pub(super) notices: Vec<String>,
}

/// Reads a model.
pub(super) fn load(path: &Path, paint: &Paint, memory: &MemoryLimit) -> Result<Model> {
    let bytes = source::read(path, memory)?;
    let checked = check::check(path, &bytes)?;
    drop(bytes);
    let mut notices = checked.skipped.notices(path);
    let materials = Materials::load(path, &checked, &mut notices, memory)?;
    let (models, list) = read(path, &checked.text, &materials)?;
    let mut meshes = assemble::meshes(models, &list, paint);
    let degenerate: usize = meshes.iter_mut().map(Mesh::drop_degenerate).sum();
    if degenerate > 0 {
        let some = counted(degenerate, "triangle");
        notices.push(format!("{}: {some} without area skipped", path.display()));
    }
    Ok(Model { meshes, notices })
}

/// The text through `tobj`: runs of triangles, each vertex with all it needs under one index.
fn read(
    path: &Path,
    text: &str,
    materials: &Materials,
) -> Result<(Vec<tobj::Model>, Vec<tobj::Material>)> {
    let options = tobj::LoadOptions {
        single_index: true,
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
    };
    let (models, list) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
        tobj::load_mtl_buf(&mut materials.text.as_bytes())
    })
    .map_err(|error| slipped(path, error))?;
    Ok((models, list.map_err(|error| slipped(path, error))?))
}

/// An error that the check should have found, with a line. Better without one than not at all.
fn slipped(path: &Path, error: tobj::LoadError) -> Error {
    Error::input(
        Place::file(path),
        format!("the model cannot be read: {error}"),
        "Export it again, as plain triangles; and please report this message with the file.",
    )
}

/// `1 face`, `2 faces`.
fn counted(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}
