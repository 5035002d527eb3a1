//! Volumes from files: what is written byte by byte is what is read.

use crate::kit::volume::*;
use glam::DVec3;
use onionskin::Volume;

fn counting() -> Vec<f32> {
    (0..24).map(|i| i as f32).collect()
}

#[track_caller]
fn stands(volume: &Volume, index: [f64; 3], world: [f64; 3]) {
    let found = volume.index_to_world().transform_point3(index.into());
    // The headers' f32 matrices, and their products in f64.
    assert!(
        found.distance(DVec3::from_array(world)) < 1e-5,
        "{found} {world:?}"
    );
}

macro_rules! bytes_of {
    ($type:ty, $order:ident) => {
        (0..24)
            .flat_map(|i| (i as $type).$order())
            .collect::<Vec<u8>>()
    };
}

/// Name in NRRD, name in VTK, number in NIfTI, the numbers 0 to 23 in little and in big endian.
type Type = (&'static str, &'static str, i16, Vec<u8>, Vec<u8>);

fn types() -> Vec<Type> {
    vec![
        (
            "int8",
            "Int8",
            256,
            bytes_of!(i8, to_le_bytes),
            bytes_of!(i8, to_be_bytes),
        ),
        (
            "uchar",
            "UInt8",
            2,
            bytes_of!(u8, to_le_bytes),
            bytes_of!(u8, to_be_bytes),
        ),
        (
            "short",
            "Int16",
            4,
            bytes_of!(i16, to_le_bytes),
            bytes_of!(i16, to_be_bytes),
        ),
        (
            "uint16",
            "UInt16",
            512,
            bytes_of!(u16, to_le_bytes),
            bytes_of!(u16, to_be_bytes),
        ),
        (
            "int",
            "Int32",
            8,
            bytes_of!(i32, to_le_bytes),
            bytes_of!(i32, to_be_bytes),
        ),
        (
            "unsigned int",
            "UInt32",
            768,
            bytes_of!(u32, to_le_bytes),
            bytes_of!(u32, to_be_bytes),
        ),
        (
            "int64_t",
            "Int64",
            1024,
            bytes_of!(i64, to_le_bytes),
            bytes_of!(i64, to_be_bytes),
        ),
        (
            "uint64",
            "UInt64",
            1280,
            bytes_of!(u64, to_le_bytes),
            bytes_of!(u64, to_be_bytes),
        ),
        (
            "float",
            "Float32",
            16,
            bytes_of!(f32, to_le_bytes),
            bytes_of!(f32, to_be_bytes),
        ),
        (
            "double",
            "Float64",
            64,
            bytes_of!(f64, to_le_bytes),
            bytes_of!(f64, to_be_bytes),
        ),
    ]
}

#[test]
fn nrrd_of_every_type_and_both_endians_attached_and_detached_raw_and_gzip() {
    for (name, _, _, little, big) in types() {
        for (endian, bytes) in [("little", little), ("big", big)] {
            for (encoding, data) in [("raw", bytes.clone()), ("gzip", gzip(&bytes))] {
                let head = nrrd_head(name, encoding, endian, "");
                let attached = read("v.nrrd", &[head.as_bytes(), b"\n", &data].concat());
                assert_eq!(attached.samples(), counting(), "{name} {endian} {encoding}");
                assert_eq!(attached.dims(), [2, 3, 4]);
                let head = format!("{head}data file: v.raw\n");
                let detached = load(&[("v.nhdr", head.as_bytes()), ("v.raw", &data)]).unwrap();
                assert_eq!(detached.samples(), counting());
            }
        }
    }
}

#[test]
fn negative_samples_keep_their_sign() {
    let head = "NRRD0004\ndimension: 3\ntype: int16\nsizes: 2 2 2\nencoding: raw\nendian: big\n\n";
    let data: Vec<u8> = (-4..4_i16).flat_map(|i| (i * 300).to_be_bytes()).collect();
    let volume = read("v.nrrd", &[head.as_bytes(), &data].concat());
    assert_eq!(volume.samples()[..2], [-1200.0, -900.0]);
}

#[test]
fn nrrd_stands_where_its_header_says() {
    let data = [0; 24];
    let with = |fields: &str| {
        let head = nrrd_head("uchar", "raw", "little", fields);
        read("v.nrrd", &[head.as_bytes(), b"\n", &data].concat())
    };
    stands(&with(""), [1.0, 2.0, 3.0], [1.0, 2.0, 3.0]);
    stands(
        &with("spacings: 0.5 2 -1\n"),
        [1.0, 2.0, 3.0],
        [0.5, 4.0, -3.0],
    );
    let directions = "space directions: (0,2,0) (-1, 0, 0) (0.5,0,3)\nspace origin: (10,20,30)\n";
    stands(&with(directions), [0.0; 3], [10.0, 20.0, 30.0]);
    stands(&with(directions), [1.0, 2.0, 2.0], [9.0, 22.0, 36.0]);
}

#[test]
fn nrrd_comments_keys_and_fields_of_no_use_are_passed_over() {
    let head = nrrd_head(
        "uchar",
        "raw",
        "little",
        "# a comment\ncontent: head\nkey:=value: 5\r\nkinds: domain domain domain\n",
    );
    read("v.nrrd", &[head.as_bytes(), b"\r\n", &[0; 24]].concat());
}

#[test]
fn nrrd_skips_lines_and_bytes() {
    let data: Vec<u8> = (0..24).collect();
    let read = |fields: &str, before: &[u8], data: &[u8]| {
        let encoding = if data.len() == 24 { "raw" } else { "gzip" };
        let head = nrrd_head(
            "uchar",
            encoding,
            "little",
            &format!("datafile: v.raw\n{fields}"),
        );
        let raw = [before, data].concat();
        load(&[("v.nhdr", head.as_bytes()), ("v.raw", &raw)]).unwrap()
    };
    assert_eq!(
        read("line skip: 2\n", b"one\ntwo\n", &data).samples(),
        counting()
    );
    assert_eq!(read("byte skip: 3\n", b"abc", &data).samples(), counting());
    assert_eq!(
        read("byteskip: -1\n", b"whatever there is", &data).samples(),
        counting()
    );
    let packed = gzip(&[b"abc", &data[..]].concat());
    assert_eq!(
        read("byte skip: 3\nlineskip: 1\n", b"\n", &packed).samples(),
        counting()
    );
}

#[test]
fn axis_mins_of_a_nrrd_are_a_notice() {
    let head = nrrd_head("uchar", "raw", "little", "axis mins: 0 0 5\n");
    let scene = load_scene(&[("v.nrrd", &[head.as_bytes(), b"\n", &[0; 24]].concat())]).unwrap();
    assert!(
        scene.notices[0].contains("axis mins"),
        "{:?}",
        scene.notices
    );
}

#[test]
fn nifti_of_every_type_and_both_endians_plain_and_packed() {
    for (_, name, number, little, big) in types() {
        for (is_big, bytes) in [(false, little), (true, big)] {
            let mut file = Nifti {
                is_big,
                datatype: number,
                ..Nifti::default()
            }
            .bytes();
            file.extend(bytes);
            assert_eq!(
                read("v.nii", &file).samples(),
                counting(),
                "{name} {is_big}"
            );
            assert_eq!(read("v.nii.gz", &gzip(&file)).samples(), counting());
        }
    }
}

#[test]
fn nifti_stands_where_its_header_says() {
    let with = |header: Nifti| read("v.nii", &[header.bytes(), vec![0; 24]].concat());
    let plain = Nifti {
        pixdim: [1.0, 0.5, 2.0, 3.0],
        ..Nifti::default()
    };
    stands(&with(plain.clone()), [1.0, 2.0, 3.0], [0.5, 4.0, 9.0]);
    // Half a turn about x, by the quaternion (0, 1, 0, 0): y and z change their signs; qfac -1 turns z again.
    let turned = Nifti {
        qform: Some([1.0, 0.0, 0.0, 10.0, 20.0, 30.0]),
        ..plain.clone()
    };
    stands(&with(turned.clone()), [1.0, 2.0, 3.0], [10.5, 16.0, 21.0]);
    let mirrored = Nifti {
        pixdim: [-1.0, 0.5, 2.0, 3.0],
        ..turned.clone()
    };
    stands(&with(mirrored), [1.0, 2.0, 3.0], [10.5, 16.0, 39.0]);
    let rows = [
        [0.0, 2.0, 0.0, 1.0],
        [1.0, 0.0, 0.0, 2.0],
        [0.0, 0.5, 4.0, 3.0],
    ];
    let matrix = Nifti {
        sform: Some(rows),
        ..turned
    };
    stands(&with(matrix), [1.0, 2.0, 3.0], [5.0, 3.0, 16.0]);
}

#[test]
fn nifti_values_are_scaled_as_the_header_asks() {
    let (nan, inf) = (f32::NAN, f32::INFINITY);
    // What the value 23 becomes, and what is said.
    for (scale, last, says) in [
        ([0.5, -3.0], 8.5, None),
        ([-1.0, 0.0], -23.0, None),
        ([1.0, 2.0], 25.0, None),
        ([0.0, 5.0], 23.0, None),
        ([nan, nan], 23.0, Some("`scl_slope` is NaN")),
        ([nan, 5.0], 23.0, Some("`scl_slope` is NaN")),
        ([inf, 0.0], 23.0, Some("`scl_slope` is inf")),
        ([-inf, inf], 23.0, Some("`scl_slope` is -inf")),
        ([2.0, nan], 46.0, Some("`scl_inter` is NaN")),
        ([2.0, -inf], 46.0, Some("`scl_inter` is -inf")),
        ([1.0, nan], 23.0, Some("`scl_inter` is NaN")),
    ] {
        let one = Nifti {
            scale,
            ..Nifti::default()
        };
        let two = one.bytes_of_version_2();
        for header in [one.bytes(), two] {
            let file = [header, (0..24).collect()].concat();
            let scene = load_scene(&[("v.nii", &file)]).unwrap();
            assert_eq!(scene.volumes[0].samples()[23], last, "{scale:?}");
            let notices = &scene.notices;
            match says {
                None => assert!(notices.is_empty(), "{scale:?} {notices:?}"),
                Some(words) => assert!(notices[0].contains(words), "{scale:?} {notices:?}"),
            }
        }
    }
}

#[test]
fn nifti_2_is_read_as_nifti_1() {
    let rows = [
        [0.0, 2.0, 0.0, 1.0],
        [1.0, 0.0, 0.0, 2.0],
        [0.0, 0.5, 4.0, 3.0],
    ];
    for is_big in [false, true] {
        for (qform, sform) in [
            (None, None),
            (Some([1.0, 0.0, 0.0, 10.0, 20.0, 30.0]), None),
            (None, Some(rows)),
        ] {
            let header = Nifti {
                is_big,
                datatype: 2,
                pixdim: [-1.0, 0.5, 2.0, 3.0],
                qform,
                sform,
                ..Nifti::default()
            };
            let data: Vec<u8> = (0..24).collect();
            let one = read("v.nii", &[header.bytes(), data.clone()].concat());
            let file = [header.bytes_of_version_2(), data].concat();
            for two in [read("v.nii", &file), read("v.nii.gz", &gzip(&file))] {
                assert_eq!(two.samples(), counting());
                assert_eq!(two.index_to_world(), one.index_to_world());
            }
        }
    }
}

#[test]
fn vti_of_every_type_in_every_form() {
    for (_, name, _, little, big) in types() {
        for (order, bytes) in [("LittleEndian", little), ("BigEndian", big)] {
            for width in [4, 8] {
                let vti = Vti {
                    name,
                    order,
                    width,
                    ..Vti::default()
                };
                let raw = vti.appended("raw", &vti.counted(&bytes));
                assert_eq!(read("v.vti", &raw).samples(), counting(), "{name} {order}");
                let packed = vti.packed(&bytes, 10);
                let vti = Vti {
                    packed: true,
                    ..vti
                };
                assert_eq!(
                    read("v.vti", &vti.appended("raw", &packed)).samples(),
                    counting()
                );
            }
        }
    }
}

#[test]
fn vti_as_base64_and_ascii() {
    let bytes: Vec<u8> = (0..24).collect();
    let vti = Vti::default();
    let text = base64(&vti.counted(&bytes));
    assert_eq!(
        read("v.vti", &vti.inline("binary", &text)).samples(),
        counting()
    );
    assert_eq!(
        read("v.vti", &vti.appended("base64", text.as_bytes())).samples(),
        counting()
    );
    // Head and samples encoded one after the other.
    let [head, samples] = [&vti.counted(&bytes)[..4], &bytes].map(base64);
    assert_eq!(
        read(
            "v.vti",
            &vti.inline("binary", &format!("\n {head}{samples}\n"))
        )
        .samples(),
        counting()
    );
    let words: Vec<_> = (0..24).map(|i| i.to_string()).collect();
    assert_eq!(
        read("v.vti", &vti.inline("ascii", &words.join("\n "))).samples(),
        counting()
    );
}

#[test]
fn vti_stands_where_its_header_says() {
    let bytes = vec![0; 24];
    let vti = Vti {
        image: r#"WholeExtent="5 6 0 2 -1 2" Origin="10 20 30" Spacing="0.5 2 3""#,
        ..Vti::default()
    };
    let volume = read("v.vti", &vti.appended("raw", &vti.counted(&bytes)));
    stands(&volume, [0.0; 3], [12.5, 20.0, 27.0]);
    stands(&volume, [1.0, 2.0, 3.0], [13.0, 24.0, 36.0]);
    let vti = Vti {
        image: r#"WholeExtent="0 1 0 2 0 3" Spacing="1 2 3" Direction="0 -1 0 1 0 0 0 0 1""#,
        ..Vti::default()
    };
    let volume = read("v.vti", &vti.appended("raw", &vti.counted(&bytes)));
    stands(&volume, [1.0, 2.0, 3.0], [-4.0, 1.0, 9.0]);
}

#[test]
fn another_byte_would_be_noticed() {
    let mut data: Vec<u8> = (0..24).collect();
    data[7] = 99;
    let head = nrrd_head("uchar", "raw", "little", "");
    let volume = read("v.nrrd", &[head.as_bytes(), b"\n", &data].concat());
    assert_ne!(volume.samples(), counting());
}
