//! Volumes among fragments: the boxes around them, which are drawn with the transparent surfaces.

use crate::papers::lindholm_2015::PROXIES;
use crate::scene::Scene;
use crate::steps::Amendment;

/// The amendments for this scene to a listing that draws transparent objects.
pub(super) const fn proxies(scene: &Scene) -> &'static [Amendment] {
    if scene.volumes.is_empty() {
        &[]
    } else {
        &[PROXIES]
    }
}
