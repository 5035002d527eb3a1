//! The files of shaders: those of `glsl/`, which the program contains, and a user's own.

use std::collections::BTreeMap;

use crate::error::{Error, Result, did_you_mean};

/// The files of `glsl/`, their names and texts: `glsl/build.rs` writes the table.
pub(super) const EMBEDDED: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/shaders.rs"));

/// The endings of files that are shaders by themselves, and not only parts that shaders include.
const WHOLE: [&str; 3] = [".frag", ".vert", ".comp"];

/// The names of all fragment shaders, as listings have them.
pub fn shaders() -> impl Iterator<Item = &'static str> {
    let fragment = |(name, _): &(&'static str, _)| name.strip_suffix(".frag");
    EMBEDDED.iter().filter_map(fragment)
}

/// The text of a file of `glsl/` by its name, as in `common/volume.glsl`, or `None` if there is no such file. With
/// [`GlMachine::set_shader_file`](crate::gl::GlMachine::set_shader_file) it can be changed.
pub fn shader_file(name: &str) -> Option<&'static str> {
    let (_, text) = EMBEDDED.iter().find(|(other, _)| *other == name)?;
    Some(text)
}

/// The files that a machine's shaders consist of.
#[derive(Debug, Default)]
pub(in crate::low_level::gl) struct Files {
    own: BTreeMap<String, String>,
}

impl Files {
    /// Adds a user's own file, or replaces the one of this name.
    ///
    /// # Errors
    /// Its name has no ending of a shader's file, or a whole shader does not begin with `#version`.
    pub(in crate::low_level::gl) fn set(&mut self, name: &str, text: &str) -> Result<()> {
        let is_whole = WHOLE.iter().any(|ending| name.ends_with(ending));
        if !is_whole && !name.ends_with(".glsl") {
            return Err(Error::FileName {
                path: name.into(),
                kind: "shader",
                remedy: "A name ends in .frag, .vert or .comp, or in .glsl if other files include it.",
            });
        }
        // What is defined for a shader is put behind its first line.
        if is_whole && !text.starts_with("#version ") {
            return Err(Error::Shader {
                file: name.into(),
                log: format!("{name}:1: a shader begins with its version, as in #version 430 core"),
            });
        }
        self.own.insert(name.into(), text.into());
        Ok(())
    }

    /// A file's text.
    pub(in crate::low_level::gl) fn text(&self, name: &str) -> Option<&str> {
        let own = self.own.get(name).map(String::as_str);
        own.or_else(|| shader_file(name))
    }

    /// A file as messages name it.
    pub(in crate::low_level::gl) fn shown(&self, name: &str) -> String {
        match self.own.contains_key(name) {
            true => name.into(),
            false => format!("glsl/{name}"),
        }
    }

    /// What to do about a file that does not exist.
    pub(super) fn meant(&self, name: &str) -> String {
        let ending = name.rfind('.').map_or("", |dot| &name[dot..]);
        let names = self.names().filter(|other| other.ends_with(ending));
        did_you_mean(name, &names.collect::<Vec<_>>())
    }

    /// The names of all fragment shaders, a user's own, too.
    pub(in crate::low_level::gl) fn shaders(&self) -> impl Iterator<Item = &str> {
        self.names().filter_map(|name| name.strip_suffix(".frag"))
    }

    fn names(&self) -> impl Iterator<Item = &str> {
        let own = self.own.keys().map(String::as_str);
        let embedded = EMBEDDED.iter().map(|(name, _)| *name);
        own.chain(embedded.filter(|name| !self.own.contains_key(*name)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_own_file_stands_in_place_of_an_embedded_one_and_is_named_without_its_folder() {
        let mut files = Files::default();
        let embedded = shader_file("peel.frag").unwrap();
        assert_eq!(files.text("peel.frag"), Some(embedded));
        assert_eq!(files.shown("peel.frag"), "glsl/peel.frag");
        files.set("peel.frag", "#version 430 core\n").unwrap();
        files.set("mine/glow.frag", "#version 430 core\n").unwrap();
        assert_eq!(files.text("peel.frag"), Some("#version 430 core\n"));
        assert_eq!(files.shown("peel.frag"), "peel.frag");
        let all: Vec<_> = files.shaders().collect();
        assert_eq!(all.len(), shaders().count() + 1);
        assert!(all.contains(&"mine/glow"));
    }

    #[test]
    fn a_name_or_a_first_line_that_no_shader_has_is_refused() {
        let mut files = Files::default();
        let version = "#version 430 core\n";
        for name in ["glow", "glow.txt", ""] {
            let error = files.set(name, version).unwrap_err();
            let named = matches!(&error, Error::FileName { path, .. } if path.as_os_str() == name);
            assert!(named, "{error}");
        }
        for text in ["", "\n#version 430 core\n", "void main() {}\n"] {
            let error = files.set("glow.frag", text).unwrap_err().to_string();
            assert!(error.contains("glow.frag:1: a shader begins"), "{error}");
        }
        files.set("part.glsl", "float part;").unwrap();
        assert_eq!(files.text("glow.frag"), None);
    }

    #[test]
    fn every_file_of_the_folder_is_embedded() {
        let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("glsl");
        let mut found = Vec::new();
        let mut folders = vec![folder.clone()];
        while let Some(folder_here) = folders.pop() {
            for entry in std::fs::read_dir(folder_here).unwrap() {
                let path = entry.unwrap().path();
                if path.is_dir() {
                    folders.push(path);
                } else {
                    let name = path.strip_prefix(&folder).unwrap();
                    found.push(name.to_str().unwrap().to_owned());
                }
            }
        }
        found.retain(|name| name != "build.rs");
        found.sort();
        let mut embedded: Vec<_> = EMBEDDED
            .iter()
            .map(|(name, _)| (*name).to_owned())
            .collect();
        embedded.sort();
        assert_eq!(found, embedded);
    }

    #[test]
    fn every_vertex_shader_marks_its_position_invariant() {
        for (name, text) in EMBEDDED.iter().filter(|(name, _)| name.ends_with(".vert")) {
            assert!(text.contains("invariant gl_Position;"), "{name}");
            assert!(text.starts_with("#version"), "{name}");
        }
    }
}
