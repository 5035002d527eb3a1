//! Volumes on the command line.

use crate::kit::cli::Desk;

const SCENE: &str = "size = [16, 12]\n[[volume]]\ngenerate = \"ball\"\nsamples = 8\n\
    transfer = [{ value = 0, color = [1, 0, 0], density = 0 }, { value = 1, color = [1, 0, 0], density = 2 }]\n";

#[test]
fn exact_renders_volumes_alone() {
    let desk = Desk::new().with("scene.toml", SCENE);
    desk.result(&["render", "scene.toml", "-m", "exact", "-o", "image.png"]);
    let image = onionskin::Image::load(desk.path("image.png")).unwrap();
    let middle = image.pixels[6 * 16 + 8];
    assert!(middle.r > 0.5 && middle.g == 0.0, "{middle:?}");
}

#[test]
fn other_methods_refuse_volumes_and_write_nothing() {
    let desk = Desk::new().with("scene.toml", SCENE);
    desk.refused(&[
        "render",
        "scene.toml",
        "-m",
        "depth-peeling",
        "-o",
        "image.png",
    ])
    .says(&["depth-peeling draws surfaces only", "volumes (1)", "exact"]);
    desk.refused(&["compare", "scene.toml", "-m", "blend,exact"])
        .says(&["blend draws surfaces only"]);
}

#[test]
fn compare_takes_of_all_methods_those_that_can() {
    let desk = Desk::new().with("scene.toml", SCENE);
    let answer = desk.run(&["compare", "scene.toml", "--json"]);
    let methods: Vec<_> = answer
        .objects()
        .iter()
        .map(|object| object["method"].clone())
        .collect();
    let a_buffers = ["ffb", "dfb", "ppll"].into_iter().flat_map(|manager| {
        ["", "+ppao", "+ppdp", "+ppao+ppdp"].map(|local| format!("{manager}{local}"))
    });
    let able = a_buffers.chain(["auto".into(), "exact".into()]);
    let able: Vec<_> = ["hybrid-layer-peeling".into()]
        .into_iter()
        .chain(able)
        .collect();
    assert_eq!(methods, able);
}

#[test]
fn slices_are_as_many_as_asked_for_and_more_methods_take_them() {
    let desk = Desk::new().with("scene.toml", SCENE);
    let answer = desk.run(&["compare", "scene.toml", "--json", "--slices", "9"]);
    let objects = answer.objects();
    let sliced = objects
        .iter()
        .filter(|object| object.contains_key("slices"));
    let sliced: Vec<_> = sliced
        .map(|object| (object["method"].clone(), object["slices"].clone()))
        .collect();
    let painter = ("painter".into(), 9.into());
    assert!(sliced.len() > 6 && sliced.contains(&painter), "{sliced:?}");
    let hybrid = ["render", "scene.toml", "-m", "hybrid-layer-peeling", "-o"];
    let rendered = |more: &[&str]| {
        let rest = ["image.png", "--json"].iter().chain(more);
        let arguments: Vec<_> = hybrid.iter().chain(rest).copied().collect();
        desk.run(&arguments).objects()[0]["slices"].clone()
    };
    assert_eq!(rendered(&[]), 256);
    assert_eq!(rendered(&["--slices", "9"]), 9);
}

#[test]
fn without_a_method_volumes_are_rendered_exactly() {
    let desk = Desk::new().with("scene.toml", SCENE);
    let rendered = |more: &[&str]| {
        let arguments = [&["render", "scene.toml", "-o", "image.png", "--json"], more].concat();
        desk.run(&arguments).objects()[0].clone()
    };
    let object = rendered(&[]);
    assert_eq!(
        (&object["method"], &object["chosen"]),
        (&"auto".into(), &"dfb+ppdp".into())
    );
    assert_eq!(object["lost"], 0);
    // What only surfaces have says which method is meant.
    let object = rendered(&["--slices", "9"]);
    assert_eq!(object["method"], "depth-peeling");
    assert_eq!(object["slices"], 9);
    desk.refused(&["render", "scene.toml", "-o", "image.png", "--peels", "2"])
        .says(&["depth-peeling draws surfaces only"]);
}

#[test]
fn animate_takes_slices_and_keeps_to_them() {
    let scene = format!("{SCENE}[path]\nframes = 4\nrotate = 360\n");
    let desk = Desk::new().with("scene.toml", &scene);
    let frame = ["animate", "scene.toml", "-o", "f", "--frames", "0..1"];
    let sliced = |slices| [&frame[..], &["--slices", slices]].concat();
    desk.result(&sliced("9"));
    desk.result(&sliced("9"));
    desk.refused(&sliced("10")).says(&["slices", "9", "10"]);
    desk.result(&["render", "scene.toml", "-o", "r.png", "--slices", "9"]);
    let [frame, render] = ["f/frame-00000.png", "r.png"].map(|name| std::fs::read(desk.path(name)));
    assert!(frame.unwrap() == render.unwrap());
}

#[test]
fn slices_that_make_no_sense_are_refused() {
    let desk = Desk::new().with("scene.toml", SCENE);
    let render = |method, slices| {
        desk.refused(&[
            "render",
            "scene.toml",
            "-m",
            method,
            "-o",
            "image.png",
            "--slices",
            slices,
        ])
    };
    for slices in ["0", "65537", "many", "1.5", "99999999999999999999"] {
        render("hybrid-layer-peeling", slices).says(&[slices, "1 to 65536"]);
    }
    render("dfb", "9").says(&["dfb casts rays", "--slices"]);
    render("blend", "9").says(&["blend", "order of submission"]);
    desk.refused(&["compare", "scene.toml", "-m", "painter"])
        .says(&["--slices: painter draws surfaces only", "as N slices"]);
}

#[test]
fn a_volume_that_is_cut_off_is_refused_with_its_name() {
    let scene = "[[volume]]\nfile = \"v.nrrd\"\ntransfer = [{ value = 0, color = [1, 0, 0], density = 0 }]\n";
    let head = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 400 400 400\nencoding: raw\n\n";
    let desk = Desk::new().with("scene.toml", scene).with("v.nrrd", head);
    desk.refused(&["render", "scene.toml", "-m", "exact", "-o", "image.png"])
        .says(&["v.nrrd:4: '400 400 400'", "`sizes`", "there are 0"]);
}
