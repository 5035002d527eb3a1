//! Scenes without what no pixel sees.

use glam::DVec2;
use onionskin::low_level::scene::Mesh;
use onionskin::{Scene, Vertex};

/// OpenGL rounds corners to fractions of a pixel, and no coarser ones than this.
const SLACK: f64 = 1.0 / 64.0;

/// The scene at its size without the triangles that cover no pixel's centre. They have no fragment, and only cost time: of
/// a detailed scene in a small image they are nearly all. The others stay in their order.
pub fn sampled(scene: &Scene) -> Scene {
    let [width, height] = scene.size;
    let size = DVec2::new(f64::from(width), f64::from(height));
    let place = places(scene);
    let seen = |mesh: &Mesh, triangle| {
        let [a, b, c] = mesh.corners(triangle).map(&place);
        // What reaches behind the eye may be anywhere.
        let corners = a.zip(b).zip(c);
        corners.is_none_or(|((a, b), c)| centres([a, b, c], size).next().is_some())
    };
    let mut sampled = scene.clone();
    for mesh in &mut sampled.meshes {
        let all = (0..mesh.triangle_count()).filter(|&triangle| seen(mesh, triangle));
        mesh.triangles = all.map(|triangle| mesh.triangles[triangle]).collect();
        leave_out_unused_vertices(mesh);
    }
    sampled
}

/// Where a vertex is seen in an image of the scene's size, in pixels from the lower left. `None` behind the eye.
pub fn places(scene: &Scene) -> impl Fn(Vertex) -> Option<DVec2> {
    let [width, height] = scene.size;
    let to_clip = scene.camera.projection(width, height) * scene.camera.view();
    let size = DVec2::new(f64::from(width), f64::from(height));
    move |corner| {
        let clip = to_clip * corner.position.extend(1.0);
        (clip.w > 0.0).then(|| (clip.truncate().truncate() / clip.w + 1.0) / 2.0 * size)
    }
}

/// The pixels whose centres lie in the triangle, or so near to it that OpenGL may see them there. Corners are in pixels, and
/// may be in either order; an image has `size` pixels.
pub fn centres(
    [a, mut b, mut c]: [DVec2; 3],
    size: DVec2,
) -> impl Iterator<Item = [u32; 2]> + Clone {
    if (b - a).perp_dot(c - a) < 0.0 {
        (b, c) = (c, b);
    }
    let low = a.min(b).min(c) - 0.5 - SLACK;
    let high = a.max(b).max(c) - 0.5 + SLACK;
    let from = low.ceil().max(DVec2::ZERO).as_ivec2();
    let to = high.floor().min(size - 1.0).as_ivec2();
    let holds = move |&[x, y]: &[u32; 2]| {
        let centre = DVec2::new(f64::from(x), f64::from(y)) + 0.5;
        let inside = |begin: DVec2, end: DVec2| {
            (end - begin).normalize_or_zero().perp_dot(centre - begin) >= -SLACK
        };
        inside(a, b) && inside(b, c) && inside(c, a)
    };
    let rows = from.y..=to.y;
    rows.flat_map(move |y| (from.x..=to.x).map(move |x| [x as u32, y as u32]))
        .filter(holds)
}

fn leave_out_unused_vertices(mesh: &mut Mesh) {
    let mut places = vec![None; mesh.vertices.len()];
    let mut vertices = Vec::new();
    for corner in mesh.triangles.iter_mut().flatten() {
        let at = *corner as usize;
        *corner = *places[at].get_or_insert_with(|| {
            vertices.push(mesh.vertices[at]);
            vertices.len() as u32 - 1
        });
    }
    mesh.vertices = vertices;
}
