//! A ray caster in f64: what should be at each pixel, by geometry alone. It shares no code with the camera, the upload,
//! the shaders or the driver.

use glam::{DVec2, DVec3};
use onionskin::{Mesh, Scene, Shading};

/// A surface that a pixel's ray meets.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Place of its triangle in the order of submission.
    pub order: u32,
    pub depth: f64,
    /// How much the depth changes from pixel to pixel, along x and y together.
    pub slope: f64,
    /// Straight alpha.
    pub color: [f64; 4],
    /// How much the channel that changes most does so from pixel to pixel, along x and y together.
    pub color_slope: f64,
    /// Whether its triangle is seen counter-clockwise.
    pub front: bool,
}

/// What the rays through all pixels' centres meet.
#[derive(Clone, Debug)]
pub struct Cast {
    /// Row by row from the top, in the order of submission.
    pub pixels: Vec<Vec<Hit>>,
    /// Whether an edge passes so near to the centre that another arithmetic may see it on the other side.
    pub doubtful: Vec<bool>,
}

/// Rasterisers snap corners to a grid, of at least 1/256 of a pixel on every driver that is tested: a corner moves by at
/// most half of that in x and in y, so that an edge moves by at most sqrt(2)/512 = 0.0028 of a pixel; the rest is for f32.
const EDGE: f64 = 0.004;

/// The camera, from its definition.
struct View {
    eye: DVec3,
    right: DVec3,
    up: DVec3,
    forward: DVec3,
    /// Half the image's extent at distance 1.
    half: DVec2,
    near: f64,
    far: f64,
    size: DVec2,
}

impl View {
    fn of(scene: &Scene) -> Self {
        let camera = &scene.camera;
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let size = DVec2::new(f64::from(scene.size[0]), f64::from(scene.size[1]));
        let half = (camera.fov.to_radians() / 2.0).tan();
        Self {
            eye: camera.eye,
            right,
            up: right.cross(forward),
            forward,
            half: DVec2::new(half * size.x / size.y, half),
            near: camera.near,
            far: camera.far,
            size,
        }
    }

    /// Column and row from the top left, the first pixel's centre at 0.5, 0.5.
    fn window(&self, point: DVec3) -> DVec2 {
        let seen = point - self.eye;
        let distance = seen.dot(self.forward);
        assert!(distance > 0.0, "nothing here is behind the eye");
        let at = DVec2::new(seen.dot(self.right), -seen.dot(self.up)) / (distance * self.half);
        (at * 0.5 + 0.5) * self.size
    }

    /// Direction of the ray through a place of the window.
    fn ray(&self, at: DVec2) -> DVec3 {
        let at = (at / self.size * 2.0 - 1.0) * self.half;
        self.forward + self.right * at.x - self.up * at.y
    }

    /// 0 at the near plane, 1 at the far plane, and linear in the window.
    fn depth(&self, point: DVec3) -> f64 {
        let distance = (point - self.eye).dot(self.forward);
        self.far / (self.far - self.near) * (1.0 - self.near / distance)
    }
}

/// A triangle, and what it takes to shade it.
struct Triangle<'m> {
    mesh: &'m Mesh,
    number: usize,
    order: u32,
    corners: [DVec3; 3],
    window: [DVec2; 3],
}

impl Triangle<'_> {
    /// Distance of a place to the nearest edge.
    fn edge_distance(&self, at: DVec2) -> f64 {
        let to_edge = |from: usize| {
            let (a, b) = (self.window[from], self.window[(from + 1) % 3]);
            let along = b - a;
            let part = ((at - a).dot(along) / along.length_squared()).clamp(0.0, 1.0);
            (at - a - along * part).length()
        };
        to_edge(0).min(to_edge(1)).min(to_edge(2))
    }

    /// Where a ray from the eye meets its plane, as weights of its corners: all positive inside (Möller and Trumbore's
    /// method).
    fn weights(&self, eye: DVec3, ray: DVec3) -> Option<[f64; 3]> {
        let [a, b, c] = self.corners;
        let (ab, ac) = (b - a, c - a);
        let normal = ray.cross(ac);
        let determinant = ab.dot(normal);
        if determinant == 0.0 {
            return None;
        }
        let from_a = eye - a;
        let second = from_a.dot(normal) / determinant;
        let third = ray.dot(from_a.cross(ab)) / determinant;
        Some([1.0 - second - third, second, third])
    }

    fn hit(&self, view: &View, at: DVec2) -> Option<Hit> {
        let weights = self.weights(view.eye, view.ray(at))?;
        if weights.iter().any(|&weight| weight < 0.0) {
            return None;
        }
        let point = weighted(self.corners, weights);
        let color = self.color(view, weights);
        // By a difference over a small step; a whole one might leave the plane.
        const STEP: f64 = 1.0 / 64.0;
        let change = |aside: DVec2| {
            let weights = self.weights(view.eye, view.ray(at + aside * STEP));
            let there = weights.map_or(color, |weights| self.color(view, weights));
            let channels = (0..4).map(|channel| (there[channel] - color[channel]).abs());
            channels.fold(0.0, f64::max) / STEP
        };
        Some(Hit {
            order: self.order,
            depth: view.depth(point),
            slope: self.slope(view),
            color,
            color_slope: change(DVec2::X) + change(DVec2::Y),
            front: self.is_front(view),
        })
    }

    fn is_front(&self, view: &View) -> bool {
        let [a, b, c] = self.corners;
        (b - a).cross(c - a).dot(view.eye - a) > 0.0
    }

    /// Of the place with these weights.
    fn color(&self, view: &View, weights: [f64; 3]) -> [f64; 4] {
        let vertices = self.mesh.corners(self.number);
        let [mut r, mut g, mut b, a] = std::array::from_fn(|channel| {
            let corners = vertices.iter().zip(weights);
            corners
                .map(|(vertex, weight)| f64::from(vertex.color.to_array()[channel]) * weight)
                .sum::<f64>()
        });
        if self.mesh.shading == Shading::None {
            return [r, g, b, a];
        }
        if self.mesh.shading == Shading::TwoSided && !self.is_front(view) {
            [r, g, b] = self.mesh.inside.map(f64::from);
        }
        let normal = weighted(vertices.map(|vertex| vertex.normal.as_dvec3()), weights);
        let to_eye = view.eye - weighted(self.corners, weights);
        let facing = normal.normalize().dot(to_eye.normalize()).abs();
        let light = 0.25 + 0.75 * facing;
        [r * light, g * light, b * light, a]
    }

    fn slope(&self, view: &View) -> f64 {
        let [a, b, c] = self.window;
        let [za, zb, zc] = self.corners.map(|corner| view.depth(corner));
        let area = (b - a).perp_dot(c - a);
        let x = (zb - za) * (c - a).y - (zc - za) * (b - a).y;
        let y = (zc - za) * (b - a).x - (zb - za) * (c - a).x;
        (x.abs() + y.abs()) / area.abs()
    }
}

fn weighted(values: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    let pairs = values.into_iter().zip(weights);
    pairs.map(|(value, weight)| value * weight).sum()
}

fn triangles<'s>(scene: &'s Scene, view: &View) -> Vec<Triangle<'s>> {
    let mut triangles = Vec::new();
    for mesh in &scene.meshes {
        for number in 0..mesh.triangle_count() {
            let corners = mesh.corners(number).map(|corner| corner.position);
            triangles.push(Triangle {
                mesh,
                number,
                order: triangles.len() as u32,
                corners,
                window: corners.map(|corner| view.window(corner)),
            });
        }
    }
    triangles
}

/// Casts a ray through each pixel's centre.
pub fn cast(scene: &Scene) -> Cast {
    let view = View::of(scene);
    let [width, height] = scene.size;
    let count = (width * height) as usize;
    let mut cast = Cast {
        pixels: vec![Vec::new(); count],
        doubtful: vec![false; count],
    };
    for triangle in triangles(scene, &view) {
        let [a, b, c] = triangle.window;
        let first = (a.min(b).min(c) - 1.0).clamp(DVec2::ZERO, view.size);
        let last = (a.max(b).max(c) + 1.0).clamp(DVec2::ZERO, view.size);
        for row in first.y as u32..last.y as u32 {
            for column in first.x as u32..last.x as u32 {
                let at = DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5);
                let pixel = (row * width + column) as usize;
                if triangle.edge_distance(at) < EDGE {
                    cast.doubtful[pixel] = true;
                } else if let Some(hit) = triangle.hit(&view, at) {
                    cast.pixels[pixel].push(hit);
                }
            }
        }
    }
    cast
}

/// Casts the ray through one pixel's centre at the plane of one triangle, whether inside its edges or not: its depth
/// there, and how much that changes from pixel to pixel.
pub fn depth_of(scene: &Scene, order: u32, [column, row]: [u32; 2]) -> (f64, f64) {
    let view = View::of(scene);
    let triangle = &triangles(scene, &view)[order as usize];
    let ray = view.ray(DVec2::new(f64::from(column) + 0.5, f64::from(row) + 0.5));
    let [a, b, c] = triangle.corners;
    let normal = (b - a).cross(c - a);
    let point = view.eye + ray * ((a - view.eye).dot(normal) / ray.dot(normal));
    (view.depth(point), triangle.slope(&view))
}
