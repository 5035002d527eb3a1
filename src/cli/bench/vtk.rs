//! VTK draws the same scene, frame by frame, in a process of its own that is asked for each frame. So its frames take turns
//! with ours. What it draws is not lit, its layers have 8 bits per channel, and its peeling has no limit.

use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

use onionskin::{Camera, Error, Mesh, Result, Scene};
use serde::{Deserialize, Serialize};

/// VTK's ways to draw what is translucent: in the order of submission, a layer a pass, two layers a pass.
pub(super) const MODES: [&str; 3] = ["alpha", "peel", "dual"];

const SCRIPT: &str = include_str!("vtk_frames.py");
/// For one answer. Importing VTK takes some seconds, and so do a hundred peels of a large scene.
pub(super) const PATIENCE: Duration = Duration::from_secs(120);

/// The process. It ends with this value, and by itself if this program is killed: it reads no more requests then, and every
/// frame of its own has an alarm.
pub(super) struct Vtk {
    child: Child,
    requests: Option<ChildStdin>,
    answers: Receiver<String>,
    patience: Duration,
    pub(super) version: String,
}

/// A frame of VTK's.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub(super) struct Frame {
    pub(super) ms: f64,
    /// How often the first translucent mesh was drawn.
    pub(super) passes: u64,
}

#[derive(Serialize)]
struct Shape {
    vertices: usize,
    triangles: usize,
    opaque: bool,
}

#[derive(Serialize)]
struct Header {
    size: [u32; 2],
    background: [f32; 3],
    meshes: Vec<Shape>,
}

#[derive(Serialize)]
struct View {
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    fov: f64,
    near: f64,
    far: f64,
}

#[derive(Serialize)]
struct Request<'a> {
    mode: &'a str,
    camera: View,
    #[serde(skip_serializing_if = "Option::is_none")]
    picture: Option<PathBuf>,
}

#[derive(Deserialize)]
struct Greeting {
    version: Option<String>,
    error: Option<String>,
}

impl Vtk {
    /// Starts it, and hands it the scene. An answer may take as long as `patience`.
    ///
    /// # Errors
    /// If there is no such Python, if it has no VTK, or if VTK fails.
    pub(super) fn start(python: &Path, scene: &Scene, patience: Duration) -> Result<Self> {
        let mut child = Command::new(python)
            .args(["-c", SCRIPT, &patience.as_secs().max(1).to_string()])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(|error| failed(format!("{} cannot be started: {error}", python.display())))?;
        let output = child.stdout.take();
        let (sender, answers) = channel();
        // The thread ends with the process, whose output ends.
        std::thread::spawn(move || {
            let lines = output
                .into_iter()
                .flat_map(|out| BufReader::new(out).lines());
            for line in lines.map_while(Result::ok) {
                if sender.send(line).is_err() {
                    break;
                }
            }
        });
        let mut vtk = Self {
            requests: child.stdin.take(),
            child,
            answers,
            patience,
            version: String::new(),
        };
        let greeting: Greeting = vtk.answer()?;
        if let Some(error) = greeting.error {
            return Err(failed(error));
        }
        vtk.version = greeting.version.unwrap_or_default();
        vtk.send_scene(scene)?;
        Ok(vtk)
    }

    /// Draws a frame by one of the [`MODES`], and writes it as a PNG picture if a path is given.
    ///
    /// # Errors
    /// If VTK fails, or takes too long.
    pub(super) fn frame(
        &mut self,
        mode: &str,
        camera: &Camera,
        picture: Option<PathBuf>,
    ) -> Result<Frame> {
        let request = Request {
            mode,
            camera: View {
                eye: camera.eye.to_array(),
                target: camera.target.to_array(),
                up: camera.up.to_array(),
                fov: camera.fov,
                near: camera.near,
                far: camera.far,
            },
            picture,
        };
        self.send(&line(&request)?)?;
        self.answer()
    }

    fn send_scene(&mut self, scene: &Scene) -> Result<()> {
        let shape = |mesh: &Mesh| Shape {
            vertices: mesh.vertices.len(),
            triangles: mesh.triangles.len(),
            opaque: mesh.opaque,
        };
        let header = Header {
            size: scene.size,
            background: scene.background,
            meshes: scene.meshes.iter().map(shape).collect(),
        };
        self.send(&line(&header)?)?;
        scene
            .meshes
            .iter()
            .try_for_each(|mesh| self.send(&numbers(mesh)))
    }

    fn send(&mut self, bytes: &[u8]) -> Result<()> {
        let requests = self.requests.as_mut();
        let sent =
            requests.map(|requests| requests.write_all(bytes).and_then(|()| requests.flush()));
        match sent {
            Some(Ok(())) => Ok(()),
            _ => Err(failed("its process has ended".into())),
        }
    }

    fn answer<T: for<'a> Deserialize<'a>>(&mut self) -> Result<T> {
        let line = self.answers.recv_timeout(self.patience).map_err(|error| {
            failed(match error {
                RecvTimeoutError::Timeout => {
                    format!("no answer in {} seconds", self.patience.as_secs())
                }
                RecvTimeoutError::Disconnected => "its process has ended".into(),
            })
        })?;
        serde_json::from_str(&line).map_err(|_| failed(format!("it answered '{line}'")))
    }
}

impl Drop for Vtk {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn failed(answer: String) -> Error {
    Error::usage(
        format!("VTK: {answer}"),
        "name a Python that has VTK (pip install vtk) with --python, or leave VTK out with --no-vtk",
    )
}

fn line(value: &impl Serialize) -> Result<Vec<u8>> {
    let mut line = serde_json::to_vec(value).map_err(|error| failed(error.to_string()))?;
    line.push(b'\n');
    Ok(line)
}

/// A mesh's positions, colours and triangles in the script's form.
fn numbers(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(16 * mesh.vertices.len() + 24 * mesh.triangles.len());
    for vertex in &mesh.vertices {
        let position = vertex.position.as_vec3().to_array();
        bytes.extend(position.into_iter().flat_map(f32::to_ne_bytes));
    }
    let byte = |value: f32| (value.clamp(0.0, 1.0) * 255.0).round() as u8;
    for vertex in &mesh.vertices {
        let color = vertex.color;
        bytes.extend([color.r, color.g, color.b, color.a].map(byte));
    }
    let corners = mesh.triangles.iter().flatten();
    bytes.extend(corners.flat_map(|&corner| i64::from(corner).to_ne_bytes()));
    bytes
}

#[cfg(all(test, unix))]
mod tests {
    use std::os::unix::fs::PermissionsExt;
    use std::time::Instant;

    use super::*;

    /// What a program in Python's place is answered with, and whether it is still running.
    fn started(script: &str) -> (String, bool) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("python");
        let number = folder.path().join("number");
        let text = format!("#!/bin/sh\necho $$ > {}\n{script}\n", number.display());
        std::fs::write(&path, text).unwrap();
        std::fs::set_permissions(&path, PermissionsExt::from_mode(0o700)).unwrap();
        let scene = Scene::of("nothing", Vec::new());
        let answer = Vtk::start(&path, &scene, Duration::from_secs(1));
        let error = answer.err().map(|error| error.to_string());
        let number = std::fs::read_to_string(number).unwrap();
        let runs = Path::new("/proc").join(number.trim()).exists();
        (error.unwrap_or_default(), runs)
    }

    #[test]
    fn a_program_that_does_not_answer_is_killed_after_a_time() {
        let begun = Instant::now();
        let (error, runs) = started("exec sleep 1000");
        assert!(error.contains("no answer in 1 seconds"), "{error}");
        assert!(!runs);
        assert!(begun.elapsed() < Duration::from_secs(100));
    }

    #[test]
    fn a_program_that_ends_or_answers_nonsense_is_an_error() {
        let (error, runs) = started("exit 3");
        assert!(error.contains("its process has ended") && !runs, "{error}");
        let (error, runs) = started("echo peels; exec sleep 1000");
        assert!(error.contains("it answered 'peels'") && !runs, "{error}");
        let (error, runs) = started("echo '{\"error\": \"no VTK\"}'; exec sleep 1000");
        assert!(error.contains("VTK: no VTK") && !runs, "{error}");
    }

    #[test]
    fn vtk_draws_what_it_is_given() {
        use onionskin::{Fragment, Image, Rgba, composite, generate};
        let quads = generate::Quads {
            count: 3,
            size: [2.0, 2.0],
            alpha: 0.5,
            order: generate::SubmissionOrder::FrontToBack,
            ..Default::default()
        };
        let mut scene = Scene::of("quads", vec![generate::quads(&quads).unwrap()]);
        scene.size = [64, 48];
        scene.camera = Camera::looking([0.0, 0.0, 6.0].into(), [0.0; 3].into());
        scene.background = [1.0; 3];
        let mut vtk = match Vtk::start(Path::new("python3"), &scene, PATIENCE) {
            Ok(vtk) => vtk,
            Err(error) => return println!("skipped: {error}"),
        };
        let folder = tempfile::tempdir().unwrap();
        let mut middle = |mode: &str| {
            let path = folder.path().join(mode).with_extension("png");
            vtk.frame(mode, &scene.camera, Some(path.clone())).unwrap();
            let pixel = Image::load(&path).unwrap().pixel(32, 24);
            [pixel.r, pixel.g, pixel.b]
        };
        // The nearest quad is submitted first, and alpha blends the last one over all others.
        let sheets = [0, 4, 8].map(|corner| scene.meshes[0].vertices[corner].color);
        let composited = |depths: [f32; 3]| {
            let mut fragments: Vec<Fragment> = (0..)
                .zip(depths.into_iter().zip(sheets))
                .map(|(order, (depth, color))| Fragment {
                    depth,
                    color,
                    order,
                })
                .collect();
            composite(&mut fragments, 1.0, Rgba::opaque([1.0; 3]))
        };
        let (right, as_submitted) = (composited([0.1, 0.2, 0.3]), composited([0.3, 0.2, 0.1]));
        let apart = |pixel: [f32; 3], expected: [f64; 4]| {
            let differences = pixel.into_iter().zip(expected);
            differences
                .map(|(a, b)| (f64::from(a) - b).abs())
                .fold(0.0, f64::max)
        };
        // Half a step of 8 bits for each colour that is handed over, and for each of three sheets that are blended.
        let bound = 4.0 * 0.5 / 255.0;
        for (mode, expected, other) in [
            ("alpha", as_submitted, right),
            ("peel", right, as_submitted),
            ("dual", right, as_submitted),
        ] {
            let pixel = middle(mode);
            assert!(
                apart(pixel, expected) <= bound,
                "{mode}: {pixel:?}, not {expected:?}"
            );
            assert!(apart(pixel, other) > 0.05, "{mode}: {pixel:?} says nothing");
        }
    }

    #[test]
    fn no_program_is_an_error() {
        let scene = Scene::of("nothing", Vec::new());
        let answer = Vtk::start(Path::new("/no/python"), &scene, PATIENCE);
        let error = answer.err().unwrap().to_string();
        assert!(error.contains("/no/python cannot be started"), "{error}");
    }
}
