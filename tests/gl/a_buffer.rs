//! A-buffers against the oracle: every memory manager, every way to fill, sort and resolve, on random fragment stacks with
//! ties, on soups and on models; complexities around every limit.

use crate::kit::bounds::F32;
use crate::kit::driver::settled;
use crate::kit::stack;
use onionskin::low_level::methods::Technique;
use onionskin::options::{ABufferOptions, ArraySort, Fill, Manager, RecordColor};
use onionskin::{Comparison, Context, CountBy, Format, Frame, Method, Renderer, Scene};
use proptest::test_runner::{TestCaseError, TestError};

use crate::kit::a_buffer::*;
use crate::kit::stack::{Stack, row, runner, scattered, stacks};

/// static, ppAO, ppDP, both.
const LOCAL: [(bool, bool); 4] = [(false, false), (true, false), (false, true), (true, true)];

/// Every combination with arrays that small stacks fill.
fn combinations() -> Vec<ABufferOptions> {
    let mut all = Vec::new();
    for manager in MANAGERS {
        for (pp_ao, pp_dp) in LOCAL {
            for fill in [Fill::Atomics, Fill::Automatic] {
                for sort in [ArraySort::Network, ArraySort::Insertion] {
                    for color in [RecordColor::Half, RecordColor::Float] {
                        all.push(ABufferOptions {
                            manager,
                            pp_ao,
                            pp_dp,
                            fill,
                            sort,
                            color,
                            array: 16,
                            peel: 3,
                            ..ABufferOptions::DEFAULT
                        });
                    }
                }
            }
        }
    }
    all
}

fn bound(options: &ABufferOptions) -> f64 {
    match options.color {
        RecordColor::Half => F16,
        RecordColor::Float | RecordColor::Fixed => F32,
    }
}

#[test]
pub(crate) fn l04_every_manager_and_fill_gives_the_oracle_s_image() {
    let context = Context::headless().unwrap();
    let combinations = combinations();
    assert_eq!(combinations.len(), 96);
    // One renderer, so that each program is compiled once.
    let renderer = std::cell::RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    for levels in [stack::LEVELS, 4] {
        let ran = runner(6).run(&stacks(levels, false), |stack| {
            let scene = stack.scene();
            let mut first: [Option<Frame>; 2] = [None, None];
            for options in &combinations {
                let frame = renderer
                    .borrow_mut()
                    .render(&scene, &Method::ABuffer(*options))
                    .unwrap();
                let (fragments, _) = stack.counts();
                let error =
                    Comparison::new(&frame.image, &stack.expected(), bound(options)).unwrap();
                let whole = frame.stats.lost == Some(0) && frame.stats.fragments == fragments;
                // The same fragments in the same order, composited by the same arithmetic: the same bits.
                let first = &mut first[usize::from(options.color == RecordColor::Float)];
                let same = first.get_or_insert_with(|| frame.clone()).image == frame.image;
                if error.over > 0 || !whole || !same {
                    let what = format!("{options:?}: {error:?} same {same}\n{}", frame.stats);
                    return Err(TestCaseError::fail(what));
                }
            }
            Ok(())
        });
        if let Err(TestError::Fail(why, stack)) = ran {
            panic!("{why}\nthe smallest stack: {stack:#?}");
        }
    }
}

/// Where fragments come in order, with every component: as exact as floats, and the bits do not depend on the manager.
#[test]
fn fixed_point_colours_are_exact_and_refused_where_they_do_not_fit() {
    let context = Context::headless().unwrap();
    // One renderer, so that each program is compiled once.
    let renderer = std::cell::RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    let fixed = |manager, (pp_ao, pp_dp)| ABufferOptions {
        manager,
        pp_ao,
        pp_dp,
        color: RecordColor::Fixed,
        ..ABufferOptions::DEFAULT
    };
    let is_in_order = context.driver().has("GL_EXT_shader_framebuffer_fetch");
    let ran = runner(30).run(&stacks(4, false), |stack| {
        let mut first: Option<Frame> = None;
        for manager in MANAGERS.into_iter().filter(|_| is_in_order) {
            for local in LOCAL {
                let options = fixed(manager, local);
                let frame = renderer
                    .borrow_mut()
                    .render(&stack.scene(), &Method::ABuffer(options));
                let frame = frame.unwrap();
                let error =
                    Comparison::new(&frame.image, &stack.expected(), bound(&options)).unwrap();
                proptest::prop_assert!(error.over == 0, "{options:?}: {error:?}");
                let same = first.get_or_insert_with(|| frame.clone()).image == frame.image;
                proptest::prop_assert!(same, "{options:?}");
            }
        }
        Ok(())
    });
    stack::expect_none(ran);
    let mut atomics = fixed(Manager::Dfb, (true, true));
    atomics.fill = Fill::Atomics;
    let bright = |alpha| {
        let mut scene = row(&[3; 6]).scene();
        scene.meshes[0].vertices[0].color.a = alpha;
        scene
    };
    let ordered = fixed(Manager::Dfb, (true, true));
    for (scene, options) in [
        (bright(0.5), atomics),
        (bright(1.5), ordered),
        (bright(f32::NAN), ordered),
    ] {
        let frame = renderer
            .borrow_mut()
            .render(&scene, &Method::ABuffer(options));
        let text = frame.unwrap_err().to_string();
        assert!(text.contains("no ids") && text.contains("float"), "{text}");
    }
}

#[test]
fn a_wrong_image_would_be_noticed() {
    let context = Context::headless().unwrap();
    let mut stack = row(&[5; 4]);
    let frame = Renderer::new(&context, 4, 1)
        .unwrap()
        .render(&stack.scene(), &Method::ABuffer(small(Manager::Ppll)))
        .unwrap();
    // Seen through the others it changes the image by more than the bound, but by less than a step of 8 bits.
    stack.pixels[3][0].color[1] += 0.1;
    let error = Comparison::new(&frame.image, &stack.expected(), F16).unwrap();
    assert_eq!(error.over, 1);
}

/// Around every segment's limit and far beyond, all pixels alike and one deep pixel among shallow ones.
#[test]
pub(crate) fn l21_every_complexity_comes_out_exact_by_peeling() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    for complexity in [
        0, 1, 7, 8, 9, 63, 64, 65, 127, 128, 129, 255, 256, 300, 1000,
    ] {
        for stack in [row(&[complexity; 4]), one_deep(complexity)] {
            let scene = stack.scene();
            let expected = stack.expected();
            for manager in MANAGERS {
                for pp_ao in [false, true] {
                    // ppDP with an array of 64 takes a driver seconds to compile, so not with every manager.
                    let array = if manager == Manager::Dfb { 64 } else { 16 };
                    let options = ABufferOptions {
                        pp_ao,
                        pp_dp: true,
                        array,
                        color: RecordColor::Float,
                        ..small(manager)
                    };
                    let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
                    let error = Comparison::new(&frame.image, &expected, F32).unwrap();
                    assert_eq!(
                        (error.over, frame.stats.lost),
                        (0, Some(0)),
                        "{complexity} {options:?}: {error:?}"
                    );
                    let deepest = frame.stats.a_buffer.unwrap().most_subpasses as usize;
                    let size = if pp_ao { array as usize } else { 8 };
                    let deepest_pixel = stack.pixels.iter().map(Vec::len).max().unwrap();
                    assert_eq!(
                        deepest,
                        deepest_pixel.div_ceil(size),
                        "{complexity} {pp_ao}"
                    );
                }
            }
        }
    }
}

#[test]
fn a_static_array_of_256_takes_256_fragments_and_no_more() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    let options = ABufferOptions {
        array: 256,
        color: RecordColor::Float,
        ..small(Manager::Dfb)
    };
    for (complexity, lost) in [(256, 0), (257, 1), (300, 44)] {
        let stack = one_deep(complexity);
        let frame = renderer
            .render(&stack.scene(), &Method::ABuffer(options))
            .unwrap();
        assert_eq!(frame.stats.lost, Some(lost));
        let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
        assert_eq!(error.over > 0, lost > 0, "{error:?}");
    }
}

/// llvmpipe ends a shader's loops after 65535 iterations; ppDP with an array of 8 would take 250 000.
#[test]
pub(crate) fn two_thousand_fragments_are_not_too_many() {
    let context = Context::headless().unwrap();
    let stack = one_deep(2000);
    let options = ABufferOptions {
        pp_dp: true,
        color: RecordColor::Float,
        ..small(Manager::Ppll)
    };
    let frame = Renderer::new(&context, 4, 1)
        .unwrap()
        .render(&stack.scene(), &Method::ABuffer(options))
        .unwrap();
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!((error.over, frame.stats.lost), (0, Some(0)), "{error:?}");
}

#[test]
fn soups_and_models_equal_the_exact_image() {
    let context = Context::headless().unwrap();
    let size = [160, 120];
    let mut scenes: Vec<Scene> = (0..3).map(soup_scene).collect();
    for file in ["teapot.toml", "molecule.toml", "slices.toml"] {
        let path = format!("{}/examples/scenes/{file}", env!("CARGO_MANIFEST_DIR"));
        scenes.push(Scene::load_at(path, Some(size)).unwrap());
    }
    let mut renderer = Renderer::new(&context, size[0], size[1]).unwrap();
    for scene in scenes {
        let exact = renderer.render(&scene, &Method::Exact).unwrap();
        for manager in MANAGERS {
            for fill in [Fill::Atomics, Fill::Automatic] {
                let options = ABufferOptions {
                    fill,
                    color: RecordColor::Float,
                    pp_dp: true,
                    ..small(manager)
                };
                let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
                let image = settled(&context, &frame, &exact);
                let error = Comparison::new(&image, &exact.image, F32).unwrap();
                assert_eq!(
                    (error.over, frame.stats.lost),
                    (0, Some(0)),
                    "{} {options:?}: {error:?}",
                    scene.name
                );
            }
        }
        let half = renderer
            .render(&scene, &Method::ABuffer(small(Manager::Ppll)))
            .unwrap();
        let image = settled(&context, &half, &exact);
        let error = Comparison::new(&image, &exact.image, F16).unwrap();
        assert_eq!(error.over, 0, "{}: {error:?}", scene.name);
    }
}

#[test]
fn shuffled_triangles_give_the_same_image_bit_for_bit() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let scene = soup_scene(3);
    let mut shuffled = scene.clone();
    shuffled.meshes[0] = shuffled.meshes[0].shuffled(9);
    for manager in MANAGERS {
        let method = Method::ABuffer(small(manager));
        let straight = renderer.render(&scene, &method).unwrap();
        assert!(straight.image == renderer.render(&shuffled, &method).unwrap().image);
    }
}

#[test]
pub(crate) fn the_counts_equal_the_occlusion_query_s_however_they_are_counted() {
    let context = Context::headless().unwrap();
    for (scene, size) in [
        (soup_scene(1), [160, 120]),
        (soup_scene(2), [1, 1]),
        (soup_scene(2), [7, 1]),
        (soup_scene(2), [129, 67]),
    ] {
        let mut renderer = Renderer::new(&context, size[0], size[1]).unwrap();
        let by = |by, renderer: &mut Renderer<'_>| renderer.complexity(&scene, by).unwrap();
        let blending = by(CountBy::Blending, &mut renderer);
        // Counted by GL's own query over passes that write no counter.
        let fragments = renderer
            .render(&scene, &Method::Blend)
            .unwrap()
            .stats
            .fragments;
        assert_eq!(blending.fragments(), fragments);
        assert!(by(CountBy::Atomics, &mut renderer) == blending);
        assert!(blending.max() < 255);
        assert!(by(CountBy::Stencil, &mut renderer) == blending);
    }
}

#[test]
fn the_stencil_counts_to_255_and_the_others_beyond() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    let scene = one_deep(300).scene();
    let mut counts = |by| renderer.complexity(&scene, by).unwrap().counts;
    assert_eq!(counts(CountBy::Blending), [2, 300, 2, 2]);
    assert_eq!(counts(CountBy::Atomics), [2, 300, 2, 2]);
    assert_eq!(counts(CountBy::Stencil), [2, 255, 2, 2]);
}

/// Fixed buffers are counted by the stencil buffer, where that is enough and there is one.
#[test]
fn without_a_stencil_buffer_nothing_is_counted_in_it() {
    let context = Context::headless().unwrap();
    let renderer = Renderer::new(&context, 4, 1).unwrap();
    let mut renderer = renderer.with_formats(Format::Rgba32F, Format::Depth32F);
    let stack = one_deep(9);
    let scene = stack.scene();
    let fixed = ABufferOptions {
        color: RecordColor::Float,
        ..small(Manager::Ffb)
    };
    let frame = renderer.render(&scene, &Method::ABuffer(fixed)).unwrap();
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!((error.over, frame.stats.lost), (0, Some(0)));
    let printed = ABufferOptions {
        pp_ao: true,
        reading: onionskin::options::Reading::AsPrinted,
        ..fixed
    };
    let refused = [
        renderer.complexity(&scene, CountBy::Stencil).err(),
        renderer.render(&scene, &Method::ABuffer(printed)).err(),
    ];
    for error in refused {
        let text = error.unwrap().to_string();
        assert!(text.contains("no stencil buffer"), "{text}");
    }
}

/// The trap that `doctor` describes: full-screen triangles over a framebuffer without depth lose atomics on llvmpipe.
#[test]
fn full_screen_layers_lose_no_fragment() {
    let context = Context::headless().unwrap();
    let mut scene = Scene::load(concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/examples/scenes/slices.toml"
    ))
    .unwrap();
    scene.size = [256, 192];
    scene.camera.fov = 10.0;
    let mut renderer = Renderer::new(&context, 256, 192).unwrap();
    for manager in MANAGERS {
        for fill in [Fill::Atomics, Fill::Automatic] {
            let options = ABufferOptions {
                fill,
                pp_dp: true,
                ..small(manager)
            };
            let stats = renderer
                .render(&scene, &Method::ABuffer(options))
                .unwrap()
                .stats;
            assert!(stats.fragments > 256 * 192 * 60, "{}", stats.fragments);
            assert_eq!(stats.lost, Some(0));
        }
    }
}

#[test]
fn options_out_of_range_are_refused_and_nothing_panics() {
    let good = small(Manager::Ppll);
    let bad = [
        ABufferOptions { array: 0, ..good },
        ABufferOptions { array: 12, ..good },
        ABufferOptions {
            array: 2048,
            ..good
        },
        ABufferOptions {
            array: 4,
            pp_ao: true,
            ..good
        },
        ABufferOptions { peel: 0, ..good },
        ABufferOptions { peel: 65, ..good },
        ABufferOptions {
            termination: -0.1,
            ..good
        },
        ABufferOptions {
            termination: f32::NAN,
            ..good
        },
        ABufferOptions {
            budget: Some(0),
            ..good
        },
    ];
    for options in bad {
        assert!(options.check().is_err(), "{options:?}");
    }
    good.check().unwrap();
}

#[test]
fn a_scene_without_anything_transparent_is_its_background() {
    let context = Context::headless().unwrap();
    let scene = row(&[0; 4]).scene();
    for manager in MANAGERS {
        let frame = Renderer::new(&context, 4, 1)
            .unwrap()
            .render(&scene, &Method::ABuffer(small(manager)))
            .unwrap();
        assert_eq!(frame.stats.lost, Some(0));
        let error = Comparison::new(&frame.image, &row(&[0; 4]).expected(), 0.0).unwrap();
        assert_eq!(error.over, 0);
    }
}

/// One pixel with so many fragments among pixels with two.
fn one_deep(complexity: usize) -> Stack {
    let mut stack = row(&[2; 4]);
    stack.pixels[1] = scattered(complexity, 1, 997);
    stack
}
