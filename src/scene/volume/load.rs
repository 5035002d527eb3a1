//! A volume from a file, by its ending.

use std::path::Path;

use glam::DAffine3;

use super::check::{self, Fault};
use super::samples::{Endian, SampleType};
use super::{Volume, nifti, nrrd, vti};
use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;
use crate::scene::{source, stem};

/// A volume, and what was assumed or left out while reading it, a sentence each.
#[derive(Debug)]
pub(in crate::scene) struct Loaded {
    pub(in crate::scene) volume: Volume,
    pub(in crate::scene) notices: Vec<String>,
}

/// The endings that are read, for messages.
pub(super) const ENDINGS: &str = ".nrrd, .nhdr, .nii, .nii.gz, .vti";

/// Reads a volume. Nothing is allocated that the file's own size does not account for: what a header promises is held
/// against the bytes that are there first.
pub(in crate::scene) fn load(path: &Path, memory: &MemoryLimit) -> Result<Loaded> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.to_ascii_lowercase();
    let ends = |ending: &str| name.ends_with(ending);
    if ends(".nrrd") || ends(".nhdr") {
        nrrd::read(path, &source::read_bytes(path, memory)?, memory)
    } else if ends(".nii") || ends(".nii.gz") {
        nifti::read(path, &source::read_bytes(path, memory)?)
    } else if ends(".vti") {
        vti::read(path, &source::read_bytes(path, memory)?)
    } else {
        Err(Error::input(
            Place::file(path),
            "this is not a volume that can be read",
            format!("Give one of {ENDINGS}."),
        ))
    }
}

/// What a header says about its samples.
#[derive(Clone, Copy, Debug)]
pub(super) struct Layout {
    pub(super) dims: [usize; 3],
    pub(super) stored: SampleType,
    pub(super) endian: Endian,
}

impl Layout {
    /// Bytes of all samples. The dims have been checked, so that this stays in range.
    pub(super) fn bytes(&self) -> usize {
        self.dims.iter().product::<usize>() * self.stored.size()
    }

    /// There must be at least so many bytes as the samples take.
    pub(super) fn expect(&self, found: usize) -> Result<(), Fault> {
        if found >= self.bytes() {
            return Ok(());
        }
        let [x, y, z] = self.dims;
        Err((
            format!(
                "{x} x {y} x {z} samples of {} bytes are {} bytes, but there are {found}",
                self.stored.size(),
                self.bytes()
            ),
            "The file is cut off, or its header belongs to another one: get it again.",
        ))
    }
}

/// Builds a volume; what is wrong with samples or placement is laid to the field that they come from.
pub(super) fn finish(
    path: &Path,
    dims: [usize; 3],
    samples: Vec<f32>,
    placement: DAffine3,
    [data, place]: [Place; 2],
) -> Result<Volume> {
    let wrong = |place: Place| move |(what, remedy): Fault| Error::input(place, what, remedy);
    check::samples(&samples).map_err(wrong(data))?;
    check::placement(&placement).map_err(wrong(place))?;
    Volume::new(stem(path), dims, samples, placement)
}
