//! The costs of A-buffers, as ratios of medians from one run at 1024 x 768: to plain blending into 32-bit float, to
//! depth peeling, and of ppAO and ppDP to the static array, beside the gains of the paper's GPUs (section 7).
//!
//! `cargo bench --bench a_buffer [SCENE.toml ...]`; without scenes, figure 7's 64 quads, a generated mesh and the molecule.

use onionskin::generate::{TorusKnot, torus_knot};
use onionskin::options::{ABufferOptions, ArraySort, Fill, Manager};
use onionskin::{Context, Method, Renderer, Result, Rgba, Scene};

const SIZE: [u32; 2] = [1024, 768];
/// The number of frames, or fewer if they do not begin within two seconds.
const FRAMES: usize = 41;

/// How many times faster than the static array ppAO and ppDP are in the paper: on the 64 quads, where ppAO "approaches"
/// it,
const QUADS_GAIN: [f64; 2] = [1.0, 3.6];
/// and on average over its scenes and GPUs.
const MEAN_GAIN: [f64; 2] = [3.0, 8.0];

fn main() -> Result<()> {
    let context = Context::headless()?;
    println!("{}", context.driver().renderer);
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?.without_costs();

    // `cargo bench` adds `--bench` to what the user gives.
    let scenes: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with("--"))
        .collect();
    for path in &scenes {
        let scene = Scene::load_at(path, Some(SIZE))?;
        table(&mut renderer, &scene.name, &scene, MEAN_GAIN)?;
    }
    if !scenes.is_empty() {
        return Ok(());
    }
    let quads = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes/sheets64.toml");
    table(
        &mut renderer,
        "figure 7's 64 quads",
        &Scene::load_at(quads, Some(SIZE))?,
        QUADS_GAIN,
    )?;
    table(
        &mut renderer,
        "a mesh of 100 000 triangles",
        &mesh()?,
        MEAN_GAIN,
    )?;
    let molecule = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes/molecule.toml");
    table(
        &mut renderer,
        "the molecule",
        &Scene::load_at(molecule, Some(SIZE))?,
        MEAN_GAIN,
    )
}

/// A winding tube of 100 000 triangles.
fn mesh() -> Result<Scene> {
    let knot = torus_knot(&TorusKnot {
        p: 5,
        q: 8,
        radius: 1.0,
        winding: 0.5,
        tube: 0.16,
        segments: 1563,
        sides: 32,
    })?;
    let mut scene = Scene::of("knot", vec![knot.painted(Rgba::new(0.8, 0.5, 0.2, 0.4))]);
    scene.size = SIZE;
    Ok(scene)
}

fn table(
    renderer: &mut Renderer<'_>,
    name: &str,
    scene: &Scene,
    [pp_ao_gain, pp_dp_gain]: [f64; 2],
) -> Result<()> {
    let complexity = renderer.complexity(scene, Default::default())?;
    println!(
        "\n{name}: {} triangles, {} fragments, {} layers at most, {} in the median of the covered pixels",
        scene.triangle_count(),
        complexity.fragments(),
        complexity.max(),
        complexity.percentile(0.5)
    );
    // Plain blending is measured again before each method, because the load of the machine may change meanwhile.
    let mut ratio = |method: &Method| -> Result<f64> {
        let blend = renderer.measure(scene, &Method::Blend, FRAMES)?.stats.ms;
        Ok(renderer.measure(scene, method, FRAMES)?.stats.ms / blend)
    };
    let peeling = ratio(&Method::DepthPeeling(Default::default()))?;
    println!("{:<34} {peeling:>7.1} of plain blending", "depth peeling");
    for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
        let mut of_static = None;
        for (pp_ao, pp_dp) in [(false, false), (true, false), (false, true), (true, true)] {
            let options = ABufferOptions {
                manager,
                pp_ao,
                pp_dp,
                ..ABufferOptions::default()
            };
            let here = ratio(&Method::ABuffer(options))?;
            let base = *of_static.get_or_insert(here);
            let of_paper = match (pp_ao, pp_dp) {
                (true, false) => format!(" (the paper's {pp_ao_gain})"),
                (false, true) => format!(" (the paper's {pp_dp_gain})"),
                _ => String::new(),
            };
            println!(
                "{:<34} {here:>7.1} of plain blending, {:6.1} times faster than peeling, {:5.2} times than \
                 static{of_paper}",
                Method::ABuffer(options).to_string(),
                peeling / here,
                base / here
            );
        }
        for (what, fill, sort) in [
            ("atomics", Fill::Atomics, ArraySort::Automatic),
            ("insertion sort", Fill::Automatic, ArraySort::Insertion),
            ("network", Fill::Automatic, ArraySort::Network),
        ] {
            let options = ABufferOptions {
                manager,
                fill,
                sort,
                ..ABufferOptions::default()
            };
            let here = ratio(&Method::ABuffer(options))?;
            let name = format!("{}, {what}", Method::ABuffer(options));
            println!("{name:<34} {here:>7.1} of plain blending");
        }
    }
    Ok(())
}
