//! `onionskin animate`: whole frames, kept frames, several commands in one folder, and what is refused.

use std::fs;

use serde_json::Value;

use crate::kit::cli::Desk;

const SHEETS: &str = "size = [20, 10]\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\nfov = 20\n\
                      [path]\nframes = 4\nrotate = 360\n\
                      [[mesh]]\ngenerate = \"quads\"\ncount = 3\nsize = [9, 9]\n";

fn desk() -> Desk {
    Desk::new().with("s.toml", SHEETS)
}

fn table(desk: &Desk) -> Vec<Vec<String>> {
    let text = fs::read_to_string(desk.path("f/frames.csv")).unwrap();
    let cells = |line: &str| line.split(',').map(str::to_owned).collect();
    text.lines().map(cells).collect()
}

fn animate(desk: &Desk, more: &[&str]) -> Value {
    let arguments = [&["animate", "s.toml", "-o", "f", "--json"], more].concat();
    serde_json::from_str(&desk.result(&arguments)).unwrap()
}

#[test]
fn every_frame_has_a_picture_and_a_row_and_is_the_one_that_render_makes() {
    let desk = desk();
    let done = animate(&desk, &[]);
    assert_eq!((&done["rendered"], &done["kept"]), (&4.into(), &0.into()));
    let table = table(&desk);
    assert_eq!(table.len(), 5);
    assert_eq!(
        table[0][..5],
        ["frame", "ms", "covered", "fragments", "max"]
    );
    assert_eq!(table[1][0], "0");
    assert_eq!(table[1][2..6], ["200", "600", "3", "3"]);
    assert!(table.iter().all(|row| row.len() == table[0].len()));
    desk.result(&["render", "s.toml", "-o", "r.png"]);
    let files = ["r.png", "f/frame-00000.png", "f/frame-00003.png"];
    let [render, first, last] = files.map(|name| fs::read(desk.path(name)).unwrap());
    assert!(render == first, "frame 0 is the scene's own view");
    assert!(render != last, "the camera has turned");
}

#[test]
fn what_is_whole_is_kept_and_what_is_not_is_rendered_again() {
    let desk = desk();
    animate(&desk, &[]);
    let before = fs::read(desk.path("f/frame-00002.csv")).unwrap();
    // As an interruption leaves it: the picture is there, its row is not; and a frame that is not there at all.
    fs::remove_file(desk.path("f/frame-00001.csv")).unwrap();
    fs::remove_file(desk.path("f/frame-00003.csv")).unwrap();
    fs::remove_file(desk.path("f/frame-00003.png")).unwrap();
    let done = animate(&desk, &[]);
    assert_eq!((&done["rendered"], &done["kept"]), (&2.into(), &2.into()));
    assert!(before == fs::read(desk.path("f/frame-00002.csv")).unwrap());
    assert_eq!(table(&desk).len(), 5);
}

#[test]
fn two_commands_at_a_time_fill_one_folder() {
    let desk = desk();
    std::thread::scope(|scope| {
        for range in ["0..2", "2..4"] {
            let desk = &desk;
            scope.spawn(move || animate(desk, &["--frames", range]));
        }
    });
    let numbers: Vec<String> = table(&desk).into_iter().map(|row| row[0].clone()).collect();
    assert_eq!(numbers, ["frame", "0", "1", "2", "3"]);
}

#[test]
fn without_a_path_it_says_that_it_takes_the_default_one() {
    let (scene, _) = SHEETS.split_once("[path]").unwrap();
    let mesh = SHEETS.split_once("[[mesh]]").unwrap().1;
    let desk = Desk::new().with("s.toml", format!("{scene}[[mesh]]{mesh}"));
    let answer = desk.run(&["animate", "s.toml", "-o", "f", "--frames", "34..36"]);
    assert_eq!(answer.code, 0, "{answer}");
    let note = "note: s.toml has no [path]: the camera turns once, in 36 frames\n";
    assert_eq!(answer.err, note);
}

#[test]
fn frames_of_something_else_are_not_mixed_in() {
    let desk = desk();
    animate(&desk, &["--frames", "0..1"]);
    let refused = |desk: &Desk, more: &[&str], says: &str| {
        let before = fs::read_dir(desk.path("f")).unwrap().count();
        desk.refused(&[&["animate", "s.toml", "-o", "f"], more].concat())
            .says(&[says, "another folder"]);
        assert_eq!(fs::read_dir(desk.path("f")).unwrap().count(), before);
    };
    refused(&desk, &["--size", "10x10"], "another scene");
    refused(&desk, &["-m", "painter"], "another method");
    refused(&desk, &["--srgb"], "another encoding");
    let changed = desk.with("s.toml", SHEETS.replace("count = 3", "count = 2"));
    refused(&changed, &[], "another scene");
}

#[test]
fn wrong_arguments_are_refused_before_anything_is_written() {
    let desk = desk();
    let refused = |more: &[&str], says: &str| {
        desk.refused(&[&["animate", "s.toml"], more].concat())
            .says(&[says]);
    };
    refused(&["-o", "f", "--frames", "2..9"], "within 0..4");
    refused(&["-o", "f", "--frames", "3..3"], "not a range of frames");
    refused(&["-o", "f", "--frames", "x"], "not a range of frames");
    refused(&["-o", "no/where"], "cannot write no/where");
    refused(&["-o", "s.toml"], "cannot write s.toml");
    refused(&["-o", "f", "--layers"], "no place for layers");
}
