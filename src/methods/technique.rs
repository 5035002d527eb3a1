//! A method with its options, published or of a caller's own, as the renderer takes it.

use std::fmt;

use super::algorithm::{Algorithm, Setup};
use super::choice::Setter;
use super::entry::Entry;
use crate::error::Result;

/// A method with its options: its facts, and its algorithm.
///
/// [`Method`](super::Method) is a technique for every published method. Each type of options is one, too. A method of
/// one's own is one more, with a shader of one's own: here light that is added up, whatever stands before it, and that
/// fades with the depth.
///
/// ```
/// use onionskin::low_level::gl::GlMachine;
/// use onionskin::low_level::methods::{Algorithm, Drawn, Setup, Technique, Ties};
/// use onionskin::low_level::papers::stage::OPAQUE_FIRST;
/// use onionskin::low_level::steps::{Dialect, Listing, Shader, Variables, gl::*, run};
/// use onionskin::{Context, Entry, Renderer, Result, Scene, generate, steps};
///
/// const FADING: &str = r#"#version 430 core
/// vec4 surface_color();    // what the mesh's shading says
/// #include "common/fragment_depth.glsl"
/// out vec4 color;
/// void main() {
///     STORE_DEPTH
///     vec4 light = surface_color();
///     color = vec4(light.rgb * light.a * (1.0 - FRAGMENT_DEPTH), 0.0);
/// }
/// "#;
///
/// const ADD: Listing = Listing {
///     title: "Light adds up",
///     source: "my renderer",
///     dialect: Dialect::Calls,
///     steps: steps! {
///         run OPAQUE_FIRST;
///         glEnable(BLEND);
///         glBlendFuncSeparate(ONE, ONE, ONE, ONE);
///         glUseProgram(Shader("my/fading"));
///         drawTransparentObjects();
///         glDisable(BLEND);
///     },
/// };
///
/// #[derive(Debug)]
/// struct Glow;
///
/// impl Technique for Glow {
///     fn entry(&self) -> &'static Entry {
///         const ENTRY: Entry = {
///             let mut entry = Entry::new("glow", "my renderer");
///             entry.ties = Ties::Unordered;
///             entry
///         };
///         &ENTRY
///     }
///
///     fn algorithm(&self, _: &Setup) -> Box<dyn Algorithm> {
///         Box::new(Glow)
///     }
/// }
///
/// impl Algorithm for Glow {
///     fn prepare(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
///         machine.set_shader_file("my/fading.frag", FADING)
///     }
///
///     fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
///         run(&ADD, &[], Variables::new(), machine)?;
///         Ok(Drawn::default())
///     }
/// }
///
/// let context = Context::headless()?;
/// let quads = generate::quads(&generate::Quads::default())?;
/// let frame = Renderer::new(&context, 64, 48)?.render(&Scene::of("quads", vec![quads]), &Glow)?;
/// assert_eq!(frame.stats.lost, Some(0));
/// # Ok::<(), onionskin::Error>(())
/// ```
pub trait Technique: fmt::Debug {
    /// The facts that are known before it runs.
    fn entry(&self) -> &'static Entry;

    /// The algorithm that draws its frames.
    fn algorithm(&self, setup: &Setup) -> Box<dyn Algorithm>;

    /// Checks the options, as far as that is possible without a scene. This is done before each frame; a caller may do
    /// it earlier.
    ///
    /// # Errors
    /// If an option is out of its range, or two options exclude each other.
    fn check(&self) -> Result<()> {
        Ok(())
    }

    /// The reason for which it cannot draw by 1/w ([`Renderer::with_inverse_w`](super::Renderer::with_inverse_w)), or
    /// `None` if it can.
    fn needs_window_depth(&self) -> Option<&'static str> {
        None
    }
}

/// A published method, which the registry lists.
pub(super) trait Published: Technique + Default + Copy + 'static {
    /// Its options.
    const CHOICES: &'static [Setter<Self>] = &[];

    /// The method under each of its names, with its default options.
    fn variants() -> Vec<Self> {
        vec![Self::default()]
    }
}
