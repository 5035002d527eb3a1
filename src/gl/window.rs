//! The rectangle of the image in which transparent surfaces may be.

use glam::{DMat4, DVec2};

use crate::scene::{Scene, Volume};

/// A rectangle that holds every transparent vertex and every volume. It is two pixels wider than computed, which is
/// more than f32's error. It is the whole image if a vertex lies behind the eye.
pub(super) fn window_of_transparent(
    scene: &Scene,
    view_projection: DMat4,
    [width, height]: [u32; 2],
) -> [i32; 4] {
    let size = DVec2::new(f64::from(width), f64::from(height));
    let (mut low, mut high) = (size, DVec2::ZERO);
    let transparent = scene.meshes.iter().filter(|mesh| !mesh.opaque);
    let vertices = transparent
        .flat_map(|mesh| &mesh.vertices)
        .map(|vertex| vertex.position);
    for position in vertices.chain(scene.volumes.iter().flat_map(Volume::corners)) {
        let clip = view_projection * position.extend(1.0);
        if clip.w <= 0.0 {
            return [0, 0, width as i32, height as i32];
        }
        let window = (clip.truncate().truncate() / clip.w * 0.5 + 0.5) * size;
        (low, high) = (low.min(window), high.max(window));
    }
    let low = (low.floor() - 2.0).clamp(DVec2::ZERO, size);
    let high = (high.ceil() + 2.0).clamp(low, size);
    [
        low.x as i32,
        low.y as i32,
        (high.x - low.x) as i32,
        (high.y - low.y) as i32,
    ]
}
