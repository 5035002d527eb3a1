//! Every program that is pseudocode, in every reading, on 10,000 random pixels: each line that is executed, and the end.

use onionskin::low_level::edition::program_json::object;
use onionskin::low_level::edition::programs::{self, Program};
use onionskin::low_level::emulator::{
    ExecutedLine, ExecutedListLine, Group, Resolved, follow_algorithm, follow_on_lists,
};
use onionskin::low_level::steps::{Reading, Text};
use serde_json::{Value, json};

use crate::cases::{self, Pixel};
use crate::compare::{ROUNDS, SEQUENCES, case, parted, shrunk, transparent, variables};
use crate::emulated::{drawn, fragments, over};
use crate::followed::Followed;
use crate::node::Node;

/// Cases that node runs at a time.
const AT_A_TIME: usize = 500;

/// A run, in either machine.
struct Ran {
    digest: Value,
    /// Every line in words, if they are wanted.
    said: Value,
    /// What is left at the end.
    end: Value,
}

/// The program on the emulated pixel.
fn ours(program: &Program, reading: Reading, pixel: &Pixel, detail: bool) -> Ran {
    let mut followed = Followed::new(detail);
    let (composited, ended, more) = match &program.text {
        Text::Pseudocode(algorithm, amendments) => {
            let surfaces = [drawn(program, pixel)];
            let follow = &mut |executed: &ExecutedLine<'_>| followed.on_fragments(executed);
            let amendments = reading.of(amendments);
            let ran = follow_algorithm(algorithm, &amendments, &surfaces, ROUNDS, follow).unwrap();
            let more = json!([ran.iterations, ran.geometry_passes]);
            (ran.composited[0].clone(), ran.ended, more)
        }
        Text::Lists(algorithm, amendments) => {
            let list = [fragments(pixel)];
            let follow = &mut |executed: &ExecutedListLine<'_>| followed.on_lists(executed);
            let (amendments, array) = (reading.of(amendments), program.array.unwrap());
            let ran =
                follow_on_lists(algorithm, &amendments, &list, array, ROUNDS, follow).unwrap();
            let resolved = &ran.pixels[0];
            (resolved.composited.clone(), ran.ended, told(resolved))
        }
        Text::Listing(..) => panic!("{} is a listing", program.key),
    };
    let image = over(pixel, &composited, behind(pixel));
    Ran {
        digest: json!(followed.digest()),
        said: json!(followed.said),
        end: json!([null, composited, ended, image, more]),
    }
}

/// The same in JavaScript, from what node answers.
fn theirs(program: &Program, pixel: &Pixel, left: &Value) -> Ran {
    let image = left["image"].as_array().unwrap().iter();
    let image: Vec<_> = image
        .map(|channel| channel.as_f64().unwrap() as f32)
        .collect();
    let lists = &left["lists"];
    let more = match program.text {
        Text::Pseudocode(..) => json!([left["rounds"], left["passes"]]),
        _ => json!([
            lists["times"],
            lists["records_read"],
            lists["slots"],
            lists["passes"]
        ]),
    };
    let composited = transparent(&left["composited"], pixel);
    let ended = left["stopped"] != "limit";
    Ran {
        digest: left["digest"].clone(),
        said: left["said"].clone(),
        end: json!([left["error"], composited, ended, image, more]),
    }
}

/// What lies behind the transparent surfaces.
fn behind(pixel: &Pixel) -> [f32; 4] {
    let opaque = pixel.iter().filter(|it| it.group == Group::Opaque);
    // Of equally near ones the first is seen.
    let nearest = opaque.min_by(|a, b| a.fragment.depth.total_cmp(&b.fragment.depth));
    nearest.map_or([0.0; 4], |it| it.fragment.color.to_array())
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

fn asked(program: &Program, pixel: &Pixel) -> Value {
    case(pixel, variables(program, pixel))
}

/// The first line after which the machines differ, in words, or what is left if that differs. Node has the program.
fn difference(
    node: &mut Node,
    program: &Program,
    reading: Reading,
    pixel: &Pixel,
) -> Option<String> {
    let left = node.answer_to(&json!({ "runs": [asked(program, pixel)], "detail": true }));
    let ours = ours(program, reading, pixel, true);
    let theirs = theirs(program, pixel, &left[0]);
    let said = |ran: &Ran| {
        let lines = ran.said.as_array().unwrap().iter();
        lines
            .map(|line| line.as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    parted("line", &said(&ours), &said(&theirs)).or_else(|| {
        let [ours, theirs] = [ours.end, theirs.end];
        (ours != theirs).then(|| {
            format!("at the end\n  the emulated pixel: {ours}\n  JavaScript:         {theirs}")
        })
    })
}

/// The first difference between the machines at some pixels, shrunk. Node has the program.
pub(crate) fn first_difference(
    node: &mut Node,
    program: &Program,
    reading: Reading,
    pixels: &[Pixel],
) -> Option<String> {
    for pixels in pixels.chunks(AT_A_TIME) {
        let asked: Vec<_> = pixels.iter().map(|pixel| asked(program, pixel)).collect();
        node.ask(&json!({ "runs": asked }));
        let ours: Vec<_> = pixels
            .iter()
            .map(|pixel| ours(program, reading, pixel, false))
            .collect();
        let left = node.answer();
        for ((pixel, ours), left) in pixels.iter().zip(ours).zip(left.as_array().unwrap()) {
            let theirs = theirs(program, pixel, left);
            if (&ours.digest, &ours.end) != (&theirs.digest, &theirs.end) {
                let mut differ = |pixel: &Pixel| difference(node, program, reading, pixel);
                let found = shrunk(pixel, &mut differ);
                return Some(found.unwrap_or_else(|| format!("{pixel:#?}: digests differ")));
            }
        }
    }
    None
}

#[test]
fn every_algorithm_does_line_by_line_what_it_does_on_the_emulated_pixel() {
    let Some(mut node) = Node::start() else {
        return;
    };
    let mut compared = 0;
    for (program, seed) in programs::all().iter().zip(100..) {
        if matches!(program.text, Text::Listing(..)) {
            continue;
        }
        for readings in program.readings() {
            // ppAO's first segment has room for 8.
            let most = if program.array == Some(8) { 20 } else { 8 };
            let pixels = cases::random_pixels_of(seed, SEQUENCES, most);
            node.run(&object(program, &readings));
            if let Some(found) = first_difference(&mut node, program, readings[0], &pixels) {
                panic!("{} {readings:?}: {found}", program.key);
            }
            println!("{} {readings:?}: {SEQUENCES} sequences", program.key);
            compared += 1;
        }
    }
    assert!(compared > 8, "{compared}");
}
