//! `onionskin animate`, killed in the middle and repeated: the frames are those of an undisturbed run, and nothing
//! unfinished is left. `onionskin render`, killed at any time, leaves nothing at all.

use std::fs::{self, File, TryLockError};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use crate::kit::cli::Desk;

const FRAMES: usize = 60;

/// Frames that take some ten milliseconds each, so that a kill after the second one comes before the last.
const SCENE: &str = "size = [160, 120]\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\n\
                     [path]\nframes = 60\nrotate = 360\n\
                     [[mesh]]\ngenerate = \"torus-knot\"\nopacity = 0.4\n";

fn desk() -> Desk {
    Desk::new().with("s.toml", SCENE)
}

/// Starts the program, and returns when it has written a frame's row.
fn started(desk: &Desk, frame: usize) -> Child {
    let mut child = Command::new(env!("CARGO_BIN_EXE_onionskin"))
        .current_dir(desk.path("."))
        .args(["animate", "s.toml", "-o", "f"])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    let row = desk.path(&format!("f/frame-{frame:05}.csv"));
    while !row.exists() {
        let ended = child.try_wait().unwrap();
        assert!(ended.is_none(), "it ended without a frame: {ended:?}");
        std::thread::sleep(Duration::from_millis(1));
    }
    child
}

fn kill(mut child: Child) {
    child.kill().unwrap();
    let status = child.wait().unwrap();
    assert!(!status.success(), "it was killed before it ended");
}

fn picture(folder: &Path, frame: usize) -> Vec<u8> {
    fs::read(folder.join(format!("frame-{frame:05}.png"))).unwrap()
}

/// The table without its times, which no run repeats.
fn counts(folder: &Path) -> Vec<Vec<String>> {
    let text = fs::read_to_string(folder.join("frames.csv")).unwrap();
    let row = |line: &str| -> Vec<String> { line.split(',').map(str::to_owned).collect() };
    let mut rows: Vec<_> = text.lines().map(row).collect();
    let ms = rows[0].iter().position(|name| name == "ms").unwrap();
    for row in &mut rows {
        row.remove(ms);
    }
    rows
}

fn unfinished(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    names.filter(|name| name.starts_with('.')).collect()
}

#[test]
fn repeated_it_makes_the_frames_of_an_undisturbed_run_and_leaves_nothing_unfinished() {
    let desk = desk();
    kill(started(&desk, 1));
    let folder = desk.path("f");
    let whole = (0..FRAMES).filter(|n| folder.join(format!("frame-{n:05}.csv")).exists());
    let whole = whole.count();
    assert!(
        (2..FRAMES).contains(&whole),
        "killed in the middle: {whole}"
    );
    assert!(!folder.join("frames.csv").exists());
    // What a kill leaves that comes while a picture is written, and not between two.
    fs::write(folder.join(".onionskin-a1B2c3"), "half a picture").unwrap();
    let answer = desk.result(&["animate", "s.toml", "-o", "f", "--json"]);
    assert!(answer.contains(&format!("\"kept\":{whole}")), "{answer}");
    assert_eq!(unfinished(&folder), [""; 0]);

    desk.result(&["animate", "s.toml", "-o", "undisturbed"]);
    let undisturbed = desk.path("undisturbed");
    assert_eq!(counts(&folder), counts(&undisturbed));
    for frame in 0..FRAMES {
        assert!(
            picture(&folder, frame) == picture(&undisturbed, frame),
            "{frame}"
        );
    }
    assert!(
        picture(&folder, 0) != picture(&folder, 1),
        "the comparison sees a turn"
    );
}

#[test]
fn what_another_command_may_be_writing_is_left_to_the_last_one() {
    let desk = desk();
    desk.result(&["animate", "s.toml", "-o", "f", "--frames", "0..1"]);
    let folder = desk.path("f");
    fs::write(folder.join(".onionskin-a1B2c3"), "another's picture").unwrap();
    // Stands for the other command: that is all that is known of one.
    let other = File::open(folder.join("animation.txt")).unwrap();
    other.lock_shared().unwrap();
    desk.result(&["animate", "s.toml", "-o", "f", "--frames", "1..2"]);
    assert_eq!(unfinished(&folder), [".onionskin-a1B2c3"]);
    drop(other);
    desk.result(&["animate", "s.toml", "-o", "f", "--frames", "2..3"]);
    assert_eq!(unfinished(&folder), [""; 0]);
}

#[test]
fn a_running_command_is_known_by_its_lock_and_a_killed_one_has_none() {
    let desk = desk();
    let child = started(&desk, 0);
    let identity = File::open(desk.path("f/animation.txt")).unwrap();
    let locked = identity.try_lock();
    assert!(
        matches!(locked, Err(TryLockError::WouldBlock)),
        "{locked:?}"
    );
    kill(child);
    identity.try_lock().unwrap();
}

/// Where files may have no name until they are whole: on Linux, and not on every file system.
#[cfg(target_os = "linux")]
#[test]
fn a_killed_render_leaves_the_picture_of_before_or_the_whole_new_one_and_nothing_else() {
    let desk = desk();
    desk.result(&["render", "s.toml", "-o", "p.png"]);
    let whole = fs::read(desk.path("p.png")).unwrap();
    for milliseconds in (0..400).step_by(20) {
        let mut child = Command::new(env!("CARGO_BIN_EXE_onionskin"))
            .current_dir(desk.path("."))
            .args(["render", "s.toml", "-o", "p.png"])
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_millis(milliseconds));
        child.kill().unwrap();
        child.wait().unwrap();
        assert_eq!(desk.names(), ["p.png", "s.toml"]);
        assert!(fs::read(desk.path("p.png")).unwrap() == whole);
    }
}
