//! What fuzzing has found: each file once made a reader panic, hang or take too much memory. Now each is read, or refused
//! with words, by the reader that its folder is named after. `tests/fuzz/run` looks for more.

use crate::kit;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::mpsc;
use std::time::Duration;

use crate::kit::scene::Folder;
use onionskin::{Error, Image, MemoryLimit};

/// Not a bound on speed: what hangs has no end, and this says so instead of hanging with it.
const LONG: Duration = Duration::from_secs(60);

/// A file of each reader, as the fuzz targets of the same names give them to it.
fn read(target: &str, bytes: &[u8]) -> Result<(), Error> {
    let volume = |name: &str| {
        let look = "transfer = [{ value = 0, color = [1, 1, 1], density = 1 }]";
        let scene = format!("[[volume]]\nfile = \"{name}\"\n{look}\n");
        Folder::new().with("scene.toml", scene)
    };
    let scene = |folder: Folder, name: &str| folder.load(name).map(drop);
    match target {
        "nrrd" | "vti" => {
            let name = format!("v.{target}");
            scene(volume(&name).with(&name, bytes), "scene.toml")
        }
        "nifti" => scene(volume("v.nii").with("v.nii", bytes), "scene.toml"),
        "nhdr" => {
            let (head, data) = in_two(bytes);
            let folder = volume("v.nhdr").with("v.nhdr", head).with("v.raw", data);
            scene(folder, "scene.toml")
        }
        "pvti" => {
            let (head, piece) = in_two(bytes);
            let folder = volume("v.pvti").with("v.pvti", head).with("a.vti", piece);
            scene(folder, "scene.toml")
        }
        "toml" => {
            let model = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
            let folder = Folder::new().with("model.obj", model);
            scene(folder.with("scene.toml", bytes), "scene.toml")
        }
        "obj" => {
            let folder = Folder::new().with("model.mtl", "newmtl red\nKd 1 0 0\nd 0.5\n");
            scene(folder.with("model.obj", bytes), "model.obj")
        }
        "mtl" => {
            let model = "mtllib model.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
            let folder = Folder::new().with("model.obj", model);
            scene(folder.with("model.mtl", bytes), "model.obj")
        }
        "png" | "exr" => {
            let name = format!("picture.{target}");
            let folder = Folder::new().with(&name, bytes);
            Image::load_within(folder.path(&name), &MemoryLimit::of(400 << 20)).map(drop)
        }
        other => panic!("there is no reader '{other}'"),
    }
}

/// Up to the first empty line, and what comes after it.
fn in_two(bytes: &[u8]) -> (&[u8], &[u8]) {
    let end = bytes.windows(2).position(|pair| pair == b"\n\n");
    bytes.split_at(end.map_or(bytes.len(), |end| end + 2))
}

fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

#[test]
fn whatever_was_found_is_read_or_refused_with_words() {
    let findings = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz_findings");
    let mut tried = 0;
    for folder in files_in(&findings) {
        let target = folder.file_name().unwrap().to_string_lossy().into_owned();
        for path in files_in(&folder) {
            let bytes = fs::read(&path).unwrap();
            let (send, receive) = mpsc::channel();
            let target = target.clone();
            std::thread::spawn(move || {
                let refused = read(&target, &bytes).map_err(|error| error.to_string());
                // Nobody may be waiting any more.
                let _ = send.send(refused);
            });
            match receive.recv_timeout(LONG) {
                Ok(Ok(())) => {}
                Ok(Err(words)) => assert!(words.len() > 20, "{}: {words}", path.display()),
                Err(error) => panic!("{}: it panicked or has no end ({error})", path.display()),
            }
            tried += 1;
        }
    }
    assert!(tried > 0, "there are no findings in {}", findings.display());
}

#[test]
fn the_targets_readers_read_what_is_good() {
    let model = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    assert!(read("obj", model).is_ok());
    assert!(read("obj", b"v 0 0\n").is_err());
    assert!(read("toml", b"[[mesh]]\nfile = \"model.obj\"\n").is_ok());
    let head = kit::volume::nrrd_head("uchar", "raw", "little", "");
    let nrrd = [head.as_bytes(), b"\n", &[0; 24]].concat();
    assert!(read("nrrd", &nrrd).is_ok());
    let head = format!("{head}data file: v.raw\n");
    let nhdr = [head.as_bytes(), b"\n", &[0; 24]].concat();
    assert!(read("nhdr", &nhdr).is_ok());
}
