//! What Carr, Měch and Miller (2008) say of the ideal GPU, and what options and the text as printed make of their methods,
//! on OpenGL.

use crate::kit::bounds::F32;
use crate::kit::carr_scenes::{LAYERS, error, ideal, is_ideal};
use crate::kit::driver::settled;
use crate::kit::render::{example, render};
use crate::kit::stack;
use onionskin::generate::{TorusKnot, torus_knot};
use onionskin::low_level::papers::carr_2008::{AT_BOUND, AT_BOUND_AS_PRINTED};
use onionskin::low_level::steps::{Amendment, Reason};
use onionskin::options::{
    BufferAccess, CoherentOptions, IdealOptions, Reading, TriangleSort, Variant,
};
use onionskin::{Comparison, Context, Method, Scene, steps};

#[test]
pub(crate) fn c19_the_ideal_gpu_takes_two_geometry_passes_an_iteration() {
    let context = Context::headless().unwrap();
    if !is_ideal(&context) {
        return;
    }
    for name in ["knots", "teapot", "soup"] {
        let scene = example(name, [80, 60]);
        let stats = render(&context, &scene, &ideal(TriangleSort::default())).stats;
        assert_eq!(stats.geometry_passes, u64::from(stats.iterations) * 2 - 1);
        let layers = render(&context, &scene, &LAYERS).stats;
        assert!(stats.iterations <= layers.iterations, "{name}");
    }
}

#[test]
pub(crate) fn c19_the_ideal_gpu_by_images_gives_the_same_image() {
    let context = Context::headless().unwrap();
    let driver = context.driver();
    // Without an interlock nothing promises the order.
    if !driver.has("GL_ARB_fragment_shader_interlock") && !driver.quirks().runs_in_order {
        println!("skipped: no GL_ARB_fragment_shader_interlock");
        return;
    }
    for name in ["knots", "soup"] {
        let scene = example(name, [120, 90]);
        let exact = render(&context, &scene, &Method::Exact);
        for tight_bound in [false, true] {
            let by = |access| {
                let options = IdealOptions {
                    tight_bound,
                    access,
                    ..IdealOptions::default()
                };
                render(
                    &context,
                    &scene,
                    &Method::IdealCoherentLayerPeeling(options),
                )
            };
            let images = by(BufferAccess::Images);
            let image = settled(&context, &images, &exact);
            let error = Comparison::new(&image, &exact.image, F32).unwrap();
            assert_eq!(error.over, 0, "{name}: {error:?}");
            if driver.has("GL_EXT_shader_framebuffer_fetch") {
                let fetched = by(BufferAccess::Best);
                assert!(images.image == fetched.image, "{name}");
                assert_eq!(images.stats.iterations, fetched.stats.iterations, "{name}");
            }
        }
    }
}

#[test]
pub(crate) fn batches_give_the_same_image_in_fewer_iterations_each() {
    let context = Context::headless().unwrap();
    let mut scene = Scene::of("knot", vec![torus_knot(&TorusKnot::default()).unwrap()]);
    scene.size = [120, 90];
    scene.meshes[0] = scene.meshes[0].shuffled(9);
    for mesh in &mut scene.meshes {
        for vertex in &mut mesh.vertices {
            vertex.color.a = 0.5;
        }
        mesh.opaque = false;
    }
    let exact = render(&context, &scene, &Method::Exact);
    for variant in [Variant::A, Variant::B] {
        for batches in [1, 2, 5, 16] {
            let options = CoherentOptions {
                sorting: TriangleSort::Submission,
                batches,
                ..variant.into()
            };
            let frame = render(&context, &scene, &Method::CoherentLayerPeeling(options));
            println!("{batches} batches: {} iterations", frame.stats.iterations);
            assert!(
                error(&frame, &exact) <= F32,
                "{variant:?}, {batches}: {}",
                error(&frame, &exact)
            );
            assert_eq!(frame.stats.lost, Some(0), "{variant:?}, {batches}");
        }
    }
}

#[test]
fn improvements_give_the_same_image() {
    let context = Context::headless().unwrap();
    let scene = example("knots", [120, 90]);
    let exact = render(&context, &scene, &Method::Exact);
    for variant in [Variant::A, Variant::B] {
        let faithful = render(
            &context,
            &scene,
            &Method::CoherentLayerPeeling(variant.into()),
        );
        let options = CoherentOptions {
            tie_friendly: true,
            stop_early: true,
            ..variant.into()
        };
        let improved = render(&context, &scene, &Method::CoherentLayerPeeling(options));
        assert!(error(&improved, &exact) <= F32);
        assert!(improved.stats.geometry_passes < faithful.stats.geometry_passes);
    }
}

// ---- As printed ------------------------------------------------------------------------------------------------------

#[test]
pub(crate) fn cx08_what_never_ends_is_given_up_and_says_so() {
    const AS_PRINTED: Amendment = Amendment {
        key: "CX08 undone",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "section 5.2, pass 6",
        printed: steps! { glUseProgram(AT_BOUND); },
        amended: steps! { glUseProgram(AT_BOUND_AS_PRINTED); },
        why: "what does the guard do?",
        test: "this one",
    };
    let context = Context::headless().unwrap();
    // Of three surfaces one lies exactly on the opaque one.
    let piece = |level| stack::Piece {
        level,
        color: [0.5; 4],
    };
    let scene = stack::Stack {
        width: 1,
        pixels: vec![vec![piece(500), piece(100), piece(300)]],
        opaque: Some(500),
    }
    .scene();
    for variant in [Variant::A, Variant::B] {
        let run = |amendments| {
            let options = CoherentOptions {
                amendments,
                sorting: TriangleSort::Submission,
                ..variant.into()
            };
            render(&context, &scene, &Method::CoherentLayerPeeling(options)).stats
        };
        assert_eq!(run(&[]).stopped, Some(Reason::EmptyLayer));
        let endless = run(&[AS_PRINTED]);
        assert_eq!(endless.stopped, Some(Reason::NoEnd), "{endless}");
        assert!(
            endless
                .to_string()
                .contains("more iterations than surfaces"),
            "{endless}"
        );
    }
}

#[test]
pub(crate) fn cx22_as_printed_the_ideal_gpu_composites_layers_again() {
    let context = Context::headless().unwrap();
    if !is_ideal(&context) {
        return;
    }
    let scene = example("knots", [120, 90]);
    let exact = render(&context, &scene, &Method::Exact);
    let run = |reading, tight_bound| {
        let options = IdealOptions {
            reading,
            tight_bound,
            ..IdealOptions::default()
        };
        render(
            &context,
            &scene,
            &Method::IdealCoherentLayerPeeling(options),
        )
    };
    assert!(error(&run(Reading::AsPrinted, false), &exact) > 0.01);
    let (faithful, tight) = (run(Reading::Amended, false), run(Reading::Amended, true));
    assert!(error(&faithful, &exact) <= F32 && error(&tight, &exact) <= F32);
    // CX23.
    assert!(tight.stats.iterations <= faithful.stats.iterations);
}
