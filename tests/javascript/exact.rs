//! What the machine says of the exact image is the oracle's, and where a run parts from it.

use onionskin::low_level::edition::program_json::object;
use onionskin::low_level::edition::programs;
use onionskin::low_level::emulator::Group;
use onionskin::low_level::oracle;
use onionskin::low_level::steps::Reading;
use onionskin::{Fragment, Rgba};
use serde_json::{Value, json};

use crate::cases::{self, Pixel};
use crate::compare::{case, variables};
use crate::emulated::fragments;
use crate::node::Node;

/// By how much the composites of up to 8 layers in 32-bit floats may be off: each layer rounds three times by 2^-24.
const ROUNDING: f64 = 8.0 * 4.0 / 16_777_216.0;

fn exact(pixel: &Pixel) -> [f64; 4] {
    let opaque = pixel.iter().filter(|it| it.group == Group::Opaque);
    let nearest = opaque.min_by(|a, b| a.fragment.depth.total_cmp(&b.fragment.depth));
    let depth = nearest.map_or(f32::INFINITY, |it| it.fragment.depth);
    let behind = nearest.map_or(Rgba::default(), |it| it.fragment.color);
    let transparent = pixel.iter().filter(|it| it.group != Group::Opaque);
    let mut list: Vec<Fragment> = transparent.map(|it| it.fragment).collect();
    oracle::composite(&mut list, depth, behind)
}

fn apart(a: &Value, b: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|channel| (a[channel].as_f64().unwrap() - b[channel]).abs())
}

/// Programs that lose one of two fragments at the same depth, and what lies on the far plane.
const DEPTH_PEELING: [&str; 3] = ["everitt/depth-peeling", "vtk/keep-layers", "vtk/on-the-fly"];

#[test]
fn the_exact_composite_is_the_oracle_s_and_parts_says_whether_the_image_is_it() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let pixels = cases::random_pixels(2026, 1000);
    let [mut right, mut wrong] = [0; 2];
    for program in programs::all() {
        for readings in program.readings() {
            let what = format!("{} {readings:?}", program.key);
            node.run(&object(program, &readings));
            let cases = pixels
                .iter()
                .map(|pixel| case(pixel, variables(program, pixel)));
            let left = node.answer_to(&json!({ "runs": cases.collect::<Vec<_>>() }));
            let mut exact_ones = 0;
            for (pixel, left) in pixels.iter().zip(left.as_array().unwrap()) {
                let exact = exact(pixel);
                let told = apart(&left["exact"]["color"], exact);
                assert!(told.iter().all(|it| *it < 1e-12), "{what}: {pixel:#?}");
                let off = apart(&left["image"], exact);
                let same_color = off[..3].iter().all(|it| *it < ROUNDING);
                match left["parts"].as_u64() {
                    None => {
                        assert!(same_color, "{what}: {pixel:#?} {left}");
                        exact_ones += 1;
                    }
                    Some(at) => {
                        let in_order = left["composited"] == left["exact"]["order"];
                        assert!(
                            !(same_color && (off[3] < ROUNDING || in_order)),
                            "{what}: {pixel:#?} {left}"
                        );
                        assert!(at < left["events"].as_u64().unwrap(), "{what}: {pixel:#?}");
                        wrong += 1;
                    }
                }
            }
            right += exact_ones;
            println!("{what}: {exact_ones} of {} are exact", pixels.len());
        }
    }
    assert!(right > 5000 && wrong > 1000, "{right} {wrong}");
}

/// Whether the method is exact at a pixel, as amended and with as many rounds as it needs.
fn should_be_exact(key: &str, pixel: &Pixel) -> bool {
    let depths = |all: &[Fragment]| all.iter().map(|it| it.depth).collect::<Vec<_>>();
    let all: Vec<_> = pixel.iter().map(|it| it.fragment).collect();
    // Opaque surfaces are peeled, too, by Everitt.
    let peeled = match key {
        "everitt/depth-peeling" => depths(&all),
        _ => depths(&fragments(pixel)),
    };
    let mut different = peeled.clone();
    different.sort_by(f32::total_cmp);
    different.dedup();
    let keeps_all = !DEPTH_PEELING.contains(&key) || different.len() == peeled.len();
    // OpenGL clips what lies beyond the far plane; what lies on it fails the depth test.
    keeps_all && all.iter().all(|it| it.depth < 1.0)
}

#[test]
fn every_amended_method_is_exact_but_for_what_its_row_in_the_registry_excepts() {
    let Some(mut node) = Node::start() else {
        return;
    };
    // No sorted surfaces: hybrid layer peeling puts unsorted ones first where depths are equal.
    let mut pixels = cases::random_pixels(7, 1000);
    for surface in pixels.iter_mut().flatten() {
        if surface.group == Group::Sorted {
            surface.group = Group::Unsorted;
        }
    }
    // A static array keeps what it has room for.
    let all = programs::all().iter();
    for program in all.filter(|it| it.key != "lindholm/static-array") {
        let readings = program.readings();
        let amended = readings.iter().find(|it| it.contains(&Reading::Amended));
        node.run(&object(program, amended.unwrap()));
        let pixels = pixels.iter();
        let pixels: Vec<_> = pixels
            .filter(|it| should_be_exact(program.key, it))
            .collect();
        assert!(pixels.len() > 200, "{}", pixels.len());
        let cases = pixels.iter().map(|pixel| {
            let mut variables = variables(program, pixel);
            let passes = variables.iter_mut().find(|(name, _)| *name == "num_passes");
            if let Some((_, passes)) = passes {
                *passes = pixel.len() as f64 + 2.0;
            }
            case(pixel, variables)
        });
        let left = node.answer_to(&json!({ "runs": cases.collect::<Vec<_>>() }));
        for (pixel, left) in pixels.iter().zip(left.as_array().unwrap()) {
            assert_eq!(
                left["parts"],
                Value::Null,
                "{}: {pixel:#?} {left}",
                program.key
            );
        }
    }
}

/// A program's key, its reading, the depths of its surfaces, and where the run parts from the exact image: the call or the
/// line, and the draw to which it leads or the walk through the list.
const PARTINGS: [(&str, Reading, &[f32], &str, u32); 5] = [
    // The second of two coplanar surfaces is lost. The next layer comes in its place.
    (
        "vtk/on-the-fly",
        Reading::Amended,
        &[0.5, 0.5, 0.7],
        "drawScreen",
        4,
    ),
    // Nothing comes in the place of the last one, so it is the end that is wrong.
    (
        "vtk/on-the-fly",
        Reading::Amended,
        &[0.5, 0.7, 0.7],
        "drawScreen",
        6,
    ),
    // Two layers more than passes. What goes behind the fourth is missing when it is drawn.
    (
        "everitt/depth-peeling",
        Reading::Amended,
        &[0.2, 0.5, 0.3, 0.7, 0.8, 0.9],
        "drawScreen",
        4,
    ),
    // Four of five coplanar fragments fit into the buffer. The second walk skips the fifth.
    (
        "lindholm/pp-dp",
        Reading::AsPrinted,
        &[0.2, 0.2, 0.2, 0.2, 0.2, 0.3],
        "resolve buffer",
        2,
    ),
    // Where it is exact, nowhere.
    (
        "bavoil/dual-peeling",
        Reading::Amended,
        &[0.2, 0.4, 0.3, 0.1],
        "",
        0,
    ),
];

#[test]
fn a_run_parts_from_the_exact_image_at_the_call_that_spoils_it() {
    let Some(mut node) = Node::start() else {
        return;
    };
    for (key, reading, depths, call, pass) in PARTINGS {
        let program = programs::all().iter().find(|it| it.key == key).unwrap();
        node.run(&object(program, &[reading]));
        let surfaces = depths
            .iter()
            .map(|depth| json!([depth, 1.0, 0.5, 0.25, 0.5, "unsorted"]));
        let surfaces: Vec<_> = surfaces.collect();
        let left = node.answer_to(&json!({ "runs": [{ "surfaces": surfaces, "options": {} }] }));
        let parting = &left[0]["parting"];
        match call {
            "" => assert_eq!(*parting, Value::Null, "{key} {depths:?}"),
            call => assert_eq!(
                [&parting["name"], &parting["pass"]],
                [&json!(call), &json!(pass)],
                "{key} {depths:?}"
            ),
        }
    }
}
