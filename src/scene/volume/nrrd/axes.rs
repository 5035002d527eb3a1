//! The three axes of a volume among the axes of a file. A file may have more than three; then axes of a single sample
//! are left out until three are left.

use super::header::Header;
use crate::error::Result;
use crate::scene::volume::check;

/// The file's axes, and the axes that are kept.
pub(super) struct Axes {
    /// The lengths of all axes.
    pub(super) sizes: Vec<usize>,
    /// The numbers of the axes that are kept, in their order.
    pub(super) kept: [usize; 3],
}

/// The largest number of axes that the format allows.
const MOST: usize = 16;

impl Axes {
    pub(super) fn read(header: &Header) -> Result<Self> {
        let dimension = header.required("dimension")?.text.as_str();
        let number = dimension
            .parse()
            .ok()
            .filter(|axes| (1..=MOST).contains(axes));
        let Some(number) = number else {
            let what = format!("'{dimension}' is not a number of axes from 1 to {MOST}");
            return Err(header.wrong("dimension", what, "Give a three-dimensional array."));
        };
        if number < 3 {
            let what = format!("the array has {number} axes");
            return Err(header.wrong("dimension", what, "Give a three-dimensional array."));
        }
        let words = header.words("sizes", number)?;
        let sizes: Option<Vec<usize>> = words.iter().map(|word| word.parse().ok()).collect();
        let sizes = sizes.ok_or_else(|| {
            let what = "these are not whole numbers";
            header.wrong("sizes", what, "Correct the line.")
        })?;
        let kept = kept(header, &sizes)?;
        let axes = Self { sizes, kept };
        check::dims(axes.dims()).map_err(|(what, remedy)| header.wrong("sizes", what, remedy))?;
        Ok(axes)
    }

    /// The lengths of the axes that are kept.
    pub(super) fn dims(&self) -> [usize; 3] {
        self.kept.map(|axis| self.sizes[axis])
    }
}

/// Leaves out axes until three are left: first axes of one sample that do not lie in space, then other axes of one
/// sample.
fn kept(header: &Header, sizes: &[usize]) -> Result<[usize; 3]> {
    let outside = outside_of_space(header, sizes.len());
    let mut kept: Vec<usize> = (0..sizes.len()).collect();
    for only_outside in [true, false] {
        while kept.len() > 3 {
            let single = |&axis: &usize| sizes[axis] == 1 && (!only_outside || outside[axis]);
            let Some(place) = kept.iter().position(single) else {
                break;
            };
            kept.remove(place);
        }
    }
    kept.try_into().map_err(|kept: Vec<usize>| {
        let what = format!(
            "{} of the {} axes have more than one sample; a volume has three",
            kept.len(),
            sizes.len()
        );
        let remedy =
            "Take one component or one moment out of it, and save that as a three-dimensional array.";
        header.wrong("sizes", what, remedy)
    })
}

/// The axes that have no direction in space.
fn outside_of_space(header: &Header, axes: usize) -> Vec<bool> {
    let directions = header.optional("space directions");
    let text = directions.map_or("", |field| field.text.as_str());
    let mut outside: Vec<bool> = items(text).map(|item| item == NONE).collect();
    outside.resize(axes, false);
    outside
}

/// The word that stands in place of a missing direction.
pub(super) const NONE: &str = "none";

/// The items of a list of vectors: `(1,0,0)`, brackets included, or a word.
pub(super) fn items(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text.trim_start();
    std::iter::from_fn(move || {
        if rest.is_empty() {
            return None;
        }
        let end = if rest.starts_with('(') {
            rest.find(')').map(|end| end + 1)
        } else {
            rest.find(|c: char| c.is_whitespace() || c == '(')
        };
        let (item, after) = rest.split_at(end.unwrap_or(rest.len()));
        rest = after.trim_start();
        Some(item)
    })
}
