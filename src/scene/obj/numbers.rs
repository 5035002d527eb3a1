//! The lines that hold numbers only: `v`, `vn`, `vt`.

use super::words::Line;
use crate::error::{Error, Result};

/// What follows the three coordinates of a vertex.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Extra {
    Nothing,
    /// The coordinates are to be divided by it.
    Weight,
    Color,
}

/// Three coordinates (divided by their weight, if there is one), and what follows them.
pub(super) fn vertex(line: &Line) -> Result<([f32; 3], Extra)> {
    let (numbers, count) = numbers(line)?;
    let [x, y, z, w, ..] = numbers;
    match count {
        3 => Ok(([x, y, z], Extra::Nothing)),
        4 => {
            let divided = [x / w, y / w, z / w];
            if divided.iter().all(|number| number.is_finite()) {
                return Ok((divided, Extra::Weight));
            }
            let word = line.words().nth(3).unwrap_or_default();
            Err(line.wrong(
                word,
                "a weight by which the coordinates cannot be divided",
                "Give a larger weight, or none.",
            ))
        }
        6 => {
            for word in line.words().skip(3) {
                line.fraction(word, "a colour channel")?;
            }
            Ok(([x, y, z], Extra::Color))
        }
        _ => Err(wrong_count(
            line,
            "a vertex has 3 coordinates, then nothing, a weight, or red, green and blue",
            count,
        )),
    }
}

/// Three numbers.
pub(super) fn normal(line: &Line) -> Result<()> {
    match numbers(line)?.1 {
        3 => Ok(()),
        count => Err(wrong_count(line, "a normal has 3 numbers", count)),
    }
}

/// One to three numbers.
pub(super) fn texture(line: &Line) -> Result<()> {
    match numbers(line)?.1 {
        1..=3 => Ok(()),
        count => Err(wrong_count(
            line,
            "a texture coordinate has 1 to 3 numbers",
            count,
        )),
    }
}

/// The first six numbers of a line, and how many there are.
fn numbers(line: &Line) -> Result<([f32; 6], usize)> {
    let mut numbers = [0.0; 6];
    let mut count = 0;
    for word in line.words() {
        let number = line.number(word)?;
        if let Some(slot) = numbers.get_mut(count) {
            *slot = number;
        }
        count += 1;
    }
    Ok((numbers, count))
}

fn wrong_count(line: &Line, wanted: &str, count: usize) -> Error {
    line.wrong(
        line.rest,
        format!("{wanted}; this line has {count} numbers"),
        "Correct the line. If it is the file's last one, the file was cut off: get it again.",
    )
}
