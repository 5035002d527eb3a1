//! The points where rays through the pixels' centres meet a scene's triangles, computed in f64 from the camera and the
//! corners alone.
//!
//! A rasteriser's depth has some ten roundings to 32 bits, and it is a hyperbola of the distance. With a near plane at
//! 0.1, two panes 1 cm apart have the same depth at a distance of 100. The order of surfaces must not depend on that.
//! So the oracle takes from the driver only which triangles cover a pixel, and computes their distances itself.
//!
//! Distances are lengths along the view direction, as in [`Ray`](super::volumes::Ray). Their inverses are stored,
//! because on a plane 1/distance is linear in the window.

use glam::DVec3;

use crate::scene::{Camera, Mesh, Scene, Vertex};

/// A scene's triangles in a view.
pub struct Surfaces<'s> {
    scene: &'s Scene,
    window: Window,
    triangles: Vec<Triangle>,
    /// The place of each mesh's first triangle in the order of submission.
    firsts: Vec<u32>,
}

/// By how many pixels an edge may be moved when its corners are snapped to a grid of 1/256 pixel.
pub const SNAP: f64 = std::f64::consts::FRAC_1_SQRT_2 / 256.0;

/// The point where a ray meets a triangle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Meeting {
    /// 1 / distance.
    pub inverse: f64,
    /// The change of `inverse` from pixel to pixel, along x and y together.
    pub slope: f64,
    /// By how much a rasteriser's `inverse` may be off because of the triangle's shape.
    pub error: f64,
    /// Whether the ray passes beside the triangle. This happens if the driver, which snaps corners to a grid, has moved
    /// an edge over the pixel's centre. `inverse` is then that of the nearest point of the triangle's outline.
    pub beside: bool,
}

impl<'s> Surfaces<'s> {
    /// The triangles of all meshes, in the order of submission, in an image of `size` pixels.
    pub fn of(scene: &'s Scene, size: [u32; 2]) -> Self {
        let window = Window::of(&scene.camera, size);
        let mut triangles = Vec::with_capacity(scene.triangle_count());
        let mut firsts = Vec::with_capacity(scene.meshes.len());
        for mesh in &scene.meshes {
            firsts.push(triangles.len() as u32);
            let seen = (0..mesh.triangle_count()).map(|number| {
                let corners = mesh
                    .corners(number)
                    .map(|corner| window.seen(corner.position));
                Triangle::of(corners)
            });
            triangles.extend(seen);
        }
        Self {
            scene,
            window,
            triangles,
            firsts,
        }
    }

    /// The point where the ray through a pixel's centre meets a triangle that covers the pixel. The pixel is in column
    /// `x` from the left and row `y` from the bottom. The triangle is given by its place in the order of submission.
    pub fn meeting(&self, [x, y]: [u32; 2], triangle: u32) -> Meeting {
        let triangle = &self.triangles[triangle as usize];
        let at = self.window.toward(x, y);
        let [along_x, along_y, _] = triangle.inverse;
        let slope = (along_x * self.window.step[0]).abs() + (along_y * self.window.step[1]).abs();
        let (inverse, beside) = match triangle.outline {
            Some(outline) => match beside(&outline, at) {
                Some(inverse) => (inverse, true),
                None => (
                    triangle.inverse_at(at).clamp(triangle.least, triangle.most),
                    false,
                ),
            },
            None => (triangle.inverse_at(at), false),
        };
        // Beside the triangle, the rasteriser goes on along its plane.
        let moved = if beside { slope * SNAP } else { 0.0 };
        Meeting {
            inverse,
            slope,
            error: triangle.error + moved,
            beside,
        }
    }

    /// The mesh of a triangle, which is given by its place in the order of submission.
    pub fn mesh(&self, triangle: u32) -> &'s Mesh {
        &self.scene.meshes[self.mesh_of(triangle)]
    }

    /// The corners of a triangle.
    pub fn corners(&self, triangle: u32) -> [Vertex; 3] {
        let mesh = self.mesh_of(triangle);
        self.scene.meshes[mesh].corners((triangle - self.firsts[mesh]) as usize)
    }

    fn mesh_of(&self, triangle: u32) -> usize {
        // Meshes without triangles begin at the same place as the next mesh. The last of them has the triangle.
        self.firsts.partition_point(|&first| first <= triangle) - 1
    }
}

/// The camera's axes, and the place of pixels in them: right and up on the plane at distance 1.
struct Window {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// The place of the lower left corner, and the step to the next pixel.
    corner: [f64; 2],
    step: [f64; 2],
}

impl Window {
    fn of(camera: &Camera, [width, height]: [u32; 2]) -> Self {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let half = (camera.fov.to_radians() / 2.0).tan();
        let (width, height) = (f64::from(width), f64::from(height));
        Self {
            eye: camera.eye,
            right,
            up: right.cross(forward),
            forward,
            corner: [-half * width / height, -half],
            step: [2.0 * half / height; 2],
        }
    }

    /// The coordinates of a point: right, up and forward of the eye.
    fn seen(&self, position: DVec3) -> DVec3 {
        let from_eye = position - self.eye;
        DVec3::new(
            from_eye.dot(self.right),
            from_eye.dot(self.up),
            from_eye.dot(self.forward),
        )
    }

    fn toward(&self, x: u32, y: u32) -> [f64; 2] {
        [
            self.corner[0] + (f64::from(x) + 0.5) * self.step[0],
            self.corner[1] + (f64::from(y) + 0.5) * self.step[1],
        ]
    }
}

/// A corner in the window, and the inverse of its distance.
type Corner = [f64; 3];

struct Triangle {
    /// The vector whose product with (x, y, 1) is 1 / distance.
    inverse: [f64; 3],
    /// The corners in the window, or `None` if one is not before the eye.
    outline: Option<[Corner; 3]>,
    /// By how much 1 / distance may be off if the plane is computed from the corners in f32.
    error: f64,
    /// The least and the greatest 1 / distance of a corner.
    least: f64,
    most: f64,
}

impl Triangle {
    fn of(corners: [DVec3; 3]) -> Self {
        let [a, b, c] = corners;
        let normal = (b - a).cross(c - a);
        // A plane has the points p with n.p = n.a. On the ray t (x, y, 1) this gives 1/t = n.(x, y, 1) / n.a.
        let [x, y, z] = (normal / normal.dot(a)).to_array();
        let outline = corners.iter().all(|corner| corner.z > 0.0).then(|| {
            corners.map(|corner| [corner.x / corner.z, corner.y / corner.z, 1.0 / corner.z])
        });
        let inverses = corners.map(|corner| 1.0 / corner.z);
        let most = inverses.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let least = inverses.into_iter().fold(f64::INFINITY, f64::min);
        // Exactly edge-on, a triangle covers nothing, except what snapping makes of it. Its nearest corner will do.
        let inverse = if x.is_finite() && y.is_finite() && z.is_finite() {
            [x, y, z]
        } else {
            [0.0, 0.0, most]
        };
        Self {
            inverse,
            error: outline.map_or(0.0, |outline| interpolation_error(&outline)),
            outline,
            least,
            most,
        }
    }

    fn inverse_at(&self, [x, y]: [f64; 2]) -> f64 {
        self.inverse[0] * x + self.inverse[1] * y + self.inverse[2]
    }
}

/// By how much a value in a triangle may be off if its change along x and along y is computed in f32. A corner is a place in
/// the image, and the value there, such as 1 / distance.
///
/// Both are differences of two products, of an edge's change of the value and another edge's length along the other axis,
/// divided by twice the area, which is such a difference, too. Each product has three roundings of 2^-24. In a sliver across
/// the axes the products are far larger than their differences, by the ratio of its box to its area.
pub(crate) fn interpolation_error(outline: &[[f64; 3]; 3]) -> f64 {
    let extent = |axis: usize| {
        let values = outline.map(|corner| corner[axis]);
        let most = values.into_iter().fold(f64::NEG_INFINITY, f64::max);
        most - values.into_iter().fold(f64::INFINITY, f64::min)
    };
    let [a, b, c] = *outline;
    let twice_the_area = side(a, b, [c[0], c[1]]).abs();
    let products = extent(2) * extent(0) * extent(1);
    // Two products for x, two for y, two for the area.
    let error = 6.0 * 3.0 * 2.0_f64.powi(-24) * products / twice_the_area;
    // An edge-on triangle in one plane with the eye has no box, or no area.
    if error.is_nan() { 0.0 } else { error }
}

/// The 1 / distance at the outline's nearest point, or `None` if the place is inside of the outline.
fn beside(outline: &[Corner; 3], at: [f64; 2]) -> Option<f64> {
    let edges = [0, 1, 2].map(|i| directed(outline[i], outline[(i + 1) % 3]));
    // The side of each edge on which the place is, for either orientation of the corners.
    let sides = [0, 1, 2].map(|i| side(outline[i], outline[(i + 1) % 3], at));
    let inside = sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0);
    if inside {
        return None;
    }
    edges
        .map(|edge| nearest(edge, at))
        .into_iter()
        .min_by(|(a, _), (b, _)| a.total_cmp(b))
        .map(|(_, inverse)| inverse)
}

/// An edge. The order of its corners does not depend on the triangle, so that two triangles with a common edge agree on
/// every point of it to the last bit.
fn directed(a: Corner, b: Corner) -> [Corner; 2] {
    let order = |corner: Corner| corner.map(f64::to_bits);
    if order(a) <= order(b) { [a, b] } else { [b, a] }
}

fn side([ax, ay, _]: Corner, [bx, by, _]: Corner, [x, y]: [f64; 2]) -> f64 {
    (bx - ax) * (y - ay) - (by - ay) * (x - ax)
}

/// The squared distance of the nearest point of an edge, and the point's 1 / distance.
fn nearest([[ax, ay, a], [bx, by, b]]: [Corner; 2], [x, y]: [f64; 2]) -> (f64, f64) {
    let (dx, dy) = (bx - ax, by - ay);
    let length = dx * dx + dy * dy;
    let part = if length > 0.0 {
        (((x - ax) * dx + (y - ay) * dy) / length).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let (off_x, off_y) = (ax + part * dx - x, ay + part * dy - y);
    (off_x * off_x + off_y * off_y, a + part * (b - a))
}
