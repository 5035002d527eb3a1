//! The history of a pixel: what it says of fragments is what happens to them, on OpenGL and on the emulated pixel.

use std::cell::RefCell;

use onionskin::inspect::{self, Fate, History};
use onionskin::low_level::methods::{Technique, Volumes};
use onionskin::{Context, Method, Renderer, Scene, registry};
use proptest::test_runner::TestCaseError;

use crate::kit::driver::keeps_lists_in_order;
use crate::kit::render::example;
use crate::kit::stack::{LEVELS, Piece, Stack, expect_none, runner, stacks};

/// Every pixel of an image.
fn every_pixel([width, height]: [u32; 2]) -> Vec<[u32; 2]> {
    let rows = 0..height;
    rows.flat_map(|y| (0..width).map(move |x| [x, y])).collect()
}

/// Every reading of every method that can be inspected on this driver, and whether it is amended.
fn methods(context: &Context) -> impl Iterator<Item = (Method, bool)> {
    let rows = registry().iter();
    let runs = rows.filter(|row| row.runs_on(context.driver()));
    let in_order = keeps_lists_in_order(context);
    let methods = runs.map(|row| row.method);
    let methods = methods.filter(|method| *method != Method::Exact);
    methods.flat_map(move |method| {
        let readings = ["as-printed", "literal"].into_iter();
        // The emulated pixel's lists are in the order of submission.
        let is_followed = in_order || !matches!(method, Method::ABuffer(_));
        let readings = readings
            .filter(move |_| is_followed)
            .filter_map(move |reading| {
                let mut read = method;
                read.choose(reading, "").ok()?;
                // Listing 1 as printed does not know when to stop.
                if method.name() == "depth-peeling" {
                    read.choose("peels", "4").ok()?;
                }
                read.check().ok().map(|()| (read, false))
            });
        std::iter::once((method, true)).chain(readings)
    })
}

fn count(history: &History, is: fn(&Fate) -> bool) -> usize {
    let fates = history.fragments.iter().map(|it| &it.fate);
    fates.filter(|fate| is(fate)).count()
}

fn lost(history: &History) -> usize {
    count(history, |fate| matches!(fate, Fate::Lost | Fate::Tied(_)))
}

/// Says how a history contradicts itself, OpenGL, or the emulated pixel. What is not amended may composite anything over
/// anything.
fn fault(history: &History, method: &Method, is_amended: bool) -> Option<String> {
    if let Some((pass, difference)) = history.differences().next() {
        return Some(format!("pass {pass}: {difference}"));
    }
    let in_pieces = |step: &&String| step.contains("drawn in pieces");
    if let Some(step) = history.not_followed.iter().find(|step| !in_pieces(step)) {
        return Some(format!("not followed: {step}"));
    }
    // Exact methods composite one by one, unless a shader chooses among pieces.
    let is_exact = is_amended && method.entry().exact && history.not_followed.is_empty();
    if is_exact && history.composited.is_none() {
        return Some("what is in the image is not told".into());
    }
    let composited = history.composited.as_ref().filter(|_| is_amended)?;
    let stored = count(history, |fate| matches!(fate, Fate::Composited(_)));
    let belong = history.exact.layers.len();
    if stored + lost(history) != belong {
        return Some(format!(
            "of {belong}, {stored} are stored, {} lost",
            lost(history)
        ));
    }
    let off = composited.color.iter().zip(history.image);
    let off = off.map(|(a, b)| (a - f64::from(b)).abs());
    // The bound of 32-bit float methods: roundings of some 20 layers.
    let off = off.fold(0.0, f64::max);
    // With rays the two were compared above, with what the rounding of rays may do.
    if !history.ray.is_empty() {
        return None;
    }
    // Records of 16-bit floats are off by half a step of 2^-11 in colour and in alpha, which is at most a step together.
    let bound = match history.list {
        Some(_) => 1.0 / 2048.0,
        None => 1e-5,
    };
    (off > bound).then(|| format!("OpenGL's image is {off} from the composite that is told"))
}

#[test]
fn every_method_is_followed_on_random_stacks_and_what_it_loses_adds_up() {
    let context = Context::headless().unwrap();
    // One renderer for all: most of the time goes to the driver's compiling.
    let renderer = RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    let outcome = runner(3).run(&stacks(8, false), |stack| {
        let scene = stack.scene();
        let pixels = every_pixel(scene.size);
        let mut renderer = renderer.borrow_mut();
        for (method, is_amended) in methods(&context) {
            let histories = inspect::histories(&mut renderer, &scene, &method, &pixels).unwrap();
            for history in &histories {
                if let Some(fault) = fault(history, &method, is_amended) {
                    let pixel = history.pixel;
                    return Err(TestCaseError::fail(format!(
                        "{method} at {pixel:?}: {fault}"
                    )));
                }
            }
            let all: usize = histories.iter().map(lost).sum();
            let said = renderer.render(&scene, &method).unwrap().stats.lost;
            if is_amended && said.is_some_and(|said| said != all as u64) {
                let why = format!("{method} has lost {said:?}, its histories say {all}");
                return Err(TestCaseError::fail(why));
            }
        }
        Ok(())
    });
    expect_none(outcome);
}

/// Figure 2 of Carr et al. (2008): s0 < s4 < s3 < s5 < s6 < s10 < s9 < s7 < s2 < s1 < s8.
const FIGURE_2: [usize; 11] = [0, 4, 3, 5, 6, 10, 9, 7, 2, 1, 8];

pub(crate) fn figure_2() -> Scene {
    figure_2_among_others([0, 0])
}

/// Figure 2's pixel in this column and row from the top, to the right of and below pixels without a fragment.
pub(crate) fn figure_2_among_others([column, row]: [u32; 2]) -> Scene {
    let place = |s| FIGURE_2.iter().position(|&other| other == s).unwrap() as u16;
    let pieces = (0..11).map(|s| Piece {
        level: place(s) * (LEVELS / 11),
        color: [0.5; 4],
    });
    let width = column + 1;
    let mut pixels = vec![Vec::new(); (width * (row + 1)) as usize];
    pixels[(width * row + column) as usize] = pieces.collect();
    Stack {
        width,
        pixels,
        opaque: None,
    }
    .scene()
}

/// The values that figure 2 has after its passes 1 to 4. It begins when everything up to s4 has been peeled, which is the
/// second iteration.
#[test]
fn the_pixel_of_figure_2_has_the_paper_s_trace() {
    let context = Context::headless().unwrap();
    let scene = figure_2();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let mut method: Method = "coherent-layer-peeling-a".parse().unwrap();
    method.choose("sort", "submission").unwrap();
    let history = inspect::history(&mut renderer, &scene, &method, [0, 0]).unwrap();
    assert_eq!(fault(&history, &method, true), None);
    let in_pass = |number: usize| {
        let title = format!("Pass {number}:");
        let passes = history.passes.iter();
        let mut pass = passes.filter(|pass| pass.lines.last().unwrap().title.starts_with(&title));
        let held = &pass.nth(1).unwrap().held;
        (held.stencil.unwrap(), held.depth.unwrap())
    };
    // A piece is two triangles, of which one covers the pixel's centre.
    let depth = |s: usize| history.fragments[s].stored_depth;
    assert_eq!(in_pass(1), (3, depth(3)));
    assert_eq!(in_pass(2), (1, depth(2)));
    assert_eq!(in_pass(3), (251, depth(7)));
    assert_eq!(in_pass(4), (255, depth(10)));
    let order: Vec<_> = history
        .composited
        .unwrap()
        .layers
        .iter()
        .map(|it| it.fragment as usize)
        .collect();
    assert_eq!(order, FIGURE_2);
}

/// With 4 nodes for 11 fragments, what was merged is what lies behind the three nearest of those drawn so far.
#[test]
fn the_nodes_of_figure_2_s_pixel_say_what_was_merged() {
    let context = Context::headless().unwrap();
    let mut method: Method = "multi-layer-alpha-blending".parse().unwrap();
    if !method.entry().runs_on(context.driver()) {
        println!("skipped: the driver has neither framebuffer fetch nor an interlock");
        return;
    }
    method.choose("nodes", "4").unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let history = inspect::history(&mut renderer, &figure_2(), &method, [0, 0]).unwrap();
    let mut passes = history.passes.iter();
    let pass = passes
        .find(|pass| pass.program == "multi_layer/insert")
        .unwrap();
    let place = |s: &u32| {
        FIGURE_2
            .iter()
            .position(|&other| other == *s as usize)
            .unwrap()
    };
    for (drawn, event) in (1..).zip(&pass.events) {
        let mut nearest: Vec<u32> = (0..drawn).collect();
        nearest.sort_by_key(place);
        let apart = nearest.len().min(3);
        let mut nodes = event.nodes.clone();
        let mut merged = nodes.split_off(apart).concat();
        merged.sort_by_key(place);
        assert_eq!(nodes.concat(), nearest[..apart]);
        assert_eq!(merged, nearest[apart..]);
    }
    assert_eq!(pass.events.len(), 11);
}

/// The bundled scenes, in small, at pixels anywhere.
#[test]
fn a_thousand_pixels_of_bundled_scenes_are_the_same_on_both_machines_by_every_method() {
    const SCENES: [&str; 5] = ["quads", "sheets64", "slices", "soup", "teapot"];
    let context = Context::headless().unwrap();
    let seed = std::env::var("ONIONSKIN_SEED").map_or(17, |seed| seed.parse().unwrap());
    let mut chance = crate::kit::chance::Chance::new(seed);
    let mut inspected = 0;
    let scenes = SCENES.map(|name| example(name, [64, 48]));
    // One renderer for all, as above.
    let mut renderer = Renderer::new(&context, 64, 48).unwrap();
    for (method, is_amended) in methods(&context) {
        for scene in &scenes {
            let pixels: Vec<_> = (0..5)
                .map(|_| [chance.below(64) as u32, chance.below(48) as u32])
                .collect();
            let histories = inspect::histories(&mut renderer, scene, &method, &pixels).unwrap();
            for history in &histories {
                assert_eq!(
                    fault(history, &method, is_amended),
                    None,
                    "{} by {method} at {:?}",
                    scene.name,
                    history.pixel
                );
            }
            inspected += histories.len();
        }
    }
    println!("{inspected} pixels");
    if keeps_lists_in_order(&context) {
        assert!(inspected >= 1000, "{inspected}");
    }
}

/// Volumes by rays: every list, every reading, in window-space depth and in 1/w.
#[test]
fn rays_through_the_volumes_of_bundled_scenes_are_the_same_on_both_machines() {
    const SCENES: [&str; 3] = ["fog", "medical", "molecule_fused"];
    let context = Context::headless().unwrap();
    let seed = std::env::var("ONIONSKIN_SEED").map_or(18, |seed| seed.parse().unwrap());
    let mut chance = crate::kit::chance::Chance::new(seed);
    let (mut cast, mut surfaces) = (0, 0);
    let scenes = SCENES.map(|name| example(name, [64, 48]));
    let renderer = || Renderer::new(&context, 64, 48).unwrap();
    let [mut by_window_depth, mut by_inverse_w] = [renderer(), renderer().with_inverse_w()];
    for (method, is_amended) in
        methods(&context).filter(|(it, _)| it.entry().volumes == Volumes::Rays)
    {
        for (number, scene) in scenes.iter().enumerate() {
            let renderer = match number {
                0 => &mut by_inverse_w,
                _ => &mut by_window_depth,
            };
            let pixels: Vec<_> = (0..3)
                .map(|_| [10 + chance.below(44) as u32, 8 + chance.below(32) as u32])
                .collect();
            let histories = inspect::histories(renderer, scene, &method, &pixels).unwrap();
            for history in &histories {
                let at = history.pixel;
                assert_eq!(
                    fault(history, &method, is_amended),
                    None,
                    "{} by {method} at {at:?}",
                    scene.name
                );
                let resolves = history
                    .passes
                    .iter()
                    .filter_map(|pass| pass.resolve.as_ref());
                cast += resolves.filter(|it| it.ray.is_some()).count();
                surfaces += history.fragments.len();
            }
        }
    }
    println!("{cast} rays among {surfaces} surfaces");
    assert!(cast > 100 && surfaces > 100);
}

#[test]
fn distances_from_1_over_w_are_the_same_on_both_machines() {
    let context = Context::headless().unwrap();
    let scene = example("teapot", [64, 48]);
    let renderer = Renderer::new(&context, 64, 48).unwrap();
    let mut renderer = renderer.with_inverse_w();
    for equation in ["7", "8", "9"] {
        let mut method: Method = "weighted-blended".parse().unwrap();
        method.choose("weight", equation).unwrap();
        let pixels = every_pixel([8, 8]).into_iter();
        let pixels: Vec<_> = pixels.map(|[x, y]| [8 * x, 6 * y]).collect();
        let histories = inspect::histories(&mut renderer, &scene, &method, &pixels).unwrap();
        assert!(histories.iter().any(|it| it.fragments.len() > 1));
        for history in &histories {
            assert_eq!(
                fault(history, &method, true),
                None,
                "{method} at {:?}",
                history.pixel
            );
        }
    }
}
