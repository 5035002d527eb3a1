//! Reading a volume from a file, by the ending of its name.

use std::path::Path;

use super::reading::{Loaded, Wish};
use super::{nifti, nrrd, vti};
use crate::error::{Error, Place, Result};

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
pub(in crate::low_level::scene) fn load(path: &Path, wish: &Wish) -> Result<Loaded> {
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

#[cfg(test)]
mod tests {
    use super::super::missing::Missing;
    use super::super::reading::Stored;
    use super::*;
    use crate::memory::MemoryLimit;

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
            let error = Wish {
                memory: &full,
                ..wish
            }
            .expect_room(24, Stored::of(&[0; 96]), Place::file(&path))
            .unwrap_err();
            let what = error.to_string();
            assert!(what.contains("24 samples take 96 bytes"), "{what}");
            assert!(what.contains("no more than 95 bytes"), "{what}");
        }
    }
}
