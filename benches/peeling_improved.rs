//! What the improvements of depth peeling are worth: ratios to depth peeling without them, all from one run. The options
//! take turns in each round, so that a busy machine is busy for each of them. Each ratio is given of medians of wall-clock
//! time, and of medians of the processor time of all threads, which another load hardly changes.
//!
//! `cargo bench --bench peeling_improved [SCENE.toml ...]`; the bundled scenes if none is named.

use onionskin::{Context, Method, Renderer, Result, Scene};

const ROUNDS: usize = 5;
const SIZE: [u32; 2] = [1024, 768];
const IMPROVEMENTS: [&str; 6] = [
    "",
    "late-query",
    "alive",
    "late-query,alive",
    "cull",
    "alive,cull",
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
        "scene            layers |       ms | late  alive  both  cull  alive+cull, by the clock and by the processor"
    );
    for path in paths {
        let scene = Scene::load_at(&path, Some(SIZE))?;
        let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
        let mut wall = [const { Vec::new() }; IMPROVEMENTS.len()];
        let mut processor = [const { Vec::new() }; IMPROVEMENTS.len()];
        let mut layers = 0;
        for round in 0..=ROUNDS {
            for (number, improvements) in IMPROVEMENTS.iter().enumerate() {
                let mut method: Method = "depth-peeling".parse()?;
                if !improvements.is_empty() {
                    method.choose("improve", improvements)?;
                }
                let before = processor_ms();
                let stats = renderer.render(&scene, &method)?.stats;
                layers = stats.layers.unwrap_or(0);
                // The first round compiles the shaders.
                if round > 0 {
                    wall[number].push(stats.ms);
                    processor[number].push(processor_ms() - before);
                }
            }
        }
        let [wall, processor] = [wall, processor].map(|times| times.map(median));
        print!("{:<16} {layers:6} | {:8.1}", scene.name, wall[0]);
        for times in [wall, processor] {
            let ratios = times[1..].iter().map(|time| time / times[0]);
            let ratios: Vec<_> = ratios.map(|ratio| format!("{ratio:5.2}")).collect();
            print!(" | {}", ratios.join(" "));
        }
        println!();
    }
    Ok(())
}

/// What all threads have run so far, as Linux counts it; 0 elsewhere.
fn processor_ms() -> f64 {
    let Ok(threads) = std::fs::read_dir("/proc/self/task") else {
        return 0.0;
    };
    let ran = |thread: std::io::Result<std::fs::DirEntry>| -> Option<f64> {
        let text = std::fs::read_to_string(thread.ok()?.path().join("schedstat")).ok()?;
        text.split_whitespace().next()?.parse().ok()
    };
    threads.filter_map(ran).sum::<f64>() / 1e6
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}
