//! The shaders' sources, and the one thing added to GLSL: `#include "common/NAME"`.
//!
//! An include is replaced by the file, between `#line` directives that give every file a number of its own. The driver
//! puts that number before each message, and [`Source::explain`] replaces it by the file's name.

#[cfg(test)]
pub(crate) mod changed;
mod declared;

pub(super) use self::declared::{Declared, declared};

use super::network::{self, LARGEST_NETWORK};
use crate::error::{Error, Result};

/// The files of `glsl/`, their names and texts: `glsl/build.rs` writes the table.
const FILES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/shaders.rs"));

/// Not a file: the comparators that sort as many elements as the constant N says, or DEEPEST if that is less, if they are not
/// too many.
const NETWORK: &str = "a_buffer/network";
/// Likewise: as many elements, one after the other.
const ELEMENTS: &str = "a_buffer/elements";
/// Likewise: as many volumes as the constant VOLUMES says.
const EACH_VOLUME: &str = "a_buffer/each_volume";
/// Likewise: the jumps of a binary search among POINTS elements.
const HALVINGS: &str = "a_buffer/halvings";

/// The names of all fragment shaders, as listings have them.
pub fn shaders() -> impl Iterator<Item = &'static str> {
    FILES
        .iter()
        .filter_map(|(name, _)| name.strip_suffix(".frag"))
}

/// A shader with its includes resolved.
#[derive(Debug)]
pub(super) struct Source {
    /// The text for the driver.
    pub(super) text: String,
    /// The names of the files, by their numbers.
    files: Vec<String>,
}

impl Source {
    /// A file of `glsl/` by its name, with constants as `#define`s after its first line, which is its `#version`. The
    /// constants N and DEEPEST make the include `a_buffer/network`: the network that sorts the lesser of both.
    pub(super) fn load_with(name: &str, constants: &[(&'static str, u32)]) -> Result<Self> {
        let constant = |wanted| constants.iter().find(|(name, _)| *name == wanted);
        let size = constant("N");
        let volumes = constant("VOLUMES").map_or_else(String::new, |&(_, n)| network::volumes(n));
        let halvings = constant("POINTS").map_or_else(String::new, |&(_, n)| network::halvings(n));
        let network = match (size, constant("DEEPEST")) {
            (Some(&(_, n)), Some(&(_, deepest))) if n.is_power_of_two() && n <= LARGEST_NETWORK => {
                network::glsl(n.min(deepest) as usize)
            }
            _ => String::new(),
        };
        let elements = size.map_or_else(String::new, |&(_, n)| network::elements(n as usize));
        let mut source = Self::resolve(name, &|file| match file {
            NETWORK => Some(network.as_str()),
            ELEMENTS => Some(elements.as_str()),
            EACH_VOLUME => Some(volumes.as_str()),
            HALVINGS => Some(halvings.as_str()),
            _ => text_of(file),
        })?;
        if let (false, Some((version, rest))) = (constants.is_empty(), source.text.split_once('\n'))
        {
            let defines: String = constants
                .iter()
                .map(|(name, value)| format!("#define {name} {value}\n"))
                .collect();
            source.text = format!("{version}\n{defines}#line 2 0\n{rest}");
        }
        Ok(source)
    }

    fn resolve<'a>(name: &str, find: &dyn Fn(&str) -> Option<&'a str>) -> Result<Self> {
        let mut source = Self {
            text: String::new(),
            files: Vec::new(),
        };
        source.append(name, find, &mut Vec::new())?;
        Ok(source)
    }

    fn append<'a>(
        &mut self,
        name: &str,
        find: &dyn Fn(&str) -> Option<&'a str>,
        open: &mut Vec<String>,
    ) -> Result<()> {
        let wrong = |what: String| Error::Shader {
            file: open.last().map_or(name, |f| f).to_owned(),
            log: what,
        };
        if open.iter().any(|file| file == name) {
            return Err(wrong(format!(
                "the include of {name} is cyclic: {} -> {name}",
                open.join(" -> ")
            )));
        }
        let text = find(name).ok_or_else(|| wrong(format!("there is no file {name} in glsl/")))?;
        let number = self.files.len();
        self.files.push(name.to_owned());
        open.push(name.to_owned());
        if number > 0 {
            self.text += &format!("#line 1 {number}\n");
        }
        for (index, line) in text.lines().enumerate() {
            match included(line) {
                Some(file) => {
                    self.append(file, find, open)?;
                    self.text += &format!("#line {} {number}\n", index + 2);
                }
                None => {
                    self.text += line;
                    self.text.push('\n');
                }
            }
        }
        open.pop();
        Ok(())
    }

    /// A driver's log with the files' names in place of their numbers: Mesa writes `0:12(3): error`, NVIDIA
    /// `0(12) : error`.
    pub(super) fn explain(&self, log: &str) -> String {
        let explained = log.trim_end_matches(['\0', '\n', ' ']).lines().map(|line| {
            let digits = line.len() - line.trim_start_matches(|c: char| c.is_ascii_digit()).len();
            let (number, rest) = line.split_at(digits);
            match number
                .parse::<usize>()
                .ok()
                .and_then(|number| self.files.get(number))
            {
                Some(file) if rest.starts_with([':', '(']) => format!("glsl/{file}{rest}"),
                _ => line.to_owned(),
            }
        });
        explained.collect::<Vec<_>>().join("\n")
    }
}

/// A file's text.
pub(super) fn text_of(name: &str) -> Option<&'static str> {
    let (_, text) = FILES.iter().find(|(other, _)| *other == name)?;
    #[cfg(test)]
    let text = &changed::text(name, text);
    Some(text)
}

/// The file that a line includes.
fn included(line: &str) -> Option<&str> {
    line.trim()
        .strip_prefix("#include")?
        .trim()
        .strip_prefix('"')?
        .strip_suffix('"')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn resolve(name: &str, files: &[(&'static str, &'static str)]) -> Result<Source> {
        Source::resolve(name, &|file| {
            files
                .iter()
                .find(|(n, _)| *n == file)
                .map(|(_, text)| *text)
        })
    }

    #[test]
    fn an_include_is_replaced_by_the_file_between_line_directives() {
        let files = [
            ("a", "#version 430 core\n#include \"b\"\nend"),
            ("b", "middle"),
        ];
        let text = resolve("a", &files).unwrap().text;
        assert_eq!(
            text,
            "#version 430 core\n#line 1 1\nmiddle\n#line 3 0\nend\n"
        );
    }

    #[test]
    fn a_log_names_the_file_instead_of_its_number() {
        let files = [("a", "#include \"b\""), ("b", "middle")];
        let source = resolve("a", &files).unwrap();
        assert_eq!(
            source.explain("1:7(3): error: no"),
            "glsl/b:7(3): error: no"
        );
        assert_eq!(
            source.explain("1(7) : error C0000: no"),
            "glsl/b(7) : error C0000: no"
        );
        assert_eq!(source.explain("2 errors"), "2 errors");
    }

    #[test]
    fn an_unknown_include_is_an_error_that_names_both_files() {
        let error = resolve("a", &[("a", "#include \"b\"")])
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("glsl/a") && error.contains("no file b"),
            "{error}"
        );
    }

    #[test]
    fn a_cyclic_include_is_an_error_that_shows_the_cycle() {
        let files = [("a", "#include \"b\""), ("b", "#include \"a\"")];
        let error = resolve("a", &files).unwrap_err().to_string();
        assert!(error.contains("a -> b -> a"), "{error}");
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
        let mut embedded: Vec<_> = FILES.iter().map(|(name, _)| (*name).to_owned()).collect();
        embedded.sort();
        assert_eq!(found, embedded);
    }

    #[test]
    fn every_vertex_shader_marks_its_position_invariant() {
        for (name, text) in FILES.iter().filter(|(name, _)| name.ends_with(".vert")) {
            assert!(text.contains("invariant gl_Position;"), "{name}");
            assert!(text.starts_with("#version"), "{name}");
        }
    }

    /// The issue asks for it; the fill that the paper has is the control.
    #[test]
    fn the_ordered_fill_has_no_atomics() {
        let atomics = |name| {
            let source = Source::load_with(name, &[]).expect("it is embedded");
            let code = source
                .text
                .lines()
                .map(|line| line.split("//").next().unwrap_or(""));
            code.filter(|line| line.to_lowercase().contains("atomic"))
                .count()
        };
        assert_eq!(atomics("a_buffer/fill_ordered.frag"), 0);
        assert_eq!(atomics("a_buffer/fill.frag"), 3);
    }
}
