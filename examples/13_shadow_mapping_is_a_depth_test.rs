//! Shadow mapping is a depth test (Everitt 2001).
//!
//! Depth peeling as it ran in 2001: a shadow map with the camera's own orientation and resolution, whose comparison of
//! r/q writes alpha, and the alpha test. With Listing 2, which also stores r/q, it gives the same image as today's
//! shadow sampler. Without Listing 2, the image falls apart.
//!
//! Writes one picture. Above: the shadow map of the second peel (nearer is darker), and the layer that passes it. Below:
//! the image with and without Listing 2.
//!
//! `cargo run --example 13_shadow_mapping_is_a_depth_test [FOLDER]`

use onionskin::options::{Compositing, DepthPeelingOptions, DepthUnit0};
use onionskin::report::{Panels, depths, opaque};
use onionskin::{Comparison, Context, Frame, Method, Renderer, Scene};

#[path = "common/example.rs"]
mod example;

fn main() -> onionskin::Result<()> {
    let scene = Scene::load_at(example::scene("teapot.toml"), Some([512, 384]))?;
    let context = Context::headless()?;
    let mut renderer = Renderer::new(&context, 512, 384)?;
    let exact = renderer.render(&scene, &Method::Exact)?;

    println!("depth unit 0         peels  maximum error  pixels off by more than 1/255");
    let mut frames = Vec::new();
    for depth_unit_0 in [
        DepthUnit0::Sampler,
        DepthUnit0::ClassicDepthReplace,
        DepthUnit0::Classic,
    ] {
        let options = DepthPeelingOptions {
            compositing: Compositing::KeepLayers,
            depth_unit_0,
            // Without Listing 2 the loop would never end.
            maximum_number_of_peels: 16,
            ..Default::default()
        };
        let frame = renderer.render(&scene, &Method::DepthPeeling(options))?;
        let error = Comparison::new(&frame.image, &exact.image, 1.0 / 255.0)?;
        println!(
            "{:<20} {:5} {:14.6} {:14}",
            format!("{depth_unit_0:?}"),
            frame.stats.iterations,
            error.max,
            error.over
        );
        frames.push(frame);
    }

    let [_, replaced, classic]: [Frame; 3] = frames.try_into().expect("three ways");
    let map = depths(replaced.layers[0].color.width, &replaced.layers[0].depth);
    let layer = opaque(&replaced.layers[1]);
    let path = example::output("13_shadow_mapping_is_a_depth_test.png")?;
    Panels::new("Shadow mapping is a depth test (Everitt 2001)")
        .columns(2)
        .picture(&map, "the second peel's shadow map: darker is nearer")
        .picture(&layer, "the layer that passes it")
        .picture(&replaced.image, "with Listing 2: right")
        .picture(&classic.image, "without Listing 2: wrong")
        .save(&path)?;
    println!("{}", path.display());
    Ok(())
}
