//! `v`, `vn` and `vt`. They are read before all faces, because a face may stand before the vertices that it names.

use std::fmt::Write;

use glam::{DVec3, Vec3};

use super::notes::{Note, Notes};
use super::numbers::Numbers;
use super::words;
use crate::scene::source::MAX_BYTES;

/// Vertices cannot outnumber the 32-bit indices of a mesh. A vertex takes a line of at least eight bytes. A corner of a
/// face may become a vertex of its own, and takes at least two bytes.
const _: () = assert!(MAX_BYTES / 2 < u32::MAX as u64);

/// A colour of whole numbers that reaches this value goes from 0 to 255. No exporter writes a colour so bright
/// otherwise.
const TOO_BRIGHT: f64 = 16.0;

/// Everything that faces may name.
#[derive(Default)]
pub(super) struct Vertices {
    /// Positions. They are not finite if they cannot be read.
    pub(super) positions: Vec<DVec3>,
    /// Red, green, blue and opacity of each vertex; empty if none has a colour.
    pub(super) colors: Vec<Option<[f32; 4]>>,
    /// Normals. A normal that cannot be used has length zero.
    pub(super) normals: Vec<DVec3>,
    /// The number of texture coordinates.
    pub(super) texture: usize,
}

impl Vertices {
    /// Reads the vertices of a file.
    pub(super) fn of(bytes: &[u8], notes: &mut Notes) -> Self {
        let mut found = Self::default();
        let mut colors = Colors::default();
        for (number, line) in words::lines(bytes) {
            match words::split(&line) {
                (b"v", rest) => found.vertex(number, rest, &mut colors, notes),
                (b"vn", rest) => found.normals.push(normal(rest)),
                (b"vt", _) => found.texture += 1,
                _ => {}
            }
        }
        found.colors = colors.finished(found.positions.len(), notes);
        found
    }

    fn vertex(&mut self, line: usize, rest: &[u8], colors: &mut Colors, notes: &mut Notes) {
        let numbers = Numbers::of(rest);
        if let Some(word) = numbers.comma {
            notes.count(Note::DecimalComma, line, word);
        }
        let position = position(&numbers);
        if position.is_none() {
            let word = numbers.unreadable(0).unwrap_or(rest);
            notes.count(Note::UnreadableVertex, line, word);
        }
        let position = position.unwrap_or(DVec3::NAN);
        if matches!(numbers.count, 5 | 8..) {
            notes.count(Note::ExtraNumbers, line, rest);
        }
        if numbers.count > 5 {
            colors.add(self.positions.len(), line, &numbers, notes);
        }
        self.positions.push(position);
    }

    /// The text for `tobj`. In place of a colour, a vertex has the index of its colour, because `tobj` knows no opacity
    /// of vertices. Normal 1, of length zero, is for corners without a normal.
    pub(super) fn write(&self, out: &mut String) {
        for (index, &position) in self.positions.iter().enumerate() {
            self.write_vertex(position, index, out);
        }
        if !self.normals.is_empty() {
            out.push_str("vn 0 0 0\n");
        }
        for normal in &self.normals {
            // Writing to a string cannot fail.
            let _ = writeln!(out, "vn {:e} {:e} {:e}", normal.x, normal.y, normal.z);
        }
    }

    /// Adds a vertex with the colour at this index.
    pub(super) fn write_vertex(&self, position: DVec3, color: usize, out: &mut String) {
        let place = if position.is_finite() {
            position
        } else {
            DVec3::ZERO
        };
        let _ = write!(out, "v {:e} {:e} {:e}", place.x, place.y, place.z);
        let _ = match self.colors.is_empty() {
            true => writeln!(out),
            false => writeln!(out, " {color} 0 0"),
        };
    }
}

/// Three finite coordinates, divided by the weight if there is exactly one more number.
fn position(numbers: &Numbers) -> Option<DVec3> {
    let place = DVec3::from_array(numbers.take(0)?);
    let place = match numbers.count {
        4 => place / numbers.take::<1>(3)?[0],
        _ => place,
    };
    place.as_vec3().is_finite().then_some(place)
}

/// A normal, or one of length zero if it cannot be read. It is rounded to 32 bits, so that a normal too short for them
/// has length zero.
fn normal(rest: &[u8]) -> DVec3 {
    let numbers = Numbers::of(rest);
    let read = numbers
        .take(0)
        .map(|normal| DVec3::from_array(normal).as_vec3());
    read.filter(|normal| normal.is_finite())
        .unwrap_or(Vec3::ZERO)
        .as_dvec3()
}

/// Colours as they stand in the file. Their meaning is known when all of them are read.
#[derive(Default)]
struct Colors {
    /// The colours, with their vertices and lines.
    read: Vec<(usize, usize, [f64; 4])>,
}

impl Colors {
    fn add(&mut self, vertex: usize, line: usize, numbers: &Numbers, notes: &mut Notes) {
        let Some([r, g, b]) = numbers.take(3) else {
            let word = numbers.unreadable(3).unwrap_or_default();
            notes.count(Note::UnreadableColor, line, word);
            return;
        };
        // A vertex without an opacity gets an infinite one, which no scale brings below 1.
        let mut opacity = f64::INFINITY;
        if numbers.count > 6 {
            match numbers.take(6) {
                Some([own]) => {
                    notes.count(Note::VertexOpacity, line, &[]);
                    opacity = own;
                }
                None => notes.count(
                    Note::ExtraNumbers,
                    line,
                    numbers.unreadable(6).unwrap_or_default(),
                ),
            }
        }
        self.read.push((vertex, line, [r, g, b, opacity]));
    }

    fn finished(self, vertices: usize, notes: &mut Notes) -> Vec<Option<[f32; 4]>> {
        if self.read.is_empty() {
            return Vec::new();
        }
        let scale = match self.goes_to_255() {
            true => 255.0,
            false => 1.0,
        };
        let mut colors = vec![None; vertices];
        for (vertex, line, channels) in self.read {
            if scale > 1.0 {
                notes.count(Note::ColorOf255, line, &[]);
            }
            let scaled = channels.map(|channel| channel / scale);
            let beyond = scaled
                .iter()
                .find(|&&channel| !(0.0..=1.0).contains(&channel) && channel.is_finite());
            if let Some(beyond) = beyond {
                notes.count(Note::ColorClamped, line, beyond.to_string().as_bytes());
            }
            colors[vertex] = Some(scaled.map(|channel| channel.clamp(0.0, 1.0) as f32));
        }
        colors
    }

    /// Whether all colours are whole numbers of one byte, and too large for anything else.
    fn goes_to_255(&self) -> bool {
        let channels = || {
            self.read
                .iter()
                .flat_map(|(_, _, [r, g, b, _])| [*r, *g, *b])
        };
        channels().all(|channel| channel.fract() == 0.0 && (0.0..=255.0).contains(&channel))
            && channels().any(|channel| channel >= TOO_BRIGHT)
    }
}
