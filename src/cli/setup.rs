//! Arguments that several subcommands share: the scene, its size, the OpenGL.

use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use clap::{Args, ValueEnum};
use onionskin::low_level::oracle::DepthBuffer;
use onionskin::{
    Animation, Backend, Context, Error, Format, LoadOptions, MemoryLimit, Renderer, Result, Scene,
};

use super::output::note;
use super::probe;
use super::progress::Progress;
use super::words::one_of;

const RENDERING: &str = "Options of every rendering";

/// An example of a scene file, for the help.
pub(super) const SCENE_FILES: &str = r#"Scene files:
  size = [1024, 768]              # pixels
  background = [1.0, 1.0, 1.0]    # linear RGB, 0 to 1

  [camera]                        # keys that are left out are fitted to the geometry
  eye = [0.0, 0.0, 3.0]
  target = [0.0, 0.0, 0.0]
  up = [0.0, 1.0, 0.0]
  fov = 30.0                      # vertical, degrees

  [[mesh]]                        # as many as you like, drawn in this order
  file = "model.obj"              # starts at the scene file's folder
  color = [0.8, 0.55, 0.3]        # default: the model's own
  opacity = 0.4                   # 1 is opaque
  shading = "none"                # none (flat unlit colour), flat, lit, two-sided

  [[volume]]                      # by ffb, dfb, ppll, exact; as slices by peeling
  file = "volume.nhdr"            # .nrrd, .nhdr, .nii, .nii.gz, .vti
  step = 0.5                      # sampling distance in voxels
  transfer = [                    # linear between values; density is extinction per unit of length
    { value = 0.0, color = [1.0, 1.0, 1.0], density = 0.0 },
    { value = 5.0, color = [0.1, 0.2, 0.9], density = 0.4 },
  ]
  name = "fog"                    # for isosurfaces and [[path.show]]; a mesh may have a name, too
  hidden = false                  # true: used for isosurfaces only

  [[mesh]]
  generate = "isosurface"         # where a volume has a value
  volume = "fog"
  value = 2.5

  [path]                          # for `onionskin animate`
  frames = 400
  rotate = 360.0                  # degrees about the target, over all frames
  dolly = 0.4                     # the eye comes as near as this part of its distance, and goes back ...
  dolly_frames = 200              # ... in so many frames

  [[path.show]]
  from = 100                      # from this frame on ...
  sources = ["fog"]               # ... only meshes and volumes with one of these names are shown"#;

#[derive(Args)]
pub(super) struct Setup {
    /// A scene file (.toml), or a model (.obj), to which a camera is fitted
    #[arg(value_name = "SCENE|MODEL")]
    pub(super) scene: PathBuf,
    #[command(flatten)]
    rendering: Rendering,
}

/// How scenes are rendered, whichever they are.
#[derive(Args)]
pub(super) struct Rendering {
    /// Width and height of the image in pixels [default: the scene's, and 1024x768 for a model]
    #[arg(long, value_name = "WxH", value_parser = size, help_heading = RENDERING)]
    size: Option<[u32; 2]>,
    /// How the image and the layers store their colours
    #[arg(long, value_name = "COLOR", value_parser = one_of(&[Format::Rgba8, Format::Rgba16F, Format::Rgba32F]),
          default_value_t = Format::Rgba32F, help_heading = RENDERING)]
    color: Format,
    /// How depths are stored
    #[arg(long, value_name = "DEPTH", value_parser = one_of(&[Format::Depth24Stencil8, Format::Depth32FStencil8]),
          default_value_t = Format::Depth32FStencil8, help_heading = RENDERING)]
    depth: Format,
    /// The clip planes between which depths are stored
    #[arg(long, value_enum, default_value_t = Planes::Fitted, help_heading = RENDERING)]
    planes: Planes,
    /// Test, store and compare 1/w instead of window-space depth: its error is a part of the distance, but it is slower
    #[arg(long, help_heading = RENDERING)]
    inverse_w: bool,
    /// The most memory that may be taken, such as 8G or 500M. Work that needs more is refused before it begins
    /// [default: the memory that the machine has left]
    #[arg(long, value_name = "SIZE", help_heading = RENDERING)]
    max_memory: Option<MemoryLimit>,
    /// The default limit, which is asked of the system once.
    #[arg(skip)]
    of_machine: OnceLock<MemoryLimit>,
    #[command(flatten)]
    pub(super) gl: Gl,
}

#[derive(Args)]
pub(super) struct Gl {
    /// The backend of OpenGL: egl or osmesa [default: the first of them that works]
    #[arg(long, env = "ONIONSKIN_BACKEND", hide_env_values = true, value_name = "BACKEND", help_heading = RENDERING)]
    backend: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Planes {
    /// Planes between the scene's, close around the geometry: nothing more is cut off
    Fitted,
    /// The scene's near and far plane as they are
    Given,
}

impl Gl {
    /// The context that the arguments ask for.
    pub(super) fn context(&self) -> Result<Context> {
        probe::context(self.backend()?)
    }

    fn backend(&self) -> Result<Option<Backend>> {
        let backend = self.backend.as_deref().filter(|name| !name.is_empty());
        let known = |name: &str| {
            name.parse().map_err(|_| {
                Error::option(
                    "backend",
                    format!("there is no backend '{name}'"),
                    "choose egl or osmesa, by the option or by the variable ONIONSKIN_BACKEND",
                )
            })
        };
        backend.map(known).transpose()
    }
}

impl Setup {
    /// Loads the scene. Notes about repairs go to standard error.
    pub(super) fn scene(&self) -> Result<Scene> {
        Ok(self.animation()?.scene)
    }

    /// Loads the scene with its camera path. Notes about repairs go to standard error.
    pub(super) fn animation(&self) -> Result<Animation> {
        self.rendering.load(&self.scene)
    }
}

impl Deref for Setup {
    type Target = Rendering;

    fn deref(&self) -> &Rendering {
        &self.rendering
    }
}

impl Rendering {
    /// Loads a scene with its camera path. Notes about repairs go to standard error.
    pub(super) fn load(&self, path: &Path) -> Result<Animation> {
        // Faults are reported before anything long begins.
        self.gl.backend()?;
        let options = LoadOptions {
            size: self.size,
            memory: self.memory(),
        };
        let progress = Progress::new(1, &format!("loading {}", path.display()));
        let animation = Animation::load_with(path, &options)?;
        drop(progress);
        let notices = &animation.scene.notices;
        notices.iter().take(MOST_NOTES).for_each(note);
        if let more @ 1.. = notices.len().saturating_sub(MOST_NOTES) {
            note(format_args!("and {more} more notes like these"));
        }
        self.check_memory(&animation.scene)?;
        Ok(animation)
    }

    /// The images' size, if it is given.
    pub(super) fn size(&self) -> Option<[u32; 2]> {
        self.size
    }

    /// The memory limit. All callers share it.
    pub(super) fn memory(&self) -> MemoryLimit {
        let of_machine = || self.of_machine.get_or_init(MemoryLimit::of_machine);
        self.max_memory.as_ref().unwrap_or_else(of_machine).clone()
    }

    /// The formats of colours and depths, in words.
    pub(super) fn formats(&self) -> String {
        format!("{} {}", self.color, self.depth)
    }

    /// A renderer for the scene's size.
    pub(super) fn renderer<'c>(&self, context: &'c Context, scene: &Scene) -> Result<Renderer<'c>> {
        if let Some(waste) = waste(scene) {
            note(format_args!("{waste}{}", self.planes.answer(scene)));
        }
        self.silent_renderer(context, scene)
    }

    /// The same renderer, without a note about the scene's planes.
    pub(super) fn silent_renderer<'c>(
        &self,
        context: &'c Context,
        scene: &Scene,
    ) -> Result<Renderer<'c>> {
        let renderer = Renderer::new(context, scene.size[0], scene.size[1])?;
        let renderer = renderer.with_formats(self.color, self.depth);
        let renderer = match self.planes {
            Planes::Fitted => renderer,
            Planes::Given => renderer.with_given_planes(),
        };
        Ok(match self.inverse_w {
            true => renderer.with_inverse_w(),
            false => renderer,
        })
    }
}

/// A note about the scene's near and far plane, if they waste most of a depth buffer's resolution.
fn waste(scene: &Scene) -> Option<String> {
    /// Planes that lose less than this are as good as any that a person writes down.
    const WORTH_SAYING: f64 = 16.0;
    let bounds = scene.bounds()?;
    let (given, fitted) = (scene.camera, scene.camera.close_around(bounds));
    let [given_resolution, fitted_resolution] = [given, fitted]
        .map(|camera| DepthBuffer::float(&camera, scene.size).resolution(fitted.far));
    (given_resolution > WORTH_SAYING * fitted_resolution).then(|| {
        format!(
            "near = {} and far = {} waste the depth buffer: {} away it confuses surfaces that are less than {} apart, with \
             planes close around the scene less than {}; ",
            given.near,
            given.far,
            digits(fitted.far),
            digits(given_resolution),
            digits(fitted_resolution)
        )
    })
}

/// A length, with three digits.
fn digits(length: f64) -> String {
    let places = (2 - length.abs().log10().floor() as i32).clamp(0, 12) as usize;
    format!("{length:.places$}")
}

impl Planes {
    fn answer(self, scene: &Scene) -> String {
        let Some(bounds) = scene.bounds() else {
            return String::new();
        };
        let fitted = scene.camera.close_around(bounds);
        match self {
            Self::Fitted => format!(
                "methods draw between {} and {}, which cuts nothing off (--planes given takes the scene's)",
                digits(fitted.near),
                digits(fitted.far)
            ),
            Self::Given => "methods draw between the scene's, as asked for".into(),
        }
    }
}

/// The number of notes about a scene that are shown. Thousands would hide what comes after them.
const MOST_NOTES: usize = 40;

fn size(text: &str) -> Result<[u32; 2], Error> {
    let wrong = || {
        Error::usage(
            format!("'{text}' is not a size"),
            "write width x height in pixels, such as 1024x768; neither is 0",
        )
    };
    let side = |text: &str| text.parse().ok().filter(|&side| side > 0).ok_or_else(wrong);
    let (width, height) = text.split_once(['x', 'X']).ok_or_else(wrong)?;
    Ok([side(width)?, side(height)?])
}
