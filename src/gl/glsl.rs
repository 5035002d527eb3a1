//! The shaders' sources, and the one thing added to GLSL: `#include "common/NAME"`. [`Files`] are those of `glsl/`, and a
//! user's own.
//!
//! An include is replaced by the file, between `#line` directives that give every file a number of its own. The driver
//! puts that number before each message, and [`Source::explain`] replaces it by the file's name.

mod declared;
mod files;

pub(super) use self::declared::Declared;
pub(super) use self::files::Files;
pub use self::files::{shader_file, shaders};

use super::network::{self, LARGEST_NETWORK};
use crate::error::{Error, Result};

/// Not a file: the comparators that sort as many elements as the constant N says, or DEEPEST if that is less, if they are not
/// too many.
const NETWORK: &str = "a_buffer/network";
/// Likewise: as many elements, one after the other.
const ELEMENTS: &str = "a_buffer/elements";
/// Likewise: as many volumes as the constant VOLUMES says.
const EACH_VOLUME: &str = "a_buffer/each_volume";
/// Likewise: the jumps of a binary search among POINTS elements.
const HALVINGS: &str = "a_buffer/halvings";

/// A shader with its includes resolved.
#[derive(Debug)]
pub(super) struct Source {
    /// The text for the driver.
    pub(super) text: String,
    /// The names of the files, by their numbers.
    files: Vec<String>,
}

impl Source {
    /// Files by their names, one behind the other, with constants as `#define`s after the first line, which is the first
    /// file's `#version`. The constants N and DEEPEST make the include `a_buffer/network`: the network that sorts the
    /// lesser of both.
    pub(super) fn load_with(
        files: &Files,
        names: &[&str],
        constants: &[(&'static str, u32)],
    ) -> Result<Self> {
        let mut source = Self {
            text: String::new(),
            files: Vec::new(),
        };
        let made = made(constants);
        let around = Around { files, made };
        for &name in names {
            let text = files.text(name).ok_or_else(|| Error::Shader {
                file: name.into(),
                log: format!("There is no file of this name. {}", files.meant(name)),
            })?;
            source.append(name, text, &around, &mut Vec::new())?;
        }
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

    /// Appends a file, its includes in place. `open` are the files that include it, the outermost first.
    fn append(
        &mut self,
        name: &str,
        text: &str,
        around: &Around<'_>,
        open: &mut Vec<String>,
    ) -> Result<()> {
        let number = self.files.len();
        let shown = around.files.shown(name);
        self.files.push(shown.clone());
        open.push(name.to_owned());
        if number > 0 {
            self.text += &format!("#line 1 {number}\n");
        }
        for (index, line) in text.lines().enumerate() {
            if number > 0 && line.starts_with("#version") {
                // The first file's holds for all.
                self.text.push('\n');
                continue;
            }
            let Some(file) = included(line) else {
                self.text += line;
                self.text.push('\n');
                continue;
            };
            let wrong = |what: String| Error::Shader {
                file: around.files.shown(&open[0]),
                log: format!("{shown}:{}: {what}", index + 1),
            };
            if open.iter().any(|other| other == file) {
                let way = open.join(" -> ");
                return Err(wrong(format!(
                    "the include of {file} is cyclic: {way} -> {file}"
                )));
            }
            let text = around.text(file).ok_or_else(|| {
                let meant = around.files.meant(file);
                wrong(format!("there is no file {file} to include. {meant}"))
            })?;
            self.append(file, text, around, open)?;
            self.text += &format!("#line {} {number}\n", index + 2);
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
                Some(file) if rest.starts_with([':', '(']) => format!("{file}{rest}"),
                _ => line.to_owned(),
            }
        });
        explained.collect::<Vec<_>>().join("\n")
    }
}

/// The files that may be included: those of the folder and a user's own, and those that are made for the constants.
struct Around<'f> {
    files: &'f Files,
    made: [(&'static str, String); 4],
}

impl Around<'_> {
    fn text(&self, name: &str) -> Option<&str> {
        let made = self.made.iter().find(|(other, _)| *other == name);
        made.map(|(_, text)| text.as_str())
            .or_else(|| self.files.text(name))
    }
}

/// The files that are made, empty if their constant is not given.
fn made(constants: &[(&'static str, u32)]) -> [(&'static str, String); 4] {
    let constant = |wanted| {
        let found = constants.iter().find(|(name, _)| *name == wanted);
        found.map(|&(_, value)| value)
    };
    let size = constant("N");
    let network = match (size, constant("DEEPEST")) {
        (Some(n), Some(deepest)) if n.is_power_of_two() && n <= LARGEST_NETWORK => {
            network::glsl(n.min(deepest) as usize)
        }
        _ => String::new(),
    };
    let elements = size.map(|n| network::elements(n as usize));
    [
        (NETWORK, network),
        (ELEMENTS, elements.unwrap_or_default()),
        (
            EACH_VOLUME,
            constant("VOLUMES").map_or_else(String::new, network::volumes),
        ),
        (
            HALVINGS,
            constant("POINTS").map_or_else(String::new, network::halvings),
        ),
    ]
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

    fn resolve(name: &str, own: &[(&str, &str)]) -> Result<Source> {
        let mut files = Files::default();
        for (name, text) in own {
            files.set(name, text).unwrap();
        }
        Source::load_with(&files, &[name], &[])
    }

    #[test]
    fn an_include_is_replaced_by_the_file_between_line_directives() {
        let files = [
            ("a.frag", "#version 430 core\n#include \"b.glsl\"\nend"),
            ("b.glsl", "middle"),
        ];
        let text = resolve("a.frag", &files).unwrap().text;
        assert_eq!(
            text,
            "#version 430 core\n#line 1 1\nmiddle\n#line 3 0\nend\n"
        );
    }

    #[test]
    fn a_log_names_the_file_instead_of_its_number() {
        let files = [("a.glsl", "#include \"b.glsl\""), ("b.glsl", "middle")];
        let source = resolve("a.glsl", &files).unwrap();
        assert_eq!(
            source.explain("1:7(3): error: no"),
            "b.glsl:7(3): error: no"
        );
        assert_eq!(
            source.explain("1(7) : error C0000: no"),
            "b.glsl(7) : error C0000: no"
        );
        assert_eq!(source.explain("2 errors"), "2 errors");
        // One of the folder is named with it.
        let source = resolve("a.glsl", &[("a.glsl", "#include \"common/clip.glsl\"")]).unwrap();
        assert_eq!(source.explain("1:7: no"), "glsl/common/clip.glsl:7: no");
    }

    #[test]
    fn an_unknown_include_is_an_error_that_names_the_line_and_what_was_meant() {
        let error = resolve("a.glsl", &[("a.glsl", "\n#include \"common/volum.glsl\"")])
            .unwrap_err()
            .to_string();
        assert!(
            error.contains("a.glsl:2: there is no file common/volum.glsl")
                && error.contains("'common/volume.glsl'"),
            "{error}"
        );
    }

    #[test]
    fn a_cyclic_include_is_an_error_that_shows_the_cycle() {
        let files = [
            ("a.glsl", "#include \"b.glsl\""),
            ("b.glsl", "#include \"a.glsl\""),
        ];
        let error = resolve("a.glsl", &files).unwrap_err().to_string();
        assert!(
            error.contains("b.glsl:1: ") && error.contains("a.glsl -> b.glsl -> a.glsl"),
            "{error}"
        );
    }

    /// The fill that the paper has is the control.
    #[test]
    fn the_ordered_fill_has_no_atomics() {
        let atomics = |name| {
            let source =
                Source::load_with(&Files::default(), &[name], &[]).expect("it is embedded");
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
