//! NRRD as people have it: as text, in several files, with axes of one sample, in the patient's spaces.

use crate::kit;
use crate::kit::scene::refused;
use crate::kit::volume::*;
use glam::DVec3;
use onionskin::{Scene, Volume};

fn counting() -> Vec<f32> {
    (0..24).map(|i| i as f32).collect()
}

fn head(kind: &str, encoding: &str, more: &str) -> String {
    format!("NRRD0004\ntype: {kind}\ndimension: 3\nsizes: 2 3 4\nencoding: {encoding}\n{more}")
}

fn attached(head: &str, data: &[u8]) -> Volume {
    read("v.nrrd", &[head.as_bytes(), b"\n", data].concat())
}

#[test]
fn text_in_every_name_and_without_endian() {
    for encoding in ["ascii", "ASCII", "text", "txt"] {
        for (kind, write) in [
            ("float", (|i| format!("{i}.0")) as fn(i32) -> String),
            ("uchar", |i| i.to_string()),
            ("double", |i| format!("{i}e0")),
        ] {
            for between in ["\n", " ", "\t\r\n", ", "] {
                let words: Vec<String> = (0..24).map(write).collect();
                let text = words.join(between);
                let volume = attached(&head(kind, encoding, ""), text.as_bytes());
                assert_eq!(volume.samples(), counting(), "{encoding} {kind}");
            }
        }
    }
    let lines = head(
        "short",
        "ascii",
        "endian: big\nline skip: 2\nbyte skip: 4\n",
    );
    let text: String = (0..24).map(|i| format!(" {i}")).collect();
    let volume = attached(&lines, format!("a\nb\nskip{text}\n and more").as_bytes());
    assert_eq!(volume.samples(), counting());
}

#[test]
fn numbers_that_are_none_are_written_in_many_ways() {
    let mut words: Vec<String> = (0..24).map(|i| i.to_string()).collect();
    let empty = [
        "nan",
        "NaN",
        "-nan",
        "+NAN",
        "inf",
        "-inf",
        "Infinity",
        "1.#INF",
        "-1.#INF",
        "1.#QNAN",
        "-1.#IND",
        "nan(ind)",
        "-nan(snan)",
        "1.#SNAN0",
    ];
    for (word, text) in words.iter_mut().zip(empty) {
        *word = text.to_owned();
    }
    let volume = attached(&head("float", "ascii", ""), words.join(" ").as_bytes());
    let samples = volume.samples();
    assert!(samples[..empty.len()].iter().all(|sample| sample.is_nan()));
    assert_eq!(samples[empty.len()..], counting()[empty.len()..]);
}

#[test]
fn hexadecimal_digits() {
    let digits: String = (0..24_i16)
        .flat_map(i16::to_le_bytes)
        .map(|byte| format!("{byte:02x}"))
        .collect();
    let little = head("short", "hex", "endian: little\n");
    for text in [
        digits.clone(),
        digits.to_uppercase(),
        digits.replace("00", "0\n0 "),
    ] {
        assert_eq!(attached(&little, text.as_bytes()).samples(), counting());
    }
    let bytes: String = (0..24).map(|byte| format!("{byte:02X}")).collect();
    assert_eq!(
        attached(&head("uchar", "hex", ""), bytes.as_bytes()).samples(),
        counting()
    );
}

#[test]
fn text_that_is_wrong_is_refused() {
    let wrong = |head: &str, data: &[u8]| bad("v.nrrd", &[head.as_bytes(), b"\n", data].concat());
    let ascii = head("float", "ascii", "");
    wrong(&ascii, b"1 2 3").says("3 numbers for 24");
    wrong(&ascii, &b"1 ".repeat(23)).says("23 numbers for 24");
    wrong(&ascii, b"1 2 3 4 5 six 7 8 9 0 1 2 3 4 5 6 7 8 9 0 1 2 3 4").says("'six'");
    wrong(&ascii, &[0xff; 48]).says("`encoding`");
    let hex = head("uchar", "hex", "");
    wrong(&hex, &b"00".repeat(23)).says("there are 23");
    wrong(&hex, &[&b"00".repeat(23)[..], b"0    "].concat()).says("one digit");
    wrong(&hex, &b"0g".repeat(24)).says("'g'");
    wrong(&head("short", "hex", ""), &b"00".repeat(48)).says("`endian`");
    wrong(&head("short", "raw", ""), &[0; 48]).says("`endian`");
    wrong(&head("float", "bz2", "endian: little\n"), &[0; 96]).says("bzip2");
    wrong(
        &head("float", "ascii", "byte skip: -1\n"),
        &b"1 ".repeat(24),
    )
    .says("raw samples only");
    for version in ["NRRD0007", "NRRD00.01", "NRRD0000"] {
        bad("v.nrrd", ascii.replace("NRRD0004", version).as_bytes()).says(version);
    }
}

#[test]
fn an_axis_of_one_sample_is_left_out_wherever_it_stands() {
    for (sizes, directions, spacings) in [
        ("1 2 3 4", "none (2,0,0) (0,3,0) (0,0,4)", "nan 2 3 4"),
        ("2 1 3 4", "(2,0,0) none (0,3,0) (0,0,4)", "2 nan 3 4"),
        ("2 3 1 4", "(2,0,0) (0,3,0) none (0,0,4)", "2 3 1 4"),
        ("2 3 4 1", "(2,0,0) (0,3,0) (0,0,4) none", "2 3 4 nan"),
        // More of them, and one that lies in space all the same.
        (
            "1 2 1 3 4",
            "none (2,0,0) none (0,3,0) (0,0,4)",
            "nan 2 nan 3 4",
        ),
        ("2 3 4 1", "(2,0,0) (0,3,0) (0,0,4) (1,1,1)", "2 3 4 9"),
    ] {
        let axes = sizes.split(' ').count();
        for place in [
            format!("space dimension: 3\nspace directions: {directions}\nspace origin: (5,6,7)\n"),
            format!("spacings: {spacings}\n"),
        ] {
            let head = format!(
                "NRRD0004\ntype: uchar\ndimension: {axes}\nsizes: {sizes}\nencoding: raw\n{place}"
            );
            let volume = attached(&head, &(0..24).collect::<Vec<u8>>());
            assert_eq!(volume.dims(), [2, 3, 4], "{sizes}");
            assert_eq!(volume.samples(), counting());
            let far = volume.index_to_world().transform_point3(DVec3::ONE);
            let first = if place.contains("origin") {
                DVec3::new(5.0, 6.0, 7.0)
            } else {
                DVec3::ZERO
            };
            assert_eq!(far - first, DVec3::new(2.0, 3.0, 4.0), "{place}");
        }
    }
}

#[test]
fn arrays_that_are_no_volume_are_refused() {
    let wrong = |dimension: usize, sizes: &str| {
        let head = format!(
            "NRRD0004\ntype: uchar\ndimension: {dimension}\nsizes: {sizes}\nencoding: raw\n\n"
        );
        bad("v.nrrd", &[head.as_bytes(), &[0; 200]].concat())
    };
    wrong(4, "3 2 3 4").says("4 of the 4 axes");
    wrong(5, "1 3 2 3 4").says("4 of the 5 axes");
    wrong(4, "1 1 3 4").says("1 samples");
    wrong(2, "3 4").says("2 axes");
    wrong(4, "2 3 4").says("3 words for 4 axes");
}

/// The numbers of slices, in files of their own.
fn slices(names: &[&str], head: &str) -> Result<Scene, onionskin::Error> {
    let each = 24 / names.len();
    let bytes: Vec<u8> = (0..24).collect();
    let mut files = vec![("v.nhdr", head.as_bytes())];
    files.extend(
        names
            .iter()
            .zip(bytes.chunks(each))
            .map(|(name, data)| (*name, data)),
    );
    load_scene(&files)
}

#[test]
fn samples_in_several_files() {
    let in_order = ["s1.raw", "s2.raw", "s3.raw", "s4.raw"];
    let good = |names: &[&str], data_file: &str| {
        let head = head("uchar", "raw", &format!("data file: {data_file}"));
        let scene = slices(names, &head).unwrap_or_else(|error| panic!("{data_file}: {error}"));
        assert_eq!(scene.volumes[0].samples(), counting(), "{data_file}");
    };
    good(&in_order, "LIST\ns1.raw\ns2.raw\ns3.raw\ns4.raw");
    good(&in_order, "LIST 2\ns1.raw\r\ns2.raw \n\ns3.raw\ns4.raw\n\n");
    good(&["b", "a", "d", "c"], "LIST\nb\na\nd\nc\n");
    // Slabs of the last axis, and single rows.
    good(&["first", "second"], "LIST 3\nfirst\nsecond\n");
    let rows: Vec<String> = (0..12).map(|row| format!("row{row}")).collect();
    let rows: Vec<&str> = rows.iter().map(String::as_str).collect();
    good(&rows, &format!("LIST 1\n{}\n", rows.join("\n")));
    good(&in_order, "s%d.raw 1 4 1\n");
    good(&in_order, "s%i.raw 1 4 1 2\n");
    good(&["s10", "s8", "s6", "s4"], "s%d 10 4 -2\n");
    good(&["s-1", "s00", "s01", "s02"], "s%02d -1 2 1\n");
    good(
        &["a 008.raw", "a 009.raw", "a 010.raw", "a 011.raw"],
        "a %03d.raw 8 11 1\n",
    );
    good(&["first0", "first1"], "first%d 0 1 1 3\n");
    good(&rows, "row%d 0 11 1 1\n");
    // A name with a percent sign in it, but without numbers.
    good(&["100%.raw"], "100%.raw\n");
}

#[test]
fn samples_in_several_files_packed_and_as_text() {
    let parts: Vec<Vec<u8>> = (0..4).map(|k| (6 * k..6 * k + 6).collect()).collect();
    let packed: Vec<Vec<u8>> = parts
        .iter()
        .map(|part| gzip(&[b"ab", &part[..]].concat()))
        .collect();
    let texts: Vec<Vec<u8>> = parts
        .iter()
        .map(|part| {
            format!(
                "# one\n{}",
                part.iter().map(|i| format!("{i}\n")).collect::<String>()
            )
            .into_bytes()
        })
        .collect();
    for (encoding, files, skip) in [
        ("gzip", packed, "byte skip: 2"),
        ("ascii", texts, "line skip: 1"),
    ] {
        let head = head(
            "uchar",
            encoding,
            &format!("{skip}\ndata file: p%d 0 3 1\n"),
        );
        let names = ["p0", "p1", "p2", "p3"];
        let mut all = vec![("v.nhdr", head.as_bytes())];
        all.extend(
            names
                .iter()
                .zip(&files)
                .map(|(name, file)| (*name, file.as_slice())),
        );
        assert_eq!(load(&all).unwrap().samples(), counting(), "{encoding}");
    }
}

#[test]
fn several_files_that_do_not_fit_are_refused() {
    let wrong = |data_file: &str| {
        let head = head("uchar", "raw", &format!("data file: {data_file}\n"));
        refused(slices(&["s1", "s2", "s3", "s4"], &head))
    };
    wrong("LIST\ns1\ns2\ns3").says("3 of them, for 4 parts");
    wrong("LIST\n").says("0 of them");
    wrong("LIST 0\ns1\ns2\ns3\ns4").says("number of axes");
    wrong("LIST 4\ns1\ns2\ns3\ns4").says("number of axes");
    wrong("LIST x\ns1\ns2\ns3\ns4").says("number of axes");
    wrong("LIST 3\ns1\ns2\ns3").says("3 of them");
    wrong("s%d 1 9 1").says("9 of them");
    wrong("s%d 4 1 1").says("0 of them");
    wrong("s%d 1 9000000000000000000 1").says("of them, for 4 parts");
    wrong("s%d -9223372036854775808 9223372036854775807 1").says("of them, for 4 parts");
    assert_eq!(wrong("s%d 2 5 1").file, "s5");
    // A step of nothing is no step, so that this is one file's name.
    wrong("s%d 1 4 0").says("no such file");
    // The files are too short for slices of this size.
    let head = head("short", "raw", "endian: little\ndata file: s%d 1 4 1\n");
    refused(slices(&["s1", "s2", "s3", "s4"], &head)).says("there are 6");
}

#[test]
fn the_patients_spaces_become_one() {
    let place = "space directions: (0,2,0) (-1,0,0) (0.5,0,3)\nspace origin: (10,20,30)\n";
    let scene = |space: &str| {
        let head = head("uchar", "raw", &format!("{space}\n{place}"));
        load_scene(&[("v.nrrd", &[head.as_bytes(), b"\n", &[0; 24]].concat())]).unwrap()
    };
    let at = |scene: &Scene, index: [f64; 3]| {
        scene.volumes[0]
            .index_to_world()
            .transform_point3(index.into())
            .to_array()
    };
    for (space, signs, said) in [
        ("right-anterior-superior", [1.0, 1.0, 1.0], None),
        ("RAS", [1.0, 1.0, 1.0], None),
        ("left-posterior-superior", [-1.0, -1.0, 1.0], Some("LPS")),
        ("Left-Posterior-Superior", [-1.0, -1.0, 1.0], Some("LPS")),
        ("LPS", [-1.0, -1.0, 1.0], Some("LPS")),
        ("left-anterior-superior", [-1.0, 1.0, 1.0], Some("LAS")),
        ("LAS", [-1.0, 1.0, 1.0], Some("LAS")),
        ("scanner-xyz", [1.0, 1.0, 1.0], None),
        ("3D-right-handed", [1.0, 1.0, 1.0], None),
        ("3D-left-handed", [1.0, 1.0, 1.0], None),
    ] {
        let scene = scene(&format!("space: {space}"));
        // 10 - 2 x 1 + 2 x 0.5, 20 + 1 x 2, 30 + 2 x 3.
        let expected = [9.0 * signs[0], 22.0 * signs[1], 36.0 * signs[2]];
        assert_eq!(at(&scene, [1.0, 2.0, 2.0]), expected, "{space}");
        match said {
            None => assert!(scene.notices.is_empty(), "{space} {:?}", scene.notices),
            Some(name) => {
                let notice = &scene.notices[0];
                assert!(notice.contains(name) && notice.contains("RAS"), "{notice}");
            }
        }
    }
    assert_eq!(
        at(&scene("content: none"), [1.0, 2.0, 2.0]),
        [9.0, 22.0, 36.0]
    );
}

#[test]
fn one_patient_as_lps_and_as_nifti_lies_in_one_place() {
    let nifti = Nifti {
        sform: Some([
            [-1.5, 0.0, 0.0, 4.0],
            [0.0, -1.25, 0.0, 3.0],
            [0.0, 0.0, 2.0, -3.0],
        ]),
        ..Nifti::default()
    };
    let ras = read("v.nii", &[nifti.bytes(), vec![0; 24]].concat());
    let place = "space: left-posterior-superior\nspace directions: (1.5,0,0) (0,1.25,0) (0,0,2)\nspace origin: (-4,-3,-3)\n";
    let lps = attached(&head("uchar", "raw", place), &[0; 24]);
    assert_eq!(lps.index_to_world(), ras.index_to_world());
    let own = attached(
        &head(
            "uchar",
            "raw",
            &place.replace("space: left-posterior-superior\n", ""),
        ),
        &[0; 24],
    );
    assert_ne!(own.index_to_world(), ras.index_to_world());
}

#[cfg(unix)]
#[test]
fn pipes_and_devices_are_refused_before_they_are_opened() {
    use std::os::unix::fs::symlink;

    let folder = kit::scene::Folder::new();
    let pipe = folder.path("pipe.raw");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    if !made.is_ok_and(|status| status.success()) {
        eprintln!("skipped: there is no mkfifo here");
        return;
    }
    symlink("/dev/zero", folder.path("zero.raw")).unwrap();
    symlink("/dev/zero", folder.path("zero.nrrd")).unwrap();
    symlink(&pipe, folder.path("pipe.nii")).unwrap();
    let look = "transfer = [{ value = 0, color = [1, 1, 1], density = 1 }]";
    let folder = ["pipe.raw", "zero.raw", "/dev/zero", "LIST 3\npipe.raw"]
        .iter()
        .enumerate()
        .fold(folder, |folder, (i, name)| {
            let header = head("uchar", "raw", &format!("data file: {name}\n"));
            folder.with(&format!("{i}.nhdr"), header).with(
                &format!("{i}.toml"),
                format!("[[volume]]\nfile = \"{i}.nhdr\"\n{look}\n"),
            )
        });
    for i in 0..4 {
        refused(folder.load(&format!("{i}.toml"))).says("a device or a pipe");
    }
    for name in ["zero.nrrd", "pipe.nii"] {
        let scene = format!("[[volume]]\nfile = \"{name}\"\n{look}\n");
        std::fs::write(folder.path("s.toml"), scene).unwrap();
        refused(folder.load("s.toml")).says("a device or a pipe");
    }
}
