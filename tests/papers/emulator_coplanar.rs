//! Coplanar depth peeling on the emulated pixel: every sequence of few surfaces on few depths, with an opaque surface
//! anywhere or nowhere, is composited as the oracle lists it, ties included.

use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::stage;
use onionskin::low_level::papers::vasilakis_2013::{COPLANAR_PEELING, RESOURCES};
use onionskin::low_level::steps::{Amendment, DepthUnits, Reason, Variables, gl::*, run};
use onionskin::{Format, steps};

use crate::kit::changed::changed;
use crate::kit::peels::{Pixel, bad, before, pixel};

const LEVELS: usize = 4;

/// Every sequence of up to 6 surfaces on four depths, with every opaque surface at, between, before and behind them.
fn cases() -> Vec<Pixel> {
    let depth = |half_level: usize| (half_level + 2) as f32 / 32.0;
    let mut sequences: Vec<Vec<usize>> = vec![vec![]];
    let mut cases = Vec::new();
    for _ in 0..6 {
        let longer = |sequence: &Vec<usize>| {
            let sequence = sequence.clone();
            (0..LEVELS).map(move |level| [&sequence[..], &[level]].concat())
        };
        sequences = sequences.iter().flat_map(longer).collect();
        for sequence in &sequences {
            let without = pixel(sequence.iter().map(|level| depth(level * 2 + 1)));
            cases.extend((0..=LEVELS * 2).map(|at| before(without.clone(), depth(at))));
            cases.push(without);
        }
    }
    cases
}

/// Runs it on an image of these pixels: how many come out wrong, how many passes found a layer, and why it ended.
fn peel(pixels: &[Pixel], amendments: &[Amendment]) -> (usize, f64, Option<Reason>) {
    let mut emulator = Emulator::new(pixels.to_vec());
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(
        &mut emulator,
        &[&stage::RESOURCES, &RESOURCES],
        color,
        depth,
    )
    .unwrap();
    // More than six depths are not there.
    let variables = Variables::new().with("num_passes", 9.0);
    let mut units = DepthUnits::new(&mut emulator);
    let outcome = run(&COPLANAR_PEELING, amendments, variables, &mut units).unwrap();
    let layers = outcome.variables.get("num_layers").unwrap();
    (bad(pixels, emulator.composited()), layers, outcome.stopped)
}

#[test]
pub(crate) fn vx03_every_sequence_is_composited_with_its_ties_in_the_order_of_submission() {
    let cases = cases();
    // 4 + 16 + ... + 4096 sequences, each with nine opaque surfaces and with none.
    assert_eq!(cases.len(), 5460 * 10);
    let (wrong, layers, stopped) = peel(&cases, &[]);
    assert_eq!((wrong, layers), (0, LEVELS as f64));
    assert_eq!(stopped, Some(Reason::EmptyLayer));
}

#[test]
fn vx03_a_changed_word_would_be_noticed() {
    const CHANGES: [(&str, &[Amendment]); 3] = [
        (
            "EQUAL to LEQUAL",
            &[changed(
                steps! { set depth func to EQUAL; },
                steps! { set depth func to LEQUAL; },
            )],
        ),
        (
            "the opaque depth not looked up",
            &[changed(
                steps! { bindDepthBuffer(stage::OPAQUE_DEPTH); set depth func to LESS; },
                steps! { bindDepthBuffer(stage::OPAQUE_DEPTH); set depth func to ALWAYS; },
            )],
        ),
        (
            "over instead of under",
            &[changed(
                steps! { glBlendFunc(ONE_MINUS_DST_ALPHA, ONE); },
                steps! { glBlendFunc(ONE, ONE_MINUS_SRC_ALPHA); },
            )],
        ),
    ];
    let cases = cases();
    for (name, change) in CHANGES {
        assert!(peel(&cases, change).0 > 0, "{name}");
    }
}
