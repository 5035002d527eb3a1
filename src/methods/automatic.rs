//! The method for those who want the exact image and do not care how.
//!
//! | the scene has | method | why |
//! | --- | --- | --- |
//! | volumes | `dfb+ppdp` | it casts rays through them, and leaves out no fragment |
//! | slices or other sorted meshes, and transparent meshes that are not | `dfb+ppdp` | what crosses many slices has no order, so most pixels need lists anyway |
//! | other surfaces | `verified-painter` | its one pass of blending is the whole image where the order is proved |
//!
//! Colours in lists have 32 bits. `benches/verified_painter.rs` measures the choice. Of the methods that are exact in every
//! pixel, with the order of submission between equal depths, it was the quickest of those measured on the bundled scenes of
//! surfaces. `dfb` alone is a little quicker on the molecule, as long as no pixel has more than 64 fragments; hybrid layer
//! peeling is quicker on slices, but puts what is not sorted before what is.

use super::a_buffer::{ABufferOptions, Manager, RecordColor};
use super::registry::Method;
use crate::scene::Scene;

/// A choice of method, and its reason.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Automatic {
    /// The method, with its options.
    pub method: Method,
    /// Why it is this one, as the end of a sentence.
    pub why: &'static str,
}

impl Method {
    /// A quick method that is exact for a scene.
    pub fn automatic(scene: &Scene) -> Automatic {
        let has = |sorted| {
            let mut transparent = scene.meshes.iter().filter(|mesh| !mesh.opaque);
            transparent.any(|mesh| mesh.sorted == sorted)
        };
        let lists = |why| Automatic {
            method: Self::ABuffer(ABufferOptions {
                manager: Manager::Dfb,
                pp_dp: true,
                color: RecordColor::Float,
                ..ABufferOptions::DEFAULT
            }),
            why,
        };
        if !scene.volumes.is_empty() {
            return lists("it casts rays through volumes, and leaves out no fragment");
        }
        if has(true) && has(false) {
            return lists("what crosses slices has no order");
        }
        Automatic {
            method: Self::VerifiedPainter,
            why: "one pass of blending is the whole image where its order is proved",
        }
    }
}
