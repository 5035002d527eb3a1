//! The materials that a model uses, each resolved to a colour and an opacity.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

use super::faces::{Faces, Used};
use super::libraries::Libraries;
use super::library::Library;
use super::look::{Look, LookNotes};
use super::notes::{Note, Notes};
use super::transparency::Tr;
use super::words;
use crate::memory::MemoryLimit;
use crate::scene::source;

/// The materials that a model uses, in the form that `tobj` reads: `newmtl`, `Kd` and `d`. Their names are the numbers
/// of [`Faces`].
pub(super) fn load(
    path: &Path,
    faces: &Faces,
    memory: &MemoryLimit,
    notes: &mut Notes,
    said: &mut Vec<String>,
) -> String {
    let numbers = numbers(&faces.materials);
    let mut looks: Vec<Option<Look>> = vec![None; numbers.len()];
    for file in Libraries::find(path, &faces.libraries, notes) {
        match source::read(&file, memory) {
            Ok(bytes) => {
                let is_used = |name: &[u8]| numbers.contains_key(name);
                let mut library = Library::read(&bytes, is_used);
                library.head.extend_from_slice(&faces.head);
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

/// Gives looks to the materials of a library that are used and that no earlier library has defined.
fn resolve(
    library: &Library,
    file: &Path,
    numbers: &HashMap<&[u8], usize>,
    looks: &mut [Option<Look>],
    said: &mut Vec<String>,
) {
    let meaning = Tr::of(&library.head, &library.evidence);
    let mut notes = LookNotes::default();
    notes.homeless(library);
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

/// A number for each name that is used, and for each name before a comment: `usemtl red # as before` may mean the
/// material `red`.
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

/// Gives a name with a comment the look of the name before the comment, if only that is defined.
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
