//! The exact composite of a pixel, by the oracle.

use super::composite::Composite;
use crate::fragment::Rgba;
use crate::gl::CapturedFragment;
use crate::oracle::DepthBuffer;
use crate::oracle::pixel::{Covering, Visible, sorted};
use crate::oracle::surfaces::Surfaces;
use crate::oracle::volumes::{Ray, Segment};
use crate::scene::Scene;

/// What the oracle says of a pixel.
pub(super) struct Exact {
    /// Window-space depths in f64, fragment by fragment.
    pub(super) depths: Vec<f64>,
    /// The transparent fragments in the image.
    pub(super) composite: Composite,
    /// The number of the opaque fragment that is seen.
    pub(super) opaque: Option<u32>,
    /// The parts of the ray that are inside of volumes.
    pub(super) ray: Vec<Segment>,
}

impl Exact {
    /// `fragments` are all of the pixel's, in the order of submission. The pixel is in column `x` from the left and row `y`
    /// from the bottom.
    pub(super) fn of(
        scene: &Scene,
        surfaces: &Surfaces<'_>,
        buffer: &DepthBuffer,
        size: [u32; 2],
        pixel: [u32; 2],
        fragments: &[CapturedFragment],
    ) -> Self {
        let covering: Vec<_> = fragments.iter().map(covering).collect();
        let depths = covering.iter().map(|covering| {
            let meeting = surfaces.meeting(pixel, covering.triangle);
            buffer.depth(meeting.inverse)
        });
        let list = sorted(surfaces, pixel, &covering);
        let visible = Visible::of(&list);
        // A triangle has one fragment at a pixel.
        let number = |triangle: u32| {
            let place = fragments.iter().position(|it| it.order == triangle);
            place.unwrap_or_default() as u32
        };
        let transparent = visible.transparent.iter().map(|located| {
            let covering = located.covering;
            (number(covering.triangle), covering.color)
        });
        let behind = visible
            .opaque
            .map_or(Rgba::opaque(scene.background), |it| it.covering.color);
        let mut composite = Composite::of(transparent, behind);
        let mut segments = Vec::new();
        if !scene.volumes.is_empty() {
            let ray = Ray::through(&scene.camera, size, pixel);
            let told = |segment| segments.push(segment);
            composite.color =
                visible.composite_telling(scene.background, &ray, &scene.volumes, told);
        }
        Self {
            depths: depths.collect(),
            opaque: visible.opaque.map(|it| number(it.covering.triangle)),
            composite,
            ray: segments,
        }
    }
}

fn covering(fragment: &CapturedFragment) -> Covering {
    Covering {
        triangle: fragment.order,
        depth: fragment.depth,
        color: fragment.color,
    }
}
