//! Boxes of samples within a lattice that several pieces share.

use glam::{DAffine3, DVec3};

/// A box of samples: the indices of the first one, and their number along each axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Block {
    pub(super) first: [i64; 3],
    pub(super) counts: [i64; 3],
}

/// The kind of place to which samples belong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Samples at the lattice's points.
    Points,
    /// Samples of the cells between points. They are in the cells' middles.
    Cells,
}

impl Kind {
    /// The element of a piece that holds such arrays.
    pub(super) fn element(self) -> &'static str {
        match self {
            Self::Points => "PointData",
            Self::Cells => "CellData",
        }
    }

    /// The samples of an extent, which gives the first and the last index of points along x, y and z.
    pub(super) fn block(self, [x0, x1, y0, y1, z0, z1]: [i64; 6]) -> Block {
        let one_more = i64::from(self == Self::Points);
        Block {
            first: [x0, y0, z0],
            counts: [x1 - x0, y1 - y0, z1 - z0].map(|count| count + one_more),
        }
    }

    /// The map from a sample's indices to its place among the points.
    pub(super) fn shift(self) -> DAffine3 {
        match self {
            Self::Points => DAffine3::IDENTITY,
            Self::Cells => DAffine3::from_translation(DVec3::splat(0.5)),
        }
    }
}

impl Block {
    /// Whether it is empty. Programs write an empty piece where a piece got no part of the image.
    pub(super) fn is_empty(&self) -> bool {
        self.counts.iter().any(|&count| count <= 0)
    }

    /// The counts as lengths.
    pub(super) fn dims(&self) -> [usize; 3] {
        self.counts.map(|count| usize::try_from(count).unwrap_or(0))
    }

    /// The number of samples, which has been checked.
    pub(super) fn count(&self) -> usize {
        self.dims().iter().product()
    }

    /// Calls with each row that it shares with another block: where the row begins in this block and in the other, and
    /// the row's length.
    pub(super) fn for_each_common_row(
        &self,
        other: &Self,
        mut take: impl FnMut(usize, usize, usize),
    ) {
        let [x, y, z]: [[i64; 2]; 3] = std::array::from_fn(|axis| self.common(other, axis));
        if x[0] >= x[1] {
            return;
        }
        let length = (x[1] - x[0]) as usize;
        for k in z[0]..z[1] {
            for j in y[0]..y[1] {
                let begin = [x[0], j, k];
                take(self.offset(begin), other.offset(begin), length);
            }
        }
    }

    /// The first common index along an axis, and the index after the last.
    fn common(&self, other: &Self, axis: usize) -> [i64; 2] {
        let end = |block: &Self| block.first[axis] + block.counts[axis];
        [
            self.first[axis].max(other.first[axis]),
            end(self).min(end(other)),
        ]
    }

    /// The number of a sample, by indices that are within the block.
    fn offset(&self, index: [i64; 3]) -> usize {
        let [x, y, z]: [i64; 3] = std::array::from_fn(|axis| index[axis] - self.first[axis]);
        (x + self.counts[0] * (y + self.counts[1] * z)) as usize
    }
}
