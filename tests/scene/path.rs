//! Camera paths: where the eye is, what is shown, and what is refused.

use glam::DVec3;
use onionskin::{Animation, Error};

const SCENE: &str = "size = [8, 8]\n[camera]\neye = [0, 0, 4]\ntarget = [0, 0, 0]\n\
                     [[mesh]]\ngenerate = \"quads\"\nname = \"sheets\"\n\
                     [[mesh]]\ngenerate = \"cone\"\nname = \"cone\"\n\
                     [[volume]]\ngenerate = \"ball\"\nname = \"fog\"\n\
                     transfer = [{ value = 0, color = [1, 1, 1], density = 1 }]\n";

fn load(path: &str) -> Result<Animation, Error> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("s.toml");
    std::fs::write(&file, format!("{SCENE}{path}")).unwrap();
    Animation::load(&file)
}

#[test]
fn a_quarter_of_a_turn_takes_the_eye_from_z_to_x() {
    let animation = load("[path]\nframes = 8\nrotate = 360\n").unwrap();
    let eye = |frame| animation.frame(frame).unwrap().camera.eye;
    assert_eq!(eye(0), animation.scene.camera.eye);
    // Sines and cosines of multiples of pi / 4 in f64.
    assert!(eye(2).distance(DVec3::new(4.0, 0.0, 0.0)) < 1e-12);
    assert!(eye(4).distance(DVec3::new(0.0, 0.0, -4.0)) < 1e-12);
}

#[test]
fn a_dolly_goes_in_and_back_on_a_line() {
    let animation = load("[path]\nframes = 20\ndolly = 0.25\ndolly_frames = 10\n").unwrap();
    let eyes = [0, 5, 10, 15].map(|frame| animation.frame(frame).unwrap().camera.eye.z);
    for (eye, expected) in eyes.into_iter().zip([4.0, 1.0, 4.0, 1.0]) {
        assert!((eye - expected).abs() < 1e-12, "{eyes:?}");
    }
    let near = animation.frame(5).unwrap().camera;
    near.check().unwrap();
    assert!(near.near < 1.0, "fitted anew: {near:?}");
}

#[test]
fn from_a_frame_on_only_the_named_sources_are_shown() {
    let animation = load(
        "[path]\nframes = 30\n[[path.show]]\nfrom = 10\nsources = [\"fog\"]\n\
         [[path.show]]\nfrom = 20\nsources = [\"cone\", \"sheets\"]\n",
    )
    .unwrap();
    let shown = |frame| {
        let scene = animation.frame(frame).unwrap();
        (scene.meshes.len(), scene.volumes.len())
    };
    let all = [0, 9, 10, 19, 20, 29].map(shown);
    assert_eq!(all, [(2, 1), (2, 1), (0, 1), (0, 1), (2, 0), (2, 0)]);
    assert!(animation.frame(30).is_err());
    assert_eq!(animation.spans(0..30), [0..10, 10..20, 20..30]);
    assert_eq!(animation.spans(5..12), [5..10, 10..12]);
    assert_eq!(animation.spans(12..12), []);
}

#[test]
fn a_frame_s_camera_is_that_of_its_scene() {
    let animation = load("[path]\nframes = 5\nrotate = 90\ndolly = 0.5\n").unwrap();
    for frame in 0..5 {
        let scene = animation.frame(frame).unwrap();
        assert_eq!(animation.camera(frame).unwrap(), scene.camera);
    }
    assert!(animation.camera(5).is_err());
    let spans = animation.spans(0..5);
    assert!(spans.into_iter().eq(std::iter::once(0..5)));
}

#[test]
fn the_fingerprint_changes_with_what_is_seen_and_with_nothing_else() {
    let of = |path: &str| load(path).unwrap().fingerprint();
    let first = of("[path]\nframes = 8\n");
    assert_eq!(of("# a comment\n[path]\nframes = 8\n"), first);
    assert_ne!(of("[path]\nframes = 9\n"), first);
    assert_ne!(
        of("[path]\nframes = 8\n[[mesh]]\ngenerate = \"plane\"\n"),
        first
    );
}

#[test]
fn a_file_without_a_path_turns_once() {
    let animation = load("").unwrap();
    assert!(!animation.has_path);
    assert_eq!((animation.path.frames, animation.path.rotate), (36, 360.0));
}

#[test]
fn what_is_wrong_with_a_path_is_said() {
    let cases = [
        ("[path]\nframe = 8\n", "Did you mean 'frames'?"),
        ("[path]\nframes = 0\n", "`frames` is out of range"),
        ("[path]\ndolly = 0\n", "`dolly` is out of range"),
        (
            "[path]\ndolly_frames = 1\n",
            "`dolly_frames` is out of range",
        ),
        ("[path]\nrotate = nan\n", "`rotate` is out of range"),
        (
            "[[path.show]]\nfrom = 1\nsources = [\"fig\"]\n",
            "Did you mean \"fog\"?",
        ),
        (
            "[[path.show]]\nfrom = 1\nsources = [1]\n",
            "a list of texts",
        ),
        ("[[path.show]]\nsources = [\"fog\"]\n", "`from` is missing"),
        ("[[path.show]]\nfrom = 1\n", "`sources` is missing"),
        (
            "[[path.show]]\nfrom = 2\nsources = []\n[[path.show]]\nfrom = 2\nsources = []\n",
            "order of their frames",
        ),
    ];
    for (path, says) in cases {
        let error = load(path).unwrap_err().to_string();
        assert!(error.contains(says), "{path}: {error}");
    }
}
