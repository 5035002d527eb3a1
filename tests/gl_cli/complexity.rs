//! `onionskin complexity`, and the A-buffers' options on the command line.

use onionskin::Image;
use serde_json::Value;

use crate::kit::cli::Desk;

/// Three sheets before each other over the whole picture.
const SHEETS: &str = "size = [20, 10]\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\nfov = 20\n\
                      [[mesh]]\ngenerate = \"quads\"\ncount = 3\nsize = [9, 9]\n";

fn desk() -> Desk {
    Desk::new().with("s.toml", SHEETS)
}

#[test]
pub(crate) fn l01_complexity_writes_the_picture_the_plot_and_the_table() {
    let desk = desk();
    let arguments = [
        "complexity",
        "s.toml",
        "-o",
        "c.exr",
        "--plot",
        "p.svg",
        "--csv",
        "t.csv",
    ];
    let text = desk.result(&arguments);
    assert!(text.contains("200 of 200 (100.0%)"), "{text}");
    assert!(text.contains("3 at most"), "{text}");
    let picture = Image::load(desk.path("c.exr")).unwrap();
    assert!(
        picture
            .pixels
            .iter()
            .all(|pixel| pixel.to_array() == [0.0, 0.0, 0.0, 1.0])
    );
    let table = std::fs::read_to_string(desk.path("t.csv")).unwrap();
    assert!(table.ends_with("3,3,200,1.000000\n"), "{table}");
    let plot = std::fs::read_to_string(desk.path("p.svg")).unwrap();
    assert!(plot.starts_with("<svg") && plot.trim_end().ends_with("</svg>"));
    desk.result(&["complexity", "s.toml", "-o", "c.png", "--plot", "p.png"]);
    // The picture of 20 x 10 pixels is enlarged to 320 x 160, and has its scale below it.
    let sheet = Image::load(desk.path("c.png")).unwrap();
    assert!(sheet.width > 320 && sheet.height > 160 + 60);
    let black = |pixel: &&onionskin::Rgba| pixel.to_array() == [0.0, 0.0, 0.0, 1.0];
    assert!(sheet.pixels.iter().filter(black).count() >= 320 * 160);
    assert!(Image::load(desk.path("p.png")).unwrap().width > 100);
}

#[test]
fn every_way_to_count_says_the_same_as_json() {
    let desk = desk();
    let object = |by: &str| -> Value {
        serde_json::from_str(&desk.result(&["complexity", "s.toml", "--json", "--by", by])).unwrap()
    };
    let blending = object("blending");
    assert_eq!(blending["fragments"], 600);
    assert_eq!(blending["max"], 3);
    assert_eq!(blending["percentile_99"], 3);
    assert_eq!(blending["histogram"][3], serde_json::json!([3, 3, 200]));
    assert_eq!(object("atomics"), blending);
    assert_eq!(object("stencil"), blending);
}

#[test]
fn names_that_say_no_format_are_refused_before_anything_is_written() {
    for arguments in [
        ["complexity", "s.toml", "-o", "c.jpg"],
        ["complexity", "s.toml", "--plot", "p.pdf"],
        ["complexity", "s.toml", "--csv", "t.txt"],
        ["complexity", "s.toml", "--csv", "nowhere/t.csv"],
        ["complexity", "s.toml", "--bin", "0"],
    ] {
        let desk = desk();
        let answer = desk.run(&arguments);
        assert_eq!(answer.code, 2, "{answer}");
        assert!(answer.out.is_empty(), "{answer}");
        assert_eq!(desk.files().len(), 1, "{answer}");
    }
}

#[test]
pub(crate) fn l09_render_says_what_a_static_array_has_lost() {
    let desk = desk();
    let answer = desk.run(&[
        "render", "s.toml", "-m", "ppll", "--array", "2", "-o", "i.png",
    ]);
    assert_eq!(answer.code, 0, "{answer}");
    assert!(
        answer
            .err
            .contains("200 of 600 fragments, of 200 pixels, are not in the image"),
        "{answer}"
    );
    assert!(answer.out.contains("local array full"), "{answer}");
    let whole = desk.run(&[
        "render",
        "s.toml",
        "-m",
        "ppll+ppdp",
        "--peel",
        "2",
        "-o",
        "i.png",
    ]);
    assert_eq!(whole.err, "", "{whole}");
}

#[test]
fn render_as_json_has_the_lists_counters() {
    let desk = desk();
    let arguments = [
        "render", "s.toml", "-m", "dfb+ppdp", "--peel", "2", "-o", "i.png", "--json",
    ];
    let object: Value = serde_json::from_str(&desk.result(&arguments)).unwrap();
    assert_eq!(object["records_read"], 2 * 600);
    assert_eq!(object["subpasses"], 2 * 200);
    assert_eq!(object["array_slots_reserved"], 2 * 200);
    assert_eq!(object["bands"], 1);
    assert_eq!(object["lost"], 0);
    // 600 records of 16 bytes; 200 offsets and the scan's 4 and 1, the latter two rounded up to 16 bytes.
    assert_eq!(object["list_bytes"], 600 * 16 + 200 * 4 + 16 + 16);
    // Another method has none of them.
    let object: Value =
        serde_json::from_str(&desk.result(&["render", "s.toml", "-o", "i.png", "--json"])).unwrap();
    assert!(object.get("records_read").is_none(), "{object}");
}

/// 200 pixels with 3 fragments each, and arrays of 8.
#[test]
fn compare_shows_the_lists_counters_of_methods_that_have_them() {
    let desk = desk();
    let out = desk.result(&["compare", "s.toml", "-m", "blend,dfb+ppdp,ppll"]);
    let row = |name: &str| {
        let rows = out.lines().map(|line| line.split_whitespace().collect());
        let mut found = rows.filter(|row: &Vec<_>| row.first() == Some(&name));
        (found.next(), found.next())
    };
    assert!(matches!(row("blend"), (Some(_), None)), "{out}");
    let counters = |name| row(name).1.expect("a second row")[3..].to_vec();
    assert_eq!(counters("dfb+ppdp"), ["600", "200", "1", "1600", "600"]);
    assert_eq!(counters("ppll"), ["600", "200", "1", "12800", "600"]);
    // No lists, no table of them.
    let out = desk.result(&["compare", "s.toml", "-m", "blend"]);
    assert!(!out.contains("fragment lists"), "{out}");
}

#[test]
fn options_of_other_methods_are_refused() {
    for arguments in [
        [
            "render",
            "s.toml",
            "-m",
            "depth-peeling",
            "--array",
            "64",
            "-o",
            "i.png",
        ],
        [
            "render", "s.toml", "-m", "ppll", "--array", "65", "-o", "i.png",
        ],
        [
            "render", "s.toml", "-m", "ppll", "--peels", "3", "-o", "i.png",
        ],
        [
            "render",
            "s.toml",
            "-m",
            "dfb",
            "--termination",
            "2",
            "-o",
            "i.png",
        ],
        [
            "render", "s.toml", "-m", "ffb", "--budget", "0", "-o", "i.png",
        ],
    ] {
        let desk = desk();
        let answer = desk.run(&arguments);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{answer}");
        assert_eq!(desk.files().len(), 1, "{answer}");
    }
}
