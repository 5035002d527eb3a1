//! The invariance experiment: depth peeling in which the stored and the compared depths are computed in different ways
//! (Everitt 2001, "An Invariance Issue").
//!
//! An [`Experiment`] says which depth is stored, which is compared with it, where, and with which bias. A [`Finding`]
//! has the errors, pixel by pixel, relative to the exact image. A pixel can go wrong in three ways. It *misses*
//! fragments that the comparison skips. It *doubles* fragments that pass the comparison with themselves. It gets
//! *stuck* if a fragment does so for ever; then no layer is ever empty, and the loop does not end.

use glam::DVec3;

use super::coplanar::{Shown, shown};
use super::depth_unit_0::{DepthSource, DepthUnit0, Experiment};
use super::{DepthPeelingOptions, Method, Renderer};
use crate::error::Result;
use crate::fragment::Rgba;
use crate::gl::{Context, Format};
use crate::image::{Comparison, Image};
use crate::scene::generate::{Soup, soup};
use crate::scene::{Camera, Scene};
use crate::steps::Reason;

/// The largest error of an exact method: f32 colours are composited in at most 64 roundings of 2^-24 each, with some
/// reserve.
const EXACT: f64 = 1e-5;

/// The comparisons that matter, by name: how the stored depth is made, and how the one that is compared with it.
pub const SOURCES: [(&str, DepthSource, DepthSource); 3] = [
    (
        "window z : window z",
        DepthSource::WindowZ,
        DepthSource::WindowZ,
    ),
    (
        "window z : r/q",
        DepthSource::WindowZ,
        DepthSource::Quotient,
    ),
    (
        "depth replace : r/q",
        DepthSource::Quotient,
        DepthSource::Quotient,
    ),
];

/// A loop is stuck if it goes on for so many more peels than the deepest pixel has fragments.
const SPARE_PEELS: u32 = 8;

/// The errors of an experiment.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The image, in the scene's own colours.
    pub image: Image,
    /// The verdict on each pixel, row by row from the top.
    pub pixels: Vec<Verdict>,
    /// The number of fragments that are missing in the image.
    pub missing: u64,
    /// The number of times that a fragment is in the image once too often.
    pub doubled: u64,
    /// Whether the loop ended.
    pub ended: bool,
}

/// The verdict on a pixel. If several apply, it is the last of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// The pixel has no transparent fragment.
    Empty,
    /// The pixel has the exact image's colour.
    Right,
    /// The pixel has the right number of fragments, but another colour.
    Reordered,
    /// The pixel lacks fragments.
    Missing,
    /// The pixel has some fragment more than once.
    Doubled,
    /// The pixel repeats a fragment for ever.
    Stuck,
}

impl Finding {
    /// The number of pixels with this verdict.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.pixels
            .iter()
            .filter(|&&pixel| pixel == verdict)
            .count()
    }

    /// The number of pixels that differ from the exact image.
    pub fn wrong(&self) -> usize {
        let fine = |verdict: &&Verdict| !matches!(verdict, Verdict::Empty | Verdict::Right);
        self.pixels.iter().filter(fine).count()
    }

    /// A picture of the verdicts, in their colours.
    pub fn picture(&self) -> Image {
        Image {
            width: self.image.width,
            height: self.image.height,
            pixels: self.pixels.iter().map(Verdict::color).collect(),
        }
    }
}

impl Verdict {
    /// The colour in pictures. An empty pixel is white and a right one grey. A pixel that misses fragments is blue, one
    /// with another order purple, one with doubled fragments yellow, and a stuck one vermilion. The colour-blind can tell
    /// them apart (Okabe and Ito's colours).
    pub fn color(&self) -> Rgba {
        let [r, g, b] = match self {
            Self::Empty => [0xFF, 0xFF, 0xFF],
            Self::Right => [0xDD, 0xDD, 0xDD],
            Self::Reordered => [0xCC, 0x79, 0xA7],
            Self::Missing => [0x00, 0x72, 0xB2],
            Self::Doubled => [0xF0, 0xE4, 0x42],
            Self::Stuck => [0xD5, 0x5E, 0x00],
        };
        Rgba::opaque([r, g, b].map(|byte: u8| f32::from(byte) / 255.0))
    }
}

/// Tries one way of comparing on a scene. `exact` is the scene's exact image, by [`Method::Exact`].
///
/// # Errors
/// If the driver fails.
pub fn run_experiment(
    context: &Context,
    scene: &Scene,
    exact: &Image,
    experiment: Experiment,
    depth: Format,
) -> Result<Finding> {
    let most = deepest(context, scene)?;
    let limit = most + SPARE_PEELS;
    let method = Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels: limit,
        depth_unit_0: DepthUnit0::Experiment(experiment),
        ..Default::default()
    });
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height)?.with_formats(Format::Rgba32F, depth);
    // The clip planes affect the result, so the camera's own are taken.
    let mut renderer = renderer.with_given_planes();
    let frame = renderer.render(scene, &method)?;
    drop(renderer);
    let shown = shown(context, scene, &method, depth)?;
    let off = Comparison::pixels(&frame.image, exact)?;
    let pixels = (0..off.len()).map(|pixel| verdict(&shown, pixel, off[pixel] > EXACT, limit));
    Ok(Finding {
        pixels: pixels.collect(),
        missing: shown.missing(),
        doubled: shown.doubled(),
        ended: frame.stats.stopped == Some(Reason::EmptyLayer),
        image: frame.image,
    })
}

fn verdict(shown: &Shown, pixel: usize, off: bool, limit: u32) -> Verdict {
    let (submitted, shown) = (shown.submitted[pixel], shown.shown[pixel]);
    match shown.cmp(&submitted) {
        // A pixel has a layer in each peel until it has none left, so this pixel had a layer in every peel.
        _ if shown >= limit => Verdict::Stuck,
        std::cmp::Ordering::Greater => Verdict::Doubled,
        std::cmp::Ordering::Less => Verdict::Missing,
        std::cmp::Ordering::Equal if off => Verdict::Reordered,
        std::cmp::Ordering::Equal if submitted == 0 => Verdict::Empty,
        std::cmp::Ordering::Equal => Verdict::Right,
    }
}

fn deepest(context: &Context, scene: &Scene) -> Result<u32> {
    let shown = shown(context, scene, &Method::Blend, Format::Depth32FStencil8)?;
    Ok(shown.submitted.into_iter().max().unwrap_or(0))
}

/// Random triangles for a camera whose far plane is `ratio` times as far as its near plane. Between the two, each
/// distance is as likely as its double, and all triangles have the same size in the image. The ratio is at least 2.
///
/// # Errors
/// If there are more triangles than a mesh may have.
pub fn perspective_soup(seed: u64, count: u32, ratio: f64, size: [u32; 2]) -> Result<Scene> {
    const NEAR: f64 = 0.1;
    let mut mesh = soup(&Soup {
        seed,
        count,
        extent: 1.0,
        triangle_size: [0.4, 1.4],
        ..Soup::default()
    })?;
    for vertex in &mut mesh.vertices {
        let [x, y, z] = vertex.position.to_array();
        // From -1.2..1.2 to 1%..99% of the way, in factors of the distance.
        let along = 0.01 + 0.98 * ((z + 1.2) / 2.4).clamp(0.0, 1.0);
        let distance = NEAR * ratio.powf(along);
        vertex.position = DVec3::new(x * 0.5 * distance, y * 0.5 * distance, -distance);
    }
    let mut scene = Scene::of("perspective soup", vec![mesh]);
    scene.size = size;
    scene.background = [1.0; 3];
    scene.camera = Camera {
        eye: glam::DVec3::ZERO,
        target: glam::DVec3::NEG_Z,
        up: glam::DVec3::Y,
        fov: 60.0,
        near: NEAR,
        far: NEAR * ratio,
    };
    Ok(scene)
}
