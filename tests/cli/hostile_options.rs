//! Hostile options and arguments: as in `cli/hostile.rs`, each is refused with words that name the thing.

use super::hostile::all_refused;
use crate::kit::cli::Desk;

#[test]
fn methods_that_there_are_not_and_the_ones_that_were_meant() {
    all_refused(&[
        (
            &["render", "m.obj", "-o", "a.png", "-m", ""],
            &["no method ''"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "-m", "all"],
            &["no method 'all'"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "-m", "depthpeeling"],
            &["Did you mean 'depth-peeling'?"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "-m", "Depth-Peeling"],
            &["Did you mean 'depth-peeling'?"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "-m", "pianter"],
            &["Did you mean 'painter'?"],
        ),
        (
            &["render", "m.obj", "-o", "a.png", "-m", "dfb+ppda"],
            &["Did you mean 'dfb+ppd"],
        ),
        (
            &["compare", "m.obj", "-m", "blend,,painter"],
            &["no method ''"],
        ),
        (&["compare", "m.obj", "-m", ","], &["no method ''"]),
        (
            &["compare", "m.obj", "-m", "blend,all"],
            &["no method 'all'"],
        ),
        (
            &["compare", "m.obj", "-m", "exakt"],
            &["Did you mean 'exact'?"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "-m", "\u{7}"],
            &["no method '\\u{7}'"],
        ),
        (
            &["compare", "m.obj", "--backend", "vulkan"],
            &["no backend 'vulkan'"],
        ),
        (&["compare", "m.obj", "--color", "rgb"], &["'rgb'", "rgba8"]),
        (&["compare", "m.obj", "--depth", "16"], &["'16'", "d24"]),
    ]);
}

/// `render m.obj -o a.png` with these.
#[track_caller]
fn all_refused_to_render(cases: &[(&[&str], &[&str])]) {
    let render = ["render", "m.obj", "-o", "a.png"];
    let whole: Vec<_> = cases
        .iter()
        .map(|(arguments, words)| ([&render, *arguments].concat(), *words))
        .collect();
    let cases: Vec<_> = whole.iter().map(|(a, words)| (&a[..], *words)).collect();
    all_refused(&cases);
}

#[test]
fn options_of_methods_out_of_their_ranges() {
    all_refused_to_render(&[
        (&["--peels", "-1"], &["-1"]),
        (&["--peels", "many"], &["'many'", "--peels"]),
        (&["--peels", "99999999999"], &["'99999999999'", "--peels"]),
        (&["--occlusion-ratio", "2"], &["occlusion ratio"]),
        (&["--occlusion-ratio", "nan"], &["occlusion ratio"]),
        (&["--depth-unit-0", "magic"], &["'magic'", "sampler"]),
        (&["-m", "blend", "--peels", "3"], &["blend has no"]),
        // Given with the value that it has where it is not given, too.
        (
            &["-m", "exact", "--peels", "0"],
            &["--peels: exact has no such option"],
        ),
        (&["-m", "exact", "--as-printed"], &["exact has no"]),
        (&["-m", "ffb", "--peels", "3"], &["ffb"]),
        (&["-m", "ffb", "--array", "0"], &["array"]),
        (&["-m", "ffb", "--array", "12"], &["array"]),
        (&["-m", "ffb", "--array", "4096"], &["array"]),
        (&["-m", "ffb+ppdp", "--peel", "0"], &["peel"]),
        (&["-m", "ffb+ppdp", "--peel", "65"], &["peel"]),
        (&["-m", "ffb", "--termination", "2"], &["transparency 2"]),
        (
            &["-m", "ffb", "--termination", "nan"],
            &["transparency NaN"],
        ),
        (&["-m", "ffb", "--budget", "0"], &["budget"]),
        (&["-m", "ffb", "--fill", "hope"], &["'hope'", "atomics"]),
        (
            &["-m", "ffb", "--array-sort", "bogo"],
            &["'bogo'", "insertion"],
        ),
        (&["-m", "ffb", "--record-color", "red"], &["'red'", "half"]),
        (
            &["-m", "painter", "--array", "8"],
            &["--array: painter has no such option", "ffb, dfb, ppll"],
        ),
        (
            &["-m", "coherent-layer-peeling-a", "--sort", "buckets=0"],
            &["'buckets=0'"],
        ),
        (
            &[
                "-m",
                "coherent-layer-peeling-a",
                "--sort",
                "buckets=99999999",
            ],
            &["'buckets=99999999'"],
        ),
        (
            &["-m", "coherent-layer-peeling-a", "--improve", "magic"],
            &["'magic' is no improvement"],
        ),
        (
            &["-m", "coherent-layer-peeling-a", "--improve", "batches=0"],
            &["'batches=0'"],
        ),
        (
            &["-m", "coherent-layer-peeling-b", "--improve", "tight-bound"],
            &["tight-bound"],
        ),
        (
            &[
                "-m",
                "ideal-coherent-layer-peeling",
                "--improve",
                "early-stop",
            ],
            &["early-stop", "tight-bound"],
        ),
        (
            &["-m", "hybrid-layer-peeling", "--slices", "0"],
            &["'0' is no number of slices"],
        ),
        (
            &["-m", "hybrid-layer-peeling", "--slices", "65537"],
            &["'65537' is no number of slices"],
        ),
        (
            &["-m", "hybrid-layer-peeling", "--slices", "9"],
            &["--slices is given", "m has no volumes"],
        ),
        (
            &["--slices", "9"],
            &["--slices is given", "m has no volumes"],
        ),
        (&["-m", "dfb", "--slices", "9"], &["dfb casts rays"]),
    ]);
    all_refused(&[
        (
            &["compare", "m.obj", "--slices", "9"],
            &["--slices is given", "no volumes"],
        ),
        (
            &["animate", "m.obj", "-o", "f", "--slices", "9"],
            &["--slices is given", "no volumes"],
        ),
        (&["complexity", "m.obj", "--bin", "0"], &["--bin"]),
        (
            &["complexity", "m.obj", "--by", "hand"],
            &["'hand'", "blending"],
        ),
    ]);
}

#[test]
fn images_bounds_and_gains_that_check_does_not_take() {
    all_refused(&[
        (
            &["check", "m.obj", "gone.png"],
            &["gone.png: ", "cannot read it"],
        ),
        (
            &["check", "m.obj", "folder.png"],
            &["folder.png: this is no file"],
        ),
        (
            &["check", "m.obj", "text.png"],
            &["text.png: cannot decode it"],
        ),
        (
            &["check", "m.obj", "half.exr"],
            &["half.exr: cannot decode it"],
        ),
        (&["check", "m.obj", "m.obj"], &["m.obj: ", ".png"]),
        (&["check", "m.obj", ""], &["IMAGE"]),
        (
            &["check", "m.obj", "kept.png", "--bound", "1.5"],
            &["--bound is 1.5", "0 to 1"],
        ),
        (
            &["check", "m.obj", "kept.png", "--bound", "nan"],
            &["--bound is NaN"],
        ),
        (
            &["check", "m.obj", "kept.png", "--bound", "inf"],
            &["--bound is inf"],
        ),
        (
            &["check", "m.obj", "kept.png", "--bound=-0.1"],
            &["--bound is -0.1"],
        ),
        (
            &["check", "m.obj", "kept.png", "--bound", "x"],
            &["'x'", "--bound"],
        ),
        (
            &["check", "m.obj", "kept.png", "--gain", "0"],
            &["--gain is 0"],
        ),
        (
            &["check", "m.obj", "kept.png", "--gain=-8"],
            &["--gain is -8"],
        ),
        (
            &["check", "m.obj", "kept.png", "--gain", "inf"],
            &["--gain is inf"],
        ),
    ]);
}

#[test]
fn a_listing_with_free_variables_asks_for_them_and_takes_them() {
    let desk = Desk::new();
    for (name, variable) in [
        ("lindholm/resolve", "N"),
        ("lindholm/pp-ao", "num_segments"),
    ] {
        let unroll = ["listing", name, "--unroll", "2"];
        let advice = format!("--set {variable}=4");
        let refused = desk.refused(&unroll);
        refused.says(&["nothing sets", variable, &advice]);
        let advice: Vec<&str> = advice.split(' ').collect();
        let four = desk.result(&[&unroll[..], &advice].concat());
        let two = desk.result(&[&unroll[..], &["--set", &format!("{variable}=2")]].concat());
        assert!(four != two, "{name}: {four}");
    }
    // A variable that has a value by itself is set all the same.
    let unroll = ["listing", "everitt/listing-1", "--unroll", "2"];
    let three = desk.result(&[&unroll[..], &["--set", "num_passes=3"]].concat());
    assert_eq!(
        three,
        desk.result(&["listing", "everitt/listing-1", "--unroll", "3"])
    );
}

#[test]
fn listings_that_there_are_not() {
    all_refused(&[
        (&["listing", ""], &["no listing ''"]),
        (&["listing", "/"], &["no listing '/'"]),
        (&["listing", "everitt/"], &["no listing 'everitt/'"]),
        (
            &["listing", "everitt/listing-9"],
            &[
                "no listing 'everitt/listing-9'",
                "Did you mean 'everitt/listing-",
            ],
        ),
        (
            &["listing", "everit/listing-1"],
            &["Did you mean 'everitt/listing-1'?"],
        ),
        (&["listing", "../../etc/passwd"], &["no listing"]),
        (&["listing", "\u{1b}[2J"], &["no listing '\\u{1b}[2J'"]),
        (
            &["listing", "everitt/listing-1", "--unroll", "0"],
            &["'0'", "--unroll"],
        ),
        (
            &["listing", "everitt/listing-1", "--unroll", "1001"],
            &["'1001'"],
        ),
        (
            &["listing", "carr/algorithm-1", "--unroll", "2"],
            &["pseudocode"],
        ),
        (
            &["listing", "everitt/listing-1", "--set", "num_passes=3"],
            &["--unroll"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "passes",
            ],
            &["'passes' sets no variable"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "num_passes=inf",
            ],
            &["sets no variable"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "num_passes=nan",
            ],
            &["sets no variable"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "num_passes=",
            ],
            &["sets no variable"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "=3",
            ],
            &["sets no variable"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "num_pases=3",
            ],
            &["no free variable 'num_pases'", "Did you mean 'num_passes'?"],
        ),
        (
            &[
                "listing",
                "everitt/listing-1",
                "--unroll",
                "2",
                "--set",
                "num_passes=1e6",
            ],
            &["calls", "fewer rounds"],
        ),
    ]);
}
