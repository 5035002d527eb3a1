//! Samples that are not numbers: they are empty, or what a scene file says, and are counted.

use crate::kit::scene::bad_toml;
use crate::kit::volume::*;
use glam::{DAffine3, DVec3};
use onionskin::generate::{Isosurface, isosurface};
use onionskin::low_level::scene::Medium;
use onionskin::{Error, Scene, Transfer, Volume};

/// 4 x 3 x 2 samples, of which some are not numbers.
fn file(bad: &[(usize, f32)]) -> Vec<u8> {
    let mut samples: Vec<f32> = (0..24).map(|i| i as f32).collect();
    for &(place, value) in bad {
        samples[place] = value;
    }
    let head = nrrd_head("float", "raw", "little", "").replace("2 3 4", "4 3 2");
    let data: Vec<u8> = samples
        .iter()
        .flat_map(|sample| sample.to_le_bytes())
        .collect();
    [head.as_bytes(), b"\n", &data].concat()
}

fn scene(keys: &str, bad: &[(usize, f32)]) -> Scene {
    load_scene_with(keys, &[("v.nrrd", &file(bad))]).unwrap_or_else(|error| panic!("{error}"))
}

const BAD: [(usize, f32); 3] = [(0, f32::NAN), (7, f32::INFINITY), (9, f32::NEG_INFINITY)];

#[test]
fn they_are_empty_and_counted() {
    for keys in ["", "nan = \"empty\""] {
        let scene = scene(keys, &BAD);
        let volume = &scene.volumes[0];
        assert!(volume.has_empty());
        for (i, sample) in volume.samples().iter().enumerate() {
            let is_bad = BAD.iter().any(|(place, _)| *place == i);
            assert!(
                if is_bad {
                    sample.is_nan()
                } else {
                    *sample == i as f32
                },
                "{i} {sample}"
            );
        }
        let notice = &scene.notices[0];
        assert!(
            notice.contains("3 of 24 samples are not numbers (1 NaN, 2 infinite)"),
            "{notice}"
        );
        assert!(notice.contains("empty"), "{notice}");
    }
    let clean = scene("", &[]);
    assert!(!clean.volumes[0].has_empty());
    assert!(clean.notices.is_empty());
}

#[test]
fn a_scene_file_may_give_them_a_value() {
    for (text, value) in [("-1", -1.0), ("0.5", 0.5), ("1e38", 1e38)] {
        let scene = scene(&format!("nan = {text}"), &BAD);
        let volume = &scene.volumes[0];
        assert!(!volume.has_empty());
        for (place, _) in BAD {
            assert_eq!(volume.samples()[place], value);
        }
        assert_eq!(volume.samples()[1], 1.0);
        assert!(
            scene.notices[0].contains("as `nan` says"),
            "{:?}",
            scene.notices
        );
    }
    for wrong in ["\"nothing\"", "nan", "inf", "true", "[1]"] {
        let scene = format!(
            "[[volume]]\nfile = \"v.nrrd\"\nnan = {wrong}\ntransfer = [{{ value = 0, color = [1, 1, 1], density = 1 }}]\n"
        );
        assert_eq!(bad_toml(&scene).line, Some(3), "{wrong}");
    }
    bad_toml("[[volume]]\ngenerate = \"ball\"\nnan = 0\n").at(3, "nan");
}

#[test]
fn numbers_that_are_too_large_stay_numbers() {
    let found = scene("", &[(3, f32::MAX), (4, f32::MIN), (5, 1e38)]);
    let samples = found.volumes[0].samples();
    assert_eq!(samples[3..6], [1e38, -1e38, 1e38]);
    assert!(
        found.notices[0].contains("2 of 24 samples are beyond 1e38"),
        "{:?}",
        found.notices
    );
    // A double beyond all floats is as large, and not infinite.
    let data: Vec<u8> = (0..24).flat_map(|_| 1e300_f64.to_le_bytes()).collect();
    let head = nrrd_head("double", "raw", "little", "");
    let volume = read("v.nrrd", &[head.as_bytes(), b"\n", &data].concat());
    assert_eq!(volume.samples()[0], 1e38);
    // Scaled by a NIfTI header, too.
    let header = Nifti {
        datatype: 16,
        scale: [1e30, 0.0],
        ..Nifti::default()
    };
    let data: Vec<u8> = (0..24)
        .flat_map(|i| (i as f32 * 1e20).to_le_bytes())
        .collect();
    let volume = read("v.nii", &[header.bytes(), data].concat());
    assert_eq!(volume.samples()[23], 1e38);
}

fn from_code(samples: Vec<f32>) -> Result<Volume, Error> {
    Volume::new("v", [4, 3, 2], samples, DAffine3::IDENTITY)
}

#[test]
fn a_cell_with_an_empty_corner_has_no_value_and_others_have_theirs() {
    let mut samples: Vec<f32> = (0..24).map(|i| (i % 4) as f32).collect();
    samples[5] = f32::NAN;
    let volume = from_code(samples).unwrap();
    // The sample (1, 1, 0): around it are the cells from (0, 0, 0) to (2, 2, 1).
    for x in 0..3 {
        for y in 0..2 {
            let middle = DVec3::new(x as f64 + 0.5, y as f64 + 0.5, 0.5);
            let value = volume.at(middle).unwrap();
            if x < 2 {
                assert!(value.is_nan(), "{middle}");
                assert_eq!(volume.transfer.at(value), Medium::NONE);
            } else {
                assert_eq!(value, middle.x, "{middle}");
            }
        }
    }
    assert_eq!(volume.at(DVec3::splat(-1.0)), None);
    assert_eq!(Transfer::default().at(f64::NAN).density, 0.0);
}

#[test]
fn volumes_from_code_may_have_empty_samples_and_no_others_that_are_no_numbers() {
    assert!(from_code(vec![f32::NAN; 24]).unwrap().has_empty());
    for wrong in [f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -1.1e38] {
        let mut samples = vec![0.0; 24];
        samples[7] = wrong;
        match from_code(samples) {
            Err(Error::Scene { what, remedy, .. }) => {
                assert!(what.contains("number 7"), "{what}");
                assert!(remedy.contains("NaN"), "{remedy}");
            }
            other => panic!("{wrong} {other:?}"),
        }
    }
}

/// A ball in a cube of 17 samples a side, and what `empty` says is empty of it.
fn ball(empty: impl Fn([usize; 3]) -> bool) -> Volume {
    let samples = (0..17 * 17 * 17).map(|i| {
        let index = [i % 17, i / 17 % 17, i / 289];
        let place = DVec3::from_array(index.map(|i| i as f64 - 8.0));
        if empty(index) {
            f32::NAN
        } else {
            8.0 - place.length() as f32
        }
    });
    Volume::new("ball", [17; 3], samples.collect(), DAffine3::IDENTITY).unwrap()
}

#[test]
fn isosurfaces_end_where_it_is_empty() {
    let surface = |volume: &Volume| isosurface(&Isosurface { volume, value: 2.9 }).unwrap();
    let whole = surface(&ball(|_| false));
    let half = surface(&ball(|[x, ..]| x < 8));
    assert!(!half.triangles.is_empty() && half.triangles.len() < whole.triangles.len());
    for vertex in &half.vertices {
        assert!(vertex.position.is_finite() && vertex.position.x >= 8.0);
        // A ball's normals point from its middle. At the edge they are of a cell alone, 0.2 of its 5.1 units wide.
        let outward = (vertex.position - DVec3::splat(8.0)).normalize();
        assert!(vertex.normal.as_dvec3().dot(outward) > 0.95, "{vertex:?}");
    }
    // What is left is the other surface's part, corner by corner.
    let all: std::collections::HashSet<_> = whole
        .vertices
        .iter()
        .map(|vertex| vertex.position.to_array().map(f64::to_bits))
        .collect();
    for vertex in &half.vertices {
        assert!(all.contains(&vertex.position.to_array().map(f64::to_bits)));
    }
    let count = |mesh: &onionskin::Mesh| {
        let right = |triangle: &&[u32; 3]| {
            triangle
                .iter()
                .all(|&i| mesh.vertices[i as usize].position.x >= 8.0)
        };
        mesh.triangles.iter().filter(right).count()
    };
    assert_eq!(count(&whole), count(&half));
    assert_eq!(count(&half), half.triangles.len());
}
