//! An OBJ file, line by line: what is wrong is found here, with its line; what is left is plain.

use std::collections::BTreeMap;
use std::path::Path;

use super::face::{self, Defined, Normals};
use super::numbers::{self, Extra};
use super::skipped::Skipped;
use super::words::{self, Line};
use crate::error::{Error, Place, Result};
use crate::scene::source::MAX_BYTES;

/// Vertices cannot outnumber the 32-bit indices of a mesh: one takes a line of at least eight bytes, and a corner of a
/// face, each of which may become a vertex of its own, at least two.
const _: () = assert!(MAX_BYTES / 2 < u32::MAX as u64);

/// Stands for no colour: none of a real one's channels is negative.
pub(super) const NO_COLOR: f32 = -1.0;

/// A model as `tobj` reads it without surprises, and what was found on the way.
#[derive(Default)]
pub(super) struct Checked {
    /// `v`, `vn`, `f`, `g`, `usemtl`, and at the top one `mtllib` that stands for them all.
    pub(super) text: String,
    /// The material files named, each with its line.
    pub(super) libraries: Vec<(String, usize)>,
    /// The materials used, each with the line that uses it first.
    pub(super) materials: BTreeMap<String, usize>,
    /// What is left out.
    pub(super) skipped: Skipped,
}

/// What `tobj` wants for all vertices or for none. If only some have it, the others get a placeholder, and the file is
/// gone through a second time for that.
#[derive(Clone, Copy, Default, PartialEq)]
struct Padding {
    /// Vertices without a colour get [`NO_COLOR`].
    colors: bool,
    /// Corners without a normal get one of length zero, which is normal 1.
    normals: bool,
}

/// Goes through a file.
pub(super) fn check(path: &Path, bytes: &[u8]) -> Result<Checked> {
    let mut pass = Pass::new(path, Padding::default(), bytes.len());
    pass.run(bytes)?;
    let padding = pass.needed_padding();
    if padding != Padding::default() {
        pass = Pass::new(path, padding, bytes.len());
        pass.run(bytes)?;
    }
    if pass.corners.with + pass.corners.without == 0 {
        return Err(Error::input(
            Place::file(path),
            pass.why_no_faces(bytes),
            "Give a model with faces (`f`). If this one should have some, get the file again.",
        ));
    }
    Ok(pass.found)
}

struct Pass<'a> {
    path: &'a Path,
    padding: Padding,
    defined: Defined,
    colored: usize,
    corners: Normals,
    found: Checked,
}

impl<'a> Pass<'a> {
    fn new(path: &'a Path, padding: Padding, length: usize) -> Self {
        let mut found = Checked::default();
        found.text.reserve(length + length / 8);
        found.text.push_str("mtllib all\n");
        if padding.normals {
            found.text.push_str("vn 0 0 0\n");
        }
        Self {
            path,
            padding,
            defined: Defined::default(),
            colored: 0,
            corners: Normals::default(),
            found,
        }
    }

    fn run(&mut self, bytes: &[u8]) -> Result<()> {
        for (number, line) in words::lines(bytes) {
            let (keyword, rest) = words::split(&line);
            // A comment may be in any encoding.
            if !keyword.is_empty() && keyword[0] != b'#' {
                let keyword = words::text(self.path, number, keyword)?.rest;
                self.line(keyword, &words::text(self.path, number, rest)?)?;
            }
        }
        Ok(())
    }

    fn line(&mut self, keyword: &str, line: &Line) -> Result<()> {
        match keyword {
            "v" => self.vertex(line)?,
            "vn" => self.normal(line)?,
            "vt" => self.texture(line)?,
            "f" | "fo" => self.face(line)?,
            // To the reader objects and groups are the same.
            "o" | "g" => self.keep("g", line.rest),
            "usemtl" => self.material(line)?,
            "mtllib" => {
                let library = (line.rest.to_owned(), line.number);
                self.found.libraries.push(library);
            }
            _ => self.found.skipped.count(keyword, line.number),
        }
        Ok(())
    }

    fn vertex(&mut self, line: &Line) -> Result<()> {
        let ([x, y, z], extra) = numbers::vertex(line)?;
        self.defined.positions += 1;
        if extra == Extra::Color {
            self.colored += 1;
        } else if self.padding.colors {
            let placeholder = format!("{x} {y} {z} {NO_COLOR} {NO_COLOR} {NO_COLOR}");
            self.keep("v", &placeholder);
            return Ok(());
        }
        self.keep("v", line.plain());
        Ok(())
    }

    fn normal(&mut self, line: &Line) -> Result<()> {
        numbers::normal(line)?;
        self.defined.normals += 1;
        self.keep("vn", line.plain());
        Ok(())
    }

    fn texture(&mut self, line: &Line) -> Result<()> {
        numbers::texture(line)?;
        self.defined.texture += 1;
        Ok(())
    }

    fn face(&mut self, line: &Line) -> Result<()> {
        let padded = self.padding.normals;
        let normals = face::check(line, &self.defined, padded, &mut self.found.text)?;
        self.corners.with += normals.with;
        self.corners.without += normals.without;
        Ok(())
    }

    fn material(&mut self, line: &Line) -> Result<()> {
        if line.rest.is_empty() {
            return Err(line.wrong("usemtl", "the material's name is missing", "Name one."));
        }
        self.keep("usemtl", line.rest);
        if !self.found.materials.contains_key(line.rest) {
            let name = line.rest.to_owned();
            self.found.materials.insert(name, line.number);
        }
        Ok(())
    }

    fn keep(&mut self, keyword: &str, rest: &str) {
        for part in [keyword, " ", rest, "\n"] {
            self.found.text.push_str(part);
        }
    }

    fn needed_padding(&self) -> Padding {
        Padding {
            colors: self.colored > 0 && self.colored < self.defined.positions,
            normals: self.corners.with > 0 && self.corners.without > 0,
        }
    }

    fn why_no_faces(&self, bytes: &[u8]) -> &'static str {
        if bytes.is_empty() {
            "the file is empty"
        } else if self.found.skipped.has_other_shapes() {
            "the model has no faces, only lines, points or free-form curves"
        } else if self.defined.positions > 0 {
            "the model has no faces, only vertices"
        } else {
            "the model has no faces and no vertices"
        }
    }
}
