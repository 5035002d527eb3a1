//! What the command line says of differences of depth that a depth buffer cannot hold.

use onionskin::{Context, Image};

use crate::kit::cli::{Answer, Desk};
use crate::kit::driver::interpolates_true_corners;

/// Two panes 1 cm apart, 100 away, the green one farther but first.
const FAR: &str = "v -20 -20 -0.01\nv 20 -20 -0.01\nv 20 20 -0.01\nv -20 20 -0.01\nf 1 2 3 4\n";
const NEAR: &str = "v -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n";
const SCENE: &str = "size = [48, 36]\n[camera]\neye = [3, 2, 100]\ntarget = [0, 0, 0]\nfov = 40\nnear = 0.1\nfar = 1000\n\
    [[mesh]]\nfile = \"far.obj\"\ncolor = [0, 1, 0]\nopacity = 0.5\nshading = \"none\"\n\
    [[mesh]]\nfile = \"near.obj\"\ncolor = [1, 0, 0]\nopacity = 0.5\nshading = \"none\"\n";

fn desk() -> Desk {
    Desk::new()
        .with("far.obj", FAR)
        .with("near.obj", NEAR)
        .with("panes.toml", SCENE)
}

fn record(answer: &Answer) -> serde_json::Map<String, serde_json::Value> {
    let mut objects = answer.objects();
    assert_eq!((answer.code, objects.len()), (0, 1), "{answer}");
    objects.remove(0)
}

#[test]
fn compare_tells_what_hangs_on_depth_from_what_is_wrong() {
    if !interpolates_true_corners(&Context::headless().unwrap()) {
        return;
    }
    let desk = desk();
    let compare = ["compare", "panes.toml", "-m", "depth-peeling", "--json"];
    let fitted = record(&desk.run(&compare));
    assert!(fitted["max_error"].as_f64().unwrap() < 1e-5);
    assert_eq!(fitted["hanging_pixels"], 0);
    let given = record(&desk.run(&[&compare[..], &["--planes", "given"]].concat()));
    // Every pixel of both panes hangs on it, and what is wrong there is no error of the method's.
    assert!(given["hanging_pixels"].as_u64().unwrap() > 300);
    // Half of red before half of green, or the other way round: 0.25; or one of the two, where depths are equal: 0.5.
    let hanging = given["hanging_max_error"].as_f64().unwrap();
    assert!(hanging > 0.25 - 1e-5, "{hanging}");
    assert!(given["max_error"].as_f64().unwrap() < 1e-5);
    let inverse = desk.run(&[&compare[..], &["--planes", "given", "--inverse-w"]].concat());
    let inverse = record(&inverse);
    assert!(inverse["max_error"].as_f64().unwrap() < 1e-5);
    assert_eq!(inverse["hanging_pixels"], 0);
}

#[test]
fn blending_in_the_wrong_order_is_an_error_all_the_same() {
    let compare = ["compare", "panes.toml", "-m", "blend", "--json"];
    let nearest_first = Desk::new()
        .with("far.obj", NEAR)
        .with("near.obj", FAR)
        .with("panes.toml", SCENE);
    let blend = record(&nearest_first.run(&compare));
    assert!((blend["max_error"].as_f64().unwrap() - 0.25).abs() < 1e-5);
}

#[test]
fn planes_that_waste_a_depth_buffer_are_said_with_what_is_done_about_them() {
    let render = ["render", "panes.toml", "-m", "exact", "-o", "panes.png"];
    let note = desk().run(&render).err;
    assert!(note.contains("near = 0.1 and far = 1000"), "{note}");
    assert!(note.contains("which cuts nothing off"), "{note}");
    let fitted = SCENE.replace("near = 0.1\nfar = 1000\n", "");
    let silent = desk().with("panes.toml", fitted);
    silent.result(&render);
}

#[test]
fn check_passes_the_right_picture_fails_the_reversed_one_and_says_why() {
    let desk = desk();
    desk.run(&["render", "panes.toml", "-m", "exact", "-o", "right.png"]);
    let right = desk.run(&["check", "panes.toml", "right.png"]);
    assert_eq!(right.code, 0, "{right}");
    let mut image = Image::load(desk.path("right.png")).unwrap();
    for pixel in &mut image.pixels {
        (pixel.r, pixel.g) = (pixel.g, pixel.r);
    }
    image.save(desk.path("reversed.png")).unwrap();
    let reversed = desk.run(&["check", "panes.toml", "reversed.png", "--json"]);
    assert_eq!(reversed.code, 1, "{reversed}");
    let verdict = &reversed.objects()[0];
    assert!(
        verdict["hanging_pixels"].as_u64().unwrap() > 300,
        "{reversed}"
    );
    let [over, of_them] = ["pixels_over", "hanging_pixels_over"].map(|key| verdict[key].as_u64());
    assert!(of_them.unwrap() > 300 && of_them <= over, "{reversed}");
    let words = desk.run(&["check", "panes.toml", "reversed.png"]).out;
    assert!(words.contains("hang on a difference of depth"), "{words}");
}

#[test]
fn depths_that_1_over_w_does_not_fit_are_refused() {
    let render = ["render", "panes.toml", "-o", "p.png", "--inverse-w"];
    desk()
        .refused(&[&render[..], &["--depth", "d24"]].concat())
        .says(&["1/w", "32-bit float"]);
    let classic = [
        "-m",
        "depth-peeling",
        "--depth-unit-0",
        "classic-depth-replace",
    ];
    desk()
        .refused(&[&render[..], &classic].concat())
        .says(&["cannot be drawn by 1/w", "depth unit 0"]);
}
