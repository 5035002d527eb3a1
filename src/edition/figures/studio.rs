//! What a figure is drawn with.

use std::cell::RefCell;
use std::collections::BTreeMap;

use super::scenes::Scenes;
use crate::error::Result;
use crate::gl::Context;
use crate::methods::Renderer;
use crate::scene::{Animation, Scene};

/// What a figure is drawn with: OpenGL, the bundled scenes, and the sizes of the edition.
pub struct Studio<'c> {
    /// OpenGL.
    pub context: &'c Context,
    /// Whether the edition is the quick one, with small pictures and few frames.
    pub quick: bool,
    scenes: Scenes,
    /// What was loaded, by name and size. Several figures show the large scenes, which take longer to load than to draw.
    loaded: RefCell<BTreeMap<(String, [u32; 2]), Animation>>,
}

impl<'c> Studio<'c> {
    /// A studio with the bundled scenes.
    ///
    /// # Errors
    /// If there is no place for the scenes' files.
    pub fn new(context: &'c Context, quick: bool) -> Result<Self> {
        Ok(Self {
            context,
            quick,
            scenes: Scenes::unpacked()?,
            loaded: RefCell::default(),
        })
    }

    /// The size of a picture: that of the whole edition, and in the quick one half of it in both directions.
    pub fn size(&self, whole: [u32; 2]) -> [u32; 2] {
        match self.quick {
            true => whole.map(|pixels| pixels.div_ceil(2)),
            false => whole,
        }
    }

    /// So many of something: the second number in the quick edition.
    pub fn number<N>(&self, whole: N, quick: N) -> N {
        match self.quick {
            true => quick,
            false => whole,
        }
    }

    /// A renderer for pictures of a scene's size.
    ///
    /// # Errors
    /// As [`Renderer::new`].
    pub fn renderer(&self, scene: &Scene) -> Result<Renderer<'c>> {
        Renderer::new(self.context, scene.size[0], scene.size[1])
    }

    /// A bundled scene by its file's name without `.toml`, for pictures of this [`size`](Self::size).
    ///
    /// # Errors
    /// As [`Scene::load_at`].
    pub fn scene(&self, name: &str, whole: [u32; 2]) -> Result<Scene> {
        Ok(self.animation(name, whole)?.scene)
    }

    /// A bundled scene for pictures of exactly this size, in the quick edition, too: for what is counted.
    ///
    /// # Errors
    /// As [`Scene::load_at`].
    pub fn scene_of_size(&self, name: &str, size: [u32; 2]) -> Result<Scene> {
        Ok(self.load(name, size)?.scene)
    }

    /// The same as [`scene`](Self::scene), with its camera path.
    ///
    /// # Errors
    /// As [`Animation::load_at`].
    pub fn animation(&self, name: &str, whole: [u32; 2]) -> Result<Animation> {
        self.load(name, self.size(whole))
    }

    fn load(&self, name: &str, size: [u32; 2]) -> Result<Animation> {
        let key = (name.to_owned(), size);
        if let Some(loaded) = self.loaded.borrow().get(&key) {
            return Ok(loaded.clone());
        }
        let loaded = Animation::load_at(self.scenes.path(name), Some(size))?;
        self.loaded.borrow_mut().insert(key, loaded.clone());
        Ok(loaded)
    }
}
