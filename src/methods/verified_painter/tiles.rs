//! The tiles of an image in which pixels are marked, and the triangles that touch them.

use glam::{DMat4, IVec2, Vec2, Vec3};

use super::view_order::{Triangles, in_parts};
use crate::scene::Camera;

/// The width and height of a tile, in pixels. Smaller ones leave fewer triangles; larger ones are read and summed quicker.
pub(super) const TILE: u32 = 2;

/// An image in tiles.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Tiles {
    across: u32,
    up: u32,
}

/// Which tiles are marked: as sums, from which any rectangle of tiles can be asked.
#[derive(Debug)]
pub(super) struct MarkedTiles {
    tiles: Tiles,
    /// How many are marked among the first x of the first y rows, row by row, one more of both than there are tiles.
    sums: Vec<u32>,
}

impl Tiles {
    pub(super) fn of([width, height]: [u32; 2]) -> Self {
        Self {
            across: width.div_ceil(TILE),
            up: height.div_ceil(TILE),
        }
    }

    pub(super) fn across(self) -> u32 {
        self.across
    }

    /// The bytes of the marks: a word for each tile, after the word that counts the lists.
    pub(super) fn bytes(self) -> u64 {
        4 * (1 + u64::from(self.across) * u64::from(self.up))
    }

    /// The tiles that the marks name. The first word counts the lists.
    pub(super) fn marked(self, marks: &[u32]) -> MarkedTiles {
        let width = self.across as usize + 1;
        let mut sums = vec![0; width];
        for row in marks[1..]
            .chunks_exact(self.across as usize)
            .take(self.up as usize)
        {
            let below = sums.len() - width;
            let mut sum = 0;
            sums.push(0);
            for (x, &mark) in row.iter().enumerate() {
                sum += u32::from(mark != 0);
                sums.push(sum + sums[below + x + 1]);
            }
        }
        MarkedTiles { tiles: self, sums }
    }
}

impl MarkedTiles {
    /// Whether a tile is marked that has one of these pixels, from the lower left one to the upper right one, both
    /// included. They need not lie in the image.
    fn hold(&self, low: IVec2, high: IVec2) -> bool {
        let Tiles { across, up } = self.tiles;
        let tile = |pixel: i32, tiles: u32| (pixel.max(0) as u32 / TILE).min(tiles) as usize;
        let [left, right] = [low.x, high.x.saturating_add(TILE as i32)].map(|x| tile(x, across));
        let [bottom, top] = [low.y, high.y.saturating_add(TILE as i32)].map(|y| tile(y, up));
        let sum = |x: usize, y: usize| self.sums[y * (across as usize + 1) + x];
        sum(right, top) + sum(left, bottom) > sum(left, top) + sum(right, bottom)
    }
}

impl Triangles {
    /// The triangles that may have a fragment in a marked tile, in the order of submission.
    pub(super) fn touching(
        &self,
        camera: &Camera,
        size: [u32; 2],
        tiles: &MarkedTiles,
    ) -> Vec<[u32; 3]> {
        let [width, height] = size;
        let to_clip =
            camera.projection(width, height) * camera.view() * DMat4::from_translation(self.origin);
        let slack = self.slack(&to_clip, camera.near, size);
        let to_clip = to_clip.as_mat4();
        let near = camera.near as f32;
        let size = Vec2::new(width as f32, height as f32);
        // In pixels, less the half by which a pixel's centre is in it. A corner before the near plane is nowhere.
        let place = |position: &Vec3| {
            let clip = to_clip * position.extend(1.0);
            match clip.w >= near {
                true => (clip.truncate().truncate() / clip.w + 1.0) * 0.5 * size - 0.5,
                false => Vec2::NAN,
            }
        };
        let places = in_parts(&self.positions, |part| part.iter().map(place).collect());
        in_parts(&self.submitted, |part| {
            let touches = |triangle: &&[u32; 3]| {
                let [a, b, c] = triangle.map(|corner| places[corner as usize]);
                if (a + b + c).is_nan() {
                    return true;
                }
                // The pixels whose centres are in the triangle's box. Small triangles often have none.
                let low = (a.min(b).min(c) - slack).ceil().as_ivec2();
                let high = (a.max(b).max(c) + slack).floor().as_ivec2();
                low.x <= high.x && low.y <= high.y && tiles.hold(low, high)
            };
            part.iter().filter(touches).copied().collect()
        })
    }

    /// By how many pixels OpenGL may have a corner elsewhere.
    ///
    /// Drivers round to 1/16 of a pixel at the coarsest (the least GL_SUBPIXEL_BITS is 4), and compute in f32, as it is
    /// done here. Of a sum of four products, f32 has an error of 4 units in the last place of their absolute values' sum;
    /// OpenGL has two matrices. Division by w multiplies the error by at most 1 / near, and once more for w's own error.
    fn slack(&self, to_clip: &DMat4, near: f64, [width, height]: [u32; 2]) -> f32 {
        let far = self.positions.iter().copied().map(Vec3::abs);
        let far = far.fold(Vec3::ZERO, Vec3::max).as_dvec3().extend(1.0);
        let terms = |row: usize| to_clip.row(row).abs().dot(far);
        let terms = terms(0).max(terms(1)).max(terms(3));
        let unit = f64::from(f32::EPSILON);
        let error = (4.0 + 2.0 * 4.0) * unit * terms / near;
        let pixels = f64::from(width.max(height)) / 2.0;
        (1.0 / 16.0 + 2.0 * error * pixels) as f32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every rectangle of pixels, against a look at every pixel of it.
    #[test]
    fn a_rectangle_holds_a_marked_tile_if_one_of_its_pixels_is_in_one() {
        let tiles = Tiles::of([5 * TILE - 1, 3 * TILE]);
        assert_eq!((tiles.across, tiles.up), (5, 3));
        let marked_at = [[0, 0], [3, 1], [4, 2]];
        let mut marks = vec![3; 1 + 15];
        for (place, mark) in marks[1..].iter_mut().enumerate() {
            *mark = u32::from(marked_at.contains(&[place % 5, place / 5]));
        }
        let marked = tiles.marked(&marks);
        let is_marked = |x: i32, y: i32| {
            let tile =
                |pixel: i32| usize::try_from(pixel.div_euclid(TILE as i32)).unwrap_or(usize::MAX);
            marked_at.contains(&[tile(x), tile(y)])
        };
        let ranges =
            |last: i32| (-2..last).flat_map(move |low| (low..last).map(move |high| [low, high]));
        let mut held = 0;
        for [left, right] in ranges(5 * TILE as i32 + 2) {
            for [bottom, top] in ranges(3 * TILE as i32 + 2) {
                let mut pixels = (bottom..=top).flat_map(|y| (left..=right).map(move |x| (x, y)));
                let expected = pixels.any(|(x, y)| is_marked(x, y));
                held += usize::from(expected);
                let [low, high] = [IVec2::new(left, bottom), IVec2::new(right, top)];
                assert_eq!(marked.hold(low, high), expected, "{low} {high}");
            }
        }
        assert!(held > 100, "{held}");
        let [low, high] = [IVec2::MIN, IVec2::MAX];
        assert!(marked.hold(low, high) && !marked.hold(high, high));
    }
}
