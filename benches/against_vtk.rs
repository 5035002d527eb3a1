//! Depth peeling against VTK's own single peeling (`peel`), both without a limit, on the same scenes and the same
//! renderer: the ratio of the medians of frames taken in turns. Says 'skipped' where VTK or its script is absent.
//!
//! `cargo bench --bench against_vtk`

use std::path::{Path, PathBuf};
use std::process::Command;

use onionskin::methods::Stats;
use onionskin::scene::Shading;
use onionskin::{Context, Method, Renderer, Result, Scene};

const TURNS: usize = 3;
const FRAMES: usize = 3;

fn main() -> Result<()> {
    let shared = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let script = shared.join("peer/vtk_peel.py");
    let context = Context::headless()?;
    println!("{}", context.driver().renderer);
    let bundled = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes/molecule.toml");
    for path in [bundled, shared.join("data/bunny.toml")] {
        if !path.exists() {
            println!("skipped: {} is not here", path.display());
            continue;
        }
        match compare(&context, &script, &path)? {
            Some((ours, vtk, stats)) => println!(
                "{}: {} peels, ours {ours:.0} ms, VTK {vtk:.0} ms, ratio {:.2}",
                path.file_name().unwrap_or_default().display(),
                stats.iterations,
                ours / vtk
            ),
            None => println!("skipped: VTK, or {}, is not here", script.display()),
        }
    }
    Ok(())
}

/// Medians in milliseconds, ours and VTK's.
fn compare(context: &Context, script: &Path, path: &PathBuf) -> Result<Option<(f64, f64, Stats)>> {
    let mut scene = Scene::load(path)?;
    // The script renders without lights whatever the scene file says.
    for mesh in &mut scene.meshes {
        mesh.shading = Shading::None;
    }
    let mut renderer = Renderer::new(context, scene.size[0], scene.size[1])?;
    let method = Method::DepthPeeling(Default::default());
    let (mut ours, mut vtk) = (Vec::new(), Vec::new());
    let mut stats = None;
    for _ in 0..TURNS {
        let Some(ms) = vtk_ms(script, path) else {
            return Ok(None);
        };
        vtk.push(ms);
        let frame = renderer.measure(&scene, &method, FRAMES)?;
        ours.push(frame.stats.ms);
        stats = Some(frame.stats);
    }
    Ok(stats.map(|stats| (median(ours), median(vtk), stats)))
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// VTK's own median of as many frames.
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
