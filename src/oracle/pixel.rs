//! The exact colour of one pixel: every triangle that covers it, sorted by where the ray meets it, composited in f64.
//!
//! Surfaces in one plane have the same distance, whatever their corners are. Among them, as everywhere in onionskin,
//! the one submitted first lies in front, and an opaque surface hides what lies exactly on it. A ray may pass beside
//! two triangles and meet the same point of an edge of both. Then geometry does not say which triangle is in front, and
//! the driver's depth decides, which is computed from the moved corners.

use std::cmp::Ordering;

use super::coplanar::coplanar;
use super::surfaces::{Meeting, Surfaces};
use super::volumes::{self, Ray, Segment};
use super::{DepthBuffer, under};
use crate::fragment::Rgba;
use crate::scene::Volume;

/// A triangle that covers a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Covering {
    /// The triangle's place in the order of submission.
    pub triangle: u32,
    /// The driver's window-space depth.
    pub depth: f32,
    /// The colour, with straight alpha.
    pub color: Rgba,
}

/// A triangle that covers a pixel, with its distance on the ray.
#[derive(Clone, Copy, Debug)]
pub struct Located {
    /// The triangle that covers the pixel.
    pub covering: Covering,
    /// The point where the ray meets it.
    pub at: Meeting,
    /// Whether the triangle's mesh is opaque.
    pub opaque: bool,
}

/// If inverse distances differ by less than this part, the triangles may lie in one plane, and [`coplanar`] decides.
/// The part is far more than the rounding, so that no pair is missed.
const NEARLY_EQUAL: f64 = 1e-7;

/// Finds the triangles that cover a pixel on its ray, and sorts them, the nearest first.
pub fn sorted(surfaces: &Surfaces<'_>, pixel: [u32; 2], covering: &[Covering]) -> Vec<Located> {
    let mut list: Vec<Located> = covering
        .iter()
        .map(|&covering| Located {
            covering,
            at: surfaces.meeting(pixel, covering.triangle),
            opaque: surfaces.mesh(covering.triangle).opaque,
        })
        .collect();
    list.sort_unstable_by(by_place);
    if join_coplanar(surfaces, &mut list) {
        list.sort_unstable_by(by_place);
    }
    let equally_far = |a: &Located, b: &Located| a.at.inverse == b.at.inverse;
    for run in list.chunk_by_mut(equally_far) {
        if run.len() > 1 && run.iter().any(|located| located.at.beside) {
            run.sort_unstable_by(|a, b| {
                let depths = a.covering.depth.total_cmp(&b.covering.depth);
                depths.then(a.covering.triangle.cmp(&b.covering.triangle))
            });
        }
    }
    list
}

/// The order by distance, then by order of submission.
fn by_place(a: &Located, b: &Located) -> Ordering {
    let nearer = b.at.inverse.total_cmp(&a.at.inverse);
    nearer.then(a.covering.triangle.cmp(&b.covering.triangle))
}

/// Gives triangles in one plane the same distance. Returns whether any distance has changed.
fn join_coplanar(surfaces: &Surfaces<'_>, list: &mut [Located]) -> bool {
    let mut changed = false;
    for first in 0..list.len() {
        let place = list[first].at.inverse;
        let corners = |located: &Located| {
            surfaces
                .corners(located.covering.triangle)
                .map(|corner| corner.position)
        };
        for second in first + 1..list.len() {
            let other = list[second].at.inverse;
            if place - other > NEARLY_EQUAL * place.abs() {
                break;
            }
            if other != place && coplanar(corners(&list[first]), corners(&list[second])) {
                list[second].at.inverse = place;
                changed = true;
            }
        }
    }
    changed
}

/// The visible part of a sorted list: the transparent surfaces before the nearest opaque one, and the opaque one.
pub struct Visible<'l> {
    /// The transparent surfaces, nearest first.
    pub transparent: Vec<&'l Located>,
    /// The opaque surface, which hides the rest.
    pub opaque: Option<&'l Located>,
}

impl<'l> Visible<'l> {
    /// The visible part of a list that [`sorted`] made.
    pub fn of(list: &'l [Located]) -> Self {
        let opaque = list.iter().position(|located| located.opaque);
        let before = &list[..opaque.unwrap_or(list.len())];
        let opaque = opaque.map(|place| &list[place]);
        // A surface exactly on the opaque surface that comes before it was submitted earlier, or the driver's depth put
        // it first.
        let hidden = |located: &Located| {
            opaque.is_some_and(|opaque| {
                let apart = located.at.beside || opaque.at.beside;
                let on_it = if apart {
                    located.covering.depth >= opaque.covering.depth
                } else {
                    true
                };
                located.at.inverse == opaque.at.inverse && on_it
            })
        };
        Self {
            transparent: before.iter().filter(|located| !hidden(located)).collect(),
            opaque,
        }
    }

    /// Composites the surfaces over a background, with the light of volumes between them.
    pub fn composite(&self, background: [f32; 3], ray: &Ray, volumes: &[Volume]) -> [f64; 4] {
        self.composite_telling(background, ray, volumes, |_| {})
    }

    /// The same, and tells of each part of the ray that is inside of volumes, nearest first.
    pub fn composite_telling(
        &self,
        background: [f32; 3],
        ray: &Ray,
        volumes: &[Volume],
        mut told: impl FnMut(Segment),
    ) -> [f64; 4] {
        let end = self
            .opaque
            .map_or(ray.far, |opaque| 1.0 / opaque.at.inverse);
        let background = self
            .opaque
            .map_or(Rgba::opaque(background), |opaque| opaque.covering.color);
        let surfaces = self
            .transparent
            .iter()
            .map(|located| (1.0 / located.at.inverse, located.covering.color));
        if volumes.is_empty() {
            let (mut image, mut visible) = ([0.0; 3], 1.0);
            surfaces.for_each(|(_, color)| under(&mut image, &mut visible, color));
            under(&mut image, &mut visible, background);
            return [image[0], image[1], image[2], 1.0 - visible];
        }
        volumes::composite_between(surfaces, end, background, ray, volumes, &mut told)
    }
}

/// Whether the colour of a sorted list depends on a difference that a depth buffer cannot hold. This is so if the
/// buffer may see two neighbours in either order, and the exchange would change a channel by more than `bound`.
///
/// Triangles with the same corners in the same order have the same depth in every buffer, and do not count.
pub fn hangs(surfaces: &Surfaces<'_>, list: &[Located], buffer: &DepthBuffer, bound: f64) -> bool {
    let noise = |located: &Located| buffer.noise_at(&located.at);
    let noises = list.iter().map(noise);
    let most = noises.fold(0.0, f64::max);
    let mut visible = 1.0;
    for (place, near) in list.iter().enumerate() {
        if visible < bound {
            return false;
        }
        let depth = buffer.depth(near.at.inverse);
        for far in &list[place + 1..] {
            let apart = buffer.depth(far.at.inverse) - depth;
            if apart > noise(near) + most {
                break;
            }
            let may_change_places = apart <= noise(near) + noise(far);
            if may_change_places
                && visible * exchanged(near, far) > bound
                && !same_corners(surfaces, near, far)
            {
                return true;
            }
        }
        if near.opaque {
            return false;
        }
        visible *= 1.0 - f64::from(near.covering.color.a);
    }
    false
}

/// The largest change of a channel if two neighbours are exchanged.
fn exchanged(near: &Located, far: &Located) -> f64 {
    let (a, b) = (near.covering.color, far.covering.color);
    let apart = [a.r - b.r, a.g - b.g, a.b - b.b];
    let apart = apart.iter().fold(0.0_f32, |most, d| most.max(d.abs()));
    // An opaque surface hides the other one, two transparent surfaces mix.
    let alpha = |located: &Located| match located.opaque {
        true => 1.0,
        false => f64::from(located.covering.color.a),
    };
    f64::from(apart) * alpha(near) * alpha(far)
}

fn same_corners(surfaces: &Surfaces<'_>, a: &Located, b: &Located) -> bool {
    let places = |located: &Located| {
        surfaces
            .corners(located.covering.triangle)
            .map(|corner| corner.position)
    };
    places(a) == places(b)
}
