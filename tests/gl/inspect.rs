//! The history of a pixel: what it says of fragments is what happens to them, on OpenGL and on the emulated pixel.

use std::cell::RefCell;

use onionskin::inspect::{self, Fate, History, Loss, Where};
use onionskin::low_level::edition::history_json;
use onionskin::low_level::methods::{Technique, Volumes};
use onionskin::low_level::steps::Reason;
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

fn figure_2() -> Scene {
    figure_2_among_others([0, 0])
}

/// Figure 2's pixel in this column and row from the top, to the right of and below pixels without a fragment.
fn figure_2_among_others([column, row]: [u32; 2]) -> Scene {
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

#[test]
fn a_shader_with_a_changed_word_is_found_with_its_pass_and_its_line() {
    const CHANGES: [(&str, &str, [&str; 2], &str); 3] = [
        (
            "depth-peeling",
            "peel",
            ["passes == 0.0", "passes == 1.0"],
            "drawTransparentObjects()",
        ),
        // What is near to the bound is left out.
        (
            "layer-peeling",
            "clip/open_open",
            ["() < z", "() + 0.15 < z"],
            "drawTransparentObjects()",
        ),
        (
            "dual-depth-peeling",
            "dual/peel",
            ["&& !at_nearest", ""],
            "drawTransparentObjects()",
        ),
    ];
    let context = Context::headless().unwrap();
    // Figure 2's pixel among others, in which the change makes no difference: they have one fragment.
    let [column, row] = [5, 3];
    let mut scene = figure_2_among_others([column, row]);
    scene.background = [1.0; 3];
    for (method, shader, [word, changed], drawn) in CHANGES {
        let file = format!("{shader}.frag");
        let text = onionskin::low_level::gl::shader_file(&file).unwrap();
        assert!(text.contains(word), "{file} has no '{word}': {text}");
        let [width, height] = scene.size;
        let renderer = Renderer::new(&context, width, height).unwrap();
        let text = text.replace(word, changed);
        let mut renderer = renderer.with_shader_file(&file, &text).unwrap();
        let method: Method = method.parse().unwrap();
        let pixel = inspect::worst(&mut renderer, &scene, &method)
            .unwrap()
            .unwrap();
        let history = inspect::history(&mut renderer, &scene, &method, pixel).unwrap();
        let (pass, _) = history.differences().next().unwrap();
        let pass = &history.passes[pass];
        let line = pass.lines.last().unwrap();
        println!(
            "{method} at {pixel:?}: {} of '{}', {}: {}",
            pass.program, line.title, line.source, line.text
        );
        assert_eq!(pixel, [column, row], "{method}");
        assert_eq!(pass.program, shader);
        assert_eq!(line.text.trim().trim_end_matches(';'), drawn);
    }
}

/// Layers enough that what a method adds up in 32 bits would drown a sixteenth of what is left.
#[test]
fn a_pixel_of_two_hundred_layers_is_told_to_the_last() {
    const LAYERS: u16 = 200;
    let pieces = (0..LAYERS).map(|number| Piece {
        // In no order, and none twice: 7 and 200 have no factor in common.
        level: number * 7 % LAYERS * (LEVELS / LAYERS),
        color: [0.5, 0.25, 0.75, 0.01],
    });
    let stack = Stack {
        width: 1,
        pixels: vec![pieces.collect()],
        opaque: None,
    };
    let scene = stack.scene();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    for name in [
        "depth-peeling",
        "dual-depth-peeling",
        "coherent-layer-peeling-b",
        "dfb+ppao+ppdp",
    ] {
        let method: Method = name.parse().unwrap();
        let history = inspect::history(&mut renderer, &scene, &method, [0, 0]).unwrap();
        let composited = history.composited.as_ref().expect(name);
        assert_eq!(composited.layers.len(), usize::from(LAYERS), "{name}");
        assert_eq!(history.parts_at, None, "{name}");
    }
}

/// All pixels are off by what 16-bit colours leave out. One has lost a fragment, too, of which hardly anything is to be seen.
#[test]
fn a_pixel_that_has_lost_something_is_found_among_many_that_are_only_rounded() {
    let piece = |level| Piece {
        level,
        color: [0.3, 0.6, 0.1, 0.7],
    };
    let layers = |count: u16| {
        (0..count)
            .map(|number| piece(number * 20))
            .collect::<Vec<_>>()
    };
    let mut pixels = vec![layers(8); 200];
    pixels[77] = layers(9);
    let stack = Stack {
        width: 20,
        pixels,
        opaque: None,
    };
    let scene = stack.scene();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 20, 10).unwrap();
    let mut method: Method = "ffb".parse().unwrap();
    method.choose("array", "8").unwrap();
    let found = inspect::find(&mut renderer, &scene, &method, Where::Lost).unwrap();
    let pixel = found.expect("one has lost its ninth fragment");
    assert_eq!(pixel, [77 % 20, 77 / 20]);
    let history = inspect::history(&mut renderer, &scene, &method, pixel).unwrap();
    let losses: Vec<_> = history.fragments.iter().filter_map(|it| it.loss).collect();
    assert_eq!(losses, [Loss::Dropped]);
    method.choose("array", "16").unwrap();
    let found = inspect::find(&mut renderer, &scene, &method, Where::Lost).unwrap();
    assert_eq!(found, None);
}

#[test]
fn what_is_lost_says_why() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let losses = |method: &Method, renderer: &mut Renderer<'_>| -> Vec<Loss> {
        let history = inspect::history(renderer, &figure_2(), method, [0, 0]).unwrap();
        history.fragments.iter().filter_map(|it| it.loss).collect()
    };
    for (name, option, value, count, loss) in [
        (
            "depth-peeling",
            "peels",
            "3",
            8,
            Loss::Ended(Reason::PeelLimit),
        ),
        ("ffb", "array", "8", 3, Loss::Dropped),
        ("ffb", "fixed-layers", "4", 7, Loss::NoRoom),
    ] {
        let mut method: Method = name.parse().unwrap();
        method.choose(option, value).unwrap();
        assert_eq!(
            losses(&method, &mut renderer),
            vec![loss; count],
            "{name} {option}"
        );
    }
    let exact: Method = "dfb+ppdp".parse().unwrap();
    assert!(losses(&exact, &mut renderer).is_empty());
}

/// Stored as 1/w, a depth is told as the distance from the eye.
#[test]
fn depths_by_1_over_w_are_told_as_distances() {
    let context = Context::headless().unwrap();
    let scene = example("teapot", [64, 48]);
    let renderer = Renderer::new(&context, 64, 48).unwrap();
    let mut renderer = renderer.with_inverse_w();
    let method: Method = "depth-peeling".parse().unwrap();
    let history = inspect::history(&mut renderer, &scene, &method, [32, 24]).unwrap();
    assert!(history.by_distance && history.fragments.len() > 2);
    let camera = &scene.camera;
    let forward = (camera.target - camera.eye).normalize();
    for fragment in &history.fragments {
        let mesh = scene
            .meshes
            .iter()
            .find(|it| it.name == fragment.mesh)
            .unwrap();
        let corners = mesh.corners(fragment.triangle as usize);
        let distances = corners.map(|it| (it.position - camera.eye).dot(forward));
        let [low, high] = [f64::min, f64::max].map(|of| distances.into_iter().reduce(of).unwrap());
        assert!(
            (low..=high).contains(&fragment.depth),
            "{} of {low} to {high}",
            fragment.depth
        );
        // Some roundings of 2^-24.
        let off = f64::from(fragment.stored_depth) / fragment.depth - 1.0;
        assert!(off.abs() < 1e-6, "{off}");
    }
    let peels = history.passes.iter().flat_map(|pass| &pass.events);
    let stored = peels.filter(|event| event.depth[0] != event.depth[1]);
    for event in stored {
        let [before, after] = event.depth;
        assert_eq!(
            after,
            history.fragments[event.fragment as usize].stored_depth
        );
        assert!(after < before);
    }
    // The first peel begins with depths infinitely far away.
    assert_eq!(history.passes[0].held.depth, Some(f32::INFINITY));
}

#[test]
fn what_cannot_be_followed_is_not_said_to_agree() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    let followed: Method = "depth-peeling".parse().unwrap();
    let mut not_followed = followed;
    not_followed.choose("depth-unit-0", "classic").unwrap();
    for (method, agree) in [
        (followed, serde_json::json!(true)),
        (not_followed, serde_json::json!(null)),
    ] {
        let history = inspect::history(&mut renderer, &figure_2(), &method, [0, 0]).unwrap();
        assert_eq!(history_json::object(&history)["agree"], agree);
    }
}

/// The scan has three levels for so many pixels.
#[test]
fn a_scan_with_a_changed_word_is_noticed() {
    const CHANGES: [[&str; 3]; 4] = [
        ["gather", "here.y * size.x + here.x", "here.y * size.x"],
        ["reduce", "sum += lower[i]", "sum = lower[i]"],
        ["spread", "before += here", "before = here"],
        ["spread", "? 0u : upper", "? 1u : upper"],
    ];
    let context = Context::headless().unwrap();
    let scene = example("teapot", [80, 60]);
    let method: Method = "dfb".parse().unwrap();
    let faults = |renderer: &mut Renderer<'_>| {
        let history = inspect::history(renderer, &scene, &method, [41, 29]).unwrap();
        let differences = history.differences();
        differences
            .map(|(_, difference)| difference.to_owned())
            .collect::<Vec<_>>()
    };
    let renderer = || Renderer::new(&context, 80, 60).unwrap();
    assert!(faults(&mut renderer()).is_empty());
    for [step, word, changed] in CHANGES {
        let file = format!("a_buffer/scan_{step}.comp");
        let text = onionskin::low_level::gl::shader_file(&file).unwrap();
        assert!(text.contains(word), "{file} has no '{word}'");
        let text = text.replace(word, changed);
        let mut renderer = renderer().with_shader_file(&file, &text).unwrap();
        let faults = faults(&mut renderer);
        println!("{file}: {faults:?}");
        assert!(
            faults.iter().any(|it| it.starts_with("base offset: ")),
            "{file}: {faults:?}"
        );
    }
}

#[test]
fn a_ray_with_a_changed_word_is_noticed() {
    const FILE: &str = "a_buffer/volume_ray.glsl";
    const CHANGES: [[&str; 2]; 3] = [
        ["occupancy ^= 1u <<", "occupancy |= 1u <<"],
        ["occupancy = left_again & ~entered;", "occupancy = 0u;"],
        ["composited += 1u;", ""],
    ];
    let context = Context::headless().unwrap();
    let text = onionskin::low_level::gl::shader_file(FILE).unwrap();
    let method: Method = "dfb+ppdp".parse().unwrap();
    // The eye is in the volume.
    let scene = crate::kit::fog_scenes::fog_and_pane(0.75, -0.4, 0.4, 0.3);
    let [width, height] = scene.size;
    for [word, changed] in CHANGES {
        assert!(text.contains(word), "{FILE} has no '{word}'");
        let renderer = Renderer::new(&context, width, height).unwrap();
        let text = text.replace(word, changed);
        let mut renderer = renderer.with_shader_file(FILE, &text).unwrap();
        let middle = [width / 2, height / 2];
        let history = inspect::history(&mut renderer, &scene, &method, middle).unwrap();
        let (pass, said) = history.differences().next().expect(word);
        println!("{}: {said}", history.passes[pass].program);
        assert!(history.passes[pass].program.starts_with("a_buffer/resolve"));
    }
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
