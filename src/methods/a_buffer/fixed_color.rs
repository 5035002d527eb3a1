//! The scenes whose colours records of fixed point hold, which are those from 0 to 1.

use crate::scene::{Scene, Shading};

/// Whether every colour of a scene's transparent surfaces is from 0 to 1.
pub(super) fn holds(scene: &Scene) -> bool {
    let is_one = |channel: f32| (0.0..=1.0).contains(&channel);
    let mut meshes = scene.meshes.iter().filter(|mesh| !mesh.opaque);
    meshes.all(|mesh| {
        let mut colors = mesh.vertices.iter().map(|vertex| vertex.color);
        mesh.shading != Shading::Slice
            && mesh.inside.into_iter().all(is_one)
            && colors.all(|color| color.to_array().into_iter().all(is_one))
    })
}
