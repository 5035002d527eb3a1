//! MTL files: checked line by line, and passed on with nothing but what is used here.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use super::check::Checked;
use super::words::{self, Line};
use crate::error::Result;
use crate::memory::MemoryLimit;
use crate::scene::source;

/// All materials of a model, in one MTL text of `newmtl`, `Kd`, `Ka`, `d` and `Tr`.
#[derive(Default)]
pub(super) struct Materials {
    pub(super) text: String,
    names: BTreeSet<String>,
    /// Files that name textures.
    textured: usize,
}

impl Materials {
    /// Reads the material files of a model. What is missing is said in a notice.
    pub(super) fn load(
        path: &Path,
        model: &Checked,
        notices: &mut Vec<String>,
        memory: &MemoryLimit,
    ) -> Result<Self> {
        let mut materials = Self::default();
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut seen = BTreeSet::new();
        for (names, line) in &model.libraries {
            for library in files(folder, names) {
                if !library.exists() {
                    notices.push(format!(
                        "{}:{line}: the material file '{}' is missing, default materials are used",
                        path.display(),
                        library.display()
                    ));
                } else if seen.insert(library.clone()) {
                    materials.read(&library, memory)?;
                }
            }
        }
        notices.extend(materials.undefined(path, model));
        if materials.textured > 0 {
            let display = path.display();
            notices.push(format!("{display}: textures of its materials are not used"));
        }
        Ok(materials)
    }

    /// A sentence about the materials that are used and not there, if any.
    fn undefined(&self, path: &Path, model: &Checked) -> Option<String> {
        let used = model.materials.iter();
        let undefined = used.filter(|(name, _)| !self.names.contains(*name));
        let others = undefined.clone().count().saturating_sub(1);
        let (name, line) = undefined.min_by_key(|(_, line)| **line)?;
        let and_others = match others {
            0 => " is".to_owned(),
            1 => " and 1 other are".to_owned(),
            some => format!(" and {some} others are"),
        };
        Some(format!(
            "{}:{line}: the material '{name}'{and_others} not defined, the default material is used",
            path.display()
        ))
    }

    fn read(&mut self, path: &Path, memory: &MemoryLimit) -> Result<()> {
        let bytes = source::read(path, memory)?;
        let mut textured = false;
        let mut named = false;
        for (number, line) in words::lines(&bytes) {
            let (keyword, rest) = words::split(&line);
            match keyword {
                b"newmtl" => {
                    self.start(&words::text(path, number, rest)?)?;
                    named = true;
                }
                b"Kd" | b"Ka" | b"d" | b"Tr" => {
                    let line = words::text(path, number, rest)?;
                    if !named {
                        return Err(line.wrong(
                            line.rest,
                            "this belongs to no material",
                            "Put a `newmtl` line with a name before it.",
                        ));
                    }
                    self.property(keyword, &line)?;
                }
                _ => textured |= keyword.starts_with(b"map_"),
            }
        }
        self.textured += usize::from(textured);
        Ok(())
    }

    fn start(&mut self, line: &Line) -> Result<()> {
        if line.rest.is_empty() {
            return Err(line.wrong("newmtl", "the material's name is missing", "Name it."));
        }
        self.names.insert(line.rest.to_owned());
        self.keep("newmtl", line.rest);
        Ok(())
    }

    fn property(&mut self, keyword: &[u8], line: &Line) -> Result<()> {
        match keyword {
            b"Kd" => self.color("Kd", line),
            b"Ka" => self.color("Ka", line),
            b"d" => self.fraction("d", line),
            _ => self.fraction("Tr", line),
        }
    }

    /// Three channels, or one for all three.
    fn color(&mut self, keyword: &str, line: &Line) -> Result<()> {
        if let Some(word @ ("spectral" | "xyz")) = line.words().next() {
            return Err(line.wrong(
                word,
                "colours other than red, green and blue are not read",
                "Give three numbers from 0 to 1.",
            ));
        }
        let channels: Vec<f32> = line
            .words()
            .map(|word| line.fraction(word, "a colour channel"))
            .collect::<Result<_>>()?;
        let [r, g, b] = match channels[..] {
            [grey] => [grey; 3],
            [r, g, b] => [r, g, b],
            _ => {
                return Err(line.wrong(
                    line.rest,
                    format!("a colour has 3 numbers, this has {}", channels.len()),
                    "Give red, green and blue. If it is the last line, the file was cut off.",
                ));
            }
        };
        self.keep(keyword, &format!("{r} {g} {b}"));
        Ok(())
    }

    /// `d 0.5`, or `d -halo 0.5`, whose dependence on the viewing angle is left out.
    fn fraction(&mut self, keyword: &str, line: &Line) -> Result<()> {
        let Some(word) = line.words().find(|&word| word != "-halo") else {
            return Err(line.wrong(
                keyword,
                "the number is missing",
                "Give one from 0 to 1. If it is the last line, the file was cut off.",
            ));
        };
        let number = line.fraction(word, "an opacity or transparency")?;
        self.keep(keyword, &number.to_string());
        Ok(())
    }

    fn keep(&mut self, keyword: &str, rest: &str) {
        for part in [keyword, " ", rest, "\n"] {
            self.text.push_str(part);
        }
    }
}

/// The files that a `mtllib` line names: its rest as one name, which may have spaces, or else each of its words.
fn files(folder: &Path, names: &str) -> Vec<PathBuf> {
    let one = folder.join(names);
    if one.exists() && !names.is_empty() {
        return vec![one];
    }
    let words = names.split_whitespace();
    words.map(|name| folder.join(name)).collect()
}
