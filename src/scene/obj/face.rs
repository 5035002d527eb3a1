//! Faces: corners, each `v`, `v/vt`, `v//vn` or `v/vt/vn`.

use std::fmt::Write;

use super::words::Line;
use crate::error::Result;

/// The most corners a polygon may have. It is made into a fan of triangles, which is right for convex ones only; a
/// line with more corners than this is no polygon that somebody drew.
const MAX_CORNERS: usize = 1 << 16;

/// How many of each kind there are so far, which is what negative indices count from.
#[derive(Clone, Copy, Default)]
pub(super) struct Defined {
    pub(super) positions: usize,
    pub(super) texture: usize,
    pub(super) normals: usize,
}

/// A corner's indices, from 1.
struct Corner {
    position: usize,
    normal: Option<usize>,
}

/// How many corners of a face have a normal, and how many do not.
#[derive(Clone, Copy, Default)]
pub(super) struct Normals {
    pub(super) with: usize,
    pub(super) without: usize,
}

/// Checks a face and writes it to `out` with absolute indices and without texture coordinates, which nothing here
/// uses. With `padded`, normal 1 is a placeholder that stands for 'none', and the others follow it.
pub(super) fn check(
    line: &Line,
    defined: &Defined,
    padded: bool,
    out: &mut String,
) -> Result<Normals> {
    let start = out.len();
    out.push('f');
    let mut normals = Normals::default();
    for word in line.words() {
        let corner = corner(line, word, defined)?;
        write_corner(out, &corner, padded);
        match corner.normal {
            Some(_) => normals.with += 1,
            None => normals.without += 1,
        }
    }
    out.push('\n');
    let corners = normals.with + normals.without;
    if corners < 3 {
        out.truncate(start);
        return Err(line.wrong(
            line.rest,
            format!("a face needs at least three corners, this has {corners}"),
            "Complete the line. If it is the file's last one, the file was cut off: get it again.",
        ));
    }
    if corners > MAX_CORNERS {
        return Err(line.wrong(
            line.rest,
            format!("a face of {corners} corners; at most {MAX_CORNERS} are read"),
            "Split the polygon into triangles.",
        ));
    }
    Ok(normals)
}

fn write_corner(out: &mut String, corner: &Corner, padded: bool) {
    // Writing to a string cannot fail.
    let _ = match (corner.normal, padded) {
        (None, false) => write!(out, " {}", corner.position),
        (Some(normal), false) => write!(out, " {}//{normal}", corner.position),
        (None, true) => write!(out, " {}//1", corner.position),
        (Some(normal), true) => write!(out, " {}//{}", corner.position, normal + 1),
    };
}

fn corner(line: &Line, word: &str, defined: &Defined) -> Result<Corner> {
    let mut parts = word.split('/');
    let position = parts.next().unwrap_or_default();
    let position = index(line, word, position, "vertex", defined.positions)?;
    let texture = parts.next();
    let normal = parts.next();
    if let Some(texture) = texture.filter(|texture| !(texture.is_empty() && normal.is_some())) {
        // Models that lost their texture coordinates still name them. Nothing here would use them.
        let defined = match defined.texture {
            0 => usize::MAX,
            some => some,
        };
        index(line, word, texture, "texture coordinate", defined)?;
    }
    let normal = normal
        .map(|normal| index(line, word, normal, "normal", defined.normals))
        .transpose()?;
    if parts.next().is_some() {
        return Err(line.wrong(
            word,
            "a corner has at most three indices",
            "Write vertex/texture/normal.",
        ));
    }
    Ok(Corner { position, normal })
}

/// An index from 1 up to `defined`, or from -1 down.
fn index(line: &Line, word: &str, part: &str, of: &str, defined: usize) -> Result<usize> {
    const CUT: &str =
        "Complete the line. If it is the file's last one, the file was cut off: get it again.";
    if part.is_empty() {
        return Err(line.wrong(word, format!("the index of a {of} is missing"), CUT));
    }
    let number: i64 = part.parse().map_err(|_| {
        line.wrong(
            word,
            format!("not the index of a {of}"),
            "Indices are whole numbers, from 1 up or from -1 down.",
        )
    })?;
    if number == 0 {
        return Err(line.wrong(
            word,
            format!("there is no {of} 0"),
            "Indices count from 1; add 1 to all of them if the file counts from 0.",
        ));
    }
    let size = usize::try_from(number.unsigned_abs()).unwrap_or(usize::MAX);
    if size > defined {
        return Err(line.wrong(
            word,
            format!("there is no {of} {number}: {defined} are defined above this line"),
            "Correct the index. If vertices are missing, the file was cut off or put together wrongly.",
        ));
    }
    Ok(if number > 0 { size } else { defined - size + 1 })
}
