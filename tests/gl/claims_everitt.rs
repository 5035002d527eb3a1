//! What Everitt 2001 claims of the layers (E01, E02, E10), each claim under its key. E03, Listing 1 as text, is in
//! `papers/listings.rs`; E04 and E05 in `gl/claims_everitt_depth_units.rs`, E12 and E13 in `gl/claims_everitt_compositing.rs`, their
//! errors in numbers in `gl/accumulation.rs`; E08 and what E04 says of the OpenGL of 2001 in `gl/classic_*.rs`; E06, E07
//! and E09 in `gl/invariance.rs`; E11 in `gl/cross_section.rs`.

use crate::kit::bounds::F32;
use crate::kit::driver::settled;
use crate::kit::everitt_scenes::{
    VISIBLE, check_stacks, disagreements, example, keeping, near, nearest, peel, render, samples,
    soup_scene,
};
use crate::kit::figures::expect_figures;
use crate::kit::lists::Lists;
use crate::kit::stack;
use onionskin::generate::{Quads, SubmissionOrder, quads};
use onionskin::options::DepthPeelingOptions;
use onionskin::{Comparison, Context, Layer, Method, Scene};

#[test]
pub(crate) fn e01_blending_in_the_order_of_submission_is_wrong_and_peeling_is_right() {
    let context = Context::headless().unwrap();
    for name in ["teapot", "knots"] {
        let scene = example(name);
        let exact = render(&context, &scene, Method::Exact);
        let off = |method| {
            let frame = render(&context, &scene, method);
            let image = settled(&context, &frame, &exact);
            Comparison::new(&image, &exact.image, VISIBLE).unwrap()
        };
        let blended = off(Method::Blend);
        let covered = Lists::of(&context, &scene).samples(0);
        println!("{name}: blending {blended:?}, {covered} pixels covered");
        // 'Incorrect' as figure 1 shows it is not a pixel here and there.
        assert!(blended.over as u64 > covered / 20, "{name}: {blended:?}");
        assert!(blended.max > 0.1, "{name}: {blended:?}");
        let peeled = off(Method::DepthPeeling(DepthPeelingOptions::default()));
        assert!(peeled.max <= F32, "{name}: {peeled:?}");
    }
}

#[test]
pub(crate) fn e01_blending_is_right_where_the_order_happens_to_be() {
    // So 'wrong' above is due to the order, and to nothing else.
    let context = Context::headless().unwrap();
    let error = |order| {
        let parameters = Quads {
            order,
            ..Quads::default()
        };
        let mut scene = Scene::of("quads", vec![quads(&parameters).unwrap()]);
        scene.size = [40, 30];
        let exact = render(&context, &scene, Method::Exact);
        let blended = render(&context, &scene, Method::Blend);
        Comparison::new(&blended.image, &exact.image, F32)
            .unwrap()
            .max
    };
    assert!(error(SubmissionOrder::BackToFront) <= F32);
    assert!(error(SubmissionOrder::FrontToBack) > VISIBLE);
}

#[test]
pub(crate) fn e02_n_passes_give_the_n_nearest_layers() {
    let context = Context::headless().unwrap();
    for scene in [soup_scene(11), example("teapot"), example("knots")] {
        let lists = Lists::of(&context, &scene).distinct();
        for passes in [1, 2, 5] {
            let frame = peel(&context, &scene, keeping(passes));
            assert_eq!(frame.layers.len(), passes as usize, "{}", scene.name);
            assert_eq!(
                disagreements(&frame.layers, &lists),
                (0, 0),
                "{}",
                scene.name
            );
        }
    }
}

#[test]
pub(crate) fn e02_all_passes_give_all_layers() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(12);
    let lists = Lists::of(&context, &scene).distinct();
    let frame = peel(&context, &scene, keeping(0));
    assert_eq!(frame.layers.len(), lists.complexity());
    assert_eq!(disagreements(&frame.layers, &lists), (0, 0));
}

#[test]
pub(crate) fn e02_two_layers_exchanged_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(11);
    let lists = Lists::of(&context, &scene).distinct();
    let mut frame = peel(&context, &scene, keeping(3));
    frame.layers.swap(1, 2);
    let (depths, colors) = disagreements(&frame.layers, &lists);
    assert!(
        depths > 0 && colors > 0,
        "{depths} depths, {colors} colours"
    );
}

#[test]
pub(crate) fn e02_a_depth_off_by_its_last_bit_would_be_noticed() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(11);
    let lists = Lists::of(&context, &scene).distinct();
    let mut frame = peel(&context, &scene, keeping(1));
    let depth = &mut frame.layers[0].depth[4000];
    *depth = f32::from_bits(depth.to_bits() + 1);
    assert_eq!(disagreements(&frame.layers, &lists), (1, 0));
}

#[test]
pub(crate) fn e02_layers_of_known_stacks_are_their_lists() {
    // Nothing here comes from a capture: the lists are what the stack was made from.
    check_stacks(stack::stacks(7, false), 64, |context, stack| {
        let frame = peel(context, &stack.scene(), keeping(0));
        let layered = nearest(stack, u32::MAX);
        let longest = layered.pixels.iter().map(Vec::len).max().unwrap_or(0);
        if frame.layers.len() != longest {
            return Err(format!("{} layers, not {longest}", frame.layers.len()));
        }
        for (pixel, pieces) in layered.pixels.iter().enumerate() {
            for (number, layer) in frame.layers.iter().enumerate() {
                let expected = pieces.get(number).map_or([0.0; 4], |piece| piece.color);
                let found = layer.color.pixels[pixel];
                if !near(found, expected.into()) {
                    return Err(format!("pixel {pixel}, layer {number}: {found:?}"));
                }
            }
        }
        Ok(())
    });
}

#[test]
pub(crate) fn e10_samples_decrease_from_layer_to_layer() {
    let context = Context::headless().unwrap();
    let frame = peel(&context, &example("teapot"), keeping(0));
    let samples: Vec<_> = frame.layers.iter().map(samples).collect();
    println!("samples of each layer: {samples:?}");
    let first: Vec<_> = samples.iter().take(4).map(|&count| count as f64).collect();
    expect_figures("E10", 0, &first);
    assert!(
        samples.windows(2).all(|pair| pair[0] > pair[1]),
        "{samples:?}"
    );
}

#[test]
pub(crate) fn e10_layer_0_shows_the_teapot_s_outside_before_the_plane() {
    let [layer, ..] = teapot_layers();
    println!("{layer:?}");
    assert!(layer.red > layer.green * 20, "{layer:?}");
    assert!(layer.blue > 0, "{layer:?}");
}

#[test]
pub(crate) fn e10_layer_1_shows_the_teapot_s_inside() {
    let [_, layer, ..] = teapot_layers();
    println!("{layer:?}");
    assert!(
        layer.green > layer.red && layer.green > layer.blue,
        "{layer:?}"
    );
}

#[test]
pub(crate) fn e10_layer_2_has_the_shape_of_a_teapot_but_most_of_it_is_plane() {
    let [zero, _, two, _] = teapot_layers();
    println!("{two:?}");
    assert!(two.blue * 2 > two.all(), "{two:?}");
    // The teapot's shape: no larger than the teapot, which is where layer 0 is red or green.
    assert!(two.all() <= zero.red + zero.green, "{two:?} in {zero:?}");
}

/// What is left behind three surfaces: the plane under the pot's far side, and the pot's own parts where handle, spout and
/// body stand before each other. It is a part of layer 2's shape.
#[test]
pub(crate) fn e10_layer_3_is_a_part_of_layer_2_s_shape() {
    let context = Context::headless().unwrap();
    let frame = peel(&context, &example("teapot"), keeping(4));
    let [two, three] = [2, 3].map(|number: usize| &frame.layers[number].depth);
    let pairs = two.iter().zip(three);
    assert!(
        pairs
            .clone()
            .all(|(two, three)| *three >= 1.0 || two < three)
    );
    assert!(
        pairs
            .filter(|(two, three)| **two < 1.0 && **three >= 1.0)
            .count()
            > 100
    );
    let [.., hues] = teapot_layers();
    println!("{hues:?}");
    // The inside of the pot once more, and the plane behind it.
    assert!(
        hues.green > 50 && hues.blue > 50 && hues.red < 20,
        "{hues:?}"
    );
}

/// How many of a layer's samples are mostly of one colour.
#[derive(Clone, Copy, Debug, Default)]
struct Hues {
    red: usize,
    green: usize,
    blue: usize,
}

impl Hues {
    fn all(&self) -> usize {
        self.red + self.green + self.blue
    }
}

fn teapot_layers() -> [Hues; 4] {
    let context = Context::headless().unwrap();
    let frame = peel(&context, &example("teapot"), keeping(4));
    let hues = |layer: &Layer| {
        let mut hues = Hues::default();
        for (pixel, _) in layer
            .color
            .pixels
            .iter()
            .zip(&layer.depth)
            .filter(|(_, depth)| **depth < 1.0)
        {
            let [r, g, b, _] = pixel.to_array();
            *(if r > g && r > b {
                &mut hues.red
            } else if g > b {
                &mut hues.green
            } else {
                &mut hues.blue
            }) += 1;
        }
        hues
    };
    std::array::from_fn(|number| hues(&frame.layers[number]))
}
