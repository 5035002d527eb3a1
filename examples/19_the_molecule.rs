//! The molecule: its surfaces and its electrostatic potential at two resolutions in one image (Lindholm et al. 2015,
//! figure 1), as the first frame of the scene's camera path has them.
//!
//! Shows the fused image by the dynamic fragment buffer with ppAO and ppDP, the same lists without the volumes, and the
//! image of `exact`. Prints the depth complexity, in which the boxes of volumes count as in the paper, and the
//! difference of the images. Records keep colours in 16 bits, as published.
//!
//! `cargo run --release --example 19_the_molecule [FOLDER]`

use onionskin::options::{ABufferOptions, Manager};
use onionskin::report::Panels;
use onionskin::{Animation, Comparison, Context, CountBy, Method, Renderer};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [480, 360];

fn main() -> onionskin::Result<()> {
    let animation = Animation::load_at(example::scene("molecule_fused.toml"), Some(SIZE))?;
    let scene = animation.frame(0)?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, SIZE[0], SIZE[1])?;
    let complexity = renderer.complexity(&scene, CountBy::Blending)?;
    println!(
        "{} triangles, {} volumes; {} fragments, {} layers at most, {} in the median of the covered pixels",
        scene.triangle_count(),
        scene.volumes.len(),
        complexity.fragments(),
        complexity.max(),
        complexity.percentile(0.5)
    );
    let fused = Method::ABuffer(ABufferOptions {
        manager: Manager::Dfb,
        pp_ao: true,
        pp_dp: true,
        ..ABufferOptions::default()
    });
    let frame = renderer.render(&scene, &fused)?;

    let exact = renderer.render(&scene, &Method::Exact)?;
    let off = |image| Comparison::new(image, &exact.image, 1e-3);
    let difference = off(&frame.image)?;
    println!(
        "fused: {:.1e} from the exact image at most, {} pixels by more than 1e-3",
        difference.max, difference.over
    );

    let mut surfaces = scene;
    surfaces.volumes.clear();
    let alone = renderer.render(&surfaces, &fused)?;
    println!(
        "without the volumes: {:.1e} from it",
        off(&alone.image)?.max
    );
    Panels::new("The molecule in its electrostatic potential (Lindholm et al. 2015, figure 1)")
        .picture(&frame.image, "surfaces, and volumes at two resolutions")
        .picture(&alone.image, "the surfaces alone")
        .difference(
            &frame.image,
            &alone.image,
            "difference of the two: largest channel",
        )?
        .save(example::output("19_the_molecule.png")?)?;
    Ok(())
}
