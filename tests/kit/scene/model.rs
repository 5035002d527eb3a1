//! OBJ models on the corners of a square, and their colours.

use onionskin::{Mesh, Rgba, Scene};

use super::Folder;

/// The corners of a square in the xy plane, without a face.
pub const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// The model `m.obj` of this content next to `m.mtl` of that content.
pub fn with_materials(model: impl AsRef<[u8]>, materials: impl AsRef<[u8]>) -> Scene {
    Folder::new()
        .with("m.obj", model)
        .with("m.mtl", materials)
        .load("m.obj")
        .unwrap_or_else(|error| panic!("{error}"))
}

/// A triangle of the material `a` of `m.mtl`.
pub fn of_material_a() -> String {
    format!("mtllib m.mtl\n{CORNERS}usemtl a\nf 1 2 3\n")
}

/// The colours of a mesh's vertices.
pub fn colors(mesh: &Mesh) -> Vec<Rgba> {
    mesh.vertices.iter().map(|v| v.color).collect()
}
