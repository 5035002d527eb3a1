//! Reading the numbers of a line.

use super::words;

/// The most numbers of a line that have a meaning.
const MOST: usize = 7;

/// The numbers of a line.
pub(super) struct Numbers<'a> {
    /// The first numbers of the line, or `None` in place of a word that is not a finite number.
    slots: [Option<f64>; MOST],
    words: [&'a [u8]; MOST],
    /// The number of words.
    pub(super) count: usize,
    /// The first number that was written with a decimal comma.
    pub(super) comma: Option<&'a [u8]>,
}

impl<'a> Numbers<'a> {
    /// Reads the numbers after a keyword.
    pub(super) fn of(rest: &'a [u8]) -> Self {
        let mut numbers = Self {
            slots: [None; MOST],
            words: [&[]; MOST],
            count: 0,
            comma: None,
        };
        for word in words::words(rest) {
            if numbers.count < MOST {
                let number = plain(word).or_else(|| {
                    let number = with_comma(word)?;
                    numbers.comma.get_or_insert(word);
                    Some(number)
                });
                numbers.slots[numbers.count] = number;
                numbers.words[numbers.count] = word;
            }
            numbers.count += 1;
        }
        numbers
    }

    /// `N` consecutive numbers from this one on, or `None` if one is missing or not finite.
    pub(super) fn take<const N: usize>(&self, first: usize) -> Option<[f64; N]> {
        let mut taken = [0.0; N];
        for (taken, slot) in taken.iter_mut().zip(self.slots.get(first..)?) {
            *taken = (*slot)?;
        }
        (first + N <= self.count).then_some(taken)
    }

    /// The first word from this one on that is not a finite number, to be shown.
    pub(super) fn unreadable(&self, first: usize) -> Option<&'a [u8]> {
        let count = self.count.min(MOST);
        let bad = (first..count).find(|&i| self.slots[i].is_none())?;
        Some(self.words[bad])
    }
}

/// A single number.
pub(super) fn number(word: &[u8]) -> Option<f64> {
    plain(word).or_else(|| with_comma(word))
}

fn plain(word: &[u8]) -> Option<f64> {
    let number: f64 = std::str::from_utf8(word).ok()?.parse().ok()?;
    number.is_finite().then_some(number)
}

/// A number with a decimal comma, such as `1,5`, which programs write in some languages.
fn with_comma(word: &[u8]) -> Option<f64> {
    let text = std::str::from_utf8(word).ok()?;
    let (whole, fraction) = text.split_once(',')?;
    if text.contains('.') || !fraction.starts_with(|first: char| first.is_ascii_digit()) {
        return None;
    }
    plain(format!("{whole}.{fraction}").as_bytes())
}
