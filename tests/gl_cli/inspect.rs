//! `onionskin inspect`, on the command line.

use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::kit::cli::Desk;

/// Three sheets before each other over the whole picture, the second and the third at the same depth.
const SHEETS: &str = "size = [20, 10]\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\nfov = 20\n\
                      [[mesh]]\ngenerate = \"quads\"\ncount = 3\ndepths = [0.0, 0.5, 0.5]\norder = \"front-to-back\"\nsize = [9, 9]\n";

fn desk() -> Desk {
    Desk::new().with("s.toml", SHEETS)
}

fn object(desk: &Desk, more: &[&str]) -> Value {
    let arguments = [&["inspect", "s.toml", "--json"], more].concat();
    serde_json::from_str(&desk.result(&arguments)).unwrap()
}

fn fates(object: &Value) -> Vec<&str> {
    let fragments = object["fragments"].as_array().unwrap().iter();
    fragments
        .map(|fragment| fragment["fate"]["is"].as_str().unwrap())
        .collect()
}

#[test]
fn the_table_tells_of_every_fragment_and_pass_and_fits_80_columns() {
    let text = desk().result(&["inspect", "s.toml", "--pixel", "3,4", "-m", "depth-peeling"]);
    for part in [
        "pixel       3, 4 of 20 x 10, from the top left",
        "fragments   3: 2 composited, 1 lost",
        "OpenGL and the emulated pixel agree after",
        "LOST to s1",
        "pass 2  peel:",
        "Everitt 2001, Listing 1",
        "<- part",
    ] {
        assert!(text.contains(part), "no '{part}' in {text}");
    }
    let longest = text.lines().map(|line| line.chars().count()).max().unwrap();
    assert!(longest <= 80, "{longest}: {text}");
    let lines = [
        "inspect",
        "s.toml",
        "--pixel",
        "3,4",
        "-m",
        "depth-peeling",
        "--lines",
    ];
    let with_lines = desk().result(&lines);
    assert!(with_lines.contains("  p enable depth test"), "{with_lines}");
}

#[test]
fn json_has_what_the_table_has() {
    let desk = desk();
    let peeled = object(&desk, &["--pixel", "3,4", "-m", "depth-peeling"]);
    assert_eq!(fates(&peeled), ["composited", "composited", "tied"]);
    assert_eq!(peeled["fragments"][2]["fate"]["with"], 1);
    assert_eq!(peeled["fragments"][0]["mesh"], "quads");
    assert_eq!(peeled["parts_at"], 2);
    assert_eq!(peeled["agree"], true);
    assert_eq!(peeled["pixel"], serde_json::json!([3, 4]));
    let exact = object(&desk, &["--pixel", "3,4", "-m", "layer-peeling"]);
    assert_eq!(fates(&exact), ["composited"; 3]);
    assert_eq!(exact["parts_at"], Value::Null);
}

#[test]
fn rows_may_be_counted_from_the_bottom() {
    let object = object(&desk(), &["--pixel", "3,4", "--bottom-up", "-m", "blend"]);
    assert_eq!(object["pixel"], serde_json::json!([3, 5]));
}

#[test]
fn a_pixel_is_found_by_what_happens_there() {
    let desk = desk();
    let lost = object(&desk, &["--where", "lost", "-m", "depth-peeling"]);
    assert_eq!(fates(&lost), ["composited", "composited", "tied"]);
    let tied = object(&desk, &["--where", "tied", "-m", "layer-peeling"]);
    assert_eq!(tied["fragments"][1]["depth"], tied["fragments"][2]["depth"]);
    let marked = object(&desk, &["--where", "marked", "-m", "verified-painter"]);
    assert_eq!(fates(&marked), ["composited"; 3]);
    assert_eq!(marked["marked"], true);
    let apart = Desk::new().with("s.toml", SHEETS.replace("0.5, 0.5]", "0.5, 0.75]"));
    let proved = object(&apart, &["--pixel", "3,4", "-m", "verified-painter"]);
    assert_eq!(proved["marked"], false);
    let peeled = object(&apart, &["--pixel", "3,4", "-m", "layer-peeling"]);
    assert_eq!(peeled["marked"], Value::Null);
    assert_eq!(
        object(&desk, &["--deepest"])["fragments"]
            .as_array()
            .unwrap()
            .len(),
        3
    );
    let worst = object(&desk, &["--worst", "-m", "blend"]);
    assert!(worst["error"].as_f64().unwrap() > 0.01);
    desk.refused(&[
        "inspect",
        "s.toml",
        "--where",
        "lost",
        "-m",
        "layer-peeling",
    ])
    .says(&["no such pixel was found", "belongs in the image"]);
    desk.refused(&["inspect", "s.toml", "--worst", "-m", "layer-peeling"])
        .says(&["exact at every pixel"]);
    desk.refused(&["inspect", "s.toml", "--where", "marked", "-m", "blend"])
        .says(&["blend marks no pixels", "verified-painter"]);
}

#[test]
fn a_pixel_without_fragments_says_so() {
    let desk = desk().with(
        "small.toml",
        SHEETS.replace("size = [9, 9]", "size = [0.1, 0.1]"),
    );
    let text = desk.result(&[
        "inspect",
        "small.toml",
        "--pixel",
        "0,0",
        "-m",
        "layer-peeling",
    ]);
    assert!(
        text.contains("none: the pixel shows the background"),
        "{text}"
    );
    let opaque = desk.with("opaque.toml", SHEETS.to_owned() + "alpha = 1.0\n");
    let text = opaque.result(&[
        "inspect",
        "opaque.toml",
        "--pixel",
        "0,0",
        "-m",
        "depth-peeling",
    ]);
    assert!(text.contains("1 opaque, 2 hidden"), "{text}");
    opaque
        .refused(&["inspect", "opaque.toml", "--deepest"])
        .says(&["no pixel has a transparent fragment"]);
}

#[test]
fn what_cannot_be_inspected_is_refused_with_a_remedy() {
    let desk = desk();
    for (arguments, parts) in [
        (vec!["--pixel", "20,0"], vec!["no pixel 20,0", "0 to 19"]),
        (
            vec!["--pixel", "0,10", "--bottom-up"],
            vec!["no pixel 0,10"],
        ),
        (vec!["--pixel", "7"], vec!["'7' is not a pixel", "320,200"]),
        (vec!["--pixel", "-1,2"], vec!["'-1,2'"]),
        (vec![], vec!["--pixel"]),
        (
            vec!["--pixel", "1,1", "--worst"],
            vec!["cannot be used with"],
        ),
        (vec!["--pixel", "1,1", "-m", "exact"], vec!["exact"]),
        (vec!["--pixel", "1,1", "--html", "page.pdf"], vec![".html"]),
        (
            vec!["--pixel", "1,1", "--html", "nowhere/page.html"],
            vec!["nowhere"],
        ),
    ] {
        desk.refused(&[&["inspect", "s.toml"], &arguments[..]].concat())
            .says(&parts);
    }
}

#[test]
fn the_page_steps_by_the_keyboard_without_a_console_error() {
    let desk = desk();
    let arguments = ["inspect", "s.toml", "--pixel", "3,4", "-m", "depth-peeling"];
    desk.result(&[&arguments[..], &["--html", "page.html"]].concat());
    let page = std::fs::read_to_string(desk.path("page.html")).unwrap();
    assert!(!page.contains("http"), "it loads nothing");
    let Some(browser) = browser() else {
        println!("SKIPPED: there is no Chromium to open the page in");
        return;
    };
    let press = |key: &str| {
        format!("document.dispatchEvent(new KeyboardEvent('keydown',{{key:'{key}'}}));")
    };
    let shown = "[...document.querySelectorAll('article')].findIndex(it => it.classList.contains('current'))";
    let told = |keys: &[&str]| {
        let keys: String = keys.iter().map(|key| press(key)).collect();
        let script = format!("<script>{keys}document.title = 'shows ' + {shown};</script></body>");
        let path = desk.path("stepped.html");
        std::fs::write(&path, page.replace("</body>", &script)).unwrap();
        let (text, errors) = opened(&browser, &path);
        assert!(errors.is_empty(), "{errors}");
        let title = text.split_once("<title>").unwrap().1;
        title.split_once("</title>").unwrap().0.to_owned()
    };
    let passes = page.matches("<article").count() - 1;
    assert_eq!(told(&[]), "shows 0");
    assert_eq!(told(&["ArrowRight", "ArrowRight", "ArrowLeft"]), "shows 1");
    assert_eq!(told(&["ArrowLeft"]), "shows 0");
    assert_eq!(told(&["End"]), format!("shows {passes}"));
    // A fault of a script would be noticed.
    let broken = desk.path("broken.html");
    std::fs::write(
        &broken,
        page.replace("</body>", "<script>fault();</script></body>"),
    )
    .unwrap();
    assert!(opened(&browser, &broken).1.contains("fault is not defined"));
}

/// A Chromium, if there is one.
fn browser() -> Option<String> {
    let names = ["chromium", "chromium-browser", "google-chrome"];
    let runs = |name: &&str| {
        let version = Command::new(name).arg("--version").output();
        version.is_ok_and(|output| output.status.success())
    };
    names.into_iter().find(runs).map(str::to_owned)
}

/// A page's document after its scripts, and its console's errors.
fn opened(browser: &str, path: &Path) -> (String, String) {
    let profile = tempfile::tempdir().unwrap();
    let output = Command::new(browser)
        .args(["--headless", "--no-sandbox", "--disable-gpu", "--dump-dom"])
        .args(["--enable-logging=stderr", "--v=0"])
        .arg(format!("--user-data-dir={}", profile.path().display()))
        .arg(format!("file://{}", path.display()))
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8_lossy(bytes).into_owned();
    let log = text(&output.stderr);
    let console: Vec<_> = log
        .lines()
        .filter(|line| line.contains("CONSOLE"))
        .collect();
    (text(&output.stdout), console.join("\n"))
}
