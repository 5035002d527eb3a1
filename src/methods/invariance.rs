//! The invariance experiment: what becomes of depth peeling when what is stored and what is compared are not computed in
//! the same way (Everitt 2001, "An Invariance Issue").
//!
//! A [`Trial`] says what is stored, what is compared with it, where, and by which margin; a [`Finding`] says what it
//! cost, pixel by pixel, against the exact image. A pixel can go wrong in three ways: it *misses* fragments, because
//! the comparison skips them; it *doubles* some, because a fragment passes the comparison with itself; and it gets
//! *stuck*, because one goes on doing so, and then no layer is ever empty and the loop does not end.

use glam::DVec3;

use super::coplanar::{Shown, shown};
use super::depth_unit_0::{DepthUnit0, Trial};
use super::{DepthPeelingOptions, Method, Renderer};
use crate::error::Result;
use crate::fragment::Rgba;
use crate::gl::{Context, Format};
use crate::image::{Comparison, Image};
use crate::scene::generate::{Soup, soup};
use crate::scene::{Camera, Scene};
use crate::steps::Reason;

/// An exact method is this near to the exact image: f32 colours composited in at most 64 roundings of 2^-24 each, and
/// some more.
const EXACT: f64 = 1e-5;

/// After so many peels more than the deepest pixel has fragments, a loop that goes on is stuck.
const SPARE_PEELS: u32 = 8;

/// What a trial cost.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The image, in the scene's own colours.
    pub image: Image,
    /// What became of each pixel, row by row from the top.
    pub pixels: Vec<Verdict>,
    /// Fragments that the image does not have.
    pub missing: u64,
    /// Fragments that it has once too often, each time counted.
    pub doubled: u64,
    /// Whether the loop found its end.
    pub ended: bool,
}

/// What became of a pixel; of several things that went wrong, the last one that applies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It has no transparent fragment.
    Empty,
    /// Its colour is the exact image's.
    Right,
    /// It has as many fragments as it should, but its colour is another.
    Reordered,
    /// It lacks fragments.
    Missing,
    /// It has some more often than once.
    Doubled,
    /// It repeats one for ever.
    Stuck,
}

impl Finding {
    /// How many pixels came out so.
    pub fn count(&self, verdict: Verdict) -> usize {
        self.pixels
            .iter()
            .filter(|&&pixel| pixel == verdict)
            .count()
    }

    /// How many pixels are not the exact image's.
    pub fn wrong(&self) -> usize {
        let fine = |verdict: &&Verdict| !matches!(verdict, Verdict::Empty | Verdict::Right);
        self.pixels.iter().filter(fine).count()
    }

    /// Where they lie: white where there is nothing, grey where all is right, blue where fragments are missing, yellow
    /// where their order is another, orange where they are doubled, red where the pixel is stuck.
    pub fn picture(&self) -> Image {
        let color = |verdict: &Verdict| match verdict {
            Verdict::Empty => [1.0, 1.0, 1.0],
            Verdict::Right => [0.8, 0.8, 0.8],
            Verdict::Reordered => [0.95, 0.85, 0.2],
            Verdict::Missing => [0.15, 0.35, 0.85],
            Verdict::Doubled => [0.95, 0.5, 0.1],
            Verdict::Stuck => [0.8, 0.05, 0.1],
        };
        let pixels = self.pixels.iter().map(color).map(Rgba::opaque);
        Image {
            width: self.image.width,
            height: self.image.height,
            pixels: pixels.collect(),
        }
    }
}

/// Tries one way of comparing on a scene. `exact` is the scene's exact image, by [`Method::Exact`].
///
/// # Errors
/// What the driver cannot do.
pub fn try_out(
    context: &Context,
    scene: &Scene,
    exact: &Image,
    trial: Trial,
    depth: Format,
) -> Result<Finding> {
    let most = deepest(context, scene)?;
    let limit = most + SPARE_PEELS;
    let method = Method::DepthPeeling(DepthPeelingOptions {
        maximum_number_of_peels: limit,
        depth_unit_0: DepthUnit0::Trial(trial),
        ..Default::default()
    });
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height)?.with_formats(Format::Rgba32F, depth);
    // What depths are held between is part of what is studied.
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
        // A pixel has a layer in each peel until it has none, so this one had a layer in every peel.
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

/// Random triangles for a camera whose far plane is `ratio` times as far as its near plane: each depth between the two
/// as likely as its double, and each triangle as large in the image wherever it lies. Ratios from 2 up.
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
