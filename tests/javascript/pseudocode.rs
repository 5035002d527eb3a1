//! Every program that is pseudocode, in every reading, on 10,000 random pixels.

use onionskin::low_level::edition::program_json::object;
use onionskin::low_level::edition::programs::{self, Program};
use onionskin::low_level::emulator::{Group, Resolved, run_algorithm, run_on_lists};
use onionskin::low_level::steps::{Reading, Text};
use serde_json::{Value, json};

use crate::cases::{self, Pixel};
use crate::compare::{ROUNDS, SEQUENCES, case, transparent, variables};
use crate::emulated::{drawn, fragments, over};
use crate::node::Node;

/// What is left in JavaScript of the program, which node has.
fn left(node: &mut Node, program: &Program, pixels: &[Pixel]) -> Vec<Value> {
    let case = |pixel| case(pixel, variables(program, pixel));
    let chunks = pixels.chunks(500).flat_map(|pixels| {
        let asked: Vec<_> = pixels.iter().map(case).collect();
        let answer = node.answer_to(&json!({ "runs": asked }));
        answer.as_array().unwrap().clone()
    });
    chunks.collect()
}

/// What lies behind the transparent surfaces.
fn behind(pixel: &Pixel) -> [f32; 4] {
    let opaque = pixel.iter().filter(|it| it.group == Group::Opaque);
    // Of equally near ones the first is seen.
    let nearest = opaque.min_by(|a, b| a.fragment.depth.total_cmp(&b.fragment.depth));
    nearest.map_or([0.0; 4], |it| it.fragment.color.to_array())
}

fn image(left: &Value) -> Vec<f32> {
    let image = left["image"].as_array().unwrap().iter();
    image
        .map(|channel| channel.as_f64().unwrap() as f32)
        .collect()
}

/// Holds what is the same for both kinds of pseudocode against the emulated pixel's.
fn check_end(what: &str, pixel: &Pixel, left: &Value, composited: &[u32], ended: bool) {
    assert_eq!(left["error"], Value::Null, "{what}: {pixel:#?}");
    assert_eq!(
        transparent(&left["composited"], pixel),
        composited,
        "{what}: {pixel:#?}"
    );
    assert_eq!(left["stopped"] != "limit", ended, "{what}: {pixel:#?}");
    let image = image(left);
    assert_eq!(
        image,
        over(pixel, composited, behind(pixel)),
        "{what}: {pixel:#?}"
    );
}

fn check_algorithm(
    what: &str,
    program: &Program,
    reading: Reading,
    pixels: &[Pixel],
    left: &[Value],
) {
    let Text::Pseudocode(algorithm, amendments) = &program.text else {
        return;
    };
    for (pixel, left) in pixels.iter().zip(left) {
        let surfaces = [drawn(program, pixel)];
        let ours = run_algorithm(algorithm, &reading.of(amendments), &surfaces, ROUNDS).unwrap();
        check_end(what, pixel, left, &ours.composited[0], ours.ended);
        assert_eq!(left["rounds"], ours.iterations, "{what}: {pixel:#?}");
        assert_eq!(left["passes"], ours.geometry_passes, "{what}: {pixel:#?}");
    }
}

fn check_lists(what: &str, program: &Program, reading: Reading, pixels: &[Pixel], left: &[Value]) {
    let Text::Lists(algorithm, amendments) = &program.text else {
        return;
    };
    let amendments = reading.of(amendments);
    let array = program.array.unwrap();
    for (pixel, left) in pixels.iter().zip(left) {
        let list = [fragments(pixel)];
        let ours = run_on_lists(algorithm, &amendments, &list, array, ROUNDS).unwrap();
        let resolved = &ours.pixels[0];
        check_end(what, pixel, left, &resolved.composited, ours.ended);
        let lists = &left["lists"];
        let theirs = json!([
            lists["times"],
            lists["records_read"],
            lists["slots"],
            lists["passes"]
        ]);
        assert_eq!(theirs, told(resolved), "{what}: {pixel:#?}");
    }
}

fn told(resolved: &Resolved) -> Value {
    let passes = resolved.passes.iter().map(|pass| {
        json!({
            "skipped": pass.skipped,
            "dropped": pass.dropped,
            "array": pass.array,
            "composited": pass.composited,
        })
    });
    let passes: Vec<_> = passes.collect();
    json!([
        resolved.times,
        resolved.records_read,
        resolved.slots,
        passes
    ])
}

#[test]
fn every_algorithm_composites_what_it_does_on_the_emulated_pixel() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let mut compared = 0;
    for (program, seed) in programs::all().iter().zip(100..) {
        if matches!(program.text, Text::Listing(..)) {
            continue;
        }
        for readings in program.readings() {
            let what = format!("{} {readings:?}", program.key);
            // ppAO's first segment has room for 8.
            let most = if program.array == Some(8) { 20 } else { 8 };
            let pixels = cases::random_pixels_of(seed, SEQUENCES, most);
            node.run(&object(program, &readings));
            let left = left(&mut node, program, &pixels);
            check_algorithm(&what, program, readings[0], &pixels, &left);
            check_lists(&what, program, readings[0], &pixels, &left);
            println!("{what}: {SEQUENCES} sequences");
            compared += 1;
        }
    }
    assert!(compared > 8, "{compared}");
}
