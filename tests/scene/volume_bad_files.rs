//! What is wrong with a volume's file is said with the file and the field, and never costs more memory than the file.

use crate::kit::scene::{Refused, refused};
use crate::kit::volume::*;

/// A NRRD file in which one line is replaced, with room for its 24 samples.
#[track_caller]
fn bad_nrrd(line: &str, by: &str) -> Refused {
    let head = nrrd_head("short", "raw", "little", "spacings: 1 1 1\n");
    assert!(head.contains(line), "{line}");
    let head = head.replace(line, by);
    bad("v.nrrd", &[head.as_bytes(), b"\n", &[0; 48]].concat())
}

#[track_caller]
fn bad_nifti(header: Nifti) -> Refused {
    bad("v.nii", &[header.bytes(), vec![0; 24]].concat())
}

#[test]
fn nrrd_that_is_none() {
    assert_eq!(bad("v.nrrd", b"").says("NRRD000").line, Some(1));
    assert_eq!(
        bad("v.nrrd", b"\x89PNG\r\n\x1a\n").says("NRRD000").line,
        Some(1)
    );
}

#[test]
fn nrrd_without_a_field() {
    for field in [
        "type: short\n",
        "dimension: 3\n",
        "sizes: 2 3 4\n",
        "encoding: raw\n",
        "endian: little\n",
    ] {
        let name = field.split(':').next().unwrap();
        bad_nrrd(field, "").says(name).suggests(name);
    }
}

#[test]
fn nrrd_with_an_unknown_type_encoding_endian_or_field() {
    bad_nrrd("type: short", "type: block")
        .at(2, "block")
        .says("`type`");
    bad_nrrd("encoding: raw", "encoding: bzip2")
        .at(5, "bzip2")
        .says("`encoding`");
    bad_nrrd("endian: little", "endian: middle")
        .at(6, "middle")
        .says("`endian`");
    bad_nrrd("endian: little", "endianness: little")
        .at(6, "endianness")
        .says("no such field");
    bad_nrrd("endian: little", "little").at(6, "little");
    bad_nrrd("endian: little", "type: short")
        .at(6, "type")
        .says("twice");
}

#[test]
fn nrrd_of_another_dimension() {
    for dimension in ["2", "0", "17", "-3", "x"] {
        bad_nrrd("dimension: 3", &format!("dimension: {dimension}"))
            .at(3, dimension)
            .says("`dimension`");
    }
    bad_nrrd("dimension: 3", "dimension: 4").says("3 words for 4 axes");
    bad_nrrd("dimension: 3", "space dimension: 2\ndimension: 3").says("`space dimension`");
}

#[test]
fn nrrd_with_bad_sizes() {
    for sizes in [
        "2 3",
        "2 3 4 5",
        "2 3 x",
        "-2 3 4",
        "2 3 4.5",
        "99999999999999999999 2 2",
    ] {
        bad_nrrd("sizes: 2 3 4", &format!("sizes: {sizes}"))
            .at(4, sizes)
            .says("`sizes`");
    }
    for (sizes, says) in [
        ("1 3 4", "1 samples"),
        ("0 3 4", "0 samples"),
        // 2^64 and more samples; their bytes overflow 64 bits, too.
        ("4294967296 4294967296 2", "more than"),
        (
            "18446744073709551615 18446744073709551615 18446744073709551615",
            "more than",
        ),
        // 20 GB.
        ("2000 2000 2500", "more than"),
        // Within what is read at all, 512 MB, but not there.
        ("512 512 1000", "there are 48"),
        ("2 3 5", "there are 48"),
    ] {
        let error = bad_nrrd("sizes: 2 3 4", &format!("sizes: {sizes}"));
        assert_eq!(error.line, Some(4));
        error.says(says).says("`sizes`");
    }
}

#[test]
fn nrrd_with_bad_spacings() {
    for spacings in [
        "0 1 1",
        "nan 1 1",
        "1 inf 1",
        "1 1 1e-300",
        "1 1 1e300",
        "1e-3 1 10",
    ] {
        bad_nrrd("spacings: 1 1 1", &format!("spacings: {spacings}")).at(7, spacings);
    }
    for spacings in ["1 1", "1 1 x"] {
        bad_nrrd("spacings: 1 1 1", &format!("spacings: {spacings}")).says("`spacings`");
    }
}

#[test]
fn nrrd_with_bad_directions_or_origin() {
    for directions in [
        "(1,0,0) (0,1,0)",
        "(1,0,0) (0,1,0) none",
        "(1,0,0) (0,1,0) (0,0)",
        "(1,0,0) (0,1,0) (0,0,x)",
        "(1,0,0) (0,1,0) (1,1,0)",
        "(1,0,0) (0,1,0) (0,0,nan)",
        "(1,0,0) (0,1,0) (0,0,0)",
        "(1,0,0) (0,1,0) (0,0,1",
        ")))",
        "",
    ] {
        let error = bad_nrrd(
            "spacings: 1 1 1",
            &format!("space directions: {directions}"),
        );
        assert_eq!(error.line, Some(7), "{directions} {error:?}");
    }
    for origin in ["(1,0)", "1 0 0", "(nan,0,0)", "(1,2,3) (1,2,3)"] {
        bad_nrrd("spacings: 1 1 1", &format!("space origin: {origin}")).at(7, origin);
    }
    bad_nrrd("spacings: 1 1 1", "space origin: (1e300,0,0)").says("first sample");
}

#[test]
fn nrrd_with_bad_skips() {
    for skip in [
        "byte skip: 1000",
        "byte skip: -2",
        "byte skip: x",
        "line skip: 5",
        "line skip: x",
    ] {
        let name = skip.split(':').next().unwrap();
        bad_nrrd("spacings: 1 1 1", skip).says(name);
    }
    // What is skipped is missing at the end.
    bad_nrrd("spacings: 1 1 1", "byte skip: 1").says("there are 47");
}

#[test]
fn nrrd_data_that_is_elsewhere() {
    let head = |name: &str| nrrd_head("short", "raw", "little", &format!("data file: {name}\n"));
    let error = refused(load(&[("v.nhdr", head("no.raw").as_bytes())]));
    assert_eq!(error.file, "no.raw");
    for name in ["LIST", "s%03d.raw 1 9 1"] {
        bad("v.nhdr", head(name).as_bytes()).says("several files");
    }
    let short = refused(load(&[
        ("v.nhdr", head("v.raw").as_bytes()),
        ("v.raw", &[0; 47]),
    ]));
    short.says("there are 47");
}

#[test]
fn nrrd_packed_and_damaged_or_short() {
    let file = |sizes: &str, data: &[u8]| {
        let head = nrrd_head("short", "gzip", "little", "").replace("2 3 4", sizes);
        bad("v.nrrd", &[head.as_bytes(), b"\n", data].concat())
    };
    let good = gzip(&[0; 48]);
    file("2 3 4", &good[..good.len() - 12]).says("`encoding`");
    file("2 3 4", b"not gzip").says("`encoding`");
    file("2 3 4", &gzip(&[0; 47])).says("there are 47");
    // So many samples cannot be in so few bytes, however well they are packed: nothing is unpacked.
    file("1000 1000 500", &good).says("there are 0");
}

#[test]
fn nifti_with_bad_fields() {
    let field = |header: Nifti, field: &str| {
        let error = bad_nifti(header);
        assert_eq!(error.token.as_deref(), Some(field), "{error:?}");
        error
    };
    let dim = |dim| Nifti {
        dim,
        ..Nifti::default()
    };
    field(dim([3, 2, 3, 5, 1, 1, 1, 1]), "dim").says("there are 24");
    field(dim([3, 2000, 2000, 5000, 1, 1, 1, 1]), "dim").says("more than");
    field(dim([3, 65535, 65535, 65535, 1, 1, 1, 1]), "dim").says("more than");
    field(dim([3, 1, 3, 4, 1, 1, 1, 1]), "dim").says("1 samples");
    field(dim([2, 2, 3, 4, 1, 1, 1, 1]), "dim").suggests("three-dimensional");
    field(dim([4, 2, 3, 4, 7, 1, 1, 1]), "dim").suggests("single");
    field(dim([0, 2, 3, 4, 1, 1, 1, 1]), "dim");
    for datatype in [0, 1, 32, 128, 1536, -3] {
        field(
            Nifti {
                datatype,
                ..Nifti::default()
            },
            "datatype",
        )
        .says(&datatype.to_string());
    }
    for offset in [0.0, -1.0, f32::NAN, f32::INFINITY, 352.5, 1e30] {
        field(
            Nifti {
                offset,
                ..Nifti::default()
            },
            "vox_offset",
        );
    }
    field(
        Nifti {
            offset: 400.0,
            ..Nifti::default()
        },
        "dim",
    )
    .says("there are 0");
    for pixdim in [
        [1.0, 0.0, 1.0, 1.0],
        [1.0, 1.0, f32::NAN, 1.0],
        [1.0, 1.0, 1.0, f32::INFINITY],
    ] {
        field(
            Nifti {
                pixdim,
                ..Nifti::default()
            },
            "pixdim",
        );
    }
    field(
        Nifti {
            qform: Some([f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0]),
            ..Nifti::default()
        },
        "pixdim",
    );
    field(
        Nifti {
            sform: Some([[1.0; 4]; 3]),
            ..Nifti::default()
        },
        "srow",
    )
    .says("one plane");
    field(
        Nifti {
            magic: *b"ni1\0",
            ..Nifti::default()
        },
        "magic",
    );
}

#[test]
fn what_is_not_read_of_nifti_is_named() {
    let magic = |magic: [u8; 4]| {
        bad_nifti(Nifti {
            magic,
            ..Nifti::default()
        })
    };
    magic(*b"ni1\0").says("NIfTI-1 pair").suggests(".nii");
    magic([0; 4]).says("ANALYZE 7.5");
    let mut two = Nifti::default().bytes_of_version_2();
    two.extend([0; 24]);
    two[5] = b'i';
    bad("v.nii", &two).says("NIfTI-2 pair");
    two[4] = b'x';
    bad("v.nii", &two).says("NIfTI-2");
    two[0] = 99;
    bad("v.nii", &two).says("540");
    for (datatype, name) in [
        (1, "BINARY"),
        (32, "COMPLEX64"),
        (128, "RGB24"),
        (2304, "RGBA32"),
    ] {
        bad_nifti(Nifti {
            datatype,
            ..Nifti::default()
        })
        .says(name)
        .says("NIfTI-1");
    }
    for (name, says) in [
        ("v.hdr", "pair"),
        ("v.img.gz", "pair"),
        ("v.mha", "MetaImage"),
        ("v.vtk", "legacy"),
    ] {
        bad(name, b"").says(says).suggests(".nii.gz");
    }
}

#[test]
fn nifti_cut_off_anywhere() {
    let file = [Nifti::default().bytes(), vec![0; 24]].concat();
    for length in [0, 1, 3, 40, 42, 347, 351, 352, 375] {
        bad("v.nii", &file[..length]);
        bad("v.nii.gz", &gzip(&file[..length]));
    }
    let packed = gzip(&file);
    for length in 0..packed.len() - 9 {
        bad("v.nii.gz", &packed[..length]);
    }
    let file = [Nifti::default().bytes_of_version_2(), vec![0; 24]].concat();
    for length in [3, 4, 12, 348, 539, 543, 567] {
        bad("v.nii", &file[..length]);
        bad("v.nii.gz", &gzip(&file[..length]));
    }
    let huge = Nifti {
        dim: [3, 800, 800, 800, 1, 1, 1, 1],
        ..Nifti::default()
    };
    bad("v.nii.gz", &gzip(&huge.bytes())).says("there are 0");
}

#[test]
fn another_kind_of_file() {
    bad("v.dcm", b"").suggests(".nrrd");
    assert_eq!(refused(load(&[("../v", b"")])).file, "v");
}
