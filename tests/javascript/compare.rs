//! A listing's program on both machines, held against each other.

use onionskin::low_level::edition::program_json::object;
use onionskin::low_level::edition::programs::{self, Program};
use onionskin::low_level::emulator::Group;
use onionskin::low_level::steps::{Reading, Text, Variables};
use serde_json::{Map, Value, json};

use crate::cases::{self, Pixel};
use crate::emulated::{self, Emulated};
use crate::node::Node;

/// Sequences of each program in each reading.
pub(crate) const SEQUENCES: usize = 10_000;
/// So many at a time, so that both machines are at work.
pub(crate) const AT_A_TIME: usize = 250;

/// The variables that a run begins with. Loops without an end of their own have more rounds than a right algorithm needs.
pub(crate) fn variables(program: &Program, pixel: &Pixel) -> Vec<(&'static str, f64)> {
    let enough = pixel.len() as f64 + 2.0;
    let bounded = program.variables.iter().map(|&(name, value)| {
        let is_endless = value == f64::INFINITY;
        (name, if is_endless { enough } else { value })
    });
    let rounds = [("rounds", ROUNDS), ("subpasses", ROUNDS)];
    let rounds = rounds.map(|(name, value)| (name, f64::from(value)));
    match program.text {
        Text::Listing(..) => bounded.collect(),
        _ => rounds.to_vec(),
    }
}

/// Rounds of a loop of pseudocode, and walks through a list: more than a right algorithm needs.
pub(crate) const ROUNDS: u32 = 12;

/// A pixel for node.
pub(crate) fn case(pixel: &Pixel, variables: Vec<(&'static str, f64)>) -> Value {
    let named = |(name, value): (&str, f64)| (name.to_owned(), json!(value));
    let variables: Map<_, _> = variables.into_iter().map(named).collect();
    json!({ "surfaces": cases::json(pixel), "options": { "variables": variables } })
}

/// The program on the emulated pixel, with a digest of each call or, with `detail`, its words.
pub(crate) fn emulate(
    program: &Program,
    reading: Reading,
    pixel: &Pixel,
    order: Option<&[u32]>,
    detail: bool,
) -> Emulated {
    let values = variables(program, pixel).into_iter();
    let values = values.fold(Variables::new(), |values, (name, value)| {
        values.with(name, value)
    });
    emulated::listing(program, reading, pixel, &values, order, detail)
}

/// The first call after which the machines differ, in words. Node has the program.
fn difference(
    node: &mut Node,
    program: &Program,
    reading: Reading,
    pixel: &Pixel,
) -> Option<String> {
    let asked = case(pixel, variables(program, pixel));
    let answer = node.answer_to(&json!({ "cases": [asked], "detail": true }));
    let theirs = answer[0].as_array().unwrap().iter();
    let theirs: Vec<_> = theirs
        .map(|said| said.as_str().unwrap().to_owned())
        .collect();
    let ours = emulate(program, reading, pixel, None, true).said;
    parted("call", &ours, &theirs)
}

/// The first moment at which the machines say different things. `what` is what they say something about.
pub(crate) fn parted(what: &str, ours: &[String], theirs: &[String]) -> Option<String> {
    let at = |number: usize| {
        [ours, theirs].map(|said| said.get(number).map_or("nothing", String::as_str))
    };
    let mut numbers = 0..ours.len().max(theirs.len());
    let number = numbers.find(|&number| {
        let [ours, theirs] = at(number);
        ours != theirs
    })?;
    let [ours, theirs] = at(number);
    Some(format!(
        "after {what} {number}\n  the emulated pixel: {ours}\n  JavaScript:         {theirs}"
    ))
}

/// The difference on as few surfaces as show one, with these surfaces.
pub(crate) fn shrunk(
    pixel: &Pixel,
    difference: &mut impl FnMut(&Pixel) -> Option<String>,
) -> Option<String> {
    let found = difference(pixel)?;
    for place in 0..pixel.len() {
        let smaller = cases::without(pixel, place);
        if let Some(found) = shrunk(&smaller, difference) {
            return Some(found);
        }
    }
    Some(format!("{pixel:#?}\n{found}"))
}

/// The first difference between the machines at some pixels, shrunk. Node has the program.
pub(crate) fn first_difference(
    node: &mut Node,
    program: &Program,
    reading: Reading,
    pixels: &[Pixel],
) -> Option<String> {
    // The calls' words, too.
    for pixel in pixels.iter().take(20) {
        if let Some(found) = shrunk(pixel, &mut |pixel| {
            difference(node, program, reading, pixel)
        }) {
            return Some(found);
        }
    }
    for pixels in pixels.chunks(AT_A_TIME) {
        let asked = pixels
            .iter()
            .map(|pixel| case(pixel, variables(program, pixel)));
        node.ask(&json!({ "cases": asked.collect::<Vec<_>>() }));
        let emulate = |pixel| emulate(program, reading, pixel, None, false);
        let ours: Vec<_> = pixels.iter().map(emulate).collect();
        let theirs = node.answer();
        for ((pixel, ours), theirs) in pixels.iter().zip(ours).zip(theirs.as_array().unwrap()) {
            let differs = theirs[0] != ours.digest[0] || theirs[1] != ours.digest[1];
            if differs {
                let mut differ = |pixel: &Pixel| difference(node, program, reading, pixel);
                let found = shrunk(pixel, &mut differ);
                return Some(found.unwrap_or_else(|| format!("{pixel:#?}: digests differ")));
            }
            let composited = transparent(&theirs[2], pixel);
            if composites_surfaces(program, reading) && composited != ours.composited {
                let ours = ours.composited;
                return Some(format!(
                    "{pixel:#?}: {composited:?} are composited, not {ours:?}"
                ));
            }
        }
    }
    None
}

/// Whether it composites surfaces by drawing them under one another, and by nothing else: then the emulated pixel tells their
/// order. Read literally, the passes of coherent layer peeling clear what has been composited, and draw into it.
fn composites_surfaces(program: &Program, reading: Reading) -> bool {
    let is_cleared = program.key.starts_with("carr/coherent") && reading == Reading::Literal;
    program.key.starts_with("carr/") && program.key != "carr/ideal" && !is_cleared
}

/// The numbers of surfaces, without opaque ones.
pub(crate) fn transparent(numbers: &Value, pixel: &Pixel) -> Vec<u32> {
    let numbers = numbers.as_array().unwrap().iter();
    let numbers = numbers.map(|number| number.as_u64().unwrap() as u32);
    numbers
        .filter(|&number| pixel[number as usize].group != Group::Opaque)
        .collect()
}

/// Holds the listings' programs with such keys against the emulated pixel, in every reading.
pub(crate) fn check(is_among: impl Fn(&str) -> bool) {
    let Some(mut node) = Node::start() else {
        return;
    };
    let mut compared = 0;
    for (program, seed) in programs::all().iter().zip(1..) {
        if !matches!(program.text, Text::Listing(..)) || !is_among(program.key) {
            continue;
        }
        for readings in program.readings() {
            node.run(&object(program, &readings));
            let pixels = cases::random_pixels(seed, SEQUENCES);
            if let Some(found) = first_difference(&mut node, program, readings[0], &pixels) {
                panic!("{} {readings:?}: {found}", program.key);
            }
            println!("{} {readings:?}: {SEQUENCES} sequences", program.key);
            compared += 1;
        }
    }
    assert!(compared > 0);
}
