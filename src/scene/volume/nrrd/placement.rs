//! Where the samples stand: `space directions`, or else `spacings`, or else one unit apart; from `space origin` on.

use glam::{DAffine3, DMat3, DVec3};

use super::header::Header;
use crate::error::Result;

/// A placement, and the field that it is owed to.
pub(super) struct Placement {
    pub(super) affine: DAffine3,
    pub(super) field: &'static str,
}

pub(super) fn read(header: &Header) -> Result<Placement> {
    expect_space_of_three(header)?;
    let (field, axes) = if header.optional("space directions").is_some() {
        ("space directions", directions(header)?)
    } else if header.optional("spacings").is_some() {
        let spacings = header.three("spacings", "three numbers", |word| word.parse().ok())?;
        ("spacings", DMat3::from_diagonal(spacings.into()))
    } else {
        ("sizes", DMat3::IDENTITY)
    };
    let origin = match header.optional("space origin") {
        None => DVec3::ZERO,
        Some(_) => {
            let [origin] = vectors(header, "space origin")?;
            if !origin.is_finite() {
                let what = "these are not finite numbers";
                return Err(header.wrong("space origin", what, "Give three finite numbers."));
            }
            origin
        }
    };
    Ok(Placement {
        affine: DAffine3::from_mat3_translation(axes, origin),
        field,
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

fn directions(header: &Header) -> Result<DMat3> {
    let [x, y, z] = vectors(header, "space directions")?;
    Ok(DMat3::from_cols(x, y, z))
}

/// As many vectors as there must be, written `(1,0,0)`.
fn vectors<const N: usize>(header: &Header, name: &'static str) -> Result<[DVec3; N]> {
    let wrong = || {
        let what = format!("this is not {N} times (x,y,z)");
        header.wrong(
            name,
            what,
            "Write each vector as three numbers in brackets.",
        )
    };
    let text = header.required(name)?.text.trim();
    let pieces = text
        .split(')')
        .map(str::trim)
        .filter(|piece| !piece.is_empty());
    let vectors: Option<Vec<DVec3>> = pieces.map(vector).collect();
    let vectors = vectors.filter(|_| text.ends_with(')')).ok_or_else(wrong)?;
    vectors.try_into().map_err(|_| wrong())
}

/// `(1,0,0` without its end.
fn vector(text: &str) -> Option<DVec3> {
    let numbers = text.strip_prefix('(')?.split(',');
    let numbers: Option<Vec<f64>> = numbers.map(|number| number.trim().parse().ok()).collect();
    Some(DVec3::from_array(numbers?.try_into().ok()?))
}
