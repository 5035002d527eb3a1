//! The oracle for scenes with volumes. Between the sorted surfaces of a pixel, the volumes are sampled along the
//! pixel's ray.
//!
//! Lindholm et al. 2015, section 6.1, do this with a list of fragments. Here it is done in f64 and from the camera
//! alone, with a ray through the pixel's centre in world space. The ray enters and leaves each volume where it crosses
//! the volume's proxy box. Surfaces, entries and exits cut the ray into segments. In a segment, all volumes around it
//! are sampled together: their densities add up, and their colours are weighted by the densities.

use glam::DVec3;

use super::under;
use crate::fragment::{Fragment, Rgba};
use crate::scene::{Camera, Medium, Volume};

/// The ray through a pixel's centre.
///
/// Places on the ray are *distances*: lengths along the view direction, with the near plane at `near` and the far plane
/// at `far`. Towards the image's borders, the ray itself is longer than these.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The eye, in the world.
    pub origin: DVec3,
    /// The vector along the ray for a distance of 1. Its length is 1 in the image's middle and greater elsewhere.
    pub direction: DVec3,
    /// The distance at which the ray begins.
    pub near: f64,
    /// The distance at which the ray ends at the latest.
    pub far: f64,
}

impl Ray {
    /// The ray through the centre of the pixel in column `x` from the left and row `y` from the bottom.
    pub fn through(camera: &Camera, [width, height]: [u32; 2], [x, y]: [u32; 2]) -> Self {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let up = right.cross(forward);
        let [width, height] = [width, height].map(f64::from);
        let half = (camera.fov.to_radians() / 2.0).tan();
        let aside = (2.0 * (f64::from(x) + 0.5) / width - 1.0) * half * width / height;
        let above = (2.0 * (f64::from(y) + 0.5) / height - 1.0) * half;
        Self {
            origin: camera.eye,
            direction: forward + right * aside + up * above,
            near: camera.near,
            far: camera.far,
        }
    }

    /// The distance of a window-space depth, 0 to 1.
    pub fn distance(&self, depth: f32) -> f64 {
        let Self { near, far, .. } = *self;
        near * far / (far - f64::from(depth) * (far - near))
    }
}

/// Composites the fragments of one pixel, and the light of volumes between them, over an opaque background, in f64.
///
/// Fragments are sorted, and left out at and behind `opaque_depth`, as by [`composite`](super::composite). Volumes are
/// sampled from the ray's beginning to the distance of `opaque_depth`, even if the ray begins or ends inside of them.
///
/// A segment is sampled in steps of the smallest [`Volume::sampling_distance`] of the volumes around it. The last step
/// ends at the segment's end. The middle of a step gives its colour and density, and its length the opacity, 1 -
/// exp(-density x length).
pub fn composite(
    fragments: &mut Vec<Fragment>,
    opaque_depth: f32,
    background: Rgba,
    ray: &Ray,
    volumes: &[Volume],
) -> [f64; 4] {
    fragments.retain(|fragment| fragment.depth < opaque_depth);
    fragments.sort_by(|a, b| a.depth.total_cmp(&b.depth).then(a.order.cmp(&b.order)));
    let surfaces = fragments
        .iter()
        .map(|fragment| (ray.distance(fragment.depth), fragment.color));
    composite_between(
        surfaces,
        ray.distance(opaque_depth),
        background,
        ray,
        volumes,
        &mut |_| {},
    )
}

/// A part of a ray between two events, in which it is inside of some volumes.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// The distances at which it begins and ends.
    pub distances: [f64; 2],
    /// The volumes' numbers in the scene.
    pub volumes: Vec<usize>,
    /// The light that the pixel has from it.
    pub light: [f64; 3],
    /// The part of the light that comes to the eye from behind the segments before it, and that it stops.
    pub stopped: f64,
}

/// The same with sorted surfaces, nearest first, each with its distance, and with an opaque background at the distance
/// `end`.
pub(super) fn composite_between(
    surfaces: impl Iterator<Item = (f64, Rgba)>,
    end: f64,
    background: Rgba,
    ray: &Ray,
    volumes: &[Volume],
    told: &mut dyn FnMut(Segment),
) -> [f64; 4] {
    let crossings = volumes.iter().enumerate();
    let crossings: Vec<_> = crossings
        .filter_map(|(number, volume)| Crossing::of(ray, end, number, volume))
        .collect();
    let mut seen = Seen {
        image: [0.0; 3],
        visible: 1.0,
    };
    let mut inside = vec![false; crossings.len()];
    let mut at = ray.near;
    for (distance, event) in events(surfaces, &crossings) {
        let occupied = crossings.iter().zip(&inside).filter(|(_, inside)| **inside);
        let occupied: Vec<_> = occupied.map(|(crossing, _)| crossing).collect();
        let before = (seen.image, seen.visible);
        seen.cast(ray, [at, distance], occupied.iter().copied());
        if !occupied.is_empty() && at < distance {
            told(Segment {
                distances: [at, distance],
                volumes: occupied.iter().map(|crossing| crossing.number).collect(),
                light: std::array::from_fn(|channel| seen.image[channel] - before.0[channel]),
                stopped: before.1 - seen.visible,
            });
        }
        at = distance;
        match event {
            Event::Surface(color) => under(&mut seen.image, &mut seen.visible, color),
            Event::Enter(volume) => inside[volume] = true,
            Event::Leave(volume) => inside[volume] = false,
        }
    }
    under(&mut seen.image, &mut seen.visible, background);
    let [r, g, b] = seen.image;
    [r, g, b, 1.0 - seen.visible]
}

/// An event on a ray at some distance.
#[derive(Clone, Copy)]
enum Event {
    Surface(Rgba),
    /// The ray enters the volume of a crossing.
    Enter(usize),
    Leave(usize),
}

/// All events, nearest first. Surfaces of equal depth stay in their order.
fn events(
    surfaces: impl Iterator<Item = (f64, Rgba)>,
    crossings: &[Crossing],
) -> Vec<(f64, Event)> {
    let surfaces = surfaces.map(|(distance, color)| (distance, Event::Surface(color)));
    let crossed = crossings.iter().enumerate();
    let proxies = crossed.flat_map(|(i, crossing)| {
        [
            (crossing.enter, Event::Enter(i)),
            (crossing.leave, Event::Leave(i)),
        ]
    });
    let mut events: Vec<_> = surfaces.chain(proxies).collect();
    events.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    events
}

/// A volume, and the distances between which a ray is inside of it.
struct Crossing<'v> {
    /// The volume's number in the scene.
    number: usize,
    volume: &'v Volume,
    /// The ray, in the volume's indices.
    origin: DVec3,
    direction: DVec3,
    enter: f64,
    leave: f64,
}

impl<'v> Crossing<'v> {
    /// The crossing of a ray, from its beginning to `end`, with a volume: the part between the planes of all three
    /// pairs of faces. `None` if there is no such part.
    fn of(ray: &Ray, end: f64, number: usize, volume: &'v Volume) -> Option<Self> {
        let to_index = volume.world_to_index();
        let origin = to_index.transform_point3(ray.origin);
        let direction = to_index.transform_vector3(ray.direction);
        let last = volume.last();
        let (mut enter, mut leave) = (ray.near, end);
        for axis in 0..3 {
            if direction[axis] == 0.0 {
                if !(0.0..=last[axis]).contains(&origin[axis]) {
                    return None;
                }
                continue;
            }
            let first = -origin[axis] / direction[axis];
            let second = (last[axis] - origin[axis]) / direction[axis];
            enter = enter.max(first.min(second));
            leave = leave.min(first.max(second));
        }
        (enter < leave).then_some(Self {
            number,
            volume,
            origin,
            direction,
            enter,
            leave,
        })
    }

    fn medium(&self, distance: f64) -> Medium {
        let index = self.origin + self.direction * distance;
        self.volume.transfer.at(self.volume.at_index(index))
    }
}

/// The light composited so far, and the part of the light behind it that it lets through.
struct Seen {
    image: [f64; 3],
    visible: f64,
}

impl Seen {
    /// Samples a segment of the ray.
    fn cast<'c, 'v: 'c>(
        &mut self,
        ray: &Ray,
        [from, to]: [f64; 2],
        occupied: impl Iterator<Item = &'c Crossing<'v>> + Clone,
    ) {
        let distances = occupied
            .clone()
            .map(|crossing| crossing.volume.sampling_distance());
        let Some(step) = distances.reduce(f64::min) else {
            return;
        };
        let scale = ray.direction.length();
        let length = (to - from) * scale;
        let steps = (length / step).ceil() as u64;
        for number in 0..steps {
            let begin = number as f64 * step;
            let end = (begin + step).min(length);
            let middle = from + (begin + end) / (2.0 * scale);
            self.add(
                end - begin,
                occupied.clone().map(|crossing| crossing.medium(middle)),
            );
        }
    }

    /// Puts a length of several mixed media under the light so far.
    fn add(&mut self, length: f64, media: impl Iterator<Item = Medium>) {
        let (mut density, mut color) = (0.0, DVec3::ZERO);
        for medium in media {
            density += medium.density;
            color += medium.color * medium.density;
        }
        if density == 0.0 {
            return;
        }
        let opacity = -(-density * length).exp_m1();
        let light = color * (self.visible * opacity / density);
        for (channel, light) in self.image.iter_mut().zip(light.to_array()) {
            *channel += light;
        }
        self.visible *= 1.0 - opacity;
    }
}
