//! What the methods lose that take one pass and the memory of a few numbers for each pixel, on bundled scenes.

use onionskin::low_level::image::Comparison;
use onionskin::low_level::methods::{MultiLayerOptions, Nodes, Weight, WeightedBlendedOptions};
use onionskin::{Context, Frame, Method};

use crate::kit::render::{example, render};

const SIZE: [u32; 2] = [160, 120];
const SCENES: [&str; 3] = ["teapot", "knots", "molecule"];

fn rms(frame: &Frame, exact: &Frame) -> f64 {
    Comparison::new(&frame.image, &exact.image, 0.0)
        .unwrap()
        .rms
}

#[test]
fn weighted_blending_is_off_on_bundled_scenes_by_every_weight() {
    let context = Context::headless().unwrap();
    for name in SCENES {
        let scene = example(name, SIZE);
        let exact = render(&context, &scene, &Method::Exact);
        let in_order = rms(&render(&context, &scene, &Method::Blend), &exact);
        let by = |weight| {
            let method = Method::WeightedBlended(WeightedBlendedOptions { weight });
            rms(&render(&context, &scene, &method), &exact)
        };
        let all = [
            Weight::Equation7,
            Weight::Equation8,
            Weight::Equation9,
            Weight::Equation10,
        ];
        let errors = all.map(by);
        println!("{name}: rms {errors:.4?}; in the order of submission {in_order:.4}");
        assert!(errors.iter().all(|error| *error > 1e-3), "{errors:?}");
    }
}

#[test]
fn more_nodes_merge_less_and_are_nearer_to_the_exact_image() {
    let context = Context::headless().unwrap();
    let of = |nodes| {
        Method::MultiLayerAlphaBlending(MultiLayerOptions {
            nodes,
            ..MultiLayerOptions::default()
        })
    };
    let entry = of(Nodes::Four).entry();
    if !entry.runs_on(context.driver()) {
        println!("skipped: this driver has none of {:?}", entry.needs);
        return;
    }
    let mut merged_anywhere = 0;
    for name in SCENES {
        let scene = example(name, SIZE);
        let exact = render(&context, &scene, &Method::Exact);
        let by = |nodes| {
            let frame = render(&context, &scene, &of(nodes));
            let part = frame.stats.merged.unwrap() as f64 / frame.stats.fragments as f64;
            (part, rms(&frame, &exact))
        };
        let [(four, off_by_four), (eight, off_by_eight)] = [Nodes::Four, Nodes::Eight].map(by);
        println!(
            "{name}: with 4 nodes {:.1} % merged, rms {off_by_four:.5}; with 8 nodes {:.1} %, rms {off_by_eight:.5}",
            100.0 * four,
            100.0 * eight
        );
        assert!(eight <= four && off_by_eight <= off_by_four, "{name}");
        merged_anywhere += u32::from(eight > 0.0);
    }
    assert!(merged_anywhere > 0);
}
