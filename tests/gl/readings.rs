//! The methods in the readings of their papers: each ends and says why, and with silence filled only errors are left.

use std::collections::BTreeMap;
use std::fs;

use onionskin::low_level::papers::carr_2008::coherent::MOVE_DEPTH;
use onionskin::low_level::steps::Amendment;
use onionskin::options::{CoherentOptions, Reading, Variant};
use onionskin::{Context, CountBy, Method, Renderer, Scene, registry};

use crate::kit::bounds::F32;
use crate::kit::carr_scenes::error;
use crate::kit::render::{example, render};

const SIZE: [u32; 2] = [64, 48];
/// Scenes of more would take minutes: what never ends draws them once for every layer.
const MOST_TRIANGLES: usize = 10_000;

#[test]
fn every_reading_of_every_method_ends_on_every_small_bundled_scene_and_says_why() {
    let context = Context::headless().expect("a context");
    let mut reasons: BTreeMap<String, usize> = BTreeMap::new();
    let mut scenes = 0;
    // One for all scenes, because compiling takes longer than rendering.
    let new = || Renderer::new(&context, SIZE[0], SIZE[1]).expect("a renderer");
    let mut of_surfaces = new();
    let mut of_volumes = new().with_slices(8).expect("so many slices");
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
    for file in fs::read_dir(folder).expect("the bundled scenes") {
        let path = file.expect("a file").path();
        if path.extension().is_none_or(|end| end != "toml") {
            continue;
        }
        let scene = Scene::load_at(&path, Some(SIZE)).expect("a scene");
        let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
        if triangles > MOST_TRIANGLES {
            println!("left out: {} has {triangles} triangles", scene.name);
            continue;
        }
        scenes += 1;
        let renderer = match scene.volumes.is_empty() {
            true => &mut of_surfaces,
            false => &mut of_volumes,
        };
        let layers = renderer
            .complexity(&scene, CountBy::Blending)
            .expect("a count")
            .max();
        for entry in registry() {
            let drawn = scene.volumes.is_empty()
                || entry.volumes.are_rendered()
                || entry.volumes.take_slices();
            if !drawn || !entry.runs_on(context.driver()) {
                continue;
            }
            for (reading, method) in readings(entry.method, layers) {
                let frame = renderer.render(&scene, &method);
                let frame = frame.unwrap_or_else(|e| panic!("{method} on {}: {e}", scene.name));
                let named = format!("{} {}", reading.name(), frame.stats.stopped_text());
                *reasons.entry(named).or_default() += 1;
            }
        }
    }
    println!("{scenes} scenes: {reasons:#?}");
    assert!(scenes >= 5, "{scenes}");
    // None of these scenes has what makes a text go on for ever. That such a loop is given up, the errata's own tests show,
    // such as x8's of a surface on the opaque one.
    let endless: Vec<_> = reasons.keys().filter(|it| it.contains("no end")).collect();
    assert!(endless.is_empty(), "{endless:?}");
    let ended = |why: &str| reasons.keys().filter(|it| it.ends_with(why)).count();
    assert_eq!(
        [ended("empty layer"), ended("done")],
        [2, 2],
        "in both readings"
    );
}

/// The method in the readings in which it may not end by itself.
fn readings(method: Method, layers: u32) -> Vec<(Reading, Method)> {
    let mut all = Vec::new();
    for reading in [Reading::AsPrinted, Reading::Literal] {
        let mut method = method;
        if method
            .choices()
            .iter()
            .any(|choice| choice.name == reading.name())
        {
            method
                .choose(reading.name(), "")
                .expect("it has this reading");
            if let Method::DepthPeeling(options) = &mut method {
                options.maximum_number_of_peels = layers + 1;
            }
            all.push((reading, method));
        }
    }
    all
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
            error(&frame, &exact)
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
