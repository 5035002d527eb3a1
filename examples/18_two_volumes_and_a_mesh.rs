//! Two overlapping volumes and a mesh in one image, by every A-buffer (Lindholm et al. 2015, section 6).
//!
//! The scene is a vortex inside of a ball of fog, and a glass ring through both. Where the volumes overlap, they are
//! sampled together. The ring's surfaces cut the rays. A pixel's list is short, but ppDP with arrays of 2 still
//! resolves it in several subpasses. Between them it keeps the ray's position and the volumes around it.
//!
//! Writes the picture beside its difference from the f64 caster's, and prints how far each method is from the f64 caster. Records keep colours in 16 bits, as
//! published.
//!
//! `cargo run --example 18_two_volumes_and_a_mesh [FOLDER]`

use onionskin::options::{ABufferOptions, Manager};
use onionskin::report::Panels;
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("fog.toml"), Some([480, 360]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 480, 360)?;
    let exact = renderer.render(&scene, &Method::Exact)?;
    println!("method           subpasses at most  largest difference");
    for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
        for (pp_ao, pp_dp) in [(false, false), (true, false), (false, true), (true, true)] {
            let method = Method::ABuffer(ABufferOptions {
                manager,
                pp_ao,
                pp_dp,
                peel: 2,
                ..ABufferOptions::default()
            });
            let frame = renderer.render(&scene, &method)?;
            let difference = Comparison::new(&frame.image, &exact.image, 0.0)?.max;
            let subpasses = frame
                .stats
                .a_buffer
                .map_or(0, |counts| counts.most_subpasses);
            println!("{:<16} {subpasses:>17}  {difference:.1e}", method.name());
            if frame.stats.method == "dfb" {
                let path = example::output("18_two_volumes_and_a_mesh.png")?;
                Panels::new("A vortex in fog, and a glass ring through both (Lindholm et al. 2015, section 6)")
                    .picture(&frame.image, "dfb: rays between the fragments of lists")
                    .difference(&frame.image, &exact.image, "difference from the f64 caster: largest channel")?
                    .save(&path)?;
            }
        }
    }
    Ok(())
}
