//! `onionskin render`: the files that it writes and what it says are what the library has.

use crate::kit;
use std::collections::BTreeSet;

use crate::kit::cli::Desk;
use crate::kit::sheets::{F32, KEYS, desk, holds_the_image_in_8_bits, library, object, peeling};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Image, Method, Rgba, registry};

#[test]
fn render_writes_the_scenes_image_as_png() {
    let desk = desk();
    desk.result(&["render", "sheets.toml", "-o", "s.png"]);
    let frame = library(&desk, "sheets.toml", None, &Method::VerifiedPainter);
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
    let frame = library(&desk, "sheets.toml", None, &Method::VerifiedPainter);
    assert!(Image::load(desk.path("s.exr")).unwrap() == frame.image);
}

#[test]
fn render_writes_a_models_image_at_the_size_that_is_asked_for() {
    let desk = desk();
    desk.result(&["render", "glass.obj", "-o", "g.exr", "--size", "24x18"]);
    let frame = library(&desk, "glass.obj", Some([24, 18]), &Method::VerifiedPainter);
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
    let frame = library(&desk, "sheets.toml", Some([1, 1]), &Method::VerifiedPainter);
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
    let frame = library(&desk, "sheets.toml", None, &Method::Automatic);
    let but_the_time = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !line.starts_with("time "));
        lines.map(str::to_owned).collect()
    };
    assert_eq!(but_the_time(&out), but_the_time(&frame.stats.to_string()));
    assert!(out.contains("\ntime "), "{out}");
}

#[test]
fn render_says_on_request_where_the_time_goes() {
    let desk = desk();
    let out = desk.result(&["render", "sheets.toml", "-o", "s.png", "--times"]);
    let (_, stages) = out.split_once("\n\n").expect("two parts");
    let names = stages.lines().map(|line| line[..24].trim_end());
    let expected = [
        "reading, OpenGL context",
        "sorting, upload, maps",
        "compiling shaders",
        "drawing",
        "counting, reading back",
        "writing the picture",
        "together",
    ];
    assert!(names.eq(expected), "{out}");
    let ms = |line: &str| -> f64 {
        let number = line[24..].trim().strip_suffix(" ms").expect("a time");
        number.parse().expect("a number")
    };
    let parts: Vec<f64> = stages.lines().map(ms).collect();
    let (together, parts) = parts.split_last().expect("lines");
    // Each has one decimal.
    assert!(
        (parts.iter().sum::<f64>() - together).abs() <= 0.05 * 7.0,
        "{out}"
    );
    desk.refused(&["render", "sheets.toml", "-o", "s.png", "--times", "--json"])
        .says(&["--json"]);
}

#[test]
fn render_as_json_prints_one_object_with_the_frames_counts() {
    let desk = desk();
    let answer = desk.run(&["render", "sheets.toml", "-o", "s.png", "--json"]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let object = object(&answer);
    let stats = library(&desk, "sheets.toml", None, &Method::Automatic).stats;
    for key in KEYS {
        assert!(object.contains_key(key), "no {key}: {answer}");
    }
    assert_eq!(object["scene"], "sheets");
    // A quick exact one.
    assert_eq!(object["method"], "auto");
    assert_eq!(object["chosen"], "verified-painter");
    assert_eq!(object["marked_pixels"], 0);
    assert_eq!(object["iterations"], stats.iterations);
    assert_eq!(object["geometry_passes"], stats.geometry_passes);
    assert_eq!(object["fragments"], stats.fragments);
    assert_eq!(object["lost"], 0);
    assert_eq!(object["stopped"], "done");
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
        reading: onionskin::options::Reading::AsPrinted,
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
        .with("wall.obj", kit::cli::SQUARE);
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
    // Half of 255 lies between two steps, and OpenGL takes either.
    let expected = |half: &str| ["64.00", half].map(String::from).into();
    let found = wall("wall.exr", &["--color", "rgba8"]);
    assert!(
        [expected("127.00"), expected("128.00")].contains(&found),
        "{found:?}"
    );
}
