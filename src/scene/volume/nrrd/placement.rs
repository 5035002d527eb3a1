//! The placement of the samples. `space directions` gives it, or else `spacings`, or else the samples are one unit
//! apart. It starts at `space origin`. It is in the patient's axes if `space` names them, or else in the file's own.

use glam::{DAffine3, DMat3, DVec3};

use super::axes::{Axes, items};
use super::header::Header;
use crate::error::Result;
use crate::scene::volume::space::Space;

/// A placement, the field that it comes from, and its space if that is known.
pub(super) struct Placement {
    pub(super) affine: DAffine3,
    pub(super) field: &'static str,
    pub(super) space: Option<Space>,
}

pub(super) fn read(header: &Header, axes: &Axes) -> Result<Placement> {
    expect_space_of_three(header)?;
    let (field, matrix) = if header.optional("space directions").is_some() {
        ("space directions", directions(header, axes)?)
    } else if header.optional("spacings").is_some() {
        ("spacings", spacings(header, axes)?)
    } else {
        ("sizes", DMat3::IDENTITY)
    };
    let space = space(header)?;
    let affine = DAffine3::from_mat3_translation(matrix, origin(header)?);
    Ok(Placement {
        affine: space.map_or(affine, |space| space.to_world(affine)),
        field,
        space,
    })
}

fn expect_space_of_three(header: &Header) -> Result<()> {
    match header.optional("space dimension") {
        Some(field) if field.text != "3" => Err(header.wrong(
            "space dimension",
            "this is not the space that we live in",
            "Give a volume in three dimensions.",
        )),
        _ => Ok(()),
    }
}

/// The format's names of the patient's spaces. Other names (of scanners, or only left- or right-handed) do not say
/// where the patient's sides are.
fn space(header: &Header) -> Result<Option<Space>> {
    let Some(field) = header.optional("space") else {
        return Ok(None);
    };
    let name = field.text.to_ascii_lowercase();
    if name.ends_with("-time") || name.ends_with('t') && name.len() == 4 {
        let what = "this space has a time as its fourth axis";
        let remedy = "Save one moment as a volume in space alone.";
        return Err(header.wrong("space", what, remedy));
    }
    Ok(match name.as_str() {
        "right-anterior-superior" | "ras" => Some(Space::Ras),
        "left-anterior-superior" | "las" => Some(Space::Las),
        "left-posterior-superior" | "lps" => Some(Space::Lps),
        _ => None,
    })
}

fn spacings(header: &Header, axes: &Axes) -> Result<DMat3> {
    let words = header.words("spacings", axes.sizes.len())?;
    let kept = axes.kept.map(|axis| words[axis].parse().ok());
    let [Some(x), Some(y), Some(z)] = kept else {
        let what = "these are not numbers";
        return Err(header.wrong("spacings", what, "Correct the line."));
    };
    Ok(DMat3::from_diagonal(DVec3::new(x, y, z)))
}

fn directions(header: &Header, axes: &Axes) -> Result<DMat3> {
    let all: Vec<&str> = items(&header.required("space directions")?.text).collect();
    let number = axes.sizes.len();
    if all.len() != number {
        let what = format!("these are {} directions for {number} axes", all.len());
        let remedy = "Write one for each axis: three numbers in brackets, or none.";
        return Err(header.wrong("space directions", what, remedy));
    }
    let [Some(x), Some(y), Some(z)] = axes.kept.map(|axis| vector(all[axis])) else {
        let what = "these are not three times (x,y,z)";
        let remedy = "Write each direction in space as three numbers in brackets.";
        return Err(header.wrong("space directions", what, remedy));
    };
    Ok(DMat3::from_cols(x, y, z))
}

fn origin(header: &Header) -> Result<DVec3> {
    let Some(field) = header.optional("space origin") else {
        return Ok(DVec3::ZERO);
    };
    match vector(field.text.trim()) {
        Some(origin) if origin.is_finite() => Ok(origin),
        _ => {
            let what = "this is not a place (x,y,z) of finite numbers";
            Err(header.wrong(
                "space origin",
                what,
                "Give three finite numbers in brackets.",
            ))
        }
    }
}

/// A vector written `(1,0,0)`.
fn vector(text: &str) -> Option<DVec3> {
    let numbers = text.strip_prefix('(')?.strip_suffix(')')?.split(',');
    let numbers: Option<Vec<f64>> = numbers.map(|number| number.trim().parse().ok()).collect();
    Some(DVec3::from_array(numbers?.try_into().ok()?))
}
