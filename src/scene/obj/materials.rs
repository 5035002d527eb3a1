//! MTL files: what they say of the materials that a model uses, resolved to a colour and an opacity each.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

use super::faces::{Faces, Used};
use super::libraries::Libraries;
use super::look::{self, Look, LookNotes};
use super::notes::{Note, Notes};
use super::words;
use crate::scene::source;

/// What a line of a material says, and where.
#[derive(Clone, Default)]
pub(super) struct Statement {
    pub(super) line: usize,
    pub(super) rest: Vec<u8>,
}

/// A material as it stands in a file.
#[derive(Default)]
pub(super) struct Material {
    pub(super) name: Vec<u8>,
    pub(super) line: usize,
    pub(super) kd: Option<Statement>,
    pub(super) ka: Option<Statement>,
    pub(super) d: Option<Statement>,
    pub(super) tr: Option<Statement>,
    /// A picture of its colour.
    pub(super) map_kd: Option<Statement>,
    /// A picture of its opacity.
    pub(super) map_d: Option<Statement>,
    /// Any other picture.
    pub(super) map: Option<Statement>,
}

/// A material file.
pub(super) struct Library {
    pub(super) materials: Vec<Material>,
    /// What the comments before the first material say, in lower case.
    pub(super) head: Vec<u8>,
}

/// The materials that a model uses, as `tobj` reads them: `newmtl`, `Kd` and `d`, their names the numbers of [`Faces`].
pub(super) fn load(
    path: &Path,
    faces: &Faces,
    notes: &mut Notes,
    said: &mut Vec<String>,
) -> String {
    let numbers = numbers(&faces.materials);
    let mut looks: Vec<Option<Look>> = vec![None; numbers.len()];
    for file in Libraries::find(path, &faces.libraries, notes) {
        match source::read(&file) {
            Ok(bytes) => {
                let mut library = Library::read(&bytes, said, &file);
                library.head.extend(faces.head.to_ascii_lowercase());
                resolve(&library, &file, &numbers, &mut looks, said);
            }
            Err(error) => {
                let what = error.to_string();
                let what = what.lines().next().unwrap_or_default();
                said.push(format!("{what}; default materials are used"));
            }
        }
    }
    resolve_without_comment(&faces.materials, &numbers, &mut looks);
    for (used, _) in faces
        .materials
        .iter()
        .zip(&looks)
        .filter(|(_, look)| look.is_none())
    {
        notes.count(Note::MaterialUndefined, used.line, &used.name);
    }
    text(&looks)
}

/// Gives the materials of a library that are used and not defined by one before their looks.
fn resolve(
    library: &Library,
    file: &Path,
    numbers: &HashMap<&[u8], usize>,
    looks: &mut [Option<Look>],
    said: &mut Vec<String>,
) {
    let meaning = look::meaning_of_tr(library);
    let mut notes = LookNotes::default();
    let mut here = vec![false; looks.len()];
    for material in &library.materials {
        let Some(&number) = numbers.get(&material.name[..]) else {
            continue;
        };
        if here[number] {
            notes.repeated(material);
        } else if looks[number].is_none() {
            looks[number] = Some(Look::of(material, meaning, &mut notes));
            here[number] = true;
        }
    }
    said.extend(notes.sentences(file));
}

/// A number for each name that is used; and for each before a comment, `usemtl red # as before` may mean the material
/// `red`.
fn numbers(used: &[Used]) -> HashMap<&[u8], usize> {
    let names = used.iter().map(|used| &used.name[..]);
    let plain = names.clone().filter_map(words::before_comment);
    let mut numbers = HashMap::new();
    for name in names.chain(plain) {
        let next = numbers.len();
        numbers.entry(name).or_insert(next);
    }
    numbers
}

/// Gives what is defined under its name before a comment only that look.
fn resolve_without_comment(
    used: &[Used],
    numbers: &HashMap<&[u8], usize>,
    looks: &mut [Option<Look>],
) {
    for (number, used) in used.iter().enumerate() {
        let plain = words::before_comment(&used.name).map(|name| numbers[name]);
        if looks[number].is_none() {
            looks[number] = plain.and_then(|plain| looks[plain]);
        }
    }
}

fn text(looks: &[Option<Look>]) -> String {
    let mut text = String::new();
    for (number, look) in looks.iter().enumerate() {
        if let Some(Look { color, opacity }) = look {
            // Writing to a string cannot fail.
            let _ = writeln!(text, "newmtl {number}");
            if let Some([r, g, b]) = color {
                let _ = writeln!(text, "Kd {r:e} {g:e} {b:e}");
            }
            if let Some(opacity) = opacity {
                let _ = writeln!(text, "d {opacity:e}");
            }
        }
    }
    text
}

impl Library {
    fn read(bytes: &[u8], said: &mut Vec<String>, file: &Path) -> Self {
        let mut library = Self {
            materials: Vec::new(),
            head: Vec::new(),
        };
        let mut homeless = Vec::new();
        for (line, text) in words::lines(bytes) {
            let (keyword, rest) = words::split(&text);
            if keyword.first().is_none_or(|&first| first == b'#') {
                if library.materials.is_empty() {
                    library.head.extend(text.to_ascii_lowercase());
                }
            } else if keyword.eq_ignore_ascii_case(b"newmtl") {
                let name = rest.to_owned();
                library.materials.push(Material {
                    name,
                    line,
                    ..Material::default()
                });
            } else if let Some(material) = library.materials.last_mut() {
                material.statement(keyword, line, rest);
            } else {
                homeless.push(line);
            }
        }
        if let Some(first) = homeless.first() {
            let some = super::counted(homeless.len(), "line");
            let path = file.display();
            said.push(format!(
                "{path}:{first}: {some} before the first material skipped"
            ));
        }
        library
    }
}

impl Material {
    fn statement(&mut self, keyword: &[u8], line: usize, rest: &[u8]) {
        let slot = match &keyword.to_ascii_lowercase()[..] {
            b"kd" => &mut self.kd,
            b"ka" => &mut self.ka,
            b"d" => &mut self.d,
            b"tr" => &mut self.tr,
            b"map_kd" => &mut self.map_kd,
            b"map_d" | b"map_tr" | b"map_opacity" => &mut self.map_d,
            other if other.starts_with(b"map_") => &mut self.map,
            _ => return,
        };
        let rest = rest.to_owned();
        *slot = Some(Statement { line, rest });
    }
}
