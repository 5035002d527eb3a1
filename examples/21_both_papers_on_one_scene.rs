//! One scene by both papers: rays cast between the fragments of a list (Lindholm et al. 2015, section 6), and the same
//! volumes as sorted slices next to peeled surfaces (Carr et al. 2008, Algorithm 1). How many slices does it take?
//!
//! A slice stands for a whole slab. If a surface is inside of a slab, or a ray enters a volume there, at most half of
//! the slab is on the wrong side. So twice as many slices halve the difference. The iterations of hybrid layer peeling
//! stay those of the surfaces. Layer peeling peels slices like surfaces, so its iterations grow with their number.
//!
//! Writes a plot, and a picture of 12 slices, of 96 slices, and of rays.
//!
//! `cargo run --release --example 21_both_papers_on_one_scene [FOLDER]`

use onionskin::options::{ABufferOptions, RecordColor};
use onionskin::report::{Curves, Panels, convergence};
use onionskin::{Comparison, Context, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

const SIZE: [u32; 2] = [200, 150];
const COUNTS: [u32; 6] = [16, 32, 64, 128, 256, 512];
/// With more slices, layer peeling takes minutes.
const MOST_FOR_LAYERS: u32 = 64;

fn main() -> onionskin::Result<()> {
    let context = Context::headless()?;
    let (rays, hybrid) = (rays(), Method::HybridLayerPeeling(Default::default()));
    let scene = Scene::load_at(example::scene("fog.toml"), Some(SIZE))?;
    let fused = renderer(&context, &scene, 1)?.render(&scene, &rays)?.image;

    let (mut rms, mut max) = (Vec::new(), Vec::new());
    let (mut hybrids, mut layers) = (Vec::new(), Vec::new());
    println!("slices  rms difference  largest  iterations: hybrid  layer peeling");
    for count in COUNTS {
        let mut renderer = renderer(&context, &scene, count)?;
        let frame = renderer.render(&scene, &hybrid)?;
        let difference = Comparison::new(&frame.image, &fused, 0.0)?;
        rms.push(difference.rms);
        max.push(difference.max);
        hybrids.push(f64::from(frame.stats.iterations));
        let mut of_layers = "not run".to_owned();
        if count <= MOST_FOR_LAYERS {
            let frame = renderer.render(&scene, &Method::LayerPeeling(Default::default()))?;
            layers.push(f64::from(frame.stats.iterations));
            of_layers = frame.stats.iterations.to_string();
        }
        println!(
            "{count:>6}  {:>14.1e}  {:>7.1e}  {:>18}  {of_layers:>13}",
            difference.rms, difference.max, frame.stats.iterations
        );
    }
    let error = Curves {
        of_what: "difference from the fused image".into(),
        curves: vec![
            ("largest difference".into(), max),
            ("rms difference".into(), rms),
        ],
    };
    let iterations = Curves {
        of_what: "iterations".into(),
        curves: vec![
            ("iterations of hybrid layer peeling".into(), hybrids),
            ("iterations of layer peeling".into(), layers),
        ],
    };
    let caption = "two volumes and a ring: slices against rays";
    let counts = COUNTS.map(f64::from);
    let [svg, png] = convergence(caption, ("slices", &counts), &error, &iterations)?;
    let path = example::output("21_slices_against_rays.png")?;
    png.save(&path)?;
    svg.save(&path.with_extension("svg"))?;

    let scene = Scene::load_at(example::scene("fog.toml"), Some([320, 240]))?;
    let mut sheet = Panels::new(
        "Two volumes and a ring: slices (Carr et al. 2008), rays (Lindholm et al. 2015)",
    );
    for count in [12, 96] {
        let frame = renderer(&context, &scene, count)?.render(&scene, &hybrid)?;
        sheet = sheet.picture(&frame.image, &format!("{count} slices"));
    }
    let frame = renderer(&context, &scene, 1)?.render(&scene, &rays)?;
    let path = example::output("21_both_papers_on_one_scene.png")?;
    sheet.picture(&frame.image, "rays").save(&path)?;
    println!("{}", path.display());
    Ok(())
}

/// Lists of any length and colours in 32 bits, so that only the slices make a difference.
fn rays() -> Method {
    Method::ABuffer(ABufferOptions {
        color: RecordColor::Float,
        pp_dp: true,
        ..ABufferOptions::default()
    })
}

fn renderer<'c>(
    context: &'c Context,
    scene: &Scene,
    count: u32,
) -> onionskin::Result<Renderer<'c>> {
    let [width, height] = scene.size;
    Renderer::new(context, width, height)?.with_slices(count)
}
