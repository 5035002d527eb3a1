//! What an entry of a scene file became in the scene.

use std::ops::Range;

/// One `[[mesh]]` or `[[volume]]`. A model's file may hold several meshes; a hidden volume is not in the scene.
#[derive(Clone, Debug)]
pub(in crate::low_level::scene) struct Source {
    /// The name in the file.
    pub(in crate::low_level::scene) name: Option<String>,
    /// Its meshes, as a range of the scene's.
    pub(in crate::low_level::scene) meshes: Range<usize>,
    /// Its volume, as a range of at most one of the scene's.
    pub(in crate::low_level::scene) volumes: Range<usize>,
}
