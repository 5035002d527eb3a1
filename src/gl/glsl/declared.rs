//! What shaders declare about themselves, in the comment lines that
//! [`set_shader_file`](crate::gl::GlMachine::set_shader_file) lists. So a new shader is a new file, in whatever folder.

use super::{Files, Source};
use crate::error::{Error, Result, did_you_mean};
use crate::steps::Shader;

/// What a fragment shader, its vertex shader and whatever they include declare.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::low_level::gl) struct Declared {
    /// The file of its vertex shader.
    pub(in crate::low_level::gl) vertex: String,
    /// It covers the screen, rather than to draw surfaces.
    pub(in crate::low_level::gl) draws_screen: bool,
    /// It looks at what classic calls have set.
    pub(in crate::low_level::gl) is_classic: bool,
    /// It is compiled with the defines of the method that runs.
    pub(in crate::low_level::gl) takes_defines: bool,
}

impl Declared {
    /// What a shader declares.
    ///
    /// # Errors
    /// There is no such shader, or a file that it names does not exist.
    pub(in crate::low_level::gl) fn read(files: &Files, Shader(name): Shader) -> Result<Self> {
        let file = format!("{name}.frag");
        if files.text(&file).is_none() {
            return Err(Error::UnknownShader {
                shader: name.into(),
                remedy: did_you_mean(name, &files.shaders().collect::<Vec<_>>()),
            });
        }
        let Source { text: fragment, .. } = Source::load_with(files, &[&file], &[])?;
        let vertex = value(&fragment, "vertex").unwrap_or("geometry.vert");
        let Source {
            text: of_vertex, ..
        } = Source::load_with(files, &[vertex], &[])?;
        Ok(Self {
            vertex: vertex.into(),
            draws_screen: value(&of_vertex, "draws") == Some("screen"),
            is_classic: value(&of_vertex, "looks at") == Some("classic state"),
            takes_defines: value(&fragment, "defines") == Some("method"),
        })
    }
}

fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    text.lines().find_map(|line| {
        let declaration = line.strip_prefix("// ")?;
        declaration.strip_prefix(key)?.strip_prefix(": ")
    })
}

#[cfg(test)]
mod tests {
    use super::super::files::EMBEDDED;
    use super::*;

    fn declared(name: &'static str) -> Result<Declared> {
        Declared::read(&Files::default(), Shader(name))
    }

    #[test]
    fn a_shader_is_what_its_lines_say() {
        let of = |name| declared(name).unwrap();
        let surface = Declared {
            vertex: "geometry.vert".into(),
            draws_screen: false,
            is_classic: false,
            takes_defines: false,
        };
        assert_eq!(of("peel"), surface);
        let layer = Declared {
            vertex: "screen.vert".into(),
            draws_screen: true,
            ..surface.clone()
        };
        assert_eq!(of("layer"), layer);
        let fixed = Declared {
            vertex: "classic/vertex.vert".into(),
            is_classic: true,
            ..surface
        };
        assert_eq!(of("classic/fixed"), fixed);
        // The line stands in what it includes.
        assert!(of("a_buffer/fill").takes_defines);
        assert!(of("ideal/changed").takes_defines && of("ideal/changed").draws_screen);
    }

    #[test]
    fn a_shader_that_does_not_exist_is_an_error_that_names_what_was_meant() {
        let error = declared("peal").unwrap_err().to_string();
        assert!(
            error.contains("'peal'") && error.contains("'peel'"),
            "{error}"
        );
    }

    #[test]
    fn an_own_shader_is_what_its_lines_say_and_its_vertex_shader_may_be_one_s_own() {
        let version = "#version 430 core\n";
        let mut files = Files::default();
        files.set("part.glsl", "// defines: method\n").unwrap();
        files
            .set(
                "mine.frag",
                &format!("{version}// vertex: mine.vert\n#include \"part.glsl\"\n"),
            )
            .unwrap();
        let error = Declared::read(&files, Shader("mine"))
            .unwrap_err()
            .to_string();
        assert!(error.contains("mine.vert"), "{error}");
        files
            .set("mine.vert", &format!("{version}// draws: screen\n"))
            .unwrap();
        let expected = Declared {
            vertex: "mine.vert".into(),
            draws_screen: true,
            is_classic: false,
            takes_defines: true,
        };
        assert_eq!(Declared::read(&files, Shader("mine")).unwrap(), expected);
    }

    #[test]
    fn every_declaration_is_one_that_is_read() {
        for (file, text) in EMBEDDED {
            for line in text.lines().filter_map(|line| line.strip_prefix("// ")) {
                let Some((key, value)) = line.split_once(": ") else {
                    continue;
                };
                let known = match key {
                    "vertex" => EMBEDDED.iter().any(|(file, _)| *file == value),
                    "draws" => value == "screen",
                    "looks at" => value == "classic state",
                    "defines" => value == "method",
                    // A sentence with a colon.
                    _ => key.contains(' ') || value.contains(' '),
                };
                assert!(known, "glsl/{file}: // {line}");
            }
        }
    }

    /// A name in a condition is defined by the text itself, by OpenGL, for volumes and depths, or by the method.
    #[test]
    fn a_file_that_asks_for_a_define_of_the_method_declares_it() {
        const OF_EVERY_PROGRAM: [&str; 3] = ["INVERSE_W", "VOLUMES", "POINTS"];
        let mut asking = 0;
        for (file, text) in EMBEDDED {
            let conditions = text.lines().filter(|line| {
                let directives = ["#if", "#elif"];
                directives
                    .iter()
                    .any(|directive| line.starts_with(directive))
            });
            let names = conditions.flat_map(|line| {
                let names = line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
                names.filter(|name| name.starts_with(|c: char| c.is_ascii_uppercase()))
            });
            let asks = names
                .filter(|name| !name.starts_with("GL_") && !OF_EVERY_PROGRAM.contains(name))
                .any(|name| !text.contains(&format!("#define {name}")));
            assert!(!asks || value(text, "defines") == Some("method"), "{file}");
            asking += u32::from(asks);
        }
        assert!(asking > 5, "{asking} files ask for a define");
    }
}
