//! What an exact image costs: the verified painter and other exact methods, as ratios of medians to plain blending into
//! 32-bit float, all from one run at 1024 x 768. The verified painter's sort and upload are part of its frames; those of
//! other methods that sort are not.
//!
//! `cargo bench --bench verified_painter [SCENE.toml ...]`; without scenes, the bundled ones that have surfaces only.

use onionskin::{Context, Method, Renderer, Result, Scene};

const SIZE: [u32; 2] = [1024, 768];
/// The number of frames, or fewer if they do not begin within two seconds.
const FRAMES: usize = 41;
/// Frames of methods that take seconds.
const FEW: usize = 3;

const BUNDLED: [&str; 7] = [
    "sheets64", "quads", "teapot", "knots", "molecule", "slices", "soup",
];
const OTHERS: [(&str, usize); 4] = [
    ("dfb+ppao+ppdp", FRAMES),
    ("dfb", FRAMES),
    ("hybrid-layer-peeling", FEW),
    ("depth-peeling", FEW),
];

fn main() -> Result<()> {
    let context = Context::headless()?;
    println!("on {}", context.driver().renderer);
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?.without_costs();
    // `cargo bench` adds `--bench` to what the user gives.
    let given = std::env::args().skip(1);
    let mut scenes: Vec<String> = given
        .filter(|argument| !argument.starts_with("--"))
        .collect();
    if scenes.is_empty() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
        scenes = BUNDLED.map(|name| format!("{folder}/{name}.toml")).to_vec();
    }
    print!(
        "{:<12} {:>9} {:>9}  {:>16}",
        "scene", "triangles", "marked", "verified-painter"
    );
    println!(
        "{}",
        OTHERS.map(|(name, _)| format!("  {name:>20}")).concat()
    );
    for path in scenes {
        row(&mut renderer, &Scene::load_at(&path, Some(SIZE))?)?;
    }
    Ok(())
}

fn row(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<()> {
    // Plain blending is measured again before each method, because the load of the machine may change meanwhile.
    let mut ratio = |method: &Method, frames: usize| -> Result<_> {
        let blend = renderer.measure(scene, &Method::Blend, FRAMES)?.stats.ms;
        let stats = renderer.measure(scene, method, frames)?.stats;
        Ok((stats.ms / blend, stats))
    };
    let (verified, stats) = ratio(&Method::VerifiedPainter, FRAMES)?;
    let pixels = f64::from(SIZE[0] * SIZE[1]);
    let marked = stats.verified.map_or(0, |counts| counts.marked_pixels);
    print!(
        "{:<12} {:>9} {:>8.2}%  {verified:>16.2}",
        scene.name,
        scene.triangle_count(),
        100.0 * marked as f64 / pixels
    );
    for (name, frames) in OTHERS {
        let (ratio, _) = ratio(&name.parse()?, frames)?;
        print!("  {ratio:>20.2}");
    }
    println!();
    Ok(())
}
