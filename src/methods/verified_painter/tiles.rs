//! The tiles of an image in which pixels are marked, and the triangles that touch them.

use glam::{DMat4, Vec2, Vec3};

use super::view_order::{Triangles, in_parts};
use crate::scene::Camera;

/// The width and height of a tile, in pixels. Smaller ones leave fewer triangles; larger ones are read and summed quicker.
pub(super) const TILE: u32 = 4;

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
    /// Whether a tile is marked that the rectangle touches. Its corners are in pixels from the lower left, and it need not
    /// lie in the image.
    fn touch(&self, low: Vec2, high: Vec2) -> bool {
        let tile = |pixel: f32, tiles: u32| (pixel / TILE as f32).clamp(0.0, tiles as f32) as usize;
        let Tiles { across, up } = self.tiles;
        let [left, right] = [low.x, high.x + TILE as f32].map(|x| tile(x, across));
        let [bottom, top] = [low.y, high.y + TILE as f32].map(|y| tile(y, up));
        let sum = |x: usize, y: usize| self.sums[y * (across as usize + 1) + x];
        sum(right, top) + sum(left, bottom) > sum(left, top) + sum(right, bottom)
    }
}

impl Triangles {
    /// The triangles that touch a marked tile, or might, in the order of submission.
    pub(super) fn touching(
        &self,
        camera: &Camera,
        [width, height]: [u32; 2],
        tiles: &MarkedTiles,
    ) -> Vec<[u32; 3]> {
        let to_clip =
            camera.projection(width, height) * camera.view() * DMat4::from_translation(self.origin);
        let to_clip = to_clip.as_mat4();
        let size = Vec2::new(width as f32, height as f32);
        // A corner at or behind the eye is nowhere in the image.
        let pixel = |position: &Vec3| {
            let clip = to_clip * position.extend(1.0);
            match clip.w > 0.0 {
                true => (clip.truncate().truncate() / clip.w + 1.0) * 0.5 * size,
                false => Vec2::NAN,
            }
        };
        let pixels = in_parts(&self.positions, |part| part.iter().map(pixel).collect());
        in_parts(&self.submitted, |part| {
            let touches = |triangle: &&[u32; 3]| {
                let [a, b, c] = triangle.map(|corner| pixels[corner as usize]);
                // A pixel on each side, for what the driver rounds.
                let [low, high] = [a.min(b).min(c) - 1.0, a.max(b).max(c) + 1.0];
                (a + b + c).is_nan() || tiles.touch(low, high)
            };
            part.iter().filter(touches).copied().collect()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every rectangle of a few, against a look at every tile that it has a pixel of.
    #[test]
    fn a_rectangle_touches_a_marked_tile_if_one_of_its_pixels_is_in_one() {
        let tiles = Tiles::of([5 * TILE - 1, 3 * TILE]);
        assert_eq!((tiles.across, tiles.up), (5, 3));
        let marked_at = [[0, 0], [3, 1], [4, 2]];
        let mut marks = vec![3; 1 + 15];
        for (place, mark) in marks[1..].iter_mut().enumerate() {
            *mark = u32::from(marked_at.contains(&[place % 5, place / 5]));
        }
        let marked = tiles.marked(&marks);
        let sides = || (-2..8).map(|side| side as f32 * TILE as f32 * 0.75);
        let mut touched = 0;
        for (left, bottom) in sides().flat_map(|x| sides().map(move |y| (x, y))) {
            for (right, top) in sides().flat_map(|x| sides().map(move |y| (x, y))) {
                if right < left || top < bottom {
                    continue;
                }
                let has = |[x, y]: [usize; 2]| {
                    let overlaps = |tile: usize, low: f32, high: f32| {
                        let tile = tile as f32 * TILE as f32;
                        low < tile + TILE as f32 && high >= tile
                    };
                    overlaps(x, left, right) && overlaps(y, bottom, top)
                };
                let expected = marked_at.into_iter().any(has);
                touched += usize::from(expected);
                let [low, high] = [Vec2::new(left, bottom), Vec2::new(right, top)];
                assert_eq!(marked.touch(low, high), expected, "{low} {high}");
            }
        }
        assert!(touched > 100, "{touched}");
    }
}
