//! Volumes among fragments: the boxes around them, which are drawn with the transparent surfaces.

use crate::papers::lindholm_2015::PROXIES;
use crate::scene::Scene;
use crate::steps::Amendment;

/// How a listing that draws transparent objects is amended for this scene.
pub(super) const fn proxies(scene: &Scene) -> &'static [Amendment] {
    if scene.volumes.is_empty() {
        &[]
    } else {
        &[PROXIES]
    }
}
