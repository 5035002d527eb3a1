//! What slices through a scene's volumes make of its image, in f64: planes across the view, met by the rays through the
//! pixels' centres, composited back to front. It shares no code with the stack, the shaders or the driver.

use glam::{DMat3, DVec3};
use onionskin::{Scene, Volume};

use super::cast::{Cast, Hit};
use super::fog::{look, over, ray, value};

/// What can be changed about slices, so that it can be seen to be noticed.
#[derive(Clone, Copy)]
pub struct Rule {
    /// The slice that is left out, counted from the eye.
    pub missing: Option<u32>,
    /// Whether opacity goes by the slab's thickness, and by the ray's slant; otherwise a slice is as opaque as a length of 1.
    pub corrected: bool,
    pub slanted: bool,
    /// Whether what several volumes have at a place is mixed; otherwise it is composited one after the other.
    pub mixed: bool,
}

pub const SLICES: Rule = Rule {
    missing: None,
    corrected: true,
    slanted: true,
    mixed: true,
};

/// Row by row from the top; nothing where a rasteriser may see something else: at the edges of surfaces and slices, and
/// where a surface and a slice are equally far.
pub fn cast_slices(scene: &Scene, hits: &Cast, count: u32, rule: Rule) -> Vec<Option<[f64; 3]>> {
    let [width, _] = scene.size;
    let planes = planes(scene, count);
    let boxes: Vec<_> = scene.volumes.iter().map(Box::of).collect();
    let pixels = hits.pixels.iter().enumerate();
    pixels
        .map(|(pixel, surfaces)| {
            let place = [pixel as u32 % width, pixel as u32 / width];
            let seen = Pixel {
                scene,
                boxes: &boxes,
                planes: &planes,
                surfaces,
            };
            seen.light(place, rule).filter(|_| !hits.doubtful[pixel])
        })
        .collect()
}

/// The distances of the slices, and what is between two of them.
struct Planes {
    distances: Vec<f64>,
    spacing: f64,
}

fn planes(scene: &Scene, count: u32) -> Planes {
    let camera = &scene.camera;
    let forward = (camera.target - camera.eye).normalize();
    let corners = scene.volumes.iter().flat_map(Volume::corners);
    let distances: Vec<f64> = corners.map(|c| (c - camera.eye).dot(forward)).collect();
    let near = distances.iter().copied().fold(camera.far, f64::min);
    let far = distances.iter().copied().fold(camera.near, f64::max);
    let (near, far) = (near.max(camera.near), far.min(camera.far));
    let spacing = (far - near) / f64::from(count);
    let distances = (0..count).map(|i| near + spacing * (0.5 + f64::from(i)));
    Planes {
        distances: distances.collect(),
        spacing,
    }
}

/// A volume's box by its first corner and three edges.
struct Box<'v> {
    volume: &'v Volume,
    corner: DVec3,
    to_edges: DMat3,
}

impl<'v> Box<'v> {
    fn of(volume: &'v Volume) -> Self {
        let [corner, x, y, _, z, ..] = volume.corners();
        let edges = DMat3::from_cols(x - corner, y - corner, z - corner);
        Self {
            volume,
            corner,
            to_edges: edges.inverse(),
        }
    }

    fn holds(&self, point: DVec3) -> bool {
        let at = self.to_edges * (point - self.corner);
        at.min_element() >= 0.0 && at.max_element() <= 1.0
    }
}

struct Pixel<'p> {
    scene: &'p Scene,
    boxes: &'p [Box<'p>],
    planes: &'p Planes,
    surfaces: &'p [Hit],
}

/// As wide as the band along an edge in which a rasteriser may see the other side, in pixels: see `cast.rs`.
const EDGE: f64 = 0.004;

impl Pixel<'_> {
    fn light(&self, place: [u32; 2], rule: Rule) -> Option<[f64; 3]> {
        let mut surfaces = self.surfaces.to_vec();
        surfaces.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order)));
        let opaque = surfaces.iter().position(|hit| hit.color[3] == 1.0);
        let mut light = DVec3::from_array(self.scene.background.map(f64::from));
        let mut end = self.scene.camera.far;
        if let Some(place) = opaque {
            let [r, g, b, _] = surfaces[place].color;
            light = DVec3::new(r, g, b);
            end = self.distance(&surfaces[place]);
            if self.at_a_slice(&surfaces[place]) {
                return None;
            }
            surfaces.truncate(place);
        }
        if surfaces.iter().any(|hit| self.at_a_slice(hit)) {
            return None;
        }
        let toward = ray(self.scene, place);
        let visible = |number: &usize| self.planes.distances[*number] < end;
        for number in (0..self.planes.distances.len()).filter(visible).rev() {
            let distance = self.planes.distances[number];
            while let Some(hit) = surfaces.pop_if(|hit| self.distance(hit) > distance) {
                light = over(hit.color, light);
            }
            let inside = self.inside(place, distance)?;
            if rule.missing != Some(number as u32) {
                light = self.slice(toward, distance, &inside, rule, light);
            }
        }
        while let Some(hit) = surfaces.pop() {
            light = over(hit.color, light);
        }
        Some(light.to_array())
    }

    fn distance(&self, hit: &Hit) -> f64 {
        let (near, far) = (self.scene.camera.near, self.scene.camera.far);
        near / (1.0 - hit.depth * (far - near) / far)
    }

    /// Whether a rasteriser may order them otherwise: 4 last places of an f32 depth near 1, and what an edge's band changes.
    fn at_a_slice(&self, hit: &Hit) -> bool {
        let (near, far) = (self.scene.camera.near, self.scene.camera.far);
        let depth = |distance: f64| far / (far - near) * (1.0 - near / distance);
        let off = hit.slope * EDGE + 4.0 * f64::from(f32::EPSILON);
        let mut planes = self.planes.distances.iter();
        planes.any(|&plane| (depth(plane) - hit.depth).abs() < off)
    }

    /// The boxes around the place at a distance; nothing if they are others an edge's band away.
    fn inside(&self, place: [u32; 2], distance: f64) -> Option<Vec<usize>> {
        let eye = self.scene.camera.eye;
        let middle = ray(self.scene, place);
        let to_right = ray(self.scene, [place[0] + 1, place[1]]) - middle;
        let down = ray(self.scene, [place[0], place[1] + 1]) - middle;
        let around = |aside: f64, below: f64| -> Vec<usize> {
            let point = eye + (middle + to_right * aside + down * below) * distance;
            let numbers = 0..self.boxes.len();
            numbers.filter(|&i| self.boxes[i].holds(point)).collect()
        };
        let here = around(0.0, 0.0);
        let bands = [(EDGE, EDGE), (EDGE, -EDGE), (-EDGE, EDGE), (-EDGE, -EDGE)];
        let same = bands.iter().all(|&(x, y)| around(x, y) == here);
        same.then_some(here)
    }

    fn slice(
        &self,
        toward: DVec3,
        distance: f64,
        inside: &[usize],
        rule: Rule,
        light: DVec3,
    ) -> DVec3 {
        let point = self.scene.camera.eye + toward * distance;
        let thickness = if rule.corrected {
            self.planes.spacing
        } else {
            1.0
        };
        let length = thickness * if rule.slanted { toward.length() } else { 1.0 };
        let media: Vec<_> = inside
            .iter()
            .map(|&i| {
                let volume = self.boxes[i].volume;
                look(&volume.transfer, value(volume, point))
            })
            .collect();
        let through = |color: DVec3, density: f64, light: DVec3| {
            let clear = (-density * length).exp();
            color * (1.0 - clear) + light * clear
        };
        if !rule.mixed {
            let back_to_front = media.into_iter().rev();
            return back_to_front.fold(light, |light, (color, density)| {
                through(color, density, light)
            });
        }
        let density: f64 = media.iter().map(|(_, density)| density).sum();
        if density == 0.0 {
            return light;
        }
        let color: DVec3 = media.iter().map(|(color, density)| *color * *density).sum();
        through(color / density, density, light)
    }
}
