//! Figure 6 of Lindholm et al. 2015 in kind: three memory managers, each with the static Local Array, ppAO, ppDP and
//! both, on four scenes after the paper's. Times are medians from one run, relative to the same manager's static array.
//! They cannot be compared with the figures of the paper's GPUs. As in the paper, linked lists take their nodes from a
//! pool, with atomics.
//!
//! `cargo bench --bench fused [WIDTH HEIGHT]`, 320 x 240 if no size is named, writes `out/figure-6.svg` and `.png`.

use std::path::Path;

use onionskin::options::{ABufferOptions, Fill, Manager};
use onionskin::report::{BarGroup, bars};
use onionskin::{Context, Error, Method, Renderer, Result, Scene};

const FRAMES: usize = 5;
const SCENES: [&str; 4] = ["molecule_fused", "space", "medical", "flow"];
const MANAGERS: [Manager; 3] = [Manager::Ffb, Manager::Dfb, Manager::Ppll];
const COMPONENTS: [(bool, bool); 4] = [(false, false), (true, false), (false, true), (true, true)];

fn main() -> Result<()> {
    // `cargo bench` adds `--bench` to what the user gives.
    let sizes: Vec<u32> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    let size = match sizes[..] {
        [width, height] => [width, height],
        _ => [320, 240],
    };
    let out = Path::new(env!("CARGO_MANIFEST_DIR")).join("out");
    std::fs::create_dir_all(&out).map_err(|error| {
        let what = format!("cannot make the folder {}: {error}", out.display());
        Error::usage(what, "remove what is in its place")
    })?;
    let context = Context::headless()?;
    println!("{} at {} x {}", context.driver().renderer, size[0], size[1]);
    let mut renderer = Renderer::new(&context, size[0], size[1])?;
    let mut names = Vec::new();
    let mut groups = Vec::new();
    for name in SCENES {
        let path = format!("{}/examples/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let scene = Scene::load_at(&path, Some(size))?;
        let complexity = renderer.complexity(&scene, Default::default())?;
        println!(
            "\n{name}: {} triangles, {} volumes, {} layers at most, {} in the median of the covered pixels",
            scene.triangle_count(),
            scene.volumes.len(),
            complexity.max(),
            complexity.percentile(0.5)
        );
        let measured = combinations(&mut renderer, &scene)?;
        let heights = measured.iter().map(|&(_, ratio)| ratio).collect();
        names = measured.into_iter().map(|(name, _)| name).collect();
        groups.push(BarGroup {
            name: name.replace("_fused", ""),
            heights,
        });
    }
    let caption =
        "Three managers, four Local Arrays, four scenes (after Lindholm et al. 2015, figure 6)";
    let of_what = "time, static array of the manager = 1";
    for (plot, ending) in bars(caption, of_what, &names, &groups)?
        .iter()
        .zip(["svg", "png"])
    {
        plot.save(&out.join("figure-6").with_extension(ending))?;
    }
    Ok(())
}

/// Each combination with its time relative to its manager's static array.
fn combinations(renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Vec<(String, f64)>> {
    let mut measured = Vec::new();
    for manager in MANAGERS {
        let mut of_static = None;
        for (pp_ao, pp_dp) in COMPONENTS {
            let fill = match manager {
                Manager::Ppll => Fill::Atomics,
                _ => Fill::Automatic,
            };
            let method = Method::ABuffer(ABufferOptions {
                manager,
                pp_ao,
                pp_dp,
                fill,
                ..Default::default()
            });
            let stats = renderer.measure(scene, &method, FRAMES)?.stats;
            let base = *of_static.get_or_insert(stats.ms);
            let ratio = stats.ms / base;
            println!(
                "{:<18} {ratio:5.2} of static, {:8.1} ms, {} fragments lost",
                method.to_string(),
                stats.ms,
                stats.lost.unwrap_or(0)
            );
            measured.push((method.to_string(), ratio));
        }
    }
    Ok(measured)
}
