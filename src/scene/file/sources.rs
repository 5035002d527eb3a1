//! What an entry of a scene file has become in the scene.

use std::ops::Range;

/// One `[[mesh]]` or `[[volume]]`: a model's file may hold several meshes, and a hidden volume is none.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Source {
    /// What the file calls it.
    pub(in crate::scene) name: Option<String>,
    /// Its meshes among the scene's.
    pub(in crate::scene) meshes: Range<usize>,
    /// Its volumes among the scene's, one at most.
    pub(in crate::scene) volumes: Range<usize>,
}
