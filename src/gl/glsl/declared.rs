//! What shaders declare about themselves, in comment lines:
//!
//! | line | in | says |
//! | --- | --- | --- |
//! | `// vertex: screen.vert` | a fragment shader | its vertex shader; without the line `geometry.vert` |
//! | `// draws: screen` | a vertex shader | its programs cover the screen; without the line they draw surfaces |
//! | `// looks at: classic state` | a vertex shader | its programs are given what classic calls have set |
//! | `// defines: method` | any file | what includes it is compiled with the defines of the method that runs |
//!
//! So a new shader is a new file, in whatever folder.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::{FILES, Source};
use crate::error::{Error, Result};
use crate::steps::Shader;

/// What a fragment shader, its vertex shader and whatever they include declare.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(in crate::low_level::gl) struct Declared {
    /// The file of its vertex shader.
    pub(in crate::low_level::gl) vertex: &'static str,
    /// It covers the screen, rather than to draw surfaces.
    pub(in crate::low_level::gl) draws_screen: bool,
    /// It looks at what classic calls have set.
    pub(in crate::low_level::gl) is_classic: bool,
    /// It is compiled with the defines of the method that runs.
    pub(in crate::low_level::gl) takes_defines: bool,
}

/// What a shader declares.
///
/// # Errors
/// There is no such shader.
pub(in crate::low_level::gl) fn declared(Shader(name): Shader) -> Result<Declared> {
    // Every shader's declarations, read once.
    static SHADERS: LazyLock<HashMap<&str, Declared>> = LazyLock::new(|| {
        let fragment = |(file, _): &(&'static str, _)| file.strip_suffix(".frag");
        let shaders = FILES.iter().filter_map(fragment);
        shaders.map(|name| (name, read(name))).collect()
    });
    SHADERS.get(name).copied().ok_or_else(|| Error::Shader {
        file: format!("{name}.frag"),
        log: format!("there is no file {name}.frag in glsl/"),
    })
}

fn read(name: &str) -> Declared {
    let fragment = text(&format!("{name}.frag"));
    let named = value(&fragment, "vertex").unwrap_or("geometry.vert");
    // The name as the table has it, which outlives the text. One that is not in the table is said where it is linked.
    let in_table = FILES.iter().find(|(file, _)| *file == named);
    let vertex = in_table.map_or("a vertex shader that does not exist", |(file, _)| file);
    let of_vertex = text(vertex);
    Declared {
        vertex,
        draws_screen: value(&of_vertex, "draws") == Some("screen"),
        is_classic: value(&of_vertex, "looks at") == Some("classic state"),
        takes_defines: value(&fragment, "defines") == Some("method"),
    }
}

/// A file's text, its includes in place. One that cannot be read is said where it is compiled.
fn text(file: &str) -> String {
    Source::load_with(file, &[]).map_or_else(|_| String::new(), |source| source.text)
}

fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    text.lines().find_map(|line| {
        let declaration = line.strip_prefix("// ")?;
        declaration.strip_prefix(key)?.strip_prefix(": ")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shader_is_what_its_lines_say() {
        let of = |name| declared(Shader(name)).unwrap();
        let surface = Declared {
            vertex: "geometry.vert",
            draws_screen: false,
            is_classic: false,
            takes_defines: false,
        };
        assert_eq!(of("peel"), surface);
        let layer = Declared {
            vertex: "screen.vert",
            draws_screen: true,
            ..surface
        };
        assert_eq!(of("layer"), layer);
        let fixed = Declared {
            vertex: "classic/vertex.vert",
            is_classic: true,
            ..surface
        };
        assert_eq!(of("classic/fixed"), fixed);
        // The line stands in what it includes.
        assert!(of("a_buffer/fill").takes_defines);
        assert!(of("ideal/changed").takes_defines && of("ideal/changed").draws_screen);
    }

    #[test]
    fn a_shader_that_does_not_exist_is_an_error_that_names_its_file() {
        let error = declared(Shader("peal")).unwrap_err().to_string();
        assert!(error.contains("peal.frag"), "{error}");
    }

    #[test]
    fn every_declaration_is_one_that_is_read() {
        for (file, text) in FILES {
            for line in text.lines().filter_map(|line| line.strip_prefix("// ")) {
                let Some((key, value)) = line.split_once(": ") else {
                    continue;
                };
                let known = match key {
                    "vertex" => FILES.iter().any(|(file, _)| *file == value),
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
        for (file, text) in FILES {
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
