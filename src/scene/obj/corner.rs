//! A corner of a face: `v`, `v/vt`, `v//vn` or `v/vt/vn`.

use std::path::Path;

use super::notes::{Note, Notes};
use super::words;
use crate::error::{Error, Place, Result};

/// The numbers of vertices, texture coordinates and normals above a line, from which negative indices count back, or in
/// the whole file.
#[derive(Clone, Copy, Default)]
pub(super) struct Counts {
    pub(super) positions: usize,
    pub(super) texture: usize,
    pub(super) normals: usize,
}

/// The indices of a corner, from 0.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    pub(super) position: usize,
    /// `None` if the corner names none, or one that does not exist.
    pub(super) normal: Option<usize>,
}

/// The place of a corner in the file.
pub(super) struct Here<'a> {
    pub(super) path: &'a Path,
    pub(super) line: usize,
    pub(super) above: Counts,
    pub(super) all: Counts,
}

/// The fault of an index.
enum Bad {
    Missing,
    NoNumber,
    Zero,
    NotThere(i64),
}

impl Corner {
    /// Reads a corner. Only the vertex must exist. Missing texture coordinates and normals are counted.
    pub(super) fn read(word: &[u8], here: &Here, notes: &mut Notes) -> Result<Self> {
        let mut parts = word.split(|&byte| byte == b'/');
        let position = parts.next().unwrap_or_default();
        let position = index(position, here.above.positions, here.all.positions)
            .map_err(|bad| here.refuse(word, &bad))?;
        let texture = parts.next();
        let normal = parts.next();
        // `1//2` names none, `1/` should have named one.
        let texture = texture.filter(|part| !(part.is_empty() && normal.is_some()));
        if texture.is_some_and(|part| index(part, here.above.texture, here.all.texture).is_err()) {
            notes.count(Note::NoTexture, here.line, word);
        }
        if parts.next().is_some() {
            notes.count(Note::ExtraIndex, here.line, word);
        }
        let normal = normal.and_then(|part| {
            let normal = index(part, here.above.normals, here.all.normals);
            if normal.is_err() {
                notes.count(Note::NoNormal, here.line, word);
            }
            normal.ok()
        });
        Ok(Self { position, normal })
    }
}

/// Resolves an index, which counts from 1 up, or from -1 down to the first element.
fn index(part: &[u8], above: usize, all: usize) -> Result<usize, Bad> {
    if part.is_empty() {
        return Err(Bad::Missing);
    }
    let text = std::str::from_utf8(part).map_err(|_| Bad::NoNumber)?;
    let number: i64 = text.parse().map_err(|_| Bad::NoNumber)?;
    if number == 0 {
        return Err(Bad::Zero);
    }
    let size = usize::try_from(number.unsigned_abs()).unwrap_or(usize::MAX);
    if number > 0 && size <= all {
        Ok(size - 1)
    } else if number < 0 && size <= above {
        Ok(above - size)
    } else {
        Err(Bad::NotThere(number))
    }
}

impl Here<'_> {
    /// The error of a corner without a vertex.
    fn refuse(&self, word: &[u8], bad: &Bad) -> Error {
        let (what, remedy) = match bad {
            Bad::Missing => (
                "the index of a vertex is missing".to_owned(),
                "Complete the line. If it is the file's last one, the file was cut off: get it again.",
            ),
            Bad::NoNumber => (
                "not the index of a vertex".to_owned(),
                "Indices are whole numbers, from 1 up or from -1 down.",
            ),
            Bad::Zero => (
                "there is no vertex 0".to_owned(),
                "Indices count from 1; add 1 to all of them if the file counts from 0.",
            ),
            Bad::NotThere(number) => (
                self.not_there(*number),
                "Correct the index. If vertices are missing, the file was cut off or put together wrongly.",
            ),
        };
        self.wrong(word, what, remedy)
    }

    fn not_there(&self, number: i64) -> String {
        match number {
            1.. => format!(
                "there is no vertex {number}: {} are defined",
                self.all.positions
            ),
            _ => format!(
                "there is no vertex {number}: {} are defined above this line",
                self.above.positions
            ),
        }
    }

    /// The error for this word of the line.
    pub(super) fn wrong(&self, word: &[u8], what: impl Into<String>, remedy: &str) -> Error {
        let place = Place::line(self.path, self.line).token(&words::shown(word));
        Error::input(place, what, remedy)
    }
}
