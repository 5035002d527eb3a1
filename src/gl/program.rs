//! Compiling and linking.

use glow::HasContext;

use super::glsl::{Declared, Files, Source};
use super::making::{Making, named};
use crate::error::{Error, Result};
use crate::scene::{Mesh, Shading};
use crate::steps::Shader;

/// A name and a value, which a shader's source sees as a `#define`.
pub(super) type Define = (&'static str, u32);

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
    /// Links the texts of stages: of each stage the files whose texts complete each other. The context is current.
    ///
    /// A stage is one shader object. NVIDIA's driver (580.159) forgets that a shader asks for an interlock when it links
    /// several objects to one stage, and cannot compile what is left.
    pub(super) fn link(
        making: &mut Making<'_>,
        files: &Files,
        stages: &[&[&str]],
        defines: &[Define],
    ) -> Result<Self> {
        let raw = making.program()?;
        let gl = making.gl();
        let shown = |names: &[&str]| {
            let names: Vec<_> = names.iter().map(|name| files.shown(name)).collect();
            names.join(" with ")
        };
        // SAFETY: the context is current, and every object used here is made here.
        unsafe {
            for &names in stages {
                let kind = match names[0].rsplit('.').next() {
                    Some("vert") => glow::VERTEX_SHADER,
                    Some("comp") => glow::COMPUTE_SHADER,
                    _ => glow::FRAGMENT_SHADER,
                };
                let source = Source::load_with(files, names, defines)?;
                let shader = named("shader", gl.create_shader(kind))?;
                gl.shader_source(shader, &source.text);
                gl.compile_shader(shader);
                if !gl.get_shader_compile_status(shader) {
                    let log = source.explain(&gl.get_shader_info_log(shader));
                    gl.delete_shader(shader);
                    return Err(Error::Shader {
                        file: files.shown(names[0]),
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
                    file: shown(&stages.concat()),
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
    shader: Shader,
    defines: Vec<Define>,
    /// If it draws slices, too, what their part is compiled with besides.
    slices: Option<[Define; 2]>,
    /// Whether it draws mixed surfaces.
    mixed: bool,
}

impl ProgramKey {
    /// The fragment shader's name.
    pub(super) fn name(&self) -> &'static str {
        self.shader.0
    }

    /// `defines` and `more`, which comes last, are for shaders that ask for them; `inverse_w` is the near plane's distance,
    /// as the bits of a float, if depths are 1/w (`common/fragment_depth.glsl`). All that draw surfaces draw slices and mixed
    /// surfaces, too, if there are any: `surfaces` says which.
    pub(super) fn new(
        shader: Shader,
        declared: &Declared,
        defines: &[Define],
        more: Option<Define>,
        surfaces: (Option<[Define; 2]>, bool),
        inverse_w: Option<u32>,
    ) -> Self {
        let (slices, mixed) = surfaces;
        let asked_for = defines.iter().copied().chain(more);
        let inverse_w = inverse_w.map(|near| ("INVERSE_W", near));
        Self {
            shader,
            defines: asked_for
                .filter(|_| declared.takes_defines)
                .chain(inverse_w)
                .collect(),
            slices: slices.filter(|_| !declared.draws_screen),
            mixed: mixed && !declared.draws_screen,
        }
    }
}

/// What a shader's name stands for.
#[derive(Debug)]
pub(super) enum ProgramSet {
    /// A program that draws [`Objects::Screen`].
    Screen(Program),
    /// Programs that draw surfaces.
    Surface(Surfaces),
}

/// How triangles are shaded, as far as a program and its uniforms tell surfaces apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Surface {
    Unlit,
    /// With the colour of back faces if both sides have one of their own.
    Lit(Option<[f32; 3]>),
    Slice,
    /// The vertices say it.
    Mixed,
}

impl Surface {
    pub(super) fn of(mesh: &Mesh) -> Self {
        match mesh.shading {
            Shading::None => Self::Unlit,
            Shading::Flat | Shading::Lit => Self::Lit(None),
            Shading::TwoSided => Self::Lit(Some(mesh.inside)),
            Shading::Slice => Self::Slice,
        }
    }
}

/// A program for each kind of shading.
#[derive(Debug)]
pub(super) struct Surfaces {
    is_classic: bool,
    unlit: Program,
    lit: Program,
    /// It is only linked if there are slices.
    slice: Option<Program>,
    /// It is only linked if there are mixed surfaces.
    mixed: Option<Program>,
}

impl Surfaces {
    pub(super) fn of(&self, surface: Surface) -> &Program {
        match (surface, &self.slice, &self.mixed) {
            (Surface::Slice, Some(slice), _) => slice,
            (Surface::Mixed, _, Some(mixed)) => mixed,
            (Surface::Lit(_), ..) => &self.lit,
            (Surface::Unlit | Surface::Slice | Surface::Mixed, ..) => &self.unlit,
        }
    }
}

impl ProgramSet {
    /// Links what the name stands for. The context is current.
    pub(super) fn new(
        gl: &glow::Context,
        files: &Files,
        declared: &Declared,
        key: &ProgramKey,
    ) -> Result<Self> {
        let vertex = declared.vertex.as_str();
        let fragment = format!("{}.frag", key.shader.0);
        let mut making = Making::new(gl);
        if declared.draws_screen {
            let program =
                Program::link(&mut making, files, &[&[vertex], &[&fragment]], &key.defines)?;
            making.finish();
            return Ok(Self::Screen(program));
        }
        let mut with = |surface, defines: &[_]| {
            Program::link(
                &mut making,
                files,
                &[&[vertex], &[&fragment, surface]],
                defines,
            )
        };
        let surfaces = Surfaces {
            is_classic: declared.is_classic,
            unlit: with("surface/unlit.frag", &key.defines)?,
            lit: with("surface/lit.frag", &key.defines)?,
            slice: key
                .slices
                .as_ref()
                .map(|slices| {
                    // Lists that are filled from slices have no volumes of their own.
                    let is_other = |own: &&Define| slices.iter().all(|(name, _)| *name != own.0);
                    let others = key.defines.iter().filter(is_other);
                    let defines: Vec<_> = others.chain(slices).copied().collect();
                    with("surface/slice.frag", &defines)
                })
                .transpose()?,
            mixed: key
                .mixed
                .then(|| with("surface/mixed.frag", &key.defines))
                .transpose()?,
        };
        making.finish();
        Ok(Self::Surface(surfaces))
    }

    /// Whether it looks at what classic calls have set.
    pub(super) fn is_classic(&self) -> bool {
        matches!(self, Self::Surface(surfaces) if surfaces.is_classic)
    }

    /// Every program.
    pub(super) fn programs(&self) -> impl Iterator<Item = &Program> {
        let (first, more) = match self {
            Self::Screen(program) => (program, [None; 3]),
            Self::Surface(surfaces) => (
                &surfaces.unlit,
                [
                    Some(&surfaces.lit),
                    surfaces.slice.as_ref(),
                    surfaces.mixed.as_ref(),
                ],
            ),
        };
        std::iter::once(first).chain(more.into_iter().flatten())
    }
}
