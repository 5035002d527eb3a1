//! The history of a pixel notices shaders with a changed word: it names the pass, its line, and what differs.

use onionskin::{Context, Method, Renderer, inspect};

use crate::inspect::figure_2_among_others;
use crate::kit::render::example;

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
