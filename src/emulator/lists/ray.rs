//! The ray through a pixel, cast between the fragments of the pixel's list (Lindholm et al. 2015, section 6.1), in f64.

use std::fmt;

use crate::emulator::settings;
use crate::fragment::{Fragment, Source};
use crate::scene::Medium;
use crate::steps::pseudo::list::{Beginning, SegmentEnd};

/// The surroundings of a pixel's ray.
///
/// Places on the ray are distances along the view direction. The ray's own length is `slant` times that.
pub struct RayScene<'m> {
    /// The distances of the near and the far plane.
    pub planes: [f64; 2],
    /// Whether depths are 1/w, and not window-space depths.
    pub inverse_w: bool,
    /// The ray's length over a distance of 1, 1 or more.
    pub slant: f64,
    /// The opaque surface's depth, or 1 if there is none.
    pub opaque: f32,
    /// The volumes, by their numbers.
    pub volumes: Vec<RayVolume<'m>>,
}

/// A volume along a ray.
pub struct RayVolume<'m> {
    /// The volume's colour and density at a distance.
    pub medium: &'m dyn Fn(f64) -> Medium,
    /// The volume's sampling distance, in world units.
    pub step: f64,
}

/// The result of a ray.
#[derive(Clone, Debug, PartialEq)]
pub struct RayRun {
    /// The ray's light, and the part of the light behind it that comes through.
    pub light: [f64; 3],
    /// 1 for a ray that met nothing.
    pub transparency: f64,
    /// The events on the ray, front to back.
    pub events: Vec<RayEvent>,
}

/// An event on a ray, and the state after it.
#[derive(Clone, Debug, PartialEq)]
pub struct RayEvent {
    /// The kind of event.
    pub what: RayHappening,
    /// The ray's position at the event.
    pub distance: f64,
    /// The volumes around the ray after the event, as a bitmask.
    pub occupancy: u32,
    /// The part of the light behind that still comes through.
    pub transparency: f64,
}

/// The kinds of events on a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayHappening {
    /// The ray begins at the near plane.
    Begins,
    /// The ray is cast through volumes, in so many samples.
    IsCast(u64),
    /// The ray meets a face of this volume's box.
    Toggles(u32),
    /// The ray meets the surface with this id.
    Blends(u32),
}

impl fmt::Display for RayRun {
    /// Prints one line per event.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "  {:<26} distance  occupancy  transparency", "the ray")?;
        for event in &self.events {
            let what = match event.what {
                RayHappening::Begins => "begins".to_owned(),
                RayHappening::IsCast(1) => "is cast, 1 sample".to_owned(),
                RayHappening::IsCast(count) => format!("is cast, {count} samples"),
                RayHappening::Toggles(volume) => format!("crosses a face of volume {volume}"),
                RayHappening::Blends(surface) => format!("meets surface {surface}"),
            };
            let (distance, occupancy) = (event.distance, event.occupancy);
            let transparency = event.transparency;
            writeln!(
                f,
                "  {what:<26} {distance:<8.4}  {occupancy:<9b}  {transparency:.4}"
            )?;
        }
        Ok(())
    }
}

/// The state that is kept between subpasses.
pub(super) struct Ray<'a> {
    scene: &'a RayScene<'a>,
    occupancy: u32,
    position: f64,
    pub(super) done: RayRun,
}

impl<'a> Ray<'a> {
    pub(super) fn new(scene: &'a RayScene<'a>) -> Self {
        Self {
            scene,
            occupancy: 0,
            position: scene.planes[0],
            done: RayRun {
                light: [0.0; 3],
                transparency: 1.0,
                events: Vec::new(),
            },
        }
    }

    /// The state at the near plane.
    pub(super) fn begin(&mut self, beginning: Beginning, list: &[Fragment]) {
        self.position = self.scene.planes[0];
        let (mut entered, mut left) = (0, 0);
        for fragment in list {
            match Source::of(fragment.order) {
                Source::Proxy { volume, leaves } if leaves => left |= 1 << volume,
                Source::Proxy { volume, .. } => entered |= 1 << volume,
                Source::Surface(_) => {}
            }
        }
        self.occupancy = match beginning {
            Beginning::Outside => 0,
            Beginning::WhatIsOnlyLeft => left & !entered,
        };
        self.record(RayHappening::Begins);
    }

    /// Casts the ray to a fragment's depth. Steps have the smallest sampling distance, and the last step ends at the
    /// segment's end. The middle of a step gives its colour and density.
    pub(super) fn cast(&mut self, end: SegmentEnd, fragment: Fragment) {
        let depth = match end {
            SegmentEnd::Fragment => fragment.depth,
            SegmentEnd::FragmentOrOpaque => fragment.depth.min(self.scene.opaque),
        };
        let (from, to) = (self.position, self.distance(depth).max(self.position));
        let volumes = self.scene.volumes.iter().enumerate();
        let inside: Vec<_> = volumes
            .filter(|(number, _)| self.occupancy >> number & 1 != 0)
            .map(|(_, volume)| volume)
            .collect();
        let step = inside.iter().map(|volume| volume.step).reduce(f64::min);
        if let Some(step) = step.filter(|_| to > from) {
            let length = (to - from) * self.scene.slant;
            let samples = (length / step).ceil() as u64;
            for number in 0..samples {
                let begin = number as f64 * step;
                let end = (begin + step).min(length);
                let middle = from + (begin + end) / (2.0 * self.scene.slant);
                let media = inside.iter().map(|volume| (volume.medium)(middle));
                self.pass(media, end - begin);
            }
            self.position = to;
            self.record(RayHappening::IsCast(samples));
        }
        self.position = to;
    }

    pub(super) fn toggle(&mut self, fragment: Fragment) {
        if let Source::Proxy { volume, .. } = Source::of(fragment.order) {
            self.occupancy ^= 1 << volume;
            self.record(RayHappening::Toggles(volume));
        }
    }

    pub(super) fn blend(&mut self, fragment: Fragment) {
        let [r, g, b, a] = fragment.color.to_array().map(f64::from);
        self.add([r, g, b], a);
        self.record(RayHappening::Blends(fragment.order));
    }

    fn record(&mut self, what: RayHappening) {
        self.done.events.push(RayEvent {
            what,
            distance: self.position,
            occupancy: self.occupancy,
            transparency: self.done.transparency,
        });
    }

    fn pass(&mut self, media: impl Iterator<Item = Medium>, length: f64) {
        let (mut density, mut light) = (0.0, [0.0; 3]);
        for medium in media {
            density += medium.density;
            for (light, color) in light.iter_mut().zip(medium.color.to_array()) {
                *light += medium.density * color;
            }
        }
        if density > 0.0 {
            let color = light.map(|channel| channel / density);
            self.add(color, -(-density * length).exp_m1());
        }
    }

    fn add(&mut self, color: [f64; 3], opacity: f64) {
        for (light, color) in self.done.light.iter_mut().zip(color) {
            *light += self.done.transparency * opacity * color;
        }
        self.done.transparency *= 1.0 - opacity;
    }

    fn distance(&self, depth: f32) -> f64 {
        settings::distance(self.scene.planes, self.scene.inverse_w, depth)
    }
}
