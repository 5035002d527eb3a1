//! The method for those who want the exact image and do not care how.
//!
//! | the scene has | method | why |
//! | --- | --- | --- |
//! | volumes | `dfb+ppdp` | it casts rays through them, and leaves out no fragment |
//! | surfaces only | `verified-painter` | its one pass of blending is the whole image where the order is proved, and on every bundled scene it was the quickest exact method (`benches/verified_painter.rs`) |

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
    /// The quickest method that is exact for a scene.
    pub fn automatic(scene: &Scene) -> Automatic {
        match scene.volumes.is_empty() {
            true => Automatic {
                method: Self::VerifiedPainter,
                why: "it is the quickest exact method for surfaces",
            },
            false => Automatic {
                method: Self::ABuffer(ABufferOptions {
                    manager: Manager::Dfb,
                    pp_dp: true,
                    color: RecordColor::Float,
                    ..ABufferOptions::DEFAULT
                }),
                why: "it casts rays through volumes, and leaves out no fragment",
            },
        }
    }
}
