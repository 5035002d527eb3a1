//! `onionskin bench`: its counts are the library's, its ratios those of its times. What the times are is not tested.

use onionskin::Method;
use serde_json::{Map, Value};

use crate::kit::sheets::{SHEETS, desk, library};

type Object = Map<String, Value>;

fn number(object: &Object, key: &str) -> f64 {
    let value = object.get(key).and_then(Value::as_f64);
    value.unwrap_or_else(|| panic!("no {key}: {object:?}"))
}

#[test]
fn every_method_has_its_counts_and_a_ratio_to_plain_blending() {
    let desk = desk();
    let methods = "verified-painter,dfb+ppdp,dual-depth-peeling";
    let answer = desk.run(&[
        "bench",
        "--no-vtk",
        "sheets.toml",
        "--json",
        "--frames",
        "3",
        "-m",
        methods,
    ]);
    assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
    let objects = answer.objects();
    let names: Vec<_> = objects
        .iter()
        .map(|object| object["method"].as_str().unwrap())
        .collect();
    assert_eq!(names.join(","), format!("blend,{methods}"), "{answer}");
    let base = number(&objects[0], "ms");
    for object in &objects {
        let method: Method = object["method"].as_str().unwrap().parse().unwrap();
        let stats = library(&desk, "sheets.toml", None, &method).stats;
        assert_eq!(object["geometry_passes"], stats.geometry_passes, "{answer}");
        assert_eq!(object["iterations"], stats.iterations, "{answer}");
        assert_eq!(object["triangles"], stats.triangles, "{answer}");
        assert_eq!(object["fragments"], stats.fragments, "{answer}");
        assert_eq!(object["frames"], 3, "{answer}");
        assert_eq!(object["left_out"], Value::Null, "{answer}");
        let [min, median, max] = ["ms_min", "ms", "ms_max"].map(|key| number(object, key));
        assert!(0.0 < min && min <= median && median <= max, "{answer}");
        // A number read from JSON may differ in its last digit.
        let ratio = number(object, "of_blend") / (median / base);
        assert!((ratio - 1.0).abs() < 1e-12, "{answer}");
    }
    // Sheets one behind the other are proved to be in order; all fragments of an A-buffer are in its lists.
    assert_eq!(objects[1]["marked_pixels"], 0);
    assert_eq!(objects[1]["list_fragments"], 0);
    assert_eq!(objects[2]["list_fragments"], objects[2]["fragments"]);
    assert_eq!(objects[3]["list_fragments"], Value::Null);
}

#[test]
fn what_cannot_be_proved_is_counted() {
    let soup = "size = [40, 30]\n[[mesh]]\ngenerate = \"soup\"\ncount = 400\nalpha = [0.3, 0.7]\n";
    let desk = desk().with("soup.toml", soup);
    let answer = desk.run(&[
        "bench",
        "--no-vtk",
        "soup.toml",
        "--json",
        "--frames",
        "1",
        "-m",
        "verified-painter",
    ]);
    let objects = answer.objects();
    let counts = library(&desk, "soup.toml", None, &Method::VerifiedPainter)
        .stats
        .verified
        .unwrap();
    assert!(counts.marked_pixels > 0);
    assert_eq!(
        objects[1]["marked_pixels"], counts.marked_pixels,
        "{answer}"
    );
    assert_eq!(
        objects[1]["list_fragments"], counts.list_fragments,
        "{answer}"
    );
}

#[test]
fn a_method_that_does_not_draw_volumes_has_a_row_that_says_why() {
    let fog = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes/fog.toml");
    let small = ["--no-vtk", "--size", "32x24", "--frames", "1"];
    let methods = ["bench", fog, "-m", "painter,dfb+ppdp"];
    let table = [&methods[..], &small].concat();
    let answer = desk().run(&[&table[..], &["--json"]].concat());
    assert_eq!(answer.code, 0, "{answer}");
    let objects = answer.objects();
    for refused in &objects[..2] {
        let why = refused["left_out"].as_str().unwrap();
        assert!(why.contains("draws surfaces only"), "{answer}");
        assert_eq!(refused["ms"], Value::Null);
    }
    assert!(number(&objects[2], "ms") > 0.0);
    assert_eq!(
        objects[2]["of_blend"],
        Value::Null,
        "there is nothing to be relative to"
    );
    let table = desk().run(&table);
    table.says(&["note: painter: ", "draws surfaces only"]);
}

#[test]
fn the_csv_has_the_lines_of_all_scenes_under_one_line_of_names() {
    let desk = desk().with("other.toml", SHEETS.replace("count = 5", "count = 2"));
    let out = desk.result(&[
        "bench",
        "--no-vtk",
        "sheets.toml",
        "other.toml",
        "-m",
        "painter",
        "--frames",
        "2",
        "--csv",
        "costs.csv",
    ]);
    assert!(
        out.contains("sheets: 40 x 30") && out.contains("other: 40 x 30"),
        "{out}"
    );
    let csv = String::from_utf8(desk.files()["costs.csv"].clone()).unwrap();
    let lines: Vec<_> = csv.lines().collect();
    assert_eq!(lines.len(), 5, "{csv}");
    assert!(
        lines[0].starts_with("scene,width,height,device,by,method,"),
        "{csv}"
    );
    let begins = |line: &str, scene| assert!(line.starts_with(&format!("{scene},40,30,")), "{csv}");
    lines[1..3].iter().for_each(|line| begins(line, "sheets"));
    lines[3..].iter().for_each(|line| begins(line, "other"));
}

#[test]
fn bad_input_is_refused_before_anything_is_measured_or_written() {
    let desk = desk();
    let refused = |arguments: &[&str], says: &[&str]| {
        let all = [&["bench", "--no-vtk", "--csv", "costs.csv"], arguments].concat();
        desk.refused(&all).says(says);
    };
    refused(&["sheets.toml", "--frames", "0"], &["--frames", "1..="]);
    refused(&["sheets.toml", "-m", "dbf"], &["no method 'dbf'", "dfb"]);
    refused(&["sheets.toml", "nothing.toml"], &["nothing.toml"]);
    refused(&[], &["SCENE|MODEL"]);
    desk.refused(&["bench", "--no-vtk", "sheets.toml", "--csv", "costs.txt"])
        .says(&["name it .csv"]);
    desk.refused(&["bench", "--no-vtk", "sheets.toml", "--csv", "no/costs.csv"])
        .says(&["there is no folder no"]);
}

#[test]
fn a_sweep_has_more_layers_or_more_disorder_from_scene_to_scene() {
    let desk = desk();
    let sweep = |what: &str| {
        let arguments = [
            "bench", "--no-vtk", "--sweep", what, "-o", "plots", "--size", "64x48",
        ];
        let more = ["-m", "verified-painter", "--frames", "1", "--json"];
        let answer = desk.run(&[&arguments[..], &more].concat());
        assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
        let objects = answer.objects();
        let verified = objects
            .into_iter()
            .filter(|object| object["method"] == "verified-painter");
        verified.collect::<Vec<_>>()
    };
    let pixels = 64.0 * 48.0;
    let depth = sweep("depth");
    let layers: Vec<_> = depth
        .iter()
        .map(|object| number(object, "fragments") / pixels)
        .collect();
    assert_eq!(layers, [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0]);
    assert!(
        depth.iter().all(|object| object["marked_pixels"] == 0),
        "{depth:?}"
    );

    let disorder = sweep("disorder");
    let marked: Vec<_> = disorder
        .iter()
        .map(|object| number(object, "marked_pixels") / pixels)
        .collect();
    assert!(
        marked.is_sorted() && marked[0] < 0.1 && marked[6] > 0.9,
        "{marked:?}"
    );
    // Strips that lean leave gaps of a pixel here and there, or overlap.
    let layers = disorder
        .iter()
        .map(|object| number(object, "fragments") / pixels);
    assert!(
        layers.into_iter().all(|layers| (layers - 16.0).abs() < 0.5),
        "{disorder:?}"
    );

    for what in ["depth", "disorder"] {
        let file =
            |ending| std::fs::read(desk.path("plots").join(what).with_extension(ending)).unwrap();
        let csv = String::from_utf8(file("csv")).unwrap();
        assert_eq!(csv.lines().count(), 1 + 7 * 2, "{csv}");
        let svg = String::from_utf8(file("svg")).unwrap();
        assert!(
            svg.contains("verified-painter\n") && svg.contains("64 x 48"),
            "{svg}"
        );
        assert!(file("png").starts_with(b"\x89PNG"));
    }
}

#[test]
fn a_plot_has_a_mark_for_each_scene_and_method() {
    let desk = desk().with("other.toml", SHEETS.replace("count = 5", "count = 2"));
    desk.result(&[
        "bench",
        "--no-vtk",
        "sheets.toml",
        "other.toml",
        "-m",
        "dfb",
        "--frames",
        "1",
        "--plot",
        "costs.svg",
    ]);
    let svg = String::from_utf8(desk.files()["costs.svg"].clone()).unwrap();
    // Two methods, two scenes, and a mark of each method in the legend.
    assert_eq!(svg.matches("<polygon").count(), 2 + 1, "lists: {svg}");
    let stroke = r##"opacity="1" stroke="#000000" stroke-width="2""##;
    assert_eq!(svg.matches(stroke).count(), 2 * (2 + 1), "blend: {svg}");
}

#[test]
fn the_steps_are_those_of_the_listing() {
    let answer = desk().run(&[
        "bench",
        "--no-vtk",
        "sheets.toml",
        "-m",
        "dual-depth-peeling",
        "--frames",
        "2",
        "--steps",
        "--json",
    ]);
    for object in answer.objects() {
        let steps = object["steps"].as_array().unwrap();
        let drawn = steps.iter().filter(|step| {
            step["step"]
                .as_str()
                .unwrap()
                .ends_with(": drawTransparentObjects()")
        });
        let passes: u64 = drawn.map(|step| step["times"].as_u64().unwrap()).sum();
        assert_eq!(
            passes,
            object["geometry_passes"].as_u64().unwrap(),
            "{answer}"
        );
        let sum: f64 = steps.iter().map(|step| step["ms"].as_f64().unwrap()).sum();
        assert!(sum > 0.0, "{answer}");
    }
    let table = desk().result(&[
        "bench",
        "--no-vtk",
        "sheets.toml",
        "-m",
        "blend",
        "--steps",
        "--frames",
        "1",
    ]);
    for part in [
        "steps of blend",
        "surface: drawTransparentObjects()",
        "Each step waited for, by glFinish",
        "Timer queries ",
    ] {
        assert!(table.contains(part), "{table}");
    }
}

#[test]
fn where_there_is_no_vtk_a_line_says_so_and_a_named_python_must_have_it() {
    let desk = desk();
    let measured = [
        "bench",
        "sheets.toml",
        "-m",
        "painter",
        "--frames",
        "1",
        "--json",
    ];
    let answer = desk.with_variable("PATH", "").run(&measured);
    assert_eq!((answer.code, answer.objects().len()), (0, 2), "{answer}");
    assert_eq!(answer.err.lines().count(), 1, "{answer}");
    answer.says(&["note: VTK: python3 cannot be started", "it takes no part"]);
    let named = [&measured[..], &["--python", "./no-python"]].concat();
    crate::kit::sheets::desk()
        .refused(&named)
        .says(&["./no-python cannot be started", "--no-vtk"]);
}

#[test]
fn vtk_takes_turns_with_our_methods() {
    let answer = desk().run(&[
        "bench",
        "sheets.toml",
        "-m",
        "painter",
        "--frames",
        "2",
        "--json",
    ]);
    if answer.err.contains("takes no part") {
        println!("skipped: {}", answer.err);
        return;
    }
    let objects = answer.objects();
    let vtk: Vec<_> = objects
        .iter()
        .filter(|object| object["by"] == "VTK")
        .collect();
    let modes: Vec<_> = vtk
        .iter()
        .map(|object| object["method"].as_str().unwrap())
        .collect();
    assert_eq!(modes, ["alpha", "peel", "dual"], "{answer}");
    // Five sheets: one pass, one for each and one that finds nothing, or at most half of them and two more.
    let passes = |number: usize| vtk[number]["geometry_passes"].as_u64().unwrap();
    assert_eq!((passes(0), passes(1)), (1, 6), "{answer}");
    assert!((3..=5).contains(&passes(2)), "{answer}");
    for (ratio, mode) in [("of_vtk_alpha", 0), ("of_vtk_peel", 1), ("of_vtk_dual", 2)] {
        assert_eq!(vtk[mode]["frames"], 2, "{answer}");
        let expected = number(&objects[1], "ms") / number(vtk[mode], "ms");
        assert!(
            (number(&objects[1], ratio) / expected - 1.0).abs() < 1e-12,
            "{answer}"
        );
    }
}
