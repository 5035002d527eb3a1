//! What Carr, Měch and Miller (2008) claim, on OpenGL: images, iterations and geometry passes of their methods on whole
//! scenes. The claims about single pixels are in `papers/emulator_*.rs`; `gl/lockstep.rs` shows that both are one machine.

use crate::kit::bounds::F32;
use crate::kit::carr_scenes::{HYBRID, LAYERS, error, figure_1, ideal, is_ideal};
use crate::kit::driver::settled;
use crate::kit::figures::expect_figures;
use crate::kit::render::{example, render};
use crate::kit::stack;
use onionskin::generate::{Soup, soup};
use onionskin::low_level::steps::Reason;
use onionskin::options::{CoherentOptions, TriangleSort, Variant};
use onionskin::{Comparison, Context, Method, Scene};
use proptest::test_runner::{TestCaseError, TestError};

fn coherent(variant: Variant, sorting: TriangleSort) -> Method {
    Method::CoherentLayerPeeling(CoherentOptions {
        sorting,
        ..variant.into()
    })
}

/// Every method of the paper that this driver runs, in the scene's own order of submission.
fn methods(context: &Context) -> Vec<Method> {
    let mut methods = vec![
        LAYERS,
        HYBRID,
        coherent(Variant::A, TriangleSort::Submission),
        coherent(Variant::B, TriangleSort::Submission),
    ];
    if is_ideal(context) {
        methods.push(ideal(TriangleSort::Submission));
    }
    methods
}

#[test]
fn every_method_gives_the_oracle_s_image_of_random_stacks_ties_included() {
    let context = Context::headless().unwrap();
    let strategy = stack::stacks(6, false);
    let result = stack::runner(40).run(&strategy, |stack| {
        let (scene, expected) = (stack.scene(), stack.expected());
        for method in methods(&context) {
            let frame = render(&context, &scene, &method);
            let error = Comparison::new(&frame.image, &expected, 0.0).unwrap().max;
            if error > F32 || frame.stats.lost != Some(0) {
                return Err(TestCaseError::fail(format!(
                    "{method}: {error}, {}",
                    frame.stats
                )));
            }
        }
        Ok(())
    });
    if let Err(TestError::Fail(why, stack)) = result {
        panic!("{why}: {stack:#?}");
    }
}

#[test]
fn every_method_gives_the_oracle_s_image_of_whole_scenes() {
    let context = Context::headless().unwrap();
    for (name, size) in [
        ("teapot", [160, 120]),
        ("knots", [160, 120]),
        ("soup", [120, 90]),
    ] {
        let scene = example(name, size);
        let exact = render(&context, &scene, &Method::Exact);
        let mut all = methods(&context);
        all.push(coherent(Variant::A, TriangleSort::default()));
        all.push(coherent(Variant::B, TriangleSort::Objects));
        for method in all {
            let frame = render(&context, &scene, &method);
            let image = settled(&context, &frame, &exact);
            let error = Comparison::new(&image, &exact.image, F32).unwrap();
            assert_eq!(error.over, 0, "{name}, {method}: {error:?}");
            assert_eq!(frame.stats.lost, Some(0), "{name}, {method}");
        }
    }
}

#[test]
fn shuffled_triangles_give_the_same_image() {
    let context = Context::headless().unwrap();
    let parameters = Soup {
        count: 300,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [80, 60];
    let mut shuffled = scene.clone();
    shuffled.meshes[0] = shuffled.meshes[0].shuffled(8);
    for method in methods(&context) {
        let [a, b] = [&scene, &shuffled].map(|scene| render(&context, scene, &method).image);
        assert!(a == b, "{method}");
    }
}

// ---- Counts ----------------------------------------------------------------------------------------------------------

#[test]
pub(crate) fn c01_layer_peeling_takes_as_many_iterations_as_the_deepest_pixel_has_layers() {
    let context = Context::headless().unwrap();
    let [a, b] = [10, 20].map(|count| {
        let scene = figure_1(count, [64, 48]);
        render(&context, &scene, &LAYERS).stats
    });
    // The cone has two layers at most; one iteration more finds nothing.
    assert_eq!([a.iterations, b.iterations], [13, 23]);
    // Two passes each, but for the last.
    assert_eq!([a.geometry_passes, b.geometry_passes], [25, 45]);
}

#[test]
pub(crate) fn c03_figure_1_takes_3_iterations_instead_of_257() {
    let context = Context::headless().unwrap();
    let scene = figure_1(256, [64, 48]);
    let hybrid = render(&context, &scene, &HYBRID).stats;
    assert_eq!(hybrid.iterations, 3);
    let layers = render(&context, &scene, &LAYERS).stats;
    // [257]; here 256 slices, two layers of the cone, and the iteration that finds nothing.
    println!(
        "figure 1: {} iterations, hybrid {}",
        layers.iterations, hybrid.iterations
    );
    assert_eq!(layers.iterations, 259);
}

#[test]
pub(crate) fn c04_iterations_grow_with_the_slices_for_layer_peeling_only() {
    let context = Context::headless().unwrap();
    println!("slices  layer  hybrid  coherent A  coherent B");
    let mut rows = Vec::new();
    for count in [8, 16, 32, 64] {
        let scene = figure_1(count, [64, 48]);
        let [layers, hybrid, a, b] = [
            LAYERS,
            HYBRID,
            coherent(Variant::A, TriangleSort::default()),
            coherent(Variant::B, TriangleSort::default()),
        ]
        .map(|method| render(&context, &scene, &method).stats.iterations);
        println!("{count:6}  {layers:5}  {hybrid:6}  {a:10}  {b:10}");
        assert_eq!(layers, count + 3);
        assert_eq!(hybrid, 3);
        assert_eq!(a, b);
        rows.push(a);
    }
    // Constant: the cone interrupts each pixel's run at most twice on either side.
    let (least, most) = (rows.iter().min().unwrap(), rows.iter().max().unwrap());
    assert!(most - least <= 1 && *most <= 6, "{rows:?}");
}

#[test]
pub(crate) fn c20_geometry_passes_are_6_5_and_2_an_iteration() {
    let context = Context::headless().unwrap();
    let scene = example("knots", [80, 60]);
    for (method, passes, last) in [
        (coherent(Variant::A, TriangleSort::default()), 6, 6),
        (coherent(Variant::B, TriangleSort::default()), 5, 5),
        (LAYERS, 2, 1),
    ] {
        let stats = render(&context, &scene, &method).stats;
        let iterations = u64::from(stats.iterations);
        assert_eq!(
            stats.geometry_passes,
            (iterations - 1) * passes + last,
            "{method}"
        );
        assert_eq!(stats.stopped, Some(Reason::EmptyLayer));
    }
}

#[test]
pub(crate) fn c21_coherent_peeling_takes_several_times_fewer_iterations_on_sorted_models() {
    let context = Context::headless().unwrap();
    println!("scene      layer  coherent");
    for (name, size) in [
        ("molecule", [96, 72]),
        ("knots", [160, 120]),
        ("teapot", [160, 120]),
    ] {
        let scene = example(name, size);
        let layers = render(&context, &scene, &LAYERS).stats.iterations;
        let a = render(
            &context,
            &scene,
            &coherent(Variant::A, TriangleSort::default()),
        )
        .stats
        .iterations;
        println!("{name:9}  {layers:5}  {a:8}");
        // [2 to 8 times]: twice on the shallowest of these.
        assert!(
            f64::from(layers) / f64::from(a) >= 2.0,
            "{name}: {layers} and {a}"
        );
    }
}

#[test]
pub(crate) fn c23_bucket_sort_makes_a_model_sorted_enough() {
    let context = Context::headless().unwrap();
    let mut scene = example("knots", [160, 120]);
    for mesh in &mut scene.meshes {
        *mesh = mesh.shuffled(23);
    }
    let iterations = |sorting| {
        render(&context, &scene, &coherent(Variant::A, sorting))
            .stats
            .iterations
    };
    let counts = [
        TriangleSort::Submission,
        TriangleSort::Buckets(16),
        TriangleSort::Buckets(1024),
    ]
    .map(iterations);
    expect_figures("C23", 0, &counts.map(f64::from));
    assert!(
        counts[0] > counts[1] && counts[1] >= counts[2],
        "{counts:?}"
    );
    assert!(counts[2] + 2 <= counts[0], "{counts:?}");
}

#[test]
pub(crate) fn c22_opaque_surfaces_bound_every_method() {
    let context = Context::headless().unwrap();
    let mut scene = example("knots", [120, 90]);
    scene.meshes[0].opaque = true;
    for vertex in &mut scene.meshes[0].vertices {
        vertex.color.a = 1.0;
    }
    let exact = render(&context, &scene, &Method::Exact);
    for method in methods(&context) {
        let frame = render(&context, &scene, &method);
        assert!(error(&frame, &exact) <= F32, "{method}");
        assert_eq!(frame.stats.lost, Some(0), "{method}");
    }
}
