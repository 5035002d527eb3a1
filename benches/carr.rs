//! The measurements of Carr et al. (2008) on this renderer: ratios of medians, all from one run, beside the paper's.
//!
//! `cargo bench --bench carr`. The Stanford bunny takes part if `ONIONSKIN_BUNNY` names its scene file.

use onionskin::low_level::edition::figures::carr::with_slices;
use onionskin::options::{CoherentOptions, IdealOptions, TriangleSort, Variant};
use onionskin::{Context, Method, Renderer, Result, Scene, Stats};

/// The number of frames of a median, or fewer if they take too long.
const FRAMES: usize = 5;

fn main() -> Result<()> {
    let context = Context::headless()?;
    println!("on {}", context.driver().renderer);
    slices_and_cone(&context)?;
    for (name, scene) in real_meshes()? {
        meshes(&context, &name, &scene)?;
    }
    Ok(())
}

/// Figures 1 and 3, section 8.
fn slices_and_cone(context: &Context) -> Result<()> {
    let size = [320, 240];
    println!("\nslices and cone, {} x {}", size[0], size[1]);
    println!("slices   layer/hybrid   coherent A/hybrid   coherent B/hybrid   ideal/hybrid");
    for count in [64, 128, 256] {
        let scene = with_slices(Scene::load_at(example("slices"), Some(size))?, count, 8)?;
        let mut renderer = Renderer::new(context, size[0], size[1])?;
        let mut ms = |method: Method| {
            Ok::<_, onionskin::Error>(renderer.measure(&scene, &method, FRAMES)?.stats.ms)
        };
        let hybrid = ms(Method::HybridLayerPeeling(Default::default()))?;
        let layer = ms(Method::LayerPeeling(Default::default()))?;
        let a = ms(Method::CoherentLayerPeeling(Variant::A.into()))?;
        let b = ms(Method::CoherentLayerPeeling(Variant::B.into()))?;
        let ideal = ms(Method::IdealCoherentLayerPeeling(Default::default()))?;
        println!(
            "{count:6}   {:12.1}   {:17.1}   {:17.1}   {:12.1}",
            layer / hybrid,
            a / hybrid,
            b / hybrid,
            ideal / hybrid
        );
    }
    println!("the paper at 256: layer/hybrid 52 (figure 1: 62), coherent/hybrid about 6");
    Ok(())
}

fn real_meshes() -> Result<Vec<(String, Scene)>> {
    let mut scenes = vec![
        (
            "molecule".to_owned(),
            Scene::load_at(example("molecule"), Some([512, 384]))?,
        ),
        (
            "knots".to_owned(),
            Scene::load_at(example("knots"), Some([512, 384]))?,
        ),
        (
            "teapot".to_owned(),
            Scene::load_at(example("teapot"), Some([512, 384]))?,
        ),
    ];
    match std::env::var("ONIONSKIN_BUNNY") {
        Ok(path) => scenes.push(("bunny".to_owned(), Scene::load_at(path, Some([512, 384]))?)),
        Err(_) => println!("skipped: the bunny (ONIONSKIN_BUNNY names no scene file)"),
    }
    Ok(scenes)
}

/// Table 1 in kind, and the gains of sorting and of the improvements.
fn meshes(context: &Context, name: &str, scene: &Scene) -> Result<()> {
    let triangles: usize = scene.meshes.iter().map(|mesh| mesh.triangles.len()).sum();
    println!(
        "\n{name}, {triangles} triangles, {} x {}",
        scene.size[0], scene.size[1]
    );
    println!(
        "                                  iterations   passes   layer peeling's time / its own"
    );
    let mut renderer = Renderer::new(context, scene.size[0], scene.size[1])?;
    let mut layer: Option<f64> = None;
    for (label, method) in rows() {
        let stats = renderer.measure(scene, &method, FRAMES)?.stats;
        let reference = *layer.get_or_insert(stats.ms);
        print_row(label, &stats, reference / stats.ms);
    }
    println!("the paper's table 1: 0.8 to 3.3 for A and B, 2 to 9 times fewer iterations");
    Ok(())
}

fn rows() -> Vec<(&'static str, Method)> {
    let coherent = |options: CoherentOptions| Method::CoherentLayerPeeling(options);
    let a = CoherentOptions::from(Variant::A);
    let b = CoherentOptions::from(Variant::B);
    let sorted = |sorting| coherent(CoherentOptions { sorting, ..b });
    let ideal = |tight_bound| {
        Method::IdealCoherentLayerPeeling(IdealOptions {
            tight_bound,
            ..IdealOptions::default()
        })
    };
    vec![
        ("layer peeling", Method::LayerPeeling(Default::default())),
        (
            "depth peeling, one pass each",
            Method::DepthPeeling(Default::default()),
        ),
        ("coherent A", coherent(a)),
        ("coherent B", coherent(b)),
        ("ideal GPU", ideal(false)),
        ("B unsorted", sorted(TriangleSort::Submission)),
        ("B, objects sorted", sorted(TriangleSort::Objects)),
        ("B, 16 buckets", sorted(TriangleSort::Buckets(16))),
        ("B, 256 buckets", sorted(TriangleSort::Buckets(256))),
        ("B, 16384 buckets", sorted(TriangleSort::Buckets(16384))),
        (
            "A, tie-friendly",
            coherent(CoherentOptions {
                tie_friendly: true,
                ..a
            }),
        ),
        (
            "A, early stop",
            coherent(CoherentOptions {
                stop_early: true,
                ..a
            }),
        ),
        (
            "A, 2 batches",
            coherent(CoherentOptions { batches: 2, ..a }),
        ),
        (
            "A, 8 batches",
            coherent(CoherentOptions { batches: 8, ..a }),
        ),
        ("ideal GPU, tight bound", ideal(true)),
    ]
}

fn print_row(label: &str, stats: &Stats, ratio: f64) {
    println!(
        "{label:<32} {:11} {:8} {ratio:10.2}",
        stats.iterations, stats.geometry_passes
    );
}

fn example(name: &str) -> String {
    format!("{}/examples/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"))
}
