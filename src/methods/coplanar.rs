//! Coplanar surfaces: the policy, and a detector of methods that break it.
//!
//! # The policy
//!
//! Of fragments of a pixel with exactly equal depths, **the one that was submitted first lies in front**. An opaque
//! surface hides what lies exactly on it. The order of submission is the order of the scene's meshes, and within a mesh
//! the order of its triangles. This holds everywhere in onionskin: the [`oracle`](crate::oracle) sorts by it, and the
//! images of the exact methods are compared with the oracle's.
//!
//! <!-- methods: generated from the registry -->
//! | fragments of equal depth | methods |
//! | --- | --- |
//! | each over those drawn before it | `blend`, `painter` |
//! | no order | `weighted-blended` |
//! | order of submission | `multi-layer-alpha-blending`, `dual-depth-peeling`, `coplanar-depth-peeling`, `layer-peeling`, `ffb`, `ffb+ppao`, `ffb+ppdp`, `ffb+ppao+ppdp`, `dfb`, `dfb+ppao`, `dfb+ppdp`, `dfb+ppao+ppdp`, `ppll`, `ppll+ppao`, `ppll+ppdp`, `ppll+ppao+ppdp`, `verified-painter`, `auto`, `exact` |
//! | the first submitted, the others lost and counted | `depth-peeling` |
//! | unsorted meshes before sorted ones | `hybrid-layer-peeling` |
//! | order of submission after sorting | `coherent-layer-peeling-a`, `coherent-layer-peeling-b`, `ideal-coherent-layer-peeling` |
//! <!-- /methods -->
//!
//! [`Entry::ties`](super::Entry::ties) says it of each method in the registry.
//!
//! # The detector
//!
//! [`shown`] does not ask a method what it has done. It renders the scene with every fragment black and equally
//! translucent over white. The light that is left at a pixel then gives the number of fragments in the image, because
//! `n` fragments let `(1 - a)^n` through in any order. If they are fewer than were drawn, some were dropped or merged.

use super::allocate_maps::allocate_maps;
use super::renderer::Renderer;
use super::technique::Technique;
use crate::error::Result;
use crate::fragment::Rgba;
use crate::gl::{Context, Format, Geometry, GlMachine, capture};
use crate::papers::stage::{self, OPAQUE_DEPTH, OPAQUE_FIRST};
use crate::scene::{Scene, Shading};
use crate::steps::{Variables, run};

/// The number of fragments of each pixel, and the number that a method shows, row by row from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Shown {
    /// The number of transparent fragments before the opaque depth, counted by lists.
    pub submitted: Vec<u32>,
    /// The number of them that the image shows.
    pub shown: Vec<u32>,
}

impl Shown {
    /// The number of fragments that were dropped, or merged with another.
    pub fn missing(&self) -> u64 {
        let pairs = self.submitted.iter().zip(&self.shown);
        pairs
            .map(|(&all, &some)| u64::from(all.saturating_sub(some)))
            .sum()
    }

    /// The number of fragments that are in the image more than once.
    pub fn doubled(&self) -> u64 {
        let pairs = self.submitted.iter().zip(&self.shown);
        pairs
            .map(|(&all, &more)| u64::from(more.saturating_sub(all)))
            .sum()
    }
}

/// Renders the scene, painted, and counts. Depths have the format `depth`.
///
/// With colours in 32-bit float the count is right for any number of fragments up to some thousands at a pixel: the
/// opacity is chosen so that about 1/e of the light is left at the deepest pixel.
///
/// # Errors
/// If the method or the driver fails.
pub fn shown(
    context: &Context,
    scene: &Scene,
    method: &dyn Technique,
    depth: Format,
) -> Result<Shown> {
    let submitted = submitted(context, scene)?;
    let most = submitted.iter().copied().max().unwrap_or(0).max(1);
    let alpha = 1.0 / (most + 1) as f32;
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height)?.with_formats(Format::Rgba32F, depth);
    // The clip planes affect the result, so the camera's own are taken.
    let mut renderer = renderer.with_given_planes();
    let image = renderer.render(&painted(scene, alpha), method)?.image;
    let through_one = f64::from(1.0 - alpha).ln();
    let count = |light: f32| (f64::from(light).max(f64::MIN_POSITIVE).ln() / through_one).round();
    Ok(Shown {
        submitted,
        shown: image
            .pixels
            .iter()
            .map(|pixel| count(pixel.r) as u32)
            .collect(),
    })
}

/// The number of fragments of each pixel.
fn submitted(context: &Context, scene: &Scene) -> Result<Vec<u32>> {
    const AT_A_TIME: u32 = 2 << 20;
    let [width, height] = scene.size;
    let _visit = context.visit()?;
    let mut machine = GlMachine::new(context, scene.size)?;
    allocate_maps(
        &mut machine,
        &[&stage::RESOURCES],
        Format::Rgba8,
        Format::Depth32FStencil8,
    )?;
    machine.set_geometry(Geometry::upload(context, scene, scene.size)?);
    machine.begin_frame();
    run(&OPAQUE_FIRST, &[], Variables::new(), &mut machine)?;
    let mut counts = vec![0; width as usize * height as usize];
    for fragment in capture(&mut machine, OPAQUE_DEPTH, AT_A_TIME)? {
        let row = height - 1 - fragment.y;
        counts[(row * width + fragment.x) as usize] += 1;
    }
    Ok(counts)
}

/// The scene in black, with a single opacity, over white. Opaque surfaces are white.
fn painted(scene: &Scene, alpha: f32) -> Scene {
    let mut scene = scene.clone();
    scene.background = [1.0; 3];
    for mesh in &mut scene.meshes {
        let paint = if mesh.opaque {
            Rgba::opaque([1.0; 3])
        } else {
            Rgba::new(0.0, 0.0, 0.0, alpha)
        };
        mesh.shading = Shading::None;
        mesh.vertices
            .iter_mut()
            .for_each(|vertex| vertex.color = paint);
    }
    scene
}
