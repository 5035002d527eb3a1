//! Table 1 of Carr, Měch and Miller (2008) on the bundled meshes: iterations and geometry passes of coherent layer peeling and
//! of layer peeling, and how many times as long the latter takes.
//!
//! Prints the table. Writes one picture: the molecule's surface from three sides.
//!
//! `cargo run --release --example 25_table_1 [FOLDER]`

use onionskin::low_level::edition::figures::carr::table_1::{VIEWS, methods, models, seen_from};
use onionskin::report::Panels;
use onionskin::{Context, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [160, 120];
fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let molecule = Scene::load(example::scene("molecule.toml"))?;
    println!(
        "model          faces  vertices  view     coherent A     coherent B  layer peeling  its time / A's"
    );
    let title = "Coherent layer peeling A of the molecule's surface (Carr et al. 2008, table 1)";
    let mut sheet = Panels::new(title);
    for (name, mesh) in models(&molecule)? {
        for (view, direction) in VIEWS {
            let scene = seen_from(&mesh, direction, SIZE);
            let (faces, vertices) = (mesh.triangles.len(), mesh.vertices.len());
            print!("{name:<12} {faces:7} {vertices:9}  {view:<5}");
            let mut ms = Vec::new();
            for method in methods() {
                let frame = renderer.measure(&scene, &method, 1)?;
                let stats = &frame.stats;
                let cell = format!("{} it, {} g", stats.iterations, stats.geometry_passes);
                print!("{cell:>15}");
                ms.push(stats.ms);
                if name == "surface" && ms.len() == 1 {
                    let caption = format!("{view}: {} iterations", stats.iterations);
                    sheet = sheet.picture(&frame.image, &caption);
                }
            }
            println!("{:>16.2}", ms[2] / ms[0]);
        }
    }
    println!(
        "the paper's table: 2.5 to 8.7 times as many iterations by layer peeling, and 0.8 to 3 times the time"
    );
    let path = example::output("25_table_1.png")?;
    sheet.save(&path)?;
    println!("{}", path.display());
    Ok(())
}
