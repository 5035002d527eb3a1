//! Reading a volume from a file, by the ending of its name.

use std::path::{Path, PathBuf};

use glam::DAffine3;

use super::check::{self, Fault};
use super::missing::{self, Missing};
use super::{Volume, gzip, nifti, nrrd, vti};
use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;
use crate::scene::{source, stem};

/// A volume, and a sentence for each thing that was assumed or left out while reading it.
#[derive(Debug)]
pub(in crate::scene) struct Loaded {
    pub(in crate::scene) volume: Volume,
    pub(in crate::scene) notices: Vec<String>,
}

/// The options of a reader.
#[derive(Clone, Debug)]
pub(in crate::scene) struct Wish<'a> {
    /// The name of the wanted array, for files with several.
    pub(in crate::scene) array: Option<&'a str>,
    /// The meaning of samples that are not numbers.
    pub(in crate::scene) missing: Missing,
    /// The memory that files and samples may take.
    pub(in crate::scene) memory: &'a MemoryLimit,
}

impl Wish<'_> {
    /// Asks for room for so many samples of these files. A reader calls it after the header was read and before
    /// anything is allocated.
    pub(super) fn expect_room(&self, samples: usize, files: Stored) -> Result<(), Fault> {
        let bytes = samples as u64 * size_of::<f32>() as u64;
        let room = if gzip::can_hold(files.read, samples as u64) {
            self.memory.take_from_files(bytes, files.distinct)
        } else {
            // The files are cut off, and their reader reports it.
            self.memory.take(bytes)
        };
        room.map_err(|shortage| shortage.words(format_args!("{samples} samples")))
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
}

/// The endings of files that can be read, for messages.
pub(super) const ENDINGS: &str = ".nrrd, .nhdr, .nii, .nii.gz, .vti, .pvti";

/// The endings of volumes that cannot be read, what they are, and what to convert them to.
const UNREAD: [(&str, &str, &str); 12] = [
    (
        ".hdr",
        "the header of a NIfTI-1 or ANALYZE 7.5 pair (.hdr and .img)",
        ".nii",
    ),
    (
        ".img",
        "the samples of a NIfTI-1 or ANALYZE 7.5 pair (.hdr and .img)",
        ".nii",
    ),
    (
        ".hdr.gz",
        "the header of a packed NIfTI-1 pair (.hdr.gz and .img.gz)",
        ".nii.gz",
    ),
    (
        ".img.gz",
        "the samples of a packed NIfTI-1 pair (.hdr.gz and .img.gz)",
        ".nii.gz",
    ),
    (".mhd", "a MetaImage header", ".nhdr"),
    (".mha", "a MetaImage", ".nrrd"),
    (".dcm", "a DICOM slice", ".nrrd"),
    (".mgz", "a packed volume of FreeSurfer", ".nii.gz"),
    (".mgh", "a volume of FreeSurfer", ".nii"),
    (".mnc", "a MINC volume", ".nii"),
    (".vtk", "a file in VTK's legacy format", ".vti"),
    (".vtr", "a rectilinear grid of VTK", ".vti"),
];

/// Reads a volume. What a header promises is first compared with the bytes of the file, so that nothing is allocated
/// that the file's own size does not account for.
pub(in crate::scene) fn load(path: &Path, wish: &Wish) -> Result<Loaded> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let name = name.to_ascii_lowercase();
    let ends = |ending: &str| name.ends_with(ending);
    if ends(".nrrd") || ends(".nhdr") {
        expect_no_array(path, wish)?;
        nrrd::read(path, &wish.read(path)?, wish)
    } else if ends(".nii") || ends(".nii.gz") {
        expect_no_array(path, wish)?;
        nifti::read(path, &wish.read(path)?, wish)
    } else if ends(".vti") {
        vti::read(path, &wish.read(path)?, wish)
    } else if ends(".pvti") {
        vti::read_parallel(path, &wish.read(path)?, wish)
    } else {
        Err(unread(path, &name))
    }
}

fn unread(path: &Path, name: &str) -> Error {
    let known = UNREAD.iter().find(|(ending, ..)| name.ends_with(ending));
    let (what, remedy) = match known {
        None => (
            "this is not a volume that can be read".to_owned(),
            format!("Give one of {ENDINGS}."),
        ),
        Some((_, what, instead)) => (
            format!("this is {what}, which is not read"),
            format!("Convert it to {instead}; known are {ENDINGS}."),
        ),
    };
    Error::input(Place::file(path), what, remedy)
}

fn expect_no_array(path: &Path, wish: &Wish) -> Result<()> {
    let Some(array) = wish.array else {
        return Ok(());
    };
    Err(Error::input(
        Place::file(path),
        format!("there is one array without a name in this file; '{array}' is asked for"),
        "Take out `array`; only VTK's images (.vti, .pvti) have several arrays.",
    ))
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

#[cfg(test)]
mod tests {
    use super::*;

    /// 2 x 3 x 4 samples, 96 bytes in memory.
    fn files() -> [(&'static str, Vec<u8>); 3] {
        let words = "1 ".repeat(24);
        let nrrd = format!(
            "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nencoding: ascii\n\n{words}"
        );
        let vti = format!(
            "<VTKFile type=\"ImageData\"><ImageData WholeExtent=\"0 1 0 2 0 3\"><Piece><PointData><DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">{words}</DataArray></PointData></Piece></ImageData></VTKFile>"
        );
        // Offsets from nifti1.h: size, dimensions, type of the samples, their distances and position, magic.
        let mut nifti = vec![1; 352 + 24];
        nifti[..352].fill(0);
        let mut put = |at: usize, bytes: &[u8]| nifti[at..at + bytes.len()].copy_from_slice(bytes);
        put(0, &348_i32.to_le_bytes());
        for (i, length) in [3_i16, 2, 3, 4].iter().enumerate() {
            put(40 + 2 * i, &length.to_le_bytes());
            put(76 + 4 * i, &1_f32.to_le_bytes());
        }
        put(70, &2_i16.to_le_bytes());
        put(108, &352_f32.to_le_bytes());
        put(344, b"n+1\0");
        [
            ("v.nrrd", nrrd.into_bytes()),
            ("v.vti", vti.into_bytes()),
            ("v.nii", nifti),
        ]
    }

    #[test]
    fn samples_that_would_take_too_much_memory_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        for (name, bytes) in files() {
            let path = folder.path().join(name);
            std::fs::write(&path, bytes).unwrap();
            let memory = MemoryLimit::of(1 << 20);
            let wish = Wish {
                array: None,
                missing: Missing::Empty,
                memory: &memory,
            };
            assert_eq!(load(&path, &wish).unwrap().volume.samples(), [1.0; 24]);
            assert_eq!(memory.left(), (1 << 20) - 96, "{name}");
            let full = MemoryLimit::of((1 << 20) + 95);
            full.take(1 << 20).unwrap();
            let (what, _) = Wish {
                memory: &full,
                ..wish
            }
            .expect_room(24, Stored::of(&[0; 96]))
            .unwrap_err();
            assert!(what.contains("24 samples take 96 bytes"), "{what}");
            assert!(what.contains("no more than 95 bytes"), "{what}");
        }
    }
}
