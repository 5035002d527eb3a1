//! What VTK's page says of its switches (V01, V05, V10) and of rectangle textures (V08), each claim under its key, and what
//! its errata's cases come to here (V5, V6).

use crate::kit::bounds::F32;
use crate::kit::lists::Lists;
use crate::kit::render::example;
use crate::kit::stack::{Piece, Stack};
use crate::kit::vtk_scenes::{nearest, over, piece, soup_scene};
use onionskin::Comparison;
use onionskin::low_level::methods::{Peeling, Technique};
use onionskin::low_level::steps::Reason;
use onionskin::options::{
    CoherentOptions, DepthPeelingOptions, DepthUnit0, TriangleSort, Variant, VtkSettings,
};
use onionskin::{Context, Format, Frame, Method, Renderer, Scene};

const ON: VtkSettings = VtkSettings {
    alpha_bit_planes: true,
    use_depth_peeling: true,
    maximum_number_of_peels: 4,
    occlusion_ratio: 0.0,
};

fn render(context: &Context, scene: &Scene, method: &dyn Technique) -> Frame {
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(context, width, height).unwrap();
    renderer.render(scene, method).unwrap()
}

/// One pixel with seven layers.
fn seven() -> Stack {
    Stack {
        width: 1,
        pixels: vec![(1..=7).rev().map(|n| piece(n * 100)).collect()],
        opaque: None,
    }
}

/// "Set the maximum number of rendering passes (initial value is 4)": the image of four layers, the rest is left out.
#[test]
pub(crate) fn v01_vtk_s_initial_maximum_is_4_peels() {
    let context = Context::headless().unwrap();
    assert_eq!(VtkSettings::default().maximum_number_of_peels, 4);
    let settings = VtkSettings {
        alpha_bit_planes: true,
        use_depth_peeling: true,
        ..VtkSettings::default()
    };
    let frame = render(&context, &seven().scene(), &settings);
    assert_eq!((frame.stats.layers, frame.stats.lost), (Some(4), Some(3)));
    assert_eq!(frame.stats.stopped, Some(Reason::PeelLimit));
    assert_eq!(over(&frame, &nearest(&seven(), 4)), 0);
    assert_eq!(over(&frame, &nearest(&seven(), 5)), 1);
    // The method by itself has no limit.
    let frame = render(&context, &seven().scene(), &DepthPeelingOptions::default());
    assert_eq!((frame.stats.layers, frame.stats.lost), (Some(7), Some(0)));
}

/// "Choose to use depth peeling (initial value is 0 (false))", "use a render window with alpha bits (as initial value is 0
/// (false))": at first translucent geometry is blended as it comes.
#[test]
pub(crate) fn v10_depth_peeling_is_off_at_first_and_needs_alpha_bit_planes() {
    let context = Context::headless().unwrap();
    let first = VtkSettings::default();
    assert_eq!(
        (first.alpha_bit_planes, first.use_depth_peeling),
        (false, false)
    );
    let scene = soup_scene();
    let blended = render(&context, &scene, &Method::Blend);
    for (alpha_bit_planes, use_depth_peeling) in [(false, false), (true, false), (false, true)] {
        let settings = VtkSettings {
            alpha_bit_planes,
            use_depth_peeling,
            ..first
        };
        let frame = render(&context, &scene, &settings);
        assert!(frame.image == blended.image, "{settings:?}");
        assert_eq!(frame.stats.method, "blend");
    }
    let peeled = render(&context, &scene, &ON);
    assert!(peeled.image != blended.image);
    assert_eq!(peeled.stats.method, "depth-peeling");
}

/// "Check if depth peeling was actually used": every answer that a caller can get, with its reason.
#[test]
pub(crate) fn v05_a_caller_can_ask_whether_depth_peeling_was_used_and_why_not() {
    let context = Context::headless().unwrap();
    let mut opaque = Stack {
        opaque: Some(500),
        ..seven()
    }
    .scene();
    opaque.meshes.truncate(1);
    let off = VtkSettings {
        use_depth_peeling: false,
        ..ON
    };
    let no_planes = VtkSettings {
        alpha_bit_planes: false,
        ..ON
    };
    let scene = seven().scene();
    let cases: [(&Scene, &dyn Technique, Peeling, &str); 5] = [
        (&scene, &ON, Peeling::Used, "used"),
        (
            &scene,
            &off,
            Peeling::SwitchedOff,
            "not used: it is switched off",
        ),
        (
            &scene,
            &no_planes,
            Peeling::NoAlphaBits,
            "not used: the window has no alpha bit planes",
        ),
        (
            &opaque,
            &ON,
            Peeling::NothingTransparent,
            "not used: nothing is transparent",
        ),
        (
            &scene,
            &Method::Painter,
            Peeling::OtherMethod,
            "not used: another method",
        ),
    ];
    for (scene, technique, expected, text) in cases {
        let stats = render(&context, scene, technique).stats;
        assert_eq!(stats.peeling, expected, "{technique:?}");
        assert_eq!(stats.peeling.to_string(), text);
    }
}

/// "In order to use rectangle textures in GLSL, we are supposed to used sampler2DRectShadow": every peel looks its shadow
/// map up in a rectangle texture, by texels. The layers are those of a texture of two dimensions, to the last bit.
#[test]
pub(crate) fn v08_depth_peeling_through_rectangle_textures_gives_the_same_image() {
    let context = Context::headless().unwrap();
    for size in [[120, 90], [97, 61], [1, 33]] {
        let mut scene = soup_scene();
        scene.size = size;
        let peels = Lists::of(&context, &scene).complexity() as u32 + 2;
        let by = |depth_unit_0| {
            let options = DepthPeelingOptions {
                depth_unit_0,
                maximum_number_of_peels: peels,
                ..Default::default()
            };
            render(&context, &scene, &options)
        };
        let [two_d, rectangle] = [
            DepthUnit0::ClassicDepthReplace,
            DepthUnit0::ClassicRectangle,
        ]
        .map(by);
        assert!(rectangle.image == two_d.image, "{size:?}");
        assert_eq!(rectangle.stats.layers, two_d.stats.layers);
        assert!(
            rectangle.stats.layers > Some(3),
            "{size:?}: there is something to peel"
        );
        // And it is the exact image but for pixels whose depths tie in r/q.
        let exact = render(&context, &scene, &Method::Exact).image;
        let error = Comparison::new(&rectangle.image, &exact, F32).unwrap();
        assert!(error.over < 10, "{size:?}: {error:?}");
    }
}

// ---- Errata ----------------------------------------------------------------------------------------------------------

/// Erratum VX05. Below an alpha of 1/510, 8 bits hold nothing of a layer, and a query that counts pixels which became visible
/// would stop. This one counts what was peeled.
#[test]
pub(crate) fn vx05_layers_below_the_step_of_8_bits_are_peeled_and_counted_all_the_same() {
    let context = Context::headless().unwrap();
    let faint = Stack {
        width: 1,
        pixels: vec![
            (0..256)
                .map(|n| Piece {
                    level: n * 3,
                    color: [1.0, 0.0, 0.0, 1.0 / 600.0],
                })
                .collect(),
        ],
        opaque: None,
    };
    let formats = [Format::Rgba32F, Format::Rgba8];
    let [float, bytes] = formats.map(|color| {
        let mut renderer = Renderer::new(&context, 1, 1)
            .unwrap()
            .with_formats(color, Format::Depth32FStencil8);
        renderer
            .render(&faint.scene(), &DepthPeelingOptions::default())
            .unwrap()
    });
    for frame in [&float, &bytes] {
        assert_eq!((frame.stats.layers, frame.stats.lost), (Some(256), Some(0)));
        assert_eq!(frame.stats.stopped, Some(Reason::EmptyLayer));
    }
    assert_eq!(over(&float, &faint), 0);
    // A third of the light is gone with 8 bits, and nothing says so but the format.
    let error = Comparison::new(&bytes.image, &faint.expected(), 0.0)
        .unwrap()
        .max;
    println!("with 8 bits: {error:.3}");
    assert!(error > 0.2, "{error}");
}

/// Erratum VX06. Planes at 0.001 and 10000 tie depths that are apart. Depth peeling says how many fragments it lost by that.
/// Coherent layer peeling loses none, but no order of submission puts the ties into the order that they have in space.
#[test]
pub(crate) fn vx06_loose_planes_make_ties_which_depth_peeling_loses_and_coherent_peeling_cannot_order()
 {
    let context = Context::headless().unwrap();
    let mut scene = example("knots", [120, 90]);
    (scene.camera.near, scene.camera.far) = (0.001, 10_000.0);
    let [width, height] = scene.size;
    let exact = render(&context, &scene, &Method::Exact);
    let with = |technique: &dyn Technique, given: bool| {
        let renderer = Renderer::new(&context, width, height).unwrap();
        let mut renderer = if given {
            renderer.with_given_planes()
        } else {
            renderer
        };
        let frame = renderer.render(&scene, technique).unwrap();
        let error = Comparison::new(&frame.image, &exact.image, 0.0)
            .unwrap()
            .max;
        (frame.stats.lost.unwrap(), error)
    };
    let peeling = DepthPeelingOptions::default();
    let coherent = |sorting| CoherentOptions {
        sorting,
        ..Variant::A.into()
    };
    let (lost, error) = with(&peeling, true);
    println!("depth peeling: {lost} lost, error {error:.3}");
    assert!(lost > 0 && error > 0.05, "{lost} {error}");
    let sorted = with(&coherent(TriangleSort::default()), true);
    let submitted = with(&coherent(TriangleSort::Submission), true);
    println!("coherent A: sorted {sorted:?}, in the order of submission {submitted:?}");
    assert_eq!((sorted.0, submitted.0), (0, 0));
    assert!(sorted.1 > 0.01 && submitted.1 > 0.01);
    // By default the planes are moved close to the geometry, and there is nothing to tie.
    for technique in [
        &peeling as &dyn Technique,
        &coherent(TriangleSort::default()),
    ] {
        let (lost, error) = with(technique, false);
        assert!(lost == 0 && error <= F32, "{technique:?}: {lost} {error}");
    }
}
