//! The two ways in which the Local Array keeps its keys: as doubles where the driver is quick with them, and as words elsewhere,
//! where doubles go wrong. llvmpipe can do both.

use crate::kit::a_buffer::{MANAGERS, options, soup_scene};
use crate::kit::changed::{Change, with_change};
use crate::kit::driver::keys_are_doubles;
use crate::kit::stack::row;
use onionskin::low_level::gl::shader_file;
use onionskin::options::{ABufferOptions, ArraySort, Keep};
use onionskin::{Context, Image, Renderer, Scene};

const IN_WORDS: Change = [
    "a_buffer/local_array.glsl",
    "#define DOUBLES KEYS_AS_DOUBLES",
    "#define DOUBLES 0",
];
/// The frame's image and counts with keys of either kind.
fn both(context: &Context, scene: &Scene, options: ABufferOptions) -> [String; 2] {
    let [width, height] = scene.size;
    let renderers = [
        Renderer::new(context, width, height).unwrap(),
        with_change(Renderer::new(context, width, height).unwrap(), IN_WORDS),
    ];
    renderers.map(|mut renderer| {
        let frame = renderer.render(scene, &options).unwrap();
        format!(
            "{:?} {:?} {:?}",
            frame.stats.lost, frame.stats.a_buffer, frame.image.pixels
        )
    })
}

#[test]
fn keys_in_words_give_the_bits_and_the_counts_of_keys_in_doubles() {
    let context = Context::headless().unwrap();
    if !keys_are_doubles(&context) {
        return;
    }
    let stack = row(&[0, 1, 7, 8, 9, 16, 17, 24, 40]).scene();
    let mut soup = soup_scene(3);
    soup.size = [40, 30];
    let ways = [(false, false), (true, false), (false, true), (true, true)];
    for (scene, sort) in [
        (&stack, ArraySort::Insertion),
        (&stack, ArraySort::Network),
        (&soup, ArraySort::Insertion),
    ] {
        for (manager, (pp_ao, pp_dp)) in MANAGERS.into_iter().flat_map(|m| ways.map(|way| (m, way)))
        {
            for keep in [Keep::First, Keep::Nearest] {
                let options = ABufferOptions {
                    manager,
                    pp_ao,
                    pp_dp,
                    sort,
                    keep,
                    array: 16,
                    ..options()
                };
                if pp_dp && keep == Keep::Nearest {
                    continue; // ppDP drops nothing.
                }
                let [doubles, words] = both(&context, scene, options);
                assert!(doubles == words, "{options:?}");
            }
        }
    }
}

#[test]
fn words_that_leave_out_the_order_would_be_noticed() {
    let context = Context::headless().unwrap();
    // Coplanar quads, so that only the order of submission tells them apart.
    let mut tied = row(&[12; 4]);
    for piece in tied.pixels.iter_mut().flatten() {
        piece.level %= 3;
    }
    let scene = tied.scene();
    let options = ABufferOptions {
        pp_dp: true,
        ..options()
    };
    let right = words_by(&context, &scene, options, ["", ""]);
    assert!(
        right
            == Renderer::new(&context, 4, 1)
                .unwrap()
                .render(&scene, &options)
                .unwrap()
                .image
    );
    // The order of submission no longer decides between equal depths.
    let depth_alone = [
        "((a).x < (b).x || ((a).x == (b).x && (a).y < (b).y))",
        "((a).x < (b).x)",
    ];
    assert!(right != words_by(&context, &scene, options, depth_alone));
}

/// With keys in words, and another text in the place of one.
fn words_by(
    context: &Context,
    scene: &Scene,
    options: ABufferOptions,
    [from, to]: [&str; 2],
) -> Image {
    let [file, doubles, words] = IN_WORDS;
    let text = shader_file(file).unwrap().replace(doubles, words);
    assert!(text.contains(from));
    let renderer = Renderer::new(context, 4, 1).unwrap();
    let mut renderer = renderer
        .with_shader_file(file, &text.replace(from, to))
        .unwrap();
    renderer.render(scene, &options).unwrap().image
}
