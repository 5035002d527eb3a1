//! Compiling and linking.

use glow::HasContext;

use super::glsl::Source;
use super::making::{Making, named};
use super::volumes::Constants;
use crate::error::{Error, Result};
use crate::scene::Shading;
use crate::steps::Shader;

/// A linked program. Deleted by its owner.
#[derive(Debug)]
pub(super) struct Program {
    pub(super) raw: glow::Program,
    /// The uniforms of `geometry.vert` and `surface/`, or `None` in a program without them.
    pub(super) view_projection: Option<glow::UniformLocation>,
    pub(super) eye: Option<glow::UniformLocation>,
    pub(super) two_sided: Option<glow::UniformLocation>,
    pub(super) inside: Option<glow::UniformLocation>,
    pub(super) first_triangle: Option<glow::UniformLocation>,
    pub(super) volume: Option<glow::UniformLocation>,
}

impl Program {
    /// Links files of `glsl/`, one vertex shader and fragment shaders that complete each other. The context is current.
    /// Every file sees the constants as `#define`s.
    pub(super) fn link(
        making: &mut Making<'_>,
        files: &[&str],
        constants: &[(&'static str, u32)],
    ) -> Result<Self> {
        let raw = making.program()?;
        let gl = making.gl();
        // SAFETY: the context is current, and every object used here is made here.
        unsafe {
            for &file in files {
                let kind = match file.rsplit('.').next() {
                    Some("vert") => glow::VERTEX_SHADER,
                    Some("comp") => glow::COMPUTE_SHADER,
                    _ => glow::FRAGMENT_SHADER,
                };
                let source = Source::load_with(file, constants)?;
                let shader = named("shader", gl.create_shader(kind))?;
                gl.shader_source(shader, &source.text);
                gl.compile_shader(shader);
                if !gl.get_shader_compile_status(shader) {
                    let log = source.explain(&gl.get_shader_info_log(shader));
                    gl.delete_shader(shader);
                    return Err(Error::Shader {
                        file: file.into(),
                        log,
                    });
                }
                gl.attach_shader(raw, shader);
                // The shader exists as long as the program.
                gl.delete_shader(shader);
            }
            gl.link_program(raw);
            if !gl.get_program_link_status(raw) {
                let log = gl.get_program_info_log(raw);
                return Err(Error::Shader {
                    file: files.join(" with glsl/"),
                    log,
                });
            }
            let uniform = |name| gl.get_uniform_location(raw, name);
            Ok(Self {
                raw,
                view_projection: uniform("view_projection"),
                eye: uniform("eye"),
                two_sided: uniform("two_sided"),
                inside: uniform("inside"),
                first_triangle: uniform("first_triangle"),
                volume: uniform("volume"),
            })
        }
    }
}

/// The key of a program: its name and its defines.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct ProgramKey {
    pub(super) shader: Shader,
    pub(super) constants: Vec<(&'static str, u32)>,
    /// The additional defines of slices, if it draws slices.
    slices: Option<Constants>,
    /// The near plane's distance, as the bits of a float, if depths are 1/w: `common/fragment_depth.glsl`.
    inverse_w: Option<u32>,
}

impl ProgramKey {
    /// Only an A-buffer's and the ideal GPU's programs are compiled with constants; `more` come last. All that draw
    /// surfaces draw slices, too, if there are any.
    pub(super) fn new(
        shader: Shader,
        constants: &[(&'static str, u32)],
        more: Option<(&'static str, u32)>,
        slices: Option<Constants>,
        inverse_w: Option<u32>,
    ) -> Self {
        let constants = if WITH_CONSTANTS
            .iter()
            .any(|folder| shader.0.starts_with(folder))
        {
            constants.iter().copied().chain(more).collect()
        } else {
            Vec::new()
        };
        let slices = slices.filter(|_| !ON_THE_SCREEN.contains(&shader.0));
        Self {
            shader,
            constants,
            slices,
            inverse_w,
        }
    }

    /// The defines of all of its files.
    fn defines(&self) -> Vec<(&'static str, u32)> {
        let inverse_w = self.inverse_w.map(|near| ("INVERSE_W", near));
        self.constants.iter().copied().chain(inverse_w).collect()
    }
}

const WITH_CONSTANTS: [&str; 2] = ["a_buffer/", "ideal/"];

/// The programs of a shader's name.
#[derive(Debug)]
pub(super) enum Linked {
    /// A program that draws [`Objects::Screen`].
    Screen(Program),
    /// Programs that draw surfaces.
    Surface(Surfaces),
}

/// A program for each kind of shading.
#[derive(Debug)]
pub(super) struct Surfaces {
    unlit: Program,
    lit: Program,
    /// It is only linked if there are slices.
    slice: Option<Program>,
}

impl Surfaces {
    pub(super) fn of(&self, shading: Shading) -> &Program {
        match (shading, &self.slice) {
            (Shading::Slice, Some(slice)) => slice,
            (Shading::None | Shading::Slice, _) => &self.unlit,
            (Shading::Flat | Shading::Lit | Shading::TwoSided, _) => &self.lit,
        }
    }
}

/// The shaders that draw [`Objects::Screen`]; all others draw surfaces.
const ON_THE_SCREEN: [&str; 13] = [
    "a_buffer/begin",
    "a_buffer/resolve",
    "a_buffer/resolve_segment",
    "clip/next_bound",
    "dual/left",
    "ideal/begin",
    "ideal/begin_as_printed",
    "ideal/begin_tight",
    "ideal/changed",
    "layer",
    "over",
    "trap",
    "under",
];

impl Linked {
    /// Links what the name stands for. The context is current.
    pub(super) fn new(gl: &glow::Context, key: &ProgramKey) -> Result<Self> {
        let Shader(name) = key.shader;
        let fragment = format!("{name}.frag");
        let defines = key.defines();
        if ON_THE_SCREEN.contains(&name) {
            let mut making = Making::new(gl);
            let files = ["screen.vert", &fragment];
            let program = Program::link(&mut making, &files, &defines)?;
            making.finish();
            return Ok(Self::Screen(program));
        }
        let vertex = match name.split_once('/') {
            Some(("classic", _)) => "classic/vertex.vert",
            Some(("invariance", _)) => "invariance/vertex.vert",
            _ => "geometry.vert",
        };
        let mut making = Making::new(gl);
        let mut with = |surface, constants: &[_]| {
            Program::link(&mut making, &[vertex, &fragment, surface], constants)
        };
        let surfaces = Surfaces {
            unlit: with("surface/unlit.frag", &defines)?,
            lit: with("surface/lit.frag", &defines)?,
            slice: key
                .slices
                .as_ref()
                .map(|slices| with("surface/slice.frag", &[&defines[..], slices].concat()))
                .transpose()?,
        };
        making.finish();
        Ok(Self::Surface(surfaces))
    }

    /// Every program.
    pub(super) fn programs(&self) -> impl Iterator<Item = &Program> {
        let (first, more) = match self {
            Self::Screen(program) => (program, [None, None]),
            Self::Surface(surfaces) => (
                &surfaces.unlit,
                [Some(&surfaces.lit), surfaces.slice.as_ref()],
            ),
        };
        std::iter::once(first).chain(more.into_iter().flatten())
    }
}
