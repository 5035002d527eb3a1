//! The options of Carr et al.'s methods on the command line.

use crate::kit::bounds::F32;
use crate::kit::cli::Desk;

const SCENE: &str = "examples/scenes/teapot.toml";

fn record(arguments: &[&str]) -> serde_json::Map<String, serde_json::Value> {
    let desk = Desk::new();
    let scene = format!("{}/{SCENE}", env!("CARGO_MANIFEST_DIR"));
    let mut all = vec![
        "render",
        &scene,
        "--size",
        "80x60",
        "--json",
        "-o",
        "image.png",
    ];
    all.extend_from_slice(arguments);
    let answer = desk.run(&all);
    answer.objects().remove(0)
}

#[test]
fn every_method_of_the_paper_renders_and_says_that_nothing_is_lost() {
    for method in [
        "layer-peeling",
        "hybrid-layer-peeling",
        "coherent-layer-peeling-a",
        "coherent-layer-peeling-b",
        "ideal-coherent-layer-peeling",
    ] {
        let record = record(&["-m", method]);
        assert_eq!(record["method"], method);
        assert_eq!(record["lost"], 0, "{method}");
        assert_eq!(record["stopped"], "empty layer", "{method}");
        assert!(record["max_error"].as_f64().unwrap() <= F32, "{method}");
    }
}

#[test]
fn sorting_saves_iterations() {
    let iterations = |sort| {
        record(&["-m", "coherent-layer-peeling-b", "--sort", sort])["iterations"]
            .as_u64()
            .unwrap()
    };
    assert!(iterations("buckets=512") < iterations("submission"));
}

#[test]
fn improvements_are_made() {
    let passes = |improve: &[&str]| {
        let arguments = [&["-m", "coherent-layer-peeling-a"], improve].concat();
        let record = record(&arguments);
        assert!(record["max_error"].as_f64().unwrap() <= 1e-5);
        record["geometry_passes"].as_u64().unwrap()
    };
    let faithful = passes(&[]);
    assert_eq!(passes(&["--improve", "early-stop"]), faithful - 5);
    assert!(passes(&["--improve", "tie-friendly,early-stop,batches=3"]) > 0);
}

/// Literally, variant A has no framebuffers. With the paper's silence filled it shows only errors that this scene does not
/// meet.
#[test]
fn each_reading_is_the_image_that_its_text_makes() {
    let error = |method, reading| {
        let record = record(&["-m", method, reading]);
        record["max_error"].as_f64().unwrap()
    };
    assert!(error("coherent-layer-peeling-a", "--literal") > 0.01);
    assert!(error("coherent-layer-peeling-a", "--as-printed") < 1e-5);
    assert!(error("ideal-coherent-layer-peeling", "--as-printed") > 0.01);
}

#[test]
fn options_that_a_method_does_not_have_are_refused_with_those_that_have_them() {
    let refused = |arguments: &[&str]| {
        let mut all = vec!["render", SCENE, "-o", "image.png", "-m"];
        all.extend_from_slice(arguments);
        Desk::new().refused(&all)
    };
    refused(&["painter", "--sort", "objects"])
        .says(&["--sort: painter has no such option", "coherent"]);
    refused(&["painter", "--as-printed"]).says(&["painter has no", "--as-printed"]);
    refused(&["layer-peeling", "--peels", "3"])
        .says(&["--peels: layer-peeling has no such option"]);
    refused(&["coherent-layer-peeling-a", "--improve", "tight-bound"]).says(&["Algorithm 2"]);
    refused(&["ideal-coherent-layer-peeling", "--improve", "early-stop"]).says(&["tight-bound"]);
    refused(&[
        "coherent-layer-peeling-a",
        "--improve",
        "early-stop",
        "--as-printed",
    ])
    .says(&["none of the improvements"]);
    refused(&["coherent-layer-peeling-a", "--sort", "buckets=0"])
        .says(&["'buckets=0'", "buckets=N"]);
    refused(&["coherent-layer-peeling-a", "--sort", "well"]).says(&["'well' is no way to sort"]);
    refused(&["coherent-layer-peeling-a", "--improve", "batches=0"]).says(&["'batches=0'"]);
    refused(&["coherent-layer-peeling-a", "--improve", "speed"])
        .says(&["'speed' is no improvement"]);
}
