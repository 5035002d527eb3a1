//! The methods in the readings of their papers: each ends and says why, and with silence filled only errors are left.

use std::fs;
use std::path::PathBuf;

use onionskin::low_level::papers::carr_2008::coherent::MOVE_DEPTH;
use onionskin::low_level::scene::Shading;
use onionskin::low_level::steps::{Amendment, Reason};
use onionskin::options::{ArraySort, CoherentOptions, Reading, Variant};
use onionskin::{Comparison, Context, CountBy, Frame, Method, Renderer, Scene, registry};

use crate::kit::bounds::F32;
use crate::kit::driver::{keeps_lists_in_order, settled};
use crate::kit::render::{example, render};
use crate::kit::sampled::sampled;
use crate::kit::stack::{Piece, Stack, scattered};

const SIZE: [u32; 2] = [64, 48];
/// Methods that draw volumes as slices draw so many.
const SLICES: u32 = 1;

#[test]
fn every_reading_of_every_method_ends_on_every_bundled_scene_and_says_why() {
    let context = Context::headless().expect("a context");
    // One for all scenes, because compiling takes longer than rendering.
    let renderer = Renderer::new(&context, SIZE[0], SIZE[1]).expect("a renderer");
    let mut renderer = renderer.with_slices(SLICES).expect("so many slices");
    let in_order = keeps_lists_in_order(&context);
    for path in scenes() {
        let whole = Scene::load_at(&path, Some(SIZE)).expect("a scene");
        let mut scene = sampled(&whole);
        let mut count = |scene| {
            let complexity = renderer.complexity(scene, CountBy::Blending);
            complexity.expect("a count")
        };
        let (complexity, of_whole) = (count(&scene), count(&whole));
        assert!(complexity.counts == of_whole.counts, "{}", scene.name);
        // No color decides when a loop ends.
        for mesh in &mut scene.meshes {
            mesh.shading = Shading::None;
        }
        for volume in &mut scene.volumes {
            volume.step *= 32.0;
        }
        let deepest = complexity.max();
        for (reading, method) in texts(&context) {
            if !draws(&method, &scene) || hangs_on_order(&method) && !in_order {
                continue;
            }
            let what = format!("{method} {} on {}", reading.name(), scene.name);
            let frame = renderer.render(&scene, &method);
            let frame = frame.unwrap_or_else(|e| panic!("{what}: {e}"));
            let why = reason(&method, deepest);
            let expected = match (scene.name.as_str(), method.name(), reading) {
                // The product of depths (CX16) comes to lie before D(s_n), and from then on the range is empty.
                ("medical", "coherent-layer-peeling-b", Reading::Literal | Reading::AsPrinted) => {
                    Some(Reason::NoEnd)
                }
                _ => why,
            };
            assert_eq!(frame.stats.stopped, expected, "{what}");
        }
    }
}

/// Whether it matters in which order fragments come into lists.
fn hangs_on_order(method: &Method) -> bool {
    matches!(method, Method::ABuffer(options) if options.reading != Reading::Amended)
}

fn draws(method: &Method, scene: &Scene) -> bool {
    let volumes = method.entry().volumes;
    scene.volumes.is_empty() || volumes.are_rendered() || volumes.take_slices()
}

fn scenes() -> Vec<PathBuf> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
    let files = fs::read_dir(folder).expect("the bundled scenes");
    let paths = files.map(|file| file.expect("a file").path());
    let scenes: Vec<_> = paths
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    assert!(scenes.len() >= 12, "{scenes:?}");
    scenes
}

/// Why a method ends where no text keeps it going, if the deepest pixel has so many fragments.
fn reason(method: &Method, deepest: u32) -> Option<Reason> {
    match method {
        Method::DepthPeeling(options) if options.reading != Reading::Amended => {
            Some(Reason::PeelLimit)
        }
        // As printed, ppAO leaves nothing to ppDP: what its last segment does not hold is in none. Literally nothing is
        // counted, and all pixels are in every segment.
        Method::ABuffer(options) => {
            let peels = options.pp_dp && (!options.pp_ao || options.reading != Reading::AsPrinted);
            (deepest > options.array && !peels).then_some(Reason::ArrayFull)
        }
        Method::Blend
        | Method::Painter
        | Method::VerifiedPainter
        | Method::Automatic
        | Method::WeightedBlended(_)
        | Method::MultiLayerAlphaBlending(_)
        | Method::Exact => None,
        _ => Some(Reason::EmptyLayer),
    }
}

/// Every method in every reading that has a text of its own.
fn texts(context: &Context) -> Vec<(Reading, Method)> {
    let mut texts = Vec::new();
    for entry in registry() {
        if entry.runs_on(context.driver()) {
            let method = &entry.method;
            let mut own = Reading::ALL.to_vec();
            own.retain(|&reading| with_the_text_of(method, reading) == reading);
            texts.extend(
                own.into_iter()
                    .map(|reading| (reading, read(*method, reading))),
            );
        }
    }
    texts
}

/// The method in a reading. Of depth peeling as printed, which has to be told how many passes it makes, the four layers of
/// its figure 3. Arrays are sorted as in the paper, by insertion: a network is another program for every depth.
fn read(mut method: Method, reading: Reading) -> Method {
    if reading != Reading::Amended {
        let chosen = method.choose(reading.name(), "");
        chosen.expect("it has this reading");
    }
    match &mut method {
        Method::DepthPeeling(options) if reading != Reading::Amended => {
            options.maximum_number_of_peels = 4;
        }
        Method::ABuffer(options) => options.sort = ArraySort::Insertion,
        _ => {}
    }
    method
}

/// The most amended of the readings that run the same text. Most texts have no gap, and some nothing that is wrong.
fn with_the_text_of(method: &Method, reading: Reading) -> Reading {
    let (filled, amended) = match method {
        Method::ABuffer(options) if options.pp_ao || options.pp_dp => (true, true),
        Method::ABuffer(_) => (false, false),
        Method::CoherentLayerPeeling(_) => (true, true),
        method => (false, method.has(Reading::AsPrinted.name())),
    };
    match reading {
        Reading::Literal if filled => Reading::Literal,
        Reading::Literal | Reading::AsPrinted if amended => Reading::AsPrinted,
        _ => Reading::Amended,
    }
}

/// With surfaces on the opaque one, ties, reversed order, and more fragments than an array holds. Here loops go on for ever,
/// and are given up.
#[test]
fn where_a_text_never_ends_it_is_given_up_and_says_so() {
    let context = Context::headless().expect("a context");
    let scene = odd();
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(&context, width, height).expect("a renderer");
    let complexity = renderer.complexity(&scene, CountBy::Blending);
    let deepest = complexity.expect("a count").max();
    let mut others = Vec::new();
    for (reading, method) in texts(&context) {
        let frame = renderer.render(&scene, &method).expect("a frame");
        let stopped = frame.stats.stopped;
        if stopped != reason(&method, deepest) {
            others.push((method.name(), reading, stopped));
        }
    }
    let mut expected = Vec::new();
    // Surfaces on the opaque one are composited in every iteration (CX08).
    for method in ["coherent-layer-peeling-a", "coherent-layer-peeling-b"] {
        expected.push((method, Reading::AsPrinted, Some(Reason::NoEnd)));
    }
    // Fragments of equal depth are lost (LX01), and waited for (LX03).
    for method in ["ffb+ppdp", "dfb+ppdp", "ppll+ppdp"] {
        expected.push((method, Reading::Literal, Some(Reason::NoEnd)));
        expected.push((method, Reading::AsPrinted, Some(Reason::ArrayFull)));
    }
    assert_eq!(others, expected);
}

fn odd() -> Scene {
    let of = |levels: &[u16]| -> Vec<Piece> {
        let mut pieces = scattered(levels.len(), 3, 997);
        pieces
            .iter_mut()
            .zip(levels)
            .for_each(|(piece, &level)| piece.level = level);
        pieces
    };
    let stack = Stack {
        width: 5,
        pixels: vec![
            of(&[500, 100, 300]),
            of(&[400, 350, 300, 250, 200, 150]),
            of(&[200; 20]),
            of(&[100, 100, 200, 200, 300, 300]),
            scattered(70, 1, 490),
        ],
        opaque: Some(500),
    };
    stack.scene()
}

/// Readings that run one text make one frame, and those that run two make two.
#[test]
fn each_text_is_seen_in_its_frame() {
    let context = Context::headless().expect("a context");
    let scene = odd();
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(&context, width, height).expect("a renderer");
    let in_order = keeps_lists_in_order(&context);
    for entry in registry() {
        if !entry.method.has(Reading::Literal.name()) || !entry.runs_on(context.driver()) {
            continue;
        }
        // Amended, what an array has no room for hangs on it, too.
        if matches!(entry.method, Method::ABuffer(_)) && !in_order {
            continue;
        }
        let frames = Reading::ALL.map(|reading| {
            let method = read(entry.method, reading);
            let frame = renderer.render(&scene, &method).expect("a frame");
            (with_the_text_of(&entry.method, reading), seen(&frame))
        });
        for (text, frame) in &frames {
            for (other_text, other_frame) in &frames {
                assert_eq!(
                    text == other_text,
                    frame == other_frame,
                    "{} {text:?} {other_text:?}",
                    entry.name
                );
            }
        }
    }
}

/// What is seen and counted of a frame.
fn seen(frame: &Frame) -> impl PartialEq + std::fmt::Debug + use<> {
    let stats = &frame.stats;
    let pixels = frame.image.pixels.iter();
    let bits: Vec<_> = pixels
        .map(|pixel| [pixel.r, pixel.g, pixel.b, pixel.a].map(f32::to_bits))
        .collect();
    (
        bits,
        stats.iterations,
        stats.geometry_passes,
        stats.lost,
        stats.stopped,
    )
}

/// None of these scenes has a transparent surface on a plane or on an opaque surface.
#[test]
fn as_printed_variant_a_is_exact_and_variant_b_is_wrong_by_its_blend_factors_alone() {
    let context = Context::headless().expect("a context");
    let coherent = |variant, reading, amendments: &'static [Amendment]| {
        Method::CoherentLayerPeeling(CoherentOptions {
            reading,
            amendments,
            ..CoherentOptions::from(variant)
        })
    };
    for name in ["knots", "soup"] {
        let scene = example(name, [60, 45]);
        let exact = render(&context, &scene, &Method::Exact);
        let off = |variant, reading, amendments| {
            let frame = render(&context, &scene, &coherent(variant, reading, amendments));
            let image = settled(&context, &frame, &exact);
            Comparison::new(&image, &exact.image, F32).unwrap().max
        };
        assert!(off(Variant::A, Reading::AsPrinted, &[]) <= F32, "{name}");
        // Of two surfaces that lower the depth, the product is right by chance: sorted knots have no more.
        let wrong = off(Variant::B, Reading::AsPrinted, &[]) > 0.1;
        assert_eq!(wrong, name == "soup", "{name}");
        assert!(
            off(Variant::B, Reading::AsPrinted, &[MOVE_DEPTH]) <= F32,
            "{name}"
        );
        for variant in [Variant::A, Variant::B] {
            assert!(
                off(variant, Reading::Literal, &[]) > 0.1,
                "{name}, {variant:?}"
            );
            assert!(
                off(variant, Reading::Amended, &[]) <= F32,
                "{name}, {variant:?}"
            );
        }
    }
}
