//! The options and the results of every reader of volumes.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use glam::DAffine3;

use super::check::{self, Fault};
use super::missing::{self, Missing};
use super::{Volume, gzip};
use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;
use crate::scene::source::{self, stem};

/// A volume, and a sentence for each thing that was assumed or left out while reading it.
#[derive(Debug)]
pub(in crate::low_level::scene) struct Loaded {
    pub(in crate::low_level::scene) volume: Volume,
    pub(in crate::low_level::scene) notices: Vec<String>,
}

/// The options of a reader.
#[derive(Clone, Debug)]
pub(in crate::low_level::scene) struct Wish<'a> {
    /// The name of the wanted array, for files with several.
    pub(in crate::low_level::scene) array: Option<&'a str>,
    /// The meaning of samples that are not numbers.
    pub(in crate::low_level::scene) missing: Missing,
    /// The memory that files and samples may take.
    pub(in crate::low_level::scene) memory: &'a MemoryLimit,
}

impl Wish<'_> {
    /// Asks for room for so many samples of these files. `place` is where a header gives their number. A reader calls it after the header was read and before
    /// anything is allocated.
    pub(super) fn expect_room(&self, samples: usize, files: Stored, place: Place) -> Result<()> {
        let bytes = samples as u64 * size_of::<f32>() as u64;
        let room = if gzip::can_hold(files.read, samples as u64) {
            self.memory.take_from_files(bytes, files.distinct)
        } else {
            // The files are cut off, and their reader reports it.
            self.memory.take(bytes)
        };
        room.map_err(|shortage| shortage.at(place, format_args!("{samples} samples")))
    }

    /// Reads another file that the first one names.
    pub(super) fn read(&self, path: &Path) -> Result<Vec<u8>> {
        source::read_bytes(path, self.memory)
    }
}

/// The sizes of the files that hold samples, in bytes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Stored {
    /// The total of all files that are read, one after the other.
    pub(super) read: u64,
    /// The total with each file counted once, even if it is read several times.
    pub(super) distinct: u64,
}

impl Stored {
    /// The size of one file.
    pub(super) fn of(bytes: &[u8]) -> Self {
        let bytes = bytes.len() as u64;
        Self {
            read: bytes,
            distinct: bytes,
        }
    }

    /// The sizes of other files with these, up to the first one that is missing, because a header can name more files than
    /// any disk has. A file with two names is one file.
    pub(super) fn and(mut self, paths: impl Iterator<Item = PathBuf>) -> Self {
        let mut known = HashSet::new();
        for path in paths {
            let (Ok(file), Ok(metadata)) = (path.canonicalize(), path.metadata()) else {
                break;
            };
            self.read = self.read.saturating_add(metadata.len());
            if known.insert(file) {
                self.distinct = self.distinct.saturating_add(metadata.len());
            }
        }
        self
    }
}

/// The path of a file that another file names. It starts at the folder of the naming file.
pub(super) fn beside(path: &Path, name: &str) -> PathBuf {
    path.parent().unwrap_or(Path::new("")).join(name)
}

/// Samples that were read, and everything that is needed to build a volume from them.
pub(super) struct Parts<'a> {
    pub(super) path: &'a Path,
    pub(super) dims: [usize; 3],
    pub(super) samples: Vec<f32>,
    pub(super) index_to_world: DAffine3,
    /// The header's field that places the samples.
    pub(super) placed_by: Place,
    pub(super) notices: Vec<String>,
}

impl Parts<'_> {
    /// Builds the volume. A fault of the placement is reported at the field that it comes from.
    pub(super) fn finish(mut self, wish: &Wish) -> Result<Loaded> {
        let wrong = |(what, remedy): Fault| Error::input(self.placed_by, what, remedy);
        check::placement(&self.index_to_world).map_err(wrong)?;
        if let Some(sentence) = missing::replace(&mut self.samples, wish.missing) {
            self.notices
                .push(format!("{}: {sentence}", self.path.display()));
        }
        Ok(Loaded {
            volume: Volume::new(
                stem(self.path),
                self.dims,
                self.samples,
                self.index_to_world,
            )?,
            notices: self.notices,
        })
    }
}
