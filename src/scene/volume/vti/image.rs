//! An image's element: its whole extent, and its placement.

use glam::{DAffine3, DMat3, DVec3};
use roxmltree::Node;

use super::block::{Block, Kind};
use super::document::Document;
use crate::error::Result;
use crate::scene::volume::check;
use crate::scene::volume::reading::{Stored, Wish};

/// First and last index of the points along x, y and z.
pub(super) type Extent = [i64; 6];

/// The lattice that an image's pieces share.
pub(super) struct Image {
    pub(super) extent: Extent,
    /// The map from a point's indices to the world.
    affine: DAffine3,
}

impl Image {
    pub(super) fn read(document: &Document, element: Node) -> Result<Self> {
        let extent = extent(document, element, "WholeExtent")?.ok_or_else(|| {
            let remedy = "Give first and last index of x, y and z.";
            document.wrong("WholeExtent", "it is missing".into(), remedy)
        })?;
        Ok(Self {
            extent,
            affine: placement(document, element)?,
        })
    }

    /// All of its samples, which are in these files.
    pub(super) fn block(
        &self,
        document: &Document,
        kind: Kind,
        wish: &Wish,
        files: Stored,
    ) -> Result<Block> {
        let block = kind.block(self.extent);
        let count = check::dims(block.dims()).map_err(|(what, remedy)| {
            let what = match kind {
                Kind::Points => what,
                Kind::Cells => format!("{what}, in the middles of the cells"),
            };
            document.wrong("WholeExtent", what, remedy)
        })?;
        wish.expect_room(count, files, document.place("WholeExtent"))?;
        Ok(block)
    }

    /// The map from the indices of a block's samples, counted from 0, to the world.
    pub(super) fn index_to_world(&self, block: &Block, kind: Kind) -> DAffine3 {
        let first = DVec3::from_array(block.first.map(|index| index as f64));
        self.affine * kind.shift() * DAffine3::from_translation(first)
    }
}

/// The extent, or `None` if the attribute is missing.
pub(super) fn extent(document: &Document, node: Node, key: &str) -> Result<Option<Extent>> {
    let read = |word: &str| word.parse::<i32>().ok().map(i64::from);
    document.numbers(node, key, read)
}

fn placement(document: &Document, element: Node) -> Result<DAffine3> {
    let number = |word: &str| word.parse::<f64>().ok();
    let vector = |key: &str, default: DVec3| -> Result<DVec3> {
        let numbers = document.numbers(element, key, number)?;
        Ok(numbers.map_or(default, DVec3::from_array))
    };
    let origin = vector("Origin", DVec3::ZERO)?;
    let spacing = vector("Spacing", DVec3::ONE)?;
    let rows: Option<[f64; 9]> = document.numbers(element, "Direction", number)?;
    let direction = rows.map_or(DMat3::IDENTITY, |rows| {
        DMat3::from_cols_array(&rows).transpose()
    });
    let axes = direction * DMat3::from_diagonal(spacing);
    Ok(DAffine3::from_mat3_translation(axes, origin))
}
