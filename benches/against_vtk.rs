//! Depth peeling against VTK's own single peeling (`peel`), both without a limit, on the same scenes and the same
//! renderer. The ratio is that of the medians of frames taken in turns. Layers have 32-bit floats, as here by default,
//! or 8 bits per channel, as in VTK. Prints 'skipped' if VTK or its script is missing.
//!
//! `cargo bench --bench against_vtk [SCENE.toml]`; the bundled molecule and the bunny if no scene is named.

use std::path::{Path, PathBuf};
use std::process::Command;

use onionskin::{Context, Format, Method, Renderer, Result, Scene, Shading, Stats};

const TURNS: usize = 5;
const FRAMES: usize = 5;
const FORMATS: [Format; 2] = [Format::Rgba32F, Format::Rgba8];

fn main() -> Result<()> {
    let shared = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let script = shared.join("peer/vtk_peel.py");
    let context = Context::headless()?;
    println!("{}", context.driver().renderer);
    let bundled = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes/molecule.toml");
    // `cargo bench` adds `--bench` to what the user gives.
    let named = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let paths = match named {
        Some(path) => vec![path.into()],
        None => vec![bundled, shared.join("data/bunny.toml")],
    };
    for path in paths {
        if !path.exists() {
            println!("skipped: {} is not here", path.display());
            continue;
        }
        let Some(Medians { ours, vtk, stats }) = compare(&context, &script, &path)? else {
            println!("skipped: VTK, or {}, is not here", script.display());
            continue;
        };
        print!(
            "{}: {} peels, VTK {vtk:.0} ms",
            path.file_name().unwrap_or_default().display(),
            stats.iterations
        );
        for (format, ms) in FORMATS.into_iter().zip(ours) {
            print!("; {format:?} {ms:.0} ms, ratio {:.2}", ms / vtk);
        }
        println!();
    }
    Ok(())
}

/// Medians in milliseconds, ours for each of [`FORMATS`].
struct Medians {
    ours: Vec<f64>,
    vtk: f64,
    stats: Stats,
}

fn compare(context: &Context, script: &Path, path: &PathBuf) -> Result<Option<Medians>> {
    let mut scene = Scene::load(path)?;
    // The script renders without lights, even if the scene file has them.
    for mesh in &mut scene.meshes {
        mesh.shading = Shading::None;
    }
    let method = Method::DepthPeeling(Default::default());
    let (mut ours, mut vtk) = (vec![Vec::new(); FORMATS.len()], Vec::new());
    let mut stats = None;
    for _ in 0..TURNS {
        let Some(ms) = vtk_ms(script, path) else {
            return Ok(None);
        };
        vtk.push(ms);
        for (format, times) in FORMATS.into_iter().zip(&mut ours) {
            let mut renderer = Renderer::new(context, scene.size[0], scene.size[1])?
                .with_formats(format, Format::Depth32FStencil8);
            let frame = renderer.measure(&scene, &method, FRAMES)?;
            times.push(frame.stats.ms);
            stats = Some(frame.stats);
        }
    }
    Ok(stats.map(|stats| Medians {
        ours: ours.into_iter().map(median).collect(),
        vtk: median(vtk),
        stats,
    }))
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// VTK's median of as many frames.
fn vtk_ms(script: &Path, scene: &Path) -> Option<f64> {
    let output = Command::new("python3")
        .arg(script)
        .arg("--scene")
        .arg(scene)
        .args(["--mode", "peel", "--frames", &FRAMES.to_string()])
        .output()
        .ok()?;
    let answer: serde_json::Value = serde_json::from_slice(&output.stdout).ok()?;
    answer.get("frame_ms_median")?.as_f64()
}
