//! The peeling options of `onionskin render`: which method has which, and what they do.

use crate::kit;
use crate::kit::cli::Desk;

/// Seven sheets over the whole picture, shuffled.
const SHEETS: &str = r#"
size = [40, 30]
background = [1.0, 1.0, 1.0]

[[mesh]]
generate = "quads"
count = 7
size = [1.0, 1.0]
spacing = 0.3
alpha = 0.5
order = "shuffled"
seed = 3
"#;

fn desk() -> Desk {
    Desk::new().with("sheets.toml", SHEETS)
}

fn number(answer: &kit::cli::Answer, key: &str) -> f64 {
    answer.objects()[0][key].as_f64().unwrap()
}

#[test]
fn depth_unit_0_as_in_2001_gives_the_exact_image_with_listing_2() {
    let answer = desk().run(&[
        "render",
        "sheets.toml",
        "-o",
        "out.png",
        "--depth-unit-0",
        "classic-depth-replace",
        "--json",
    ]);
    assert!(number(&answer, "max_error") < 1e-6);
    assert_eq!(number(&answer, "iterations"), 8.0);
    assert_eq!(number(&answer, "lost"), 0.0);
}

#[test]
fn the_peel_limit_is_dual_peelings_too_and_takes_two_layers_a_peel() {
    let peels = |peels: &str| {
        desk().run(&[
            "render",
            "sheets.toml",
            "-o",
            "out.png",
            "-m",
            "dual-depth-peeling",
            "--peels",
            peels,
            "--json",
        ])
    };
    let [two, four] = ["2", "4"].map(peels);
    assert_eq!(number(&two, "geometry_passes"), 3.0);
    // The three in the middle of seven, at each pixel that has all of them.
    assert!(number(&two, "lost") > 0.0 && number(&two, "max_error") > 0.01);
    assert_eq!(number(&four, "lost"), 0.0);
}

#[test]
fn options_that_a_method_does_not_have_are_refused() {
    for (method, option) in [
        ("dual-depth-peeling", &["--layers"][..]),
        ("dual-depth-peeling", &["--depth-unit-0", "classic"]),
        ("coplanar-depth-peeling", &["--occlusion-ratio", "0.1"]),
        ("coplanar-depth-peeling", &["--as-printed"]),
        ("painter", &["--depth-unit-0", "classic"]),
    ] {
        let mut arguments = vec!["render", "sheets.toml", "-o", "out.png", "-m", method];
        arguments.extend(option);
        let desk = desk();
        desk.refused(&arguments).says(&[method, "depth-peeling"]);
        assert_eq!(desk.names(), ["sheets.toml"]);
    }
}

/// As printed, the silence of the texts on the depth unit of 2001 is filled. Literally nothing is peeled, and each layer is the
/// first.
#[test]
fn the_depth_unit_of_2001_runs_in_every_reading_of_its_paper() {
    let error = |unit, reading| {
        let answer = desk().run(&[
            "render",
            "sheets.toml",
            "-o",
            "out.png",
            "--peels",
            "8",
            "--depth-unit-0",
            unit,
            reading,
            "--json",
        ]);
        number(&answer, "max_error")
    };
    let today = error("sampler", "--as-printed");
    let unit = "classic-depth-replace";
    assert!((error(unit, "--as-printed") - today).abs() < 1e-6);
    assert!(error(unit, "--literal") > today + 1e-3);
}

#[test]
fn a_depth_format_that_gets_stuck_does_not_hang() {
    let answer = desk().run(&[
        "render",
        "sheets.toml",
        "-o",
        "out.png",
        "-m",
        "depth-peeling",
        "--depth",
        "d24",
        "--json",
    ]);
    let stopped = answer.objects()[0]["stopped"].as_str().unwrap().to_owned();
    // Whether these sheets' depths are among those that are rounded down, is llvmpipe's affair.
    assert!(
        stopped == "empty layer" || stopped.starts_with("no end"),
        "{stopped}"
    );
}
