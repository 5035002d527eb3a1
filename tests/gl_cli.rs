//! The command line at work: the files that it writes and what it says are what the library has.

mod cli_kit;

use std::collections::BTreeSet;

use cli_kit::{Answer, Desk};
use onionskin::fragment::Rgba;
use onionskin::methods::{Compositing, DepthPeelingOptions, Frame, registry};
use onionskin::{Context, Image, Method, Renderer, Scene};

/// Five sheets that cover the middle of the picture, shuffled, so that the order matters.
const SHEETS: &str = r#"
size = [40, 30]
background = [1.0, 1.0, 1.0]

[[mesh]]
generate = "quads"
count = 5
size = [1.0, 1.0]
spacing = 0.3
alpha = 0.5
order = "shuffled"
seed = 3
"#;

/// Two sheets of glass, the farther one first, before a wall.
const GLASS: &str = "mtllib glass.mtl
v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0
v 0 0 1\nv 1 0 1\nv 1 2 1\nv 0 2 1
v 0 0 2\nv 2 0 2\nv 2 1 2\nv 0 1 2
usemtl wall\nf 1 2 3 4\nusemtl red\nf 5 6 7 8\nusemtl green\nf 9 10 11 12
";

const MATERIALS: &str = "newmtl wall\nKd 0.5 0.5 0.5
newmtl red\nKd 0.9 0.1 0.1\nd 0.4
newmtl green\nKd 0.1 0.9 0.1\nd 0.6
";

/// The keys that a reader of the JSON may rely on.
const KEYS: [&str; 11] = [
    "scene",
    "method",
    "iterations",
    "geometry_passes",
    "fragments",
    "lost",
    "stopped",
    "bytes",
    "ms",
    "max_error",
    "rms_error",
];

/// f32 colours through at most a few roundings of 2^-24 for each of five layers: 1e-6.
const F32: f64 = 1e-6;

fn desk() -> Desk {
    Desk::new()
        .with("sheets.toml", SHEETS)
        .with("glass.obj", GLASS)
        .with("glass.mtl", MATERIALS)
}

/// What the library makes of a scene of the desk.
fn library(desk: &Desk, scene: &str, size: Option<[u32; 2]>, method: &Method) -> Frame {
    let scene = Scene::load_at(desk.path(scene), size).unwrap();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, scene.size[0], scene.size[1]).unwrap();
    renderer.render(&scene, method).unwrap()
}

fn peeling(options: DepthPeelingOptions) -> Method {
    Method::DepthPeeling(options)
}

/// The only object of an answer that has nothing else.
#[track_caller]
fn object(answer: &Answer) -> serde_json::Map<String, serde_json::Value> {
    let mut objects = answer.objects();
    assert_eq!(objects.len(), 1, "{answer}");
    objects.remove(0)
}

#[track_caller]
fn holds_the_image_in_8_bits(desk: &Desk, name: &str, image: &Image) {
    let file = Image::load(desk.path(name)).unwrap();
    assert_eq!([file.width, file.height], [image.width, image.height]);
    for (file, pixel) in file.pixels.iter().zip(&image.pixels) {
        for (file, value) in file.to_array().into_iter().zip(pixel.to_array()) {
            // Half a step of 8 bits, and f32's rounding of the division by 255.
            assert!((file - value).abs() <= 0.5 / 255.0 + 1e-6);
        }
    }
}

#[test]
fn render_writes_the_scenes_image_as_png() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-o", "s.png"]);
    let frame = library(&desk, "sheets.toml", None, &peeling(Default::default()));
    assert_eq!([frame.image.width, frame.image.height], [40, 30]);
    holds_the_image_in_8_bits(&desk, "s.png", &frame.image);
    let background = frame
        .image
        .pixels
        .iter()
        .filter(|&&p| p == frame.image.pixels[0]);
    assert!(
        background.count() < 1200,
        "there is something in the picture"
    );
}

#[test]
fn render_writes_the_scenes_image_as_exr_to_the_bit() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-o", "s.exr"]);
    let frame = library(&desk, "sheets.toml", None, &peeling(Default::default()));
    assert!(Image::load(desk.path("s.exr")).unwrap() == frame.image);
}

#[test]
fn render_writes_a_models_image_at_the_size_that_is_asked_for() {
    let desk = desk();
    desk.result(&["render", "glass.obj", "-o", "g.exr", "--size", "24x18"]);
    let method = peeling(Default::default());
    let frame = library(&desk, "glass.obj", Some([24, 18]), &method);
    assert_eq!([frame.image.width, frame.image.height], [24, 18]);
    assert!(frame.stats.fragments > 0, "{}", frame.stats);
    assert!(Image::load(desk.path("g.exr")).unwrap() == frame.image);
}

#[test]
fn a_model_is_rendered_at_1024_by_768_if_no_size_is_asked_for() {
    let desk = desk();
    desk.result(&["render", "glass.obj", "-m", "blend", "-o", "g.png"]);
    let image = Image::load(desk.path("g.png")).unwrap();
    assert_eq!([image.width, image.height], [1024, 768]);
}

#[test]
fn an_image_of_one_pixel_is_rendered() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-o", "s.exr", "--size", "1x1"]);
    let method = peeling(Default::default());
    let frame = library(&desk, "sheets.toml", Some([1, 1]), &method);
    assert!(Image::load(desk.path("s.exr")).unwrap() == frame.image);
}

#[test]
fn render_leaves_the_image_and_no_other_file() {
    let desk = desk();
    let before = desk.names();
    desk.result(&["render", "sheets.toml", "-o", "s.png"]);
    let after: Vec<_> = desk.names().into_iter().filter(|n| n != "s.png").collect();
    assert_eq!(after, before);
}

#[test]
fn render_replaces_an_image_that_was_there() {
    let desk = desk().with("s.exr", "yesterday's");
    desk.result(&["render", "sheets.toml", "-o", "s.exr"]);
    assert!(Image::load(desk.path("s.exr")).is_ok());
}

#[test]
fn every_method_is_rendered_by_its_name() {
    let desk = desk();
    for entry in registry() {
        desk.result(&["render", "sheets.toml", "-m", entry.name, "-o", "s.exr"]);
        let frame = library(&desk, "sheets.toml", None, &entry.method);
        let image = Image::load(desk.path("s.exr")).unwrap();
        assert!(image == frame.image, "{}", entry.name);
    }
}

#[test]
fn blending_in_the_wrong_order_is_another_image() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "blend", "-o", "s.exr"]);
    let exact = library(&desk, "sheets.toml", None, &Method::Exact);
    assert!(Image::load(desk.path("s.exr")).unwrap() != exact.image);
}

#[test]
fn render_prints_the_frames_statistics() {
    let desk = desk();
    let out = desk.result(&["render", "sheets.toml", "-o", "s.png"]);
    let frame = library(&desk, "sheets.toml", None, &peeling(Default::default()));
    let but_the_time = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !line.starts_with("time "));
        lines.map(str::to_owned).collect()
    };
    assert_eq!(but_the_time(&out), but_the_time(&frame.stats.to_string()));
    assert!(out.contains("\ntime "), "{out}");
}

#[test]
fn render_as_json_prints_one_object_with_the_frames_counts() {
    let desk = desk();
    let answer = desk.run(&["render", "sheets.toml", "-o", "s.png", "--json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let object = object(&answer);
    let stats = library(&desk, "sheets.toml", None, &peeling(Default::default())).stats;
    for key in KEYS {
        assert!(object.contains_key(key), "no {key}: {answer}");
    }
    assert_eq!(object["scene"], "sheets");
    assert_eq!(object["method"], "depth-peeling");
    assert_eq!(object["iterations"], stats.iterations);
    assert_eq!(object["geometry_passes"], stats.geometry_passes);
    assert_eq!(object["fragments"], stats.fragments);
    assert_eq!(object["lost"], 0);
    assert_eq!(object["stopped"], "empty layer");
    assert_eq!(object["bytes"], stats.bytes);
    assert!(object["ms"].as_f64().unwrap() > 0.0);
    assert!(object["max_error"].as_f64().unwrap() <= F32, "{answer}");
    assert!(object["rms_error"].as_f64() <= object["max_error"].as_f64());
    holds_the_image_in_8_bits(
        &desk,
        "s.png",
        &library(&desk, "sheets.toml", None, &Method::Exact).image,
    );
}

#[test]
fn peels_that_are_not_made_are_counted_and_said() {
    let desk = desk();
    let answer = desk.run(&["render", "sheets.toml", "-o", "s.exr", "--peels", "2"]);
    let options = DepthPeelingOptions {
        maximum_number_of_peels: 2,
        ..Default::default()
    };
    let frame = library(&desk, "sheets.toml", None, &peeling(options));
    assert!(Image::load(desk.path("s.exr")).unwrap() == frame.image);
    let (lost, fragments) = (frame.stats.lost.unwrap(), frame.stats.fragments);
    assert!(lost > 0 && answer.code == 0, "{answer}");
    answer.says(&[
        &format!("note: {lost} of {fragments} fragments are not in the image"),
        "peel limit",
    ]);
    assert_eq!(answer.err.lines().count(), 1, "{answer}");
}

#[test]
fn an_occlusion_ratio_of_1_ends_after_one_peel() {
    let desk = desk();
    let render = ["render", "sheets.toml", "-o", "s.exr", "--json"];
    let answer = desk.run(&[&render[..], &["--occlusion-ratio", "1"]].concat());
    let object = object(&answer);
    assert_eq!(object["stopped"], "occlusion ratio");
    assert_eq!(object["iterations"], 1);
    let options = DepthPeelingOptions {
        occlusion_ratio: 1.0,
        ..Default::default()
    };
    let frame = library(&desk, "sheets.toml", None, &peeling(options));
    assert!(Image::load(desk.path("s.exr")).unwrap() == frame.image);
}

#[test]
fn every_layer_is_written_beside_the_image() {
    let desk = desk();
    let before: BTreeSet<_> = desk.names().into_iter().collect();
    desk.result(&["render", "sheets.toml", "-o", "s.exr", "--layers"]);
    let options = DepthPeelingOptions {
        compositing: Compositing::KeepLayers,
        ..Default::default()
    };
    let frame = library(&desk, "sheets.toml", None, &peeling(options));
    assert_eq!(frame.layers.len(), 5, "as many as there are sheets");
    let mut expected = before;
    expected.insert("s.exr".into());
    for (number, layer) in frame.layers.iter().enumerate() {
        let name = format!("s-layer-{number}.exr");
        assert!(
            Image::load(desk.path(&name)).unwrap() == layer.color,
            "{name}"
        );
        expected.insert(name);
    }
    assert_eq!(desk.names().into_iter().collect::<BTreeSet<_>>(), expected);
}

#[test]
fn listing_1_runs_as_printed_and_writes_no_layer_that_was_not_asked_for() {
    let desk = desk();
    let before = desk.names().len();
    let render = ["render", "sheets.toml", "-o", "s.exr", "--as-printed"];
    desk.result(&[&render[..], &["--peels", "5"]].concat());
    let options = DepthPeelingOptions {
        maximum_number_of_peels: 5,
        as_printed: true,
        ..Default::default()
    };
    let frame = library(&desk, "sheets.toml", None, &peeling(options));
    assert!(Image::load(desk.path("s.exr")).unwrap() == frame.image);
    assert_eq!(desk.names().len(), before + 1);
}

#[test]
fn listing_1_as_printed_writes_the_layers_that_were_asked_for() {
    let desk = desk();
    let render = ["render", "sheets.toml", "-o", "s.png", "--as-printed"];
    desk.result(&[&render[..], &["--peels", "3", "--layers"]].concat());
    let layers = desk.names().into_iter().filter(|n| n.contains("-layer-"));
    assert_eq!(layers.count(), 3);
}

/// A wall of 0.5 before a background of 0.25, without shading.
const WALL: &str = "size = [8, 8]\nbackground = [0.25, 0.25, 0.25]\n[camera]\neye = [0.5, 0.5, 5]\nfov = 30\n\
    target = [0.5, 0.5, 0]\n[[mesh]]\nfile = \"wall.obj\"\ncolor = [0.5, 0.5, 0.5]\nopacity = 1\nshading = \"none\"\n";

/// The red values of a rendering of the wall.
fn wall(name: &str, flags: &[&str]) -> BTreeSet<String> {
    let desk = Desk::new()
        .with("wall.toml", WALL)
        .with("wall.obj", cli_kit::SQUARE);
    desk.result(&[&["render", "wall.toml", "-o", name], flags].concat());
    let image = Image::load(desk.path(name)).unwrap();
    let value = |pixel: &Rgba| format!("{:.2}", pixel.r * 255.0);
    image.pixels.iter().map(value).collect()
}

#[test]
fn a_png_holds_linear_values() {
    // 0.25 and 0.5 times 255, rounded to nearest, halves up.
    assert_eq!(
        wall("wall.png", &[]),
        ["64.00", "128.00"].map(String::from).into()
    );
}

#[test]
fn a_png_is_encoded_for_display_if_that_is_asked_for() {
    // 1.055 x^(1 / 2.4) - 0.055 is 0.5371 and 0.7354; times 255 that is 136.96 and 187.52.
    let expected = ["137.00", "188.00"].map(String::from).into();
    assert_eq!(wall("wall.png", &["--srgb"]), expected);
}

#[test]
fn an_exr_is_never_encoded() {
    let expected = ["63.75", "127.50"].map(String::from).into();
    assert_eq!(wall("wall.exr", &["--srgb"]), expected);
}

#[test]
fn colours_stored_in_8_bits_are_rounded_there() {
    let expected = ["64.00", "128.00"].map(String::from).into();
    assert_eq!(wall("wall.exr", &["--color", "rgba8"]), expected);
}

#[test]
fn compare_shows_every_method_in_the_registrys_order() {
    let desk = desk();
    let out = desk.result(&["compare", "sheets.toml"]);
    let rows: Vec<Vec<_>> = out
        .lines()
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(rows[0][0], "method");
    for (row, entry) in rows[1..].iter().zip(registry()) {
        assert_eq!(row[0], entry.name);
        // Iterations, passes, lost, memory, time, two errors; 'not counted' is two words.
        assert!(row.len() == 8 || out.contains("not counted"), "{out}");
    }
    let fragments = library(&desk, "sheets.toml", None, &Method::Exact)
        .stats
        .fragments;
    let after = out.lines().nth(registry().len() + 1).unwrap();
    assert_eq!(after, format!("{fragments} fragments in 40 x 30 pixels"));
    // And then what lists have cost those that have them.
    let with_lists: Vec<_> = registry()
        .iter()
        .filter(|entry| matches!(entry.method, Method::ABuffer(_)))
        .map(|entry| entry.name)
        .collect();
    let second = &rows[registry().len() + 2..];
    assert!(second[0].is_empty() && second[1][..2] == ["fragment", "lists"]);
    let names: Vec<_> = second[2..].iter().map(|row| row[0]).collect();
    assert_eq!(names, with_lists, "{out}");
    assert!(out.lines().all(|line| line.len() <= 100), "{out}");
}

#[test]
fn compare_as_json_prints_one_object_for_each_method() {
    let desk = desk();
    let answer = desk.run(&["compare", "sheets.toml", "--json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let objects = answer.objects();
    assert_eq!(objects.len(), registry().len(), "{answer}");
    for (object, entry) in objects.iter().zip(registry()) {
        for key in KEYS {
            assert!(object.contains_key(key), "no {key}: {answer}");
        }
        assert_eq!(object["method"], entry.name);
        let error = object["max_error"].as_f64().unwrap();
        // Fragment lists keep colours in 16 bits: the bound of `gl_a_buffer.rs`.
        let bound = match entry.method {
            Method::ABuffer(_) => 1.5e-3,
            _ => F32,
        };
        assert!(!entry.exact || error <= bound, "{answer}");
    }
    let by_name = |name| objects.iter().find(|object| object["method"] == name);
    let blend = &by_name("blend").unwrap()["max_error"];
    assert!(
        blend.as_f64().unwrap() > 0.1,
        "the sheets are shuffled: {answer}"
    );
    assert_eq!(by_name("exact").unwrap()["max_error"], 0.0);
}

#[test]
fn compare_takes_methods_by_name_in_the_order_that_is_asked_for() {
    let answer = desk().run(&["compare", "sheets.toml", "--json", "-m", "painter, blend"]);
    let objects = answer.objects();
    let names: Vec<_> = objects.iter().map(|object| &object["method"]).collect();
    assert_eq!(names, ["painter", "blend"]);
}

#[test]
fn fragments_that_a_tie_has_cost_are_a_note_of_compare() {
    let scene = SHEETS.replace("spacing = 0.3", "spacing = 0.0");
    let desk = desk().with("ties.toml", scene);
    let answer = desk.run(&["compare", "ties.toml", "-m", "depth-peeling", "--json"]);
    let object = object(&answer);
    // Of five sheets in one place one is kept.
    let (lost, fragments) = (object["lost"].as_u64(), object["fragments"].as_u64());
    assert_eq!(lost.unwrap() * 5, fragments.unwrap() * 4);
    answer.says(&["note: ", "fragments are not in the image of depth-peeling"]);
}

/// A desk with `mine.png`: the exact image of the sheets as `render` writes it, changed.
fn desk_with_image(change: impl FnOnce(&mut Image)) -> Desk {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "exact", "-o", "mine.png"]);
    let mut image = Image::load(desk.path("mine.png")).unwrap();
    change(&mut image);
    image.save(desk.path("mine.png")).unwrap();
    desk
}

const CHECK: [&str; 3] = ["check", "sheets.toml", "mine.png"];

#[test]
fn check_passes_the_exact_image_in_8_bits() {
    let desk = desk_with_image(|_| {});
    let out = desk.result(&CHECK);
    assert!(out.contains("exact within the bound"), "{out}");
    assert!(out.contains("0 of 1200"), "{out}");
}

#[test]
fn check_passes_the_exact_image_in_32_bits_with_no_bound_at_all() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "exact", "-o", "mine.exr"]);
    desk.result(&["check", "sheets.toml", "mine.exr", "--bound", "0"]);
}

#[test]
fn check_finds_one_changed_pixel_and_shows_it_in_the_third_panel() {
    let desk = desk_with_image(|image| image.pixels[7 * 40 + 5].g -= 0.5);
    let answer = desk.run(&CHECK);
    assert_eq!((answer.code, answer.err.as_str()), (1, ""), "{answer}");
    assert!(answer.out.contains("differs"), "{answer}");
    assert!(answer.out.contains("1 of 1200"), "{answer}");
    assert!(answer.out.contains("5, 7 (from the top left)"), "{answer}");
    let picture = Image::load(desk.path("difference.png")).unwrap();
    // Three panels with two gaps of four pixels.
    assert_eq!([picture.width, picture.height], [3 * 40 + 2 * 4, 30]);
    // A difference of 0.5, and up to half a step of rounding, times 8 is more than 1.
    assert_eq!(picture.pixel(2 * 44 + 5, 7).g, 1.0);
    // Half a step times 8 is under four steps.
    assert!(picture.pixel(2 * 44 + 6, 7).g <= 4.0 / 255.0);
}

#[test]
fn check_as_json_prints_one_object_with_its_verdict() {
    let desk = desk_with_image(|image| image.pixels[7 * 40 + 5].g -= 0.5);
    let answer = desk.run(&[&CHECK[..], &["--json"]].concat());
    assert_eq!(answer.code, 1, "{answer}");
    let object = object(&answer);
    assert_eq!(object["scene"], "sheets");
    assert_eq!(object["image"], "mine.png");
    assert_eq!(object["passed"], false);
    assert_eq!(object["pixels_over"], 1);
    assert_eq!(object["pixels"], 1200);
    assert_eq!(object["worst_pixel"], serde_json::json!([5, 7]));
    // Rounded to 8 bits twice: a step in all.
    let error = object["max_error"].as_f64().unwrap();
    assert!((error - 0.5).abs() <= 1.0 / 255.0, "{answer}");
}

#[test]
fn check_takes_one_step_of_8_bits_for_rounding_and_two_for_a_difference() {
    let step = |steps: f32| {
        // The exact image is 1 in all the background, so the difference is the change alone.
        let desk = desk_with_image(|image| image.pixels[0].r -= steps / 255.0);
        desk.run(&CHECK).code
    };
    assert_eq!([step(1.0), step(2.0)], [0, 1]);
}

#[test]
fn check_holds_an_image_to_a_tighter_bound() {
    let desk = desk_with_image(|image| image.pixels[0].r -= 1.0 / 255.0);
    let answer = desk.run(&[&CHECK[..], &["--bound", "0.003"]].concat());
    assert_eq!(answer.code, 1, "{answer}");
    assert!(answer.out.contains("0, 0 (from the top left)"), "{answer}");
}

#[test]
fn check_writes_the_difference_picture_where_it_is_asked_to() {
    let desk = desk_with_image(|_| {});
    desk.result(&[&CHECK[..], &["-o", "d.exr"]].concat());
    assert_eq!(Image::load(desk.path("d.exr")).unwrap().width, 128);
    assert!(!desk.names().contains(&"difference.png".to_owned()));
}

#[test]
fn check_finds_blending_in_the_wrong_order() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-m", "blend", "-o", "mine.png"]);
    assert_eq!(desk.run(&CHECK).code, 1);
}

#[test]
fn check_takes_the_advice_that_it_gave_about_the_size() {
    let desk = desk();
    let render = ["render", "sheets.toml", "-m", "exact", "-o", "mine.png"];
    desk.result(&[&render[..], &["--size", "20x15"]].concat());
    let refused = desk.refused(&CHECK);
    let advice = refused.err.split("add ").nth(1).unwrap().trim_end();
    let advice: Vec<_> = advice.split(' ').collect();
    desk.result(&[&CHECK[..], &advice].concat());
}

#[test]
fn work_of_some_seconds_draws_no_progress_where_there_is_no_terminal() {
    let scene = SHEETS
        .replace("count = 5", "count = 48")
        .replace("[40, 30]", "[1024, 768]");
    let desk = desk().with("long.toml", scene);
    // `result` holds that standard error is empty.
    let out = desk.result(&["compare", "long.toml", "-m", "depth-peeling"]);
    assert!(!out.contains(['\r', '\u{1b}']), "{out}");
}

#[test]
fn the_doctor_reports_the_driver_that_renders() {
    let answer = desk().run(&["doctor"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let context = Context::headless().unwrap();
    let driver = context.driver();
    for part in [&driver.renderer, &driver.version_text] {
        assert!(answer.out.contains(part), "{answer}");
    }
    for (name, value) in &driver.limits {
        let line = answer.out.lines().find(|line| line.contains(name)).unwrap();
        assert!(line.ends_with(&format!(" {value}")), "{line}");
    }
}

#[test]
fn the_doctor_as_json_prints_one_object_for_each_backend() {
    let answer = desk().run(&["doctor", "--json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let objects = answer.objects();
    let names: Vec<_> = objects.iter().map(|object| &object["backend"]).collect();
    assert_eq!(names, ["egl", "osmesa"]);
    let context = Context::headless().unwrap();
    let backend = context.backend().unwrap().to_string();
    let used = objects.iter().find(|object| object["backend"] == *backend);
    let (used, driver) = (used.unwrap(), context.driver());
    assert_eq!(used["works"], true);
    assert_eq!(used["version"], driver.version_text);
    assert_eq!(
        used["limits"]["GL_MAX_TEXTURE_SIZE"],
        driver.largest_image()
    );
    assert_eq!(
        used["extensions"]["GL_KHR_debug"],
        driver.has("GL_KHR_debug")
    );
}

#[test]
fn the_backend_of_the_argument_comes_before_that_of_the_environment() {
    let context = Context::headless().unwrap();
    let backend = context.backend().unwrap().to_string();
    // A backend that is not there would end the program before it could look at the argument.
    let desk = desk().with_variable("ONIONSKIN_BACKEND", "none");
    let render = ["render", "sheets.toml", "-o", "s.png"];
    desk.refused(&render);
    desk.result(&[&render[..], &["--backend", &backend]].concat());
}
