//! A scene from one camera after another.

use std::borrow::Cow;
use std::fmt;
use std::time::Instant;

use super::algorithm::{Algorithm, DrawOrder};
use super::complexity::{Complexity, CountBy};
use super::frame::Frame;
use super::renderer::{Renderer, orders};
use super::technique::Technique;
use crate::error::Result;
use crate::gl::StepTime;
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
    /// The method at work, if the last frame was only timed.
    ready: Option<Ready>,
}

/// A method that is set up for the scene.
struct Ready(Box<dyn Algorithm>);

impl<'c> Renderer<'c> {
    /// Takes a scene, to render it from one camera after another.
    pub fn film<'r>(&'r mut self, scene: Scene, method: &'r dyn Technique) -> Film<'r, 'c> {
        Film {
            renderer: self,
            scene,
            method,
            held: None,
            ready: None,
        }
    }
}

impl Film<'_, '_> {
    /// Renders a frame: what [`Renderer::render`] returns for the scene with this camera.
    ///
    /// # Errors
    /// If the method or the driver fails.
    pub fn frame(&mut self, camera: Camera) -> Result<Frame> {
        self.ready = None;
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

    /// Renders a frame, and returns only its time in milliseconds. The time has everything that another view takes: sorting
    /// triangles, uploading their order, drawing. Reading the image and setting the method up are not in it. Neither is
    /// cutting volumes into slices.
    ///
    /// Between frames that are only timed, the method keeps its maps. The first frame of a film sets it up, and its shaders
    /// are compiled, so its time says little.
    ///
    /// # Errors
    /// If the method or the driver fails.
    pub fn time(&mut self, camera: Camera) -> Result<f64> {
        Ok(self.timed(camera, false)?.0)
    }

    /// Renders a frame as [`time`](Self::time) does, and waits for OpenGL before and after each step that clears, copies or
    /// draws. Returns the frame's time in milliseconds, which is longer for that, and those of its steps.
    ///
    /// # Errors
    /// If the method or the driver fails.
    pub fn time_steps(&mut self, camera: Camera) -> Result<(f64, Vec<StepTime>)> {
        self.timed(camera, true)
    }

    fn timed(&mut self, camera: Camera, by_steps: bool) -> Result<(f64, Vec<StepTime>)> {
        let renderer = &mut *self.renderer;
        let _visit = renderer.machine.context().visit()?;
        self.scene.camera = camera;
        self.scene.camera = renderer.camera(&self.scene);
        let shown = renderer.shown(Cow::Borrowed(&self.scene), camera, self.method)?;
        let (mut algorithm, sorting) = match self.ready.take() {
            Some(Ready(mut algorithm)) if shown.slices.is_none() => {
                renderer.machine.finish();
                let start = Instant::now();
                look(renderer, &shown.scene, algorithm.as_mut(), &mut self.held)?;
                (algorithm, start.elapsed().as_secs_f64() * 1e3)
            }
            _ => (renderer.prepare(&shown, self.method, &mut self.held)?, 0.0),
        };
        if by_steps {
            renderer.machine.time_steps();
        }
        let drawn = renderer.draw(&shown.scene, algorithm.as_mut());
        let steps = renderer.machine.step_times();
        let (_, drawing) = drawn?;
        renderer
            .machine
            .expect_no_error("while a frame was timed")?;
        self.ready = Some(Ready(algorithm));
        Ok((sorting + drawing, steps))
    }
}

impl fmt::Debug for Ready {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Ready")
    }
}

/// Has a scene that is set up seen by the camera that it has now, in the method's order for this view.
fn look(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    algorithm: &mut dyn Algorithm,
    held: &mut Option<DrawOrder>,
) -> Result<()> {
    renderer.machine.look(scene);
    // Methods that submit triangles themselves sort them while they draw.
    if *held == Some(DrawOrder::Own) {
        return Ok(());
    }
    let order = algorithm.order(scene);
    if held.as_ref() != Some(&order) {
        renderer.machine.reorder(scene, orders(&order))?;
    }
    *held = Some(order);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gl::Context;
    use crate::methods::Method;
    use crate::papers::stage;
    use crate::scene::generate::{Soup, soup};

    /// Both images of a method's frame from one place, the eye having been elsewhere before: timed, and rendered.
    fn timed_and_rendered(context: &Context, method: &str) -> [Vec<[f32; 4]>; 2] {
        let mut scene = Scene::of("soup", vec![soup(&Soup::default()).unwrap()]);
        scene.size = [64, 48];
        let front = scene.camera;
        let behind = Camera {
            eye: 2.0 * front.target - front.eye,
            ..front
        };
        let method: Method = method.parse().unwrap();
        let mut renderer = Renderer::new(context, 64, 48).unwrap();
        let colors = |film: &Film<'_, '_>| {
            let machine = &film.renderer.machine;
            machine.read_colors(stage::IMAGE_COLOR).unwrap()
        };
        let mut film = renderer.film(scene, &method);
        film.time(front).unwrap();
        assert!(film.time(behind).unwrap() > 0.0);
        let timed = colors(&film);
        film.time(front).unwrap();
        assert_ne!(timed, colors(&film), "{method} shows both sides alike");
        film.frame(behind).unwrap();
        [timed, colors(&film)]
    }

    #[test]
    fn a_frame_that_is_timed_is_the_frame_of_its_view() {
        let context = Context::headless().unwrap();
        for method in [
            "blend",
            "painter",
            "verified-painter",
            "auto",
            "dfb",
            "coherent-layer-peeling-a",
        ] {
            let [timed, rendered] = timed_and_rendered(&context, method);
            assert!(timed == rendered, "{method}");
        }
    }
}
