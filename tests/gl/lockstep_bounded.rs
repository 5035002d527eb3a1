//! The two methods with bounded memory on the emulated pixel and on OpenGL: the same sums, products and nodes after every
//! draw.

use onionskin::Context;
use onionskin::low_level::papers::mcguire_2013::{RESOURCES, WEIGHTED_BLENDED};
use onionskin::low_level::papers::salvi_2014::{
    COUNT_TAKEN, EIGHT_IMAGES, EIGHT_NODES, FOUR_IMAGES, FOUR_NODES, RESOURCES_OF_EIGHT,
    RESOURCES_OF_FOUR,
};
use onionskin::low_level::steps::{Variables, run};

use crate::kit::both::{Both, parting};
use crate::kit::changed::Change;
use crate::kit::lockstep::LockStep;
use crate::lockstep::random_stack;

/// Weights, and so sums of them, are off relatively. The depth of which a distance of up to 4 is computed, with the near
/// plane at 1, is off by 2^-25, the distance by up to 3 times that, and OpenGL's own distance by as much. A weight has up to
/// the sixth power of it, and ten more roundings of 2^-24; then ten are added up, and one sum is divided by another.
const WEIGHTED: f32 = 2.0 * (6.0 * 3.0 + 10.0 + 10.0) / 16_777_216.0;

fn weighted(equation: u32) -> Both {
    Both {
        color_bound: WEIGHTED,
        ..Both::with(&[&RESOURCES]).defining(&[("EQUATION", equation)])
    }
}

fn blended(both: &mut LockStep<'_, '_>) {
    run(&WEIGHTED_BLENDED, &[], Variables::new(), both).unwrap();
}

#[test]
fn ten_thousand_sequences_by_weighted_blended_transparency() {
    let context = Context::headless().unwrap();
    for equation in 7..=10 {
        let scene = random_stack(u64::from(equation)).scene();
        let compared = weighted(equation).drive(&context, &scene, blended);
        println!("equation {equation}: {compared} comparisons");
        assert!(compared > 200_000, "{compared}");
    }
}

#[test]
fn a_changed_word_of_weighted_blended_transparency_is_noticed() {
    const CHANGES: [(Change, &str); 3] = [
        (
            [
                "weighted/accumulate.frag",
                "vec4(straight.a);",
                "vec4(1.0);",
            ],
            "revealage",
        ),
        (
            [
                "weighted/accumulate.frag",
                "square(z / 5.0)",
                "square(z / 5.001)",
            ],
            "weighted colors",
        ),
        (
            ["weighted/composite.frag", "sums.rgb / sums.a", "sums.rgb"],
            "image",
        ),
    ];
    let context = Context::headless().unwrap();
    let scene = random_stack(11).scene();
    for (change, said) in CHANGES {
        let what = parting(|| {
            weighted(7).changed(change).drive(&context, &scene, blended);
        });
        assert!(what.starts_with(said), "{change:?}: {what}");
    }
}

fn multi_layer(nodes: u32, by_images: bool) -> Both {
    let resources = match nodes {
        4 => &RESOURCES_OF_FOUR,
        _ => &RESOURCES_OF_EIGHT,
    };
    Both {
        color_bound: 0.0,
        ..Both::with(&[resources]).defining(&[("NODES", nodes), ("IMAGES", u32::from(by_images))])
    }
}

fn merged(nodes: u32, by_images: bool) -> impl Fn(&mut LockStep<'_, '_>) {
    move |both| {
        let (listing, images) = match nodes {
            4 => (&FOUR_NODES, &FOUR_IMAGES),
            _ => (&EIGHT_NODES, &EIGHT_IMAGES),
        };
        let images = std::slice::from_ref(images);
        let amendments = if by_images { images } else { &[] };
        run(listing, amendments, Variables::new(), both).unwrap();
        let nodes = Variables::new().with("nodes", f64::from(nodes));
        run(&COUNT_TAKEN, &[], nodes, both).unwrap();
    }
}

/// Fragments that the driver's framebuffer hands out in their order, or that images have in the order in which llvmpipe draws
/// them. Nodes have 24 bits of colours, so only a driver that rounds sums and products one by one has the same bits.
#[test]
fn ten_thousand_sequences_by_multi_layer_alpha_blending() {
    let context = Context::headless().unwrap();
    for by_images in [false, true] {
        let quirks = context.driver().quirks();
        if !has_order(&context, by_images) || !quirks.blends_in_three_roundings {
            continue;
        }
        for nodes in [4, 8] {
            let scene = random_stack(u64::from(nodes)).scene();
            let compared =
                multi_layer(nodes, by_images).drive(&context, &scene, merged(nodes, by_images));
            println!("{nodes} nodes: {compared} comparisons");
            assert!(compared > 200_000, "{compared}");
        }
    }
}

#[test]
fn a_changed_word_of_multi_layer_alpha_blending_is_noticed() {
    const CHANGES: [(Change, &str); 3] = [
        (
            [
                "multi_layer/insert.frag",
                "farther.x < here.x",
                "farther.x <= here.x",
            ],
            "node",
        ),
        (
            [
                "multi_layer/node.glsl",
                "return Node(near.depth,",
                "return Node(far.depth,",
            ],
            "node",
        ),
        (
            [
                "multi_layer/composite.frag",
                "vec4(all.color, all.transmittance)",
                "vec4(all.color, 1.0)",
            ],
            "image",
        ),
    ];
    let context = Context::headless().unwrap();
    if !has_order(&context, false) {
        return;
    }
    let scene = random_stack(12).scene();
    for (change, said) in CHANGES {
        let what = parting(|| {
            let changed = multi_layer(4, false).changed(change);
            changed.drive(&context, &scene, merged(4, false));
        });
        assert!(what.starts_with(said), "{change:?}: {what}");
    }
}

/// Whether the driver gives a pixel's fragments their turns, by framebuffer fetch or, on llvmpipe alone, by images.
pub(crate) fn has_order(context: &Context, by_images: bool) -> bool {
    let driver = context.driver();
    let has = match by_images {
        false => driver.has("GL_EXT_shader_framebuffer_fetch"),
        true => {
            driver.has("GL_ARB_fragment_shader_interlock") || driver.renderer.contains("llvmpipe")
        }
    };
    if !has {
        println!("skipped: {} has no order", driver.renderer);
    }
    has
}
