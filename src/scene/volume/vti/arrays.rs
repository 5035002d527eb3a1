//! Choosing the array of a file that becomes the volume.

use roxmltree::Node;

use super::block::Kind;
use super::document::Document;
use crate::error::Result;
use crate::scene::volume::reading::Wish;

/// The chosen array, as it is found in every piece.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Choice {
    pub(super) kind: Kind,
    /// The name, or `None` for an array without a name.
    name: Option<String>,
}

/// An array of a file.
struct Array<'a> {
    kind: Kind,
    name: Option<&'a str>,
    components: &'a str,
    /// Whether the file names it as the active array.
    is_active: bool,
}

/// VTK's name for its mask of hidden samples.
const GHOSTS: &str = "vtkGhostType";

impl Array<'_> {
    /// Whether it has one number per sample.
    fn is_scalar(&self) -> bool {
        matches!(self.components, "0" | "1") && self.name != Some(GHOSTS)
    }

    fn shown(&self) -> &str {
        self.name.unwrap_or("(without a name)")
    }
}

/// Chooses among the arrays of an element: the wanted one, or else the active scalars, or else the first scalars, with
/// those of points before those of cells. `prefix` is P in files that name pieces. If neither the user nor the file
/// names the chosen array, a sentence says which one it is.
pub(super) fn choose(
    document: &Document,
    parent: Node,
    prefix: &str,
    wish: &Wish,
) -> Result<(Choice, Option<String>)> {
    let arrays = arrays(parent, prefix);
    if let Some(wanted) = wish.array {
        return Ok((wanted_one(document, &arrays, wanted)?, None));
    }
    let scalars: Vec<&Array> = arrays.iter().filter(|array| array.is_scalar()).collect();
    let active = scalars.iter().find(|array| array.is_active);
    let Some(chosen) = active.or(scalars.first()) else {
        return Err(without_scalars(document, &arrays));
    };
    let choice = Choice {
        kind: chosen.kind,
        name: chosen.name.map(str::to_owned),
    };
    let others = scalars.len() - 1;
    let notice = (active.is_none() && others > 0).then(|| {
        format!(
            "{}: of its scalars {} the first are taken, since none are marked as active; `array` in [[volume]] chooses others",
            document.path().display(),
            names(scalars.iter().copied())
        )
    });
    Ok((choice, notice))
}

fn arrays<'a>(parent: Node<'a, 'a>, prefix: &str) -> Vec<Array<'a>> {
    let mut found = Vec::new();
    for kind in [Kind::Points, Kind::Cells] {
        let element = format!("{prefix}{}", kind.element());
        let array = format!("{prefix}DataArray");
        for data in children(parent, &element) {
            let active = data.attribute("Scalars");
            found.extend(children(data, &array).map(|node| {
                let name = node.attribute("Name");
                Array {
                    kind,
                    name,
                    components: node.attribute("NumberOfComponents").unwrap_or("1").trim(),
                    is_active: active.is_some() && name == active,
                }
            }));
        }
    }
    found
}

/// The child elements of that name.
pub(super) fn children<'a, 'n>(
    parent: Node<'a, 'a>,
    name: &'n str,
) -> impl Iterator<Item = Node<'a, 'a>> + use<'a, 'n> {
    parent
        .children()
        .filter(move |node| node.has_tag_name(name))
}

fn wanted_one(document: &Document, arrays: &[Array], wanted: &str) -> Result<Choice> {
    let Some(array) = arrays.iter().find(|array| array.name == Some(wanted)) else {
        let what = format!("there is no array '{wanted}'");
        let remedy = match arrays {
            [] => "There are no arrays at all in this file.".to_owned(),
            _ => format!("Its arrays are {}.", names(arrays.iter())),
        };
        return Err(document.wrong("array", what, &remedy));
    };
    if !matches!(array.components, "0" | "1") {
        let what = format!(
            "the array '{wanted}' has {} components for each sample, and a volume is of one",
            array.components
        );
        let scalars = names(arrays.iter().filter(|array| array.is_scalar()));
        let remedy = if scalars.is_empty() {
            "Save one component, or the length, as an array of its own.".to_owned()
        } else {
            format!("Choose among its scalars: {scalars}.")
        };
        return Err(document.wrong("NumberOfComponents", what, &remedy));
    }
    Ok(Choice {
        kind: array.kind,
        name: Some(wanted.to_owned()),
    })
}

fn without_scalars(document: &Document, arrays: &[Array]) -> crate::error::Error {
    let vectors = arrays.iter().find(|array| array.name != Some(GHOSTS));
    let Some(vectors) = vectors else {
        let what = "there are no arrays of data of the points or of the cells".to_owned();
        let remedy = "Save the scalars as data of the points (PointData) or cells (CellData).";
        return document.wrong("PointData", what, remedy);
    };
    let what = format!(
        "each sample of the array '{}' has {} components, and there are no scalars beside it",
        vectors.shown(),
        vectors.components
    );
    let remedy = "Save one component, or the length, as an array of its own.";
    document.wrong("NumberOfComponents", what, remedy)
}

fn names<'a>(arrays: impl Iterator<Item = &'a Array<'a>>) -> String {
    let names: Vec<String> = arrays.map(|array| format!("'{}'", array.shown())).collect();
    names.join(", ")
}

/// The chosen array in a piece.
pub(super) fn find<'a>(
    document: &Document,
    piece: Node<'a, 'a>,
    choice: &Choice,
) -> Result<Node<'a, 'a>> {
    let element = choice.kind.element();
    let mut found = children(piece, element).flat_map(|data| children(data, "DataArray"));
    let array = found.find(|array| array.attribute("Name") == choice.name.as_deref());
    array.ok_or_else(|| {
        let name = choice.name.as_deref().unwrap_or("(without a name)");
        let what = format!("there is no array '{name}' in this piece");
        document.wrong(element, what, "Save the image again.")
    })
}
