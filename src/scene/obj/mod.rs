//! Wavefront models: OBJ and its MTL.
//!
//! `tobj` is the reader. It reports faults without their line, and it stops at many that do not matter for the image.
//! It takes lines (`l`) for polygons and every polygon for a convex one. If only some vertices have colours or normals,
//! it gives them to other vertices. A `Kd` of one number makes it panic. So every file is first read line by line:
//! [`vertices`], then [`faces`], then its [`materials`]. A fault that matters for the image is reported with its line,
//! and the others are counted ([`notes`]). The text that goes to `tobj` is plain: it has triangles and convex polygons,
//! and numbers in place of names, which may be in any encoding.

mod assemble;
mod corner;
mod cover;
mod even_odd;
mod faces;
mod libraries;
mod library;
mod look;
mod materials;
mod notes;
mod numbers;
mod outline;
mod polygon;
mod smoothing;
mod transparency;
mod vertices;
mod words;

use std::path::Path;

use super::mesh::Mesh;
use super::source;
use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;
use assemble::Legend;
pub(super) use assemble::Paint;
use faces::Faces;
use notes::{Note, Notes, counted};
use vertices::Vertices;

/// A model, and the notes about it.
pub(super) struct Model {
    /// One mesh for each run of faces with the same object, group and material, in the order of the file.
    pub(super) meshes: Vec<Mesh>,
    /// What was skipped or assumed.
    pub(super) notices: Vec<String>,
}

/// Reads a model.
pub(super) fn load(path: &Path, paint: &Paint, memory: &MemoryLimit) -> Result<Model> {
    let bytes = source::read(path, memory)?;
    let mut notes = Notes::default();
    let vertices = Vertices::of(&bytes, &mut notes);
    let faces = Faces::of(path, &bytes, &vertices, &mut notes)?;
    if faces.count == 0 {
        return Err(no_faces(path, bytes.is_empty(), &vertices, &notes));
    }
    drop(bytes);
    let mut of_materials = Vec::new();
    let materials = materials::load(path, &faces, memory, &mut notes, &mut of_materials);
    let (models, list) = read(path, &faces.text, &materials)?;
    let used = faces.materials.iter();
    let legend = Legend {
        materials: used.map(|used| words::shown(&used.name)).collect(),
        names: faces.names,
        colors: faces.colors,
    };
    let mut meshes = assemble::meshes(models, &list, &legend, paint);
    let degenerate: usize = meshes.iter_mut().map(Mesh::drop_degenerate).sum();
    let mut notices: Vec<String> = notes.sentences(path).chain(of_materials).collect();
    if degenerate > 0 {
        let some = counted(degenerate, "triangle");
        notices.push(format!("{}: {some} without area skipped", path.display()));
    }
    if paint.opacity.is_none() {
        notices.extend(invisible(path, &meshes));
    }
    Ok(Model { meshes, notices })
}

/// Reads the plain text by `tobj`. The result is runs of triangles, with one index for all data of a vertex.
fn read(
    path: &Path,
    text: &str,
    materials: &str,
) -> Result<(Vec<tobj::Model>, Vec<tobj::Material>)> {
    let options = tobj::LoadOptions {
        single_index: true,
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
    };
    let (models, list) = tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| {
        tobj::load_mtl_buf(&mut materials.as_bytes())
    })
    .map_err(|error| slipped(path, error))?;
    Ok((models, list.map_err(|error| slipped(path, error))?))
}

/// A sentence about the meshes that are invisible, or `None` if there are none.
fn invisible(path: &Path, meshes: &[Mesh]) -> Option<String> {
    let is_clear = |mesh: &&Mesh| mesh.vertices.iter().all(|vertex| vertex.color.a == 0.0);
    let clear: Vec<&Mesh> = meshes.iter().filter(is_clear).collect();
    let first = clear.first()?;
    let some = match (clear.len(), meshes.len()) {
        (1, 1) => "the only mesh is".to_owned(),
        (count, all) if count == all => format!("all {count} meshes are"),
        (1, all) => format!("1 mesh of {all} is"),
        (count, all) => format!("{count} meshes of {all} are"),
    };
    Some(format!(
        "{}: {some} wholly transparent and invisible, the first is '{}': give `opacity` in a scene file if that is not meant",
        path.display(),
        first.name
    ))
}

/// The error for a model without any face that can be drawn.
fn no_faces(path: &Path, is_empty: bool, vertices: &Vertices, notes: &Notes) -> Error {
    let other = [Note::LineElement, Note::PointElement, Note::FreeForm];
    let first = [
        Note::FaceOfUnreadable,
        Note::UnreadableVertex,
        Note::FewCorners,
    ];
    if notes.of(Note::FaceOfUnreadable) + notes.of(Note::FewCorners) > 0 {
        let first = first.iter().rev().find_map(|&note| notes.first(note));
        let (line, word) = first.unwrap_or_default();
        let what = match notes.of(Note::UnreadableVertex) {
            0 => "the model's faces have fewer than three corners",
            _ => "none of the model's faces can be drawn: vertices have no place that can be read",
        };
        let remedy = "Write numbers with a point, and finite: 0.5, -3 or 1e-4. If the file was cut off, get it again.";
        return Error::input(Place::line(path, line).token(word), what, remedy);
    }
    let what = if is_empty {
        "the file is empty"
    } else if other.iter().any(|&note| notes.of(note) > 0) {
        "the model has no faces, only lines, points or free-form curves"
    } else if !vertices.positions.is_empty() {
        "the model has no faces, only vertices"
    } else {
        "the model has no faces and no vertices"
    };
    let remedy = "Give a model with faces (`f`). If this one should have some, get the file again.";
    Error::input(Place::file(path), what, remedy)
}

/// An error of `tobj` that should have been found before, with its line. Here it has no line.
fn slipped(path: &Path, error: tobj::LoadError) -> Error {
    Error::input(
        Place::file(path),
        format!("the model cannot be read: {error}"),
        "Export it again, as plain triangles; and please report this message with the file.",
    )
}
