//! The files that hold the samples: the header's file, a file of their own, or several files.

use std::collections::HashMap;
use std::path::PathBuf;

use super::axes::Axes;
use super::header::Header;
use crate::error::Result;
use crate::scene::MAX_BYTES;
use crate::scene::volume::reading::{Stored, beside};

/// The files. Each holds the same number of samples.
pub(super) enum Files<'h> {
    /// The file that has the header.
    Attached,
    /// One other file.
    Single(&'h str),
    /// Several files, in the order of the samples.
    Listed(&'h [String]),
    /// Several files with a number in their names.
    Numbered(Numbered<'h>),
}

/// `file%03d.raw 1 10 1`: names with numbers, from the first to the last, in steps.
pub(super) struct Numbered<'h> {
    before: &'h str,
    after: &'h str,
    /// The least number of characters of the number, and whether it is filled up with zeros.
    width: usize,
    zeros: bool,
    first: i64,
    step: i64,
    count: usize,
}

impl<'h> Files<'h> {
    pub(super) fn of(header: &'h Header, axes: &Axes) -> Result<Self> {
        let Some(field) = header.optional("data file") else {
            return Ok(Self::Attached);
        };
        let mut words = field.text.split_whitespace();
        if words.next() == Some("LIST") {
            let subdim = match words.next() {
                None => None,
                Some(word) => Some(word.parse().map_err(|_| bad_subdim(header))?),
            };
            let list = Self::Listed(&header.list);
            list.expect_count(header, axes, subdim)?;
            return Ok(list);
        }
        match Numbered::parse(&field.text) {
            None => Ok(Self::Single(&field.text)),
            Some((numbered, subdim)) => {
                let files = Self::Numbered(numbered);
                files.expect_count(header, axes, subdim)?;
                Ok(files)
            }
        }
    }

    pub(super) fn count(&self) -> usize {
        match self {
            Self::Attached | Self::Single(_) => 1,
            Self::Listed(names) => names.len(),
            Self::Numbered(numbered) => numbered.count,
        }
    }

    fn name(&self, number: usize) -> String {
        match self {
            Self::Attached => String::new(),
            Self::Single(name) => (*name).to_owned(),
            Self::Listed(names) => names[number].clone(),
            Self::Numbered(numbered) => numbered.name(number),
        }
    }

    /// Each file has the first `subdim` axes, by default all but the last. If `subdim` is the number of all axes, the
    /// last axis is divided among the files.
    fn expect_count(&self, header: &Header, axes: &Axes, subdim: Option<usize>) -> Result<()> {
        let dimension = axes.sizes.len();
        let subdim = subdim.unwrap_or(dimension - 1);
        if !(1..=dimension).contains(&subdim) {
            return Err(bad_subdim(header));
        }
        let found = self.count();
        // The product of all sizes is in range.
        let fits = if subdim == dimension {
            found > 0 && axes.sizes[dimension - 1].is_multiple_of(found)
        } else {
            axes.sizes[subdim..].iter().product::<usize>() == found
        };
        if fits {
            return Ok(());
        }
        let wanted = axes.sizes[subdim.min(dimension - 1)..]
            .iter()
            .product::<usize>();
        let what = format!(
            "it names several files, {found} of them, for {wanted} parts of {subdim} of the {dimension} axes"
        );
        Err(header.wrong("data file", what, "Name a file for each part."))
    }

    /// The sizes of all files. The header's own has these bytes.
    pub(super) fn stored(&self, header: &Header, own: &[u8]) -> Stored {
        Stored::of(own).and(self.all(header))
    }

    fn all<'f>(&'f self, header: &'f Header) -> impl Iterator<Item = PathBuf> + 'f {
        let count = match self {
            Self::Attached => 0,
            _ => self.count(),
        };
        (0..count).map(move |number| beside(header.path, &self.name(number)))
    }

    /// The paths of the files other than the header's. Their total size is compared with the limit of a single file.
    pub(super) fn paths<'f>(
        &'f self,
        header: &'f Header,
    ) -> impl Iterator<Item = Result<PathBuf>> + 'f {
        let mut sizes: HashMap<PathBuf, u64> = HashMap::new();
        let mut total = 0;
        self.all(header).enumerate().map(move |(number, path)| {
            let size = *sizes
                .entry(path.clone())
                .or_insert_with(|| std::fs::metadata(&path).map_or(0, |metadata| metadata.len()));
            total = u64::saturating_add(total, size);
            if total > MAX_BYTES {
                let what = format!(
                    "the files up to number {} have {total} bytes together; at most {MAX_BYTES} (2 GiB) are read",
                    number + 1
                );
                return Err(header.wrong("data file", what, "Crop the volume."));
            }
            Ok(path)
        })
    }
}

fn bad_subdim(header: &Header) -> crate::error::Error {
    let what = "the last number is not a number of axes";
    let remedy = "Write how many axes each file has, or leave the number out.";
    header.wrong("data file", what, remedy)
}

impl<'h> Numbered<'h> {
    /// The numbers are at the end, after the name. A name without a place for a number, or without numbers after it, is
    /// the name of a single file.
    fn parse(text: &'h str) -> Option<(Self, Option<usize>)> {
        [4, 3].into_iter().find_map(|count| Self::with(text, count))
    }

    fn with(text: &'h str, count: usize) -> Option<(Self, Option<usize>)> {
        let mut rest = text.trim_end();
        let mut numbers = Vec::new();
        for _ in 0..count {
            let (before, word) = rest.rsplit_once(char::is_whitespace)?;
            numbers.push(word.parse::<i64>().ok()?);
            rest = before.trim_end();
        }
        numbers.reverse();
        let (before, format) = rest.split_once('%')?;
        let digits = format.find(|c: char| !c.is_ascii_digit())?;
        let (width, after) = format.split_at(digits);
        let after = after.strip_prefix(['d', 'i', 'u'])?;
        let &[first, last, step, ref subdim @ ..] = numbers.as_slice() else {
            return None;
        };
        let steps = (i128::from(last) - i128::from(first)).checked_div(step.into())?;
        let named = Self {
            before,
            after,
            width: if width.is_empty() {
                0
            } else {
                width.parse().ok().filter(|&width: &usize| width < 256)?
            },
            zeros: width.starts_with('0'),
            first,
            step,
            // If the step leads away from the last number, there is no file.
            count: usize::try_from(steps).map_or(0, |steps| steps.saturating_add(1)),
        };
        let subdim = subdim
            .first()
            .map(|&axes| usize::try_from(axes).unwrap_or(0));
        Some((named, subdim))
    }

    fn name(&self, number: usize) -> String {
        let Self {
            before,
            after,
            width,
            ..
        } = *self;
        // This is between the first and the last number.
        let value = i128::from(self.first) + i128::from(self.step) * number as i128;
        if self.zeros {
            format!("{before}{value:0width$}{after}")
        } else {
            format!("{before}{value:width$}{after}")
        }
    }
}
