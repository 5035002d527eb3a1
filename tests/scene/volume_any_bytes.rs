//! Whatever the bytes of a volume's file, there is a volume or an error: no panic, and nothing but finite numbers and what
//! is empty.

use crate::kit::volume::*;
use proptest::prelude::*;

/// Good files and their names.
fn good_files() -> Vec<(&'static str, Vec<u8>)> {
    let head = nrrd_head(
        "short",
        "raw",
        "little",
        "spacings: 1 2 3\nspace origin: (1,2,3)\n",
    );
    let packed = nrrd_head(
        "short",
        "gzip",
        "little",
        "space directions: (1,0,0) (0,1,0) (0,0,1)\n",
    );
    let vti = Vti::default();
    let zlib = Vti {
        packed: true,
        ..Vti::default()
    };
    vec![
        ("v.nrrd", [head.as_bytes(), b"\n", &[0; 48]].concat()),
        (
            "v.nrrd",
            [packed.as_bytes(), b"\n", &gzip(&[0; 48])].concat(),
        ),
        ("v.nii", [Nifti::default().bytes(), vec![0; 24]].concat()),
        (
            "v.nii.gz",
            gzip(&[Nifti::default().bytes(), vec![0; 24]].concat()),
        ),
        ("v.vti", vti.appended("raw", &vti.counted(&[7; 24]))),
        (
            "v.vti",
            vti.inline("binary", &base64(&vti.counted(&[7; 24]))),
        ),
        ("v.vti", zlib.appended("raw", &zlib.packed(&[7; 24], 10))),
        ("v.nrrd", text("float", "ascii", "nan 1.5 -2e3 7")),
        ("v.nrrd", text("short", "hex", "00ff 10fE 0000 7f80")),
        (
            "v.nii",
            [Nifti::default().bytes_of_version_2(), vec![0; 24]].concat(),
        ),
        ("v.vti", pieces_of_cells().into_bytes()),
    ]
}

/// How many of them there are.
const GOOD: usize = 11;

/// Four axes, one of them of one sample, and an anatomical space.
fn text(kind: &str, encoding: &str, four: &str) -> Vec<u8> {
    let head = format!(
        "NRRD0005\ntype: {kind}\ndimension: 4\nsizes: 2 1 2 3\nspace: LPS\nspace directions: (1,0,0) none (0,1,0) (0,0,2)\nencoding: {encoding}\nendian: big\n\n"
    );
    format!("{head}{}", format!("{four}\n").repeat(3)).into_bytes()
}

fn pieces_of_cells() -> String {
    let piece = |extent: &str| {
        format!(
            "<Piece Extent=\"{extent}\"><CellData><DataArray type=\"Int16\" Name=\"a\" format=\"ascii\">1 2 3 4</DataArray></CellData></Piece>"
        )
    };
    format!(
        "<VTKFile type=\"ImageData\" version=\"1.0\"><ImageData WholeExtent=\"0 2 0 2 0 2\">{}{}</ImageData></VTKFile>",
        piece("0 2 0 2 0 1"),
        piece("0 2 0 2 1 2")
    )
}

fn check(name: &str, bytes: &[u8]) -> Result<(), TestCaseError> {
    match load(&[(name, bytes)]) {
        Err(onionskin::Error::Input { remedy, .. }) => prop_assert!(!remedy.is_empty()),
        Err(onionskin::Error::Memory { .. }) => {}
        Err(other) => prop_assert!(false, "{other:?}"),
        Ok(volume) => {
            prop_assert_eq!(
                volume.samples().len(),
                volume.dims().iter().product::<usize>()
            );
            let mut samples = volume.samples().iter();
            prop_assert!(samples.all(|sample| sample.is_nan() || sample.abs() <= 1e38));
            prop_assert!(volume.bounds().size().is_finite());
        }
    }
    Ok(())
}

#[test]
fn the_good_files_are_good_and_no_cut_makes_a_reader_panic() {
    assert_eq!(good_files().len(), GOOD);
    for (name, bytes) in good_files() {
        read(name, &bytes);
        for length in (0..bytes.len()).step_by(3) {
            check(name, &bytes[..length]).unwrap();
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn no_bytes_make_a_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..600), kind in 0..4_usize) {
        let name = ["v.nrrd", "v.nii", "v.nii.gz", "v.vti"][kind];
        check(name, &bytes)?;
        // Past the first hurdle of the format.
        let magic: &[u8] = [&b"NRRD0004\n"[..], b"\x5c\x01\0\0", &[0x1f, 0x8b, 8], b"<VTKFile>"][kind];
        check(name, &[magic, &bytes].concat())?;
    }

    #[test]
    fn no_changed_bytes_make_a_reader_panic(
        file in 0..GOOD,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let (name, mut bytes) = good_files().swap_remove(file);
        for (place, byte) in changes {
            let place = place.index(bytes.len());
            bytes[place] = byte;
        }
        check(name, &bytes)?;
    }

    #[test]
    fn no_changed_digits_make_a_reader_panic(
        file in 0..GOOD,
        changes in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(b"0123456789-.e(), \n".to_vec())), 1..6),
    ) {
        let (name, mut bytes) = good_files().swap_remove(file);
        let digits: Vec<_> = (0..bytes.len()).filter(|&i| bytes[i].is_ascii_digit()).collect();
        for (place, byte) in changes {
            if !digits.is_empty() {
                bytes[digits[place.index(digits.len())]] = byte;
            }
        }
        check(name, &bytes)?;
    }
}
