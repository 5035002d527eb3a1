//! The numbers of marked pixels, row by row from the bottom. A pixel's number is how many marked pixels come before it, so
//! neither a map nor an atomic counter is needed for it, and the pixels of a part of a row have consecutive numbers.

use std::ops::Range;

/// Pixels of a row that share a word of marks.
const WORD: u32 = 32;

/// Which pixels of an image are marked, and their numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Numbers {
    /// Words of a row.
    across: u32,
    /// The marks of 32 pixels of a row, the first pixel in the lowest bit, and how many marked pixels come before them. The
    /// last word is behind the image.
    words: Vec<[u32; 2]>,
}

impl Numbers {
    /// The words of a row of an image.
    pub fn words_across([width, _]: [u32; 2]) -> u32 {
        width.div_ceil(WORD)
    }

    /// The bytes of an image's marks: a bit for each pixel, and whole words for each row.
    pub fn bytes_of_marks(size: [u32; 2]) -> u64 {
        4 * u64::from(Self::words_across(size)) * u64::from(size[1])
    }

    /// Numbers the pixels of an image of this size by their marks. More words than it has are left out.
    pub fn of(marks: &[u32], size: [u32; 2]) -> Self {
        let across = Self::words_across(size);
        let height = size[1];
        let mut before = 0;
        let marks = marks.iter().take((across * height) as usize);
        let numbered = marks.chain([&0]).map(|&marks| {
            let word = [marks, before];
            before += marks.count_ones();
            word
        });
        let words = numbered.collect();
        Self { across, words }
    }

    /// How many pixels are marked.
    pub fn count(&self) -> u32 {
        self.words.last().map_or(0, |[_, before]| *before)
    }

    /// How many marked pixels come before the pixel in column `x` from the left and row `y` from the bottom. A column may be
    /// the one behind the last.
    pub fn before(&self, x: u32, y: u32) -> u32 {
        // Behind a row of whole words the next row begins.
        let [marks, before] = self.words[(y * self.across + x / WORD) as usize];
        before + (marks & ((1 << (x % WORD)) - 1)).count_ones()
    }

    /// Whether a pixel is marked in these columns of row `y`.
    pub fn is_any(&self, columns: Range<u32>, y: u32) -> bool {
        let Range { start, end } = columns;
        let word = |x: u32| (y * self.across + x / WORD) as usize;
        let (first, last) = (word(start), word(end));
        // Of the first word those from `start` on, and of the last word those before `end`.
        let (from, before) = (u32::MAX << (start % WORD), (1 << (end % WORD)) - 1);
        let marks = |word: usize| self.words[word][0];
        match first < last {
            false => marks(first) & from & before != 0,
            true => {
                marks(first) & from != 0
                    || marks(last) & before != 0
                    || self.words[first + 1][1] != self.words[last][1]
            }
        }
    }

    /// The number of a pixel, or `None` if it is not marked.
    pub fn number(&self, [x, y]: [u32; 2]) -> Option<u32> {
        let [marks, _] = self.words[(y * self.across + x / WORD) as usize];
        (marks >> (x % WORD) & 1 != 0).then(|| self.before(x, y))
    }

    /// The words, as shaders read them.
    pub(super) fn words(&self) -> &[[u32; 2]] {
        &self.words
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marked_pixels_are_numbered_row_by_row() {
        for width in [1, 31, 32, 33, 64, 70] {
            let height = 5;
            let is_marked = |x: u32, y: u32| y != 3 && (x * 7 + y * 3) % (2 + 9 * y) < 2;
            let across = Numbers::words_across([width, height]);
            let mut marks = vec![0; (across * height) as usize];
            assert_eq!(
                Numbers::bytes_of_marks([width, height]),
                size_of_val(marks.as_slice()) as u64
            );
            let pixels = || (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
            for [x, y] in pixels().filter(|&[x, y]| is_marked(x, y)) {
                marks[(y * across + x / WORD) as usize] |= 1 << (x % WORD);
            }
            // A buffer is never empty, and may be longer.
            marks.push(u32::MAX);
            let numbers = Numbers::of(&marks, [width, height]);
            let mut before = 0;
            for [x, y] in pixels() {
                assert_eq!(numbers.before(x, y), before);
                let number = is_marked(x, y).then_some(before);
                assert_eq!(numbers.number([x, y]), number);
                before += u32::from(number.is_some());
                assert_eq!(numbers.before(x + 1, y), before);
            }
            assert_eq!(numbers.count(), before);
            for [start, y] in pixels() {
                for end in start..=width {
                    let is_any = numbers.before(start, y) < numbers.before(end, y);
                    assert_eq!(numbers.is_any(start..end, y), is_any, "{start} {end} {y}");
                }
            }
        }
    }
}
