//! Figures 4 and 5 of Lindholm et al. 2015 as they are drawn: their numbers are those of the frames that OpenGL renders.

use onionskin::low_level::emulator::run_on_lists;
use onionskin::low_level::papers::lindholm_2015::components::*;
use onionskin::options::{ABufferOptions, Fill, Manager};
use onionskin::report::{Plot, Strips, local_arrays, memory_layout};
use onionskin::{Context, Fragment, Method, Renderer, Scene};

use crate::kit::lists::captured;

fn scene(name: &str, size: [u32; 2]) -> Scene {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
    Scene::load_at(format!("{folder}/{name}.toml"), Some(size)).unwrap()
}

/// The lines of text of a drawing, joined.
fn text(strips: &Strips) -> String {
    let [Plot::Svg(svg), Plot::Png(_)] = strips.draw().unwrap() else {
        panic!("an SVG and a picture were promised");
    };
    svg
}

/// The numbers around the words, as in "30 of 64 used".
fn numbers(text: &str, between: &str, after: &str) -> Vec<[u64; 2]> {
    let last = |text: &str| {
        text.rsplit(|c: char| !c.is_ascii_digit())
            .next()?
            .parse()
            .ok()
    };
    let pieces: Vec<_> = text.split(between).collect();
    let pairs = pieces.windows(2).filter_map(|pair| {
        let (second, rest) = pair[1].split_at(pair[1].find(|c: char| !c.is_ascii_digit())?);
        rest.starts_with(after)
            .then_some([last(pair[0])?, second.parse().ok()?])
    });
    pairs.collect()
}

#[test]
fn figure_4_has_room_for_as_many_fragments_as_the_managers_allocate() {
    let context = Context::headless().unwrap();
    let has_fetch = context.driver().has("GL_EXT_shader_framebuffer_fetch");
    for (name, size) in [
        ("knots", [6, 5]),
        ("teapot", [16, 12]),
        ("molecule", [6, 4]),
    ] {
        let scene = scene(name, size);
        let mut fragments = captured(&context, &scene, u32::MAX).unwrap();
        fragments.sort_by_key(|fragment| (fragment.order, fragment.y, fragment.x));
        let pixels: Vec<u32> = fragments.iter().map(|f| f.y * size[0] + f.x).collect();
        let drawn = text(&memory_layout("figure 4", size[0] * size[1], &pixels));
        let room = |manager: &str| -> u64 {
            let (_, after) = drawn
                .split_once(&format!("({manager}): room for "))
                .unwrap();
            after.split(' ').next().unwrap().parse().unwrap()
        };
        let mut renderer = Renderer::new(&context, size[0], size[1]).unwrap();
        let mut bytes = |manager, fill| {
            let options = ABufferOptions {
                manager,
                fill,
                budget: Some(u64::MAX),
                ..ABufferOptions::default()
            };
            let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
            let counts = frame.stats.a_buffer.unwrap();
            assert_eq!(
                (counts.bands, frame.stats.fragments),
                (1, pixels.len() as u64)
            );
            (counts.list_bytes, options.record_bytes())
        };
        // The pool's counter takes 16 bytes.
        let (all, record) = bytes(Manager::Ppll, Fill::Atomics);
        assert_eq!(all, room("PPLL") * record + 16, "{name}");
        if !has_fetch {
            println!("skipped: the lists in order (no GL_EXT_shader_framebuffer_fetch)");
            continue;
        }
        let (all, record) = bytes(Manager::Ffb, Fill::Ordered);
        assert_eq!(all, room("FFB") * record, "{name}");
        // Both have the same base offsets. What a link takes is the only difference.
        let (linked, record_with_link) = bytes(Manager::Ppll, Fill::Ordered);
        let (dynamic, record) = bytes(Manager::Dfb, Fill::Ordered);
        let links = room("DFB") * (record_with_link - record);
        assert_eq!(linked - dynamic, links, "{name}");
        println!(
            "{name}: FFB {}, DFB {}, PPLL {} records",
            room("FFB"),
            room("DFB"),
            room("PPLL")
        );
    }
}

#[test]
fn figure_5_has_the_slots_that_two_pixels_reserve_and_use() {
    let context = Context::headless().unwrap();
    let scene = scene("molecule", [1, 2]);
    let mut fragments = captured(&context, &scene, u32::MAX).unwrap();
    fragments.sort_by_key(|fragment| fragment.order);
    let list = |y: u32| -> Vec<Fragment> {
        let of_pixel = fragments.iter().filter(|fragment| fragment.y == y);
        let fragment =
            |(order, fragment): (usize, &onionskin::low_level::gl::CapturedFragment)| Fragment {
                depth: fragment.depth,
                color: fragment.color,
                order: order as u32,
            };
        of_pixel.enumerate().map(fragment).collect()
    };
    let lists = [list(0), list(1)];
    assert!(
        lists.iter().all(|list| list.len() > 4),
        "both have some to sort"
    );
    let mut renderer = Renderer::new(&context, 1, 2).unwrap();
    let cases: [(_, _, &[_], u32, bool, bool); 3] = [
        ("static", &STATIC_ARRAY, &[], 64, false, false),
        ("ppAO", &PP_AO, &[PP_AO_AMENDMENT], 64, true, false),
        ("ppDP", &PP_DP, &PP_DP_AMENDMENTS, 4, false, true),
    ];
    for (name, algorithm, amendments, array, pp_ao, pp_dp) in cases {
        let run = run_on_lists(algorithm, amendments, &lists, array, 64).unwrap();
        let lengths = [0, 1].map(|n| lists[n].len() as u32);
        let figure = local_arrays(
            "figure 5",
            lengths,
            &[(name, [&run.pixels[0], &run.pixels[1]])],
        );
        let drawn = text(&figure);
        let slots = numbers(&drawn, " of ", " used");
        assert_eq!(slots.len(), 2, "{drawn}");
        let options = ABufferOptions {
            manager: Manager::Dfb,
            pp_ao,
            pp_dp,
            array: 64,
            peel: 4,
            ..ABufferOptions::default()
        };
        let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
        let counts = frame.stats.a_buffer.unwrap();
        let sum = |n: usize| slots.iter().map(|pair| pair[n]).sum::<u64>();
        println!("{name}: {slots:?}, {} subpasses", counts.subpasses);
        assert_eq!(
            (sum(1), sum(0)),
            (counts.slots_reserved, counts.slots_used),
            "{name}"
        );
    }
}
