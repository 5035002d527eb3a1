//! Faces, and their objects, groups, materials and smoothing groups.

use std::collections::HashMap;
use std::fmt::Write;
use std::path::Path;

use glam::DVec3;

use super::corner::{Corner, Counts, Here};
use super::cover::{Cover, Point};
use super::even_odd::Effort;
use super::notes::{Note, Notes};
use super::polygon;
use super::smoothing::Smoothing;
use super::vertices::Vertices;
use super::words;
use crate::error::Result;

/// The most corners of a polygon. Nobody draws a polygon with more.
const MAX_CORNERS: usize = 1 << 16;

/// The name of a material that faces use.
pub(super) struct Used {
    pub(super) name: Vec<u8>,
    /// The first line that uses it.
    pub(super) line: usize,
}

/// A model in the plain form that is passed to `tobj`.
pub(super) struct Faces<'a> {
    path: &'a Path,
    vertices: &'a Vertices,
    above: Counts,
    all: Counts,
    smoothing: Smoothing,
    /// Statements `v`, `vn`, `vt`, `f`, `g` and `usemtl`, and at the top one `mtllib` that stands for all. Numbers
    /// stand in place of names.
    pub(super) text: String,
    /// The colours of vertices that `text` adds.
    pub(super) colors: Vec<Option<[f32; 4]>>,
    /// The names of objects and groups, each at its number.
    pub(super) names: Vec<String>,
    /// The materials, each at its number.
    pub(super) materials: Vec<Used>,
    numbers: HashMap<Vec<u8>, usize>,
    /// The text after each `mtllib`, with its line.
    pub(super) libraries: Vec<(Vec<u8>, usize)>,
    /// The comments at the head of the file.
    pub(super) head: Vec<u8>,
    /// The number of faces that are drawn.
    pub(super) count: usize,
    /// The number of vertices of `text`.
    written: usize,
    effort: Effort,
    corners: Vec<Corner>,
    places: Vec<DVec3>,
}

impl<'a> Faces<'a> {
    /// Reads the faces of a file.
    pub(super) fn of(
        path: &'a Path,
        bytes: &[u8],
        vertices: &'a Vertices,
        notes: &mut Notes,
    ) -> Result<Self> {
        let mut faces = Self::new(path, bytes, vertices);
        let mut at_head = true;
        for (number, line) in words::lines(bytes) {
            let (keyword, rest) = words::split(&line);
            if keyword.first().is_none_or(|&first| first == b'#') {
                if at_head {
                    words::keep_head(&line, &mut faces.head);
                }
                continue;
            }
            at_head = false;
            faces.line(number, keyword, rest, notes)?;
        }
        Ok(faces)
    }

    fn new(path: &'a Path, bytes: &[u8], vertices: &'a Vertices) -> Self {
        let mut text = String::with_capacity(bytes.len() + bytes.len() / 4);
        text.push_str("mtllib all\n");
        vertices.write(&mut text);
        let grouped = words::lines(bytes).any(|(_, line)| words::split(&line).0 == b"s");
        Self {
            path,
            vertices,
            above: Counts::default(),
            all: Counts {
                positions: vertices.positions.len(),
                texture: vertices.texture,
                normals: vertices.normals.len(),
            },
            smoothing: Smoothing::new(grouped),
            text,
            colors: vertices.colors.clone(),
            names: Vec::new(),
            materials: Vec::new(),
            numbers: HashMap::new(),
            libraries: Vec::new(),
            head: Vec::new(),
            count: 0,
            written: vertices.positions.len(),
            effort: Effort::default(),
            corners: Vec::new(),
            places: Vec::new(),
        }
    }

    fn line(
        &mut self,
        number: usize,
        keyword: &[u8],
        rest: &[u8],
        notes: &mut Notes,
    ) -> Result<()> {
        match keyword {
            b"v" => self.above.positions += 1,
            b"vn" => self.above.normals += 1,
            b"vt" => self.above.texture += 1,
            b"f" | b"fo" => self.face(number, rest, notes)?,
            // Objects and groups are treated alike.
            b"o" | b"g" => {
                let _ = writeln!(self.text, "g {}", self.names.len());
                self.names.push(words::shown(rest));
            }
            b"s" => self.smoothing.switch(rest, &mut self.text),
            b"usemtl" => self.material(number, rest),
            b"mtllib" => self.libraries.push((rest.to_owned(), number)),
            b"l" => notes.count(Note::LineElement, number, rest),
            b"p" => notes.count(Note::PointElement, number, rest),
            b"curv" | b"curv2" | b"surf" => notes.count(Note::FreeForm, number, rest),
            _ if SILENT.contains(&keyword) => {}
            _ => notes.count(Note::UnknownKeyword, number, keyword),
        }
        Ok(())
    }

    /// Without a name it is the white material, which undefined materials also get.
    fn material(&mut self, line: usize, name: &[u8]) {
        if name.is_empty() {
            self.text.push_str("usemtl none\n");
            return;
        }
        let next = self.materials.len();
        let number = match self.numbers.get(name) {
            Some(&number) => number,
            None => {
                self.numbers.insert(name.to_owned(), next);
                let name = name.to_owned();
                self.materials.push(Used { name, line });
                next
            }
        };
        let _ = writeln!(self.text, "usemtl {number}");
    }

    fn face(&mut self, line: usize, rest: &[u8], notes: &mut Notes) -> Result<()> {
        let here = Here {
            path: self.path,
            line,
            above: self.above,
            all: self.all,
        };
        self.corners.clear();
        self.places.clear();
        for word in words::words(rest) {
            let mut corner = Corner::read(word, &here, notes)?;
            let normal = corner.normal.map(|normal| self.vertices.normals[normal]);
            if normal == Some(DVec3::ZERO) {
                notes.count(Note::NoNormal, line, word);
                corner.normal = None;
            }
            self.places.push(self.vertices.positions[corner.position]);
            self.corners.push(corner);
        }
        if self.corners.len() < 3 {
            notes.count(Note::FewCorners, line, rest);
            return Ok(());
        }
        if self.corners.len() > MAX_CORNERS {
            let what = format!(
                "a face of {} corners; at most {MAX_CORNERS} are read",
                self.corners.len()
            );
            return Err(here.wrong(rest, what, "Split the polygon into triangles."));
        }
        if let Some(bad) = self.places.iter().position(|place| !place.is_finite()) {
            let word = words::words(rest).nth(bad).unwrap_or_default();
            notes.count(Note::FaceOfUnreadable, line, word);
            return Ok(());
        }
        self.count += 1;
        self.polygon(line, rest, notes);
        Ok(())
    }

    /// Writes a face whose corners all have a place.
    fn polygon(&mut self, line: usize, rest: &[u8], notes: &mut Notes) {
        let needs_group = self.corners.iter().any(|corner| corner.normal.is_none());
        let group = match needs_group {
            true => self.smoothing.of_face(&mut self.text),
            false => None,
        };
        match polygon::cover(&self.places, &mut self.effort) {
            Cover::Fan => self.fan(group),
            Cover::Tangled => {
                notes.count(Note::TangledPolygon, line, rest);
                self.fan(group);
            }
            Cover::Triangles {
                triangles,
                added,
                crossed,
            } => {
                if triangles.is_empty() {
                    notes.count(Note::EmptyPolygon, line, rest);
                } else if crossed {
                    notes.count(Note::CrossedPolygon, line, rest);
                }
                for point in added {
                    self.add(point);
                }
                for triangle in triangles {
                    self.text.push('f');
                    for corner in triangle {
                        self.corner(self.corners[corner], group);
                    }
                    self.text.push('\n');
                }
            }
        }
    }

    /// All corners in one line, from which `tobj` makes a fan.
    fn fan(&mut self, group: Option<usize>) {
        self.text.push('f');
        for corner in 0..self.corners.len() {
            self.corner(self.corners[corner], group);
        }
        self.text.push('\n');
    }

    fn corner(&mut self, corner: Corner, group: Option<usize>) {
        let position = corner.position + 1;
        // Normal 1 stands for no normal.
        let normal = corner.normal.map_or(1, |normal| normal + 2);
        let has_normals = self.all.normals > 0;
        // A corner with a normal needs no smoothing group.
        let group = group.filter(|_| corner.normal.is_none());
        let _ = match (group, has_normals) {
            (None, false) => write!(self.text, " {position}"),
            (None, true) => write!(self.text, " {position}//{normal}"),
            (Some(group), false) => write!(self.text, " {position}/{group}"),
            (Some(group), true) => write!(self.text, " {position}/{group}/{normal}"),
        };
    }

    /// Adds a corner where two edges of the polygon cross, between the corners of one edge.
    fn add(&mut self, point: Point) {
        let [from, to] = point.between.map(|corner| self.corners[corner]);
        let color = self.colors.len();
        if !self.colors.is_empty() {
            let [a, b] = [from, to].map(|corner| self.colors[corner.position]);
            let between = |a: [f32; 4], b: [f32; 4]| {
                std::array::from_fn(|i| a[i] + (b[i] - a[i]) * point.at as f32)
            };
            self.colors.push(a.zip(b).map(|(a, b)| between(a, b)));
        }
        self.vertices
            .write_vertex(point.place, color, &mut self.text);
        let normal = from.normal;
        let position = self.written;
        self.corners.push(Corner { position, normal });
        self.written += 1;
    }
}

/// Keywords of the format that do not change the image, or that belong to a free-form curve that was counted.
const SILENT: [&[u8]; 28] = [
    b"vp",
    b"deg",
    b"bmat",
    b"step",
    b"cstype",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"mg",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"usemap",
    b"maplib",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
    b"stech",
    b"call",
    b"csh",
    b"res",
    b"cdc",
    b"cdp",
];
