//! Four scenes after the paper's four (Lindholm et al. 2015, Table 1 and figures 1, 8, 9 and 10): a molecule, an ejection of
//! the sun, a head, a flow.
//!
//! Each scene is rendered by ppDP on dynamic fragment buffers, with all of its layers. Prints the columns of Table 1,
//! in which boxes of volumes count as in the paper. The scene files say how large the paper's scenes were.
//!
//! Writes one picture of all four.
//!
//! `cargo run --release --example 23_four_scenes [FOLDER]`

use onionskin::options::{ABufferOptions, Manager};
use onionskin::report::Panels;
use onionskin::{Context, CountBy, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [400, 300];
const SCENES: [(&str, &str); 4] = [
    ("molecule_fused", "molecule"),
    ("space", "ejection of the sun"),
    ("medical", "fibres in a head"),
    ("flow", "flow"),
];

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let rays = Method::ABuffer(ABufferOptions {
        manager: Manager::Dfb,
        pp_dp: true,
        ..ABufferOptions::default()
    });
    println!("scene           triangles  volumes  fragments  layers: most  median");
    let title = "Four scenes after Lindholm et al. 2015, table 1";
    let mut sheet = Panels::new(title).columns(2);
    for (name, of_what) in SCENES {
        let path = example::scene(&format!("{name}.toml"));
        let scene = Scene::load_at(path, Some(SIZE))?;
        let complexity = renderer.complexity(&scene, CountBy::Blending)?;
        println!(
            "{name:<14} {:>10} {:>8} {:>10} {:>13} {:>7}",
            scene.triangle_count(),
            scene.volumes.len(),
            complexity.fragments(),
            complexity.max(),
            complexity.percentile(0.5)
        );
        let caption = format!("{of_what}: up to {} layers", complexity.max());
        sheet = sheet.picture(&renderer.render(&scene, &rays)?.image, &caption);
    }
    let path = example::output("23_four_scenes.png")?;
    sheet.save(&path)?;
    println!("{}", path.display());
    Ok(())
}
