//! A scene from one camera after another.

use std::borrow::Cow;

use super::algorithm::DrawOrder;
use super::complexity::{Complexity, CountBy};
use super::frame::Frame;
use super::renderer::Renderer;
use super::technique::Technique;
use crate::error::Result;
use crate::scene::{Camera, Scene};

/// A scene that is rendered from one camera after another, and uploaded once. Only methods that sort triangles upload them
/// again, in the order of the new view, and only slices of volumes are made and uploaded for every camera.
///
/// ```
/// use onionskin::{Context, Method, Renderer, Scene, generate};
///
/// let context = Context::headless()?;
/// let mut renderer = Renderer::new(&context, 64, 48)?;
/// let quads = generate::quads(&generate::Quads::default())?;
/// let scene = Scene::of("quads", vec![quads]);
/// let mut camera = scene.camera;
/// let method = Method::DepthPeeling(Default::default());
/// let mut film = renderer.film(scene, &method);
/// for _ in 0..3 {
///     camera.eye.x += 0.1;
///     film.frame(camera)?;
/// }
/// # Ok::<(), onionskin::Error>(())
/// ```
#[derive(Debug)]
pub struct Film<'r, 'c> {
    renderer: &'r mut Renderer<'c>,
    scene: Scene,
    method: &'r dyn Technique,
    /// The order in which the scene is uploaded, if it is.
    held: Option<DrawOrder>,
}

impl<'c> Renderer<'c> {
    /// Takes a scene, to render it from one camera after another.
    pub fn film<'r>(&'r mut self, scene: Scene, method: &'r dyn Technique) -> Film<'r, 'c> {
        Film {
            renderer: self,
            scene,
            method,
            held: None,
        }
    }
}

impl Film<'_, '_> {
    /// Renders a frame: what [`Renderer::render`] returns for the scene with this camera.
    ///
    /// # Errors
    /// If the method or the driver fails.
    pub fn frame(&mut self, camera: Camera) -> Result<Frame> {
        let renderer = &mut *self.renderer;
        let _visit = renderer.machine.context().visit()?;
        self.scene.camera = camera;
        self.scene.camera = renderer.camera(&self.scene);
        let shown = renderer.shown(Cow::Borrowed(&self.scene), camera, self.method)?;
        renderer.render_shown(&shown, self.method, &mut self.held)
    }

    /// Renders a frame, and counts every pixel's transparent fragments: what [`Renderer::render_and_count`] returns for the
    /// scene with this camera.
    ///
    /// # Errors
    /// If the method or the driver fails.
    pub fn frame_and_count(&mut self, camera: Camera, by: CountBy) -> Result<(Frame, Complexity)> {
        let frame = self.frame(camera)?;
        self.scene.camera = camera;
        let complexity = self.renderer.count_after(&frame, &self.scene, by)?;
        Ok((frame, complexity))
    }
}
