//! The options for loading a scene.

use crate::memory::MemoryLimit;

/// Options for loading a scene.
#[derive(Clone, Debug, Default)]
pub struct LoadOptions {
    /// Width and height of the image in pixels, instead of the file's. The camera is fitted to this size.
    pub size: Option<[u32; 2]>,
    /// The memory that the scene may take. A scene that would take more is refused before its memory is allocated. The
    /// default is the memory that the machine has left.
    pub memory: MemoryLimit,
}

impl From<Option<[u32; 2]>> for LoadOptions {
    /// The default options, for images of this size, or of the file's size if `None`.
    fn from(size: Option<[u32; 2]>) -> Self {
        Self {
            size,
            ..Self::default()
        }
    }
}
