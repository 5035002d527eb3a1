//! Dual depth peeling, and peeling that keeps coplanar fragments, against single peeling: ratios of medians, all from
//! one run. The methods take turns in each round, so that a busy machine is busy for each of them.
//!
//! `cargo bench --bench dual_peeling [SCENE.toml ...]`; the bundled scenes if none is named.

use onionskin::{Context, Method, Renderer, Result, Scene};

const ROUNDS: usize = 5;
const METHODS: [&str; 3] = [
    "depth-peeling",
    "dual-depth-peeling",
    "coplanar-depth-peeling",
];
const BUNDLED: [&str; 6] = ["teapot", "knots", "soup", "slices", "quads", "molecule"];

fn main() -> Result<()> {
    // `cargo bench` adds `--bench` to what the user gives.
    let mut paths: Vec<String> = std::env::args()
        .skip(1)
        .filter(|argument| !argument.starts_with('-'))
        .collect();
    if paths.is_empty() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes");
        paths = BUNDLED.map(|name| format!("{folder}/{name}.toml")).to_vec();
    }
    let context = Context::headless()?;
    println!("on {}", context.driver().renderer);
    println!(
        "scene            layers | passes: single  dual  coplanar | ms: single | dual/single  coplanar/single"
    );
    for path in paths {
        let scene = Scene::load(&path)?;
        let [width, height] = scene.size;
        let mut renderer = Renderer::new(&context, width, height)?;
        let mut times = [const { Vec::new() }; METHODS.len()];
        let mut passes = [0; METHODS.len()];
        let mut layers = 0;
        for _ in 0..ROUNDS {
            for (number, name) in METHODS.iter().enumerate() {
                let method: Method = name.parse()?;
                let stats = renderer.measure(&scene, &method, 1)?.stats;
                times[number].push(stats.ms);
                passes[number] = stats.geometry_passes;
                layers = layers.max(stats.layers.unwrap_or(0));
            }
        }
        let [single, dual, coplanar] = times.map(median);
        println!(
            "{:<16} {layers:6} | {:14} {:5} {:9} | {single:10.1} | {:11.2} {:16.2}",
            scene.name,
            passes[0],
            passes[1],
            passes[2],
            dual / single,
            coplanar / single
        );
    }
    Ok(())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}
