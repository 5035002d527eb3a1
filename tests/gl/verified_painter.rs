//! The verified painter: exact wherever the oracle is, whatever the order of submission; what it marks, and why.

use glam::DVec3;
use onionskin::generate::{Soup, TorusKnot, soup, torus_knot};
use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::gl::{Geometry, GlMachine, Texels, largest_storage};
use onionskin::low_level::methods::{VerifiedCounts, allocate_maps};
use onionskin::low_level::papers::edition::{BLEND_AND_PROVE, PROOF_DEPTH, RESOURCES};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Variables, run};
use onionskin::{Comparison, Context, Format, Frame, Mesh, Method, Renderer, Rgba, Scene, Shading};

use crate::kit::bounds::{self, F32};
use crate::kit::chance::Chance;
use crate::kit::changed::{Change, with_change};
use crate::kit::lockstep::{LockStep, Watched, surfaces};
use crate::kit::render::{example, render};
use crate::kit::stack::{LEVELS, Piece, Stack, expect_none, runner, stacks};

pub const METHOD: Method = Method::VerifiedPainter;

pub fn counts(frame: &Frame) -> VerifiedCounts {
    frame.stats.verified.expect("the method proves")
}

/// The largest difference from the oracle's image at pixels that do not hang on a difference of depth that the depth buffer
/// cannot hold.
pub fn error(context: &Context, scene: &Scene, frame: &Frame) -> f64 {
    let exact = render(context, scene, &Method::Exact);
    let hanging = exact
        .hanging
        .as_ref()
        .expect("the oracle says which")
        .drawn
        .clone();
    let among = |pixel: usize| !hanging[pixel];
    Comparison::among(&frame.image, &exact.image, F32, among)
        .unwrap()
        .max
}

#[test]
fn every_bundled_scene_is_exact_by_the_verified_painter() {
    let context = Context::headless().unwrap();
    let (mut marked, mut proved) = (0, 0);
    for name in [
        "knots", "molecule", "quads", "sheets64", "slices", "soup", "teapot",
    ] {
        let scene = example(name, [160, 120]);
        let frame = render(&context, &scene, &METHOD);
        let error = error(&context, &scene, &frame);
        println!("{name}: off by {error:.1e}, {:?}", counts(&frame));
        assert!(error <= F32, "{name}: {error}");
        assert_eq!(frame.stats.lost, Some(0));
        marked += u32::from(counts(&frame).marked_pixels > 0);
        proved += u32::from(counts(&frame).marked_pixels == 0);
    }
    assert!(marked >= 4 && proved >= 2, "{marked} {proved}");
}

/// Ties, opaque depths, and alphas of 0 and 1 are among them.
#[test]
fn random_stacks_are_the_oracle_s() {
    let context = Context::headless().unwrap();
    for levels in [4, 500] {
        let outcome = runner(60).run(&stacks(levels, false), |stack| {
            let frame = render(&context, &stack.scene(), &METHOD);
            let compared = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
            proptest::prop_assert!(compared.max <= F32, "off by {}", compared.max);
            Ok(())
        });
        expect_none(outcome);
    }
}

/// A stack whose quads the CPU sorts right, but for those on one depth: just the pixels with ties are marked, and their
/// lists hold just their fragments.
#[test]
fn what_is_marked_is_what_is_tied() {
    let context = Context::headless().unwrap();
    let mut chance = Chance::new(16);
    let pixels: Vec<Vec<Piece>> = (0..40 * 30)
        .map(|_| {
            let count = chance.below(9);
            let piece = |_| Piece {
                level: (chance.below(12) * usize::from(LEVELS) / 12) as u16,
                color: std::array::from_fn(|_| chance.below(256) as f32 / 255.0),
            };
            (0..count).map(piece).collect()
        })
        .collect();
    let has_ties = |pieces: &&Vec<Piece>| {
        let mut levels: Vec<u16> = pieces.iter().map(|piece| piece.level).collect();
        levels.sort_unstable();
        levels.windows(2).any(|pair| pair[0] == pair[1])
    };
    let tied: Vec<&Vec<Piece>> = pixels.iter().filter(has_ties).collect();
    let fragments: usize = tied.iter().map(|pieces| pieces.len()).sum();
    let (pixels_tied, fragments_tied) = (tied.len() as u64, fragments as u64);
    assert!(pixels_tied > 300, "{pixels_tied}");
    let stack = Stack {
        width: 40,
        pixels,
        opaque: None,
    };
    let frame = render(&context, &stack.scene(), &METHOD);
    let counts = counts(&frame);
    assert_eq!(counts.marked_pixels, pixels_tied);
    assert_eq!(counts.list_fragments, fragments_tied);
    // The verified pass, and one more to fill the lists.
    assert_eq!(frame.stats.geometry_passes, 2);
    let compared = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert!(compared.max <= F32, "{}", compared.max);
}

/// Each quad of a stack twice: every pixel is marked, and llvmpipe's largest buffer (128 MiB) does not hold the lists of
/// all, which take their turns.
#[test]
fn lists_that_do_not_fit_into_a_buffer_take_turns() {
    let context = Context::headless().unwrap();
    let scene = |size| {
        let mut scene = example("sheets64", size);
        // Nobody sees the inside, but records that are to hold it have 32 bytes.
        scene.meshes[0].inside = [2.0; 3];
        let again = scene.meshes[0].clone();
        scene.meshes.push(again);
        scene
    };
    let frame = render(&context, &scene([240, 180]), &METHOD);
    let fragments = 240 * 180 * 128;
    assert_eq!(counts(&frame).list_fragments, fragments);
    if largest_storage(&context, Texels::Rgba32Ui) < fragments * 32 {
        assert!(frame.stats.geometry_passes > 2, "{}", frame.stats);
    }
    // Every pixel has the same fragments.
    let exact = render(&context, &scene([8, 6]), &Method::Exact)
        .image
        .pixels[27];
    let bound = bounds::composited(128) as f32;
    for pixel in &frame.image.pixels {
        let channels = pixel.to_array().into_iter().zip(exact.to_array());
        assert!(
            channels.into_iter().all(|(a, b)| (a - b).abs() <= bound),
            "{pixel:?} {exact:?}"
        );
    }
}

/// In order there is one pass, and no byte of lists.
#[test]
fn sorted_quads_are_proved_in_one_pass() {
    let context = Context::headless().unwrap();
    let frame = render(&context, &example("sheets64", [64, 48]), &METHOD);
    assert_eq!(counts(&frame), VerifiedCounts::default());
    assert_eq!(frame.stats.geometry_passes, 1);
}

/// A frame of shuffled triangles has the same bits, but for pixels that failed in one of them: there the blends round
/// as a shader does, and not as the blending unit does.
#[test]
fn shuffled_triangles_give_the_same_image() {
    let context = Context::headless().unwrap();
    for (name, mesh) in [
        (
            "soup",
            soup(&Soup {
                count: 300,
                ..Soup::default()
            })
            .unwrap(),
        ),
        (
            "knot",
            torus_knot(&TorusKnot::default())
                .unwrap()
                .painted(Rgba::new(0.8, 0.5, 0.2, 0.4)),
        ),
    ] {
        let mut scene = Scene::of(name, vec![mesh]);
        scene.size = [80, 60];
        let mut shuffled = scene.clone();
        shuffled.meshes[0] = shuffled.meshes[0].shuffled(8);
        let [a, b] = [&scene, &shuffled].map(|scene| render(&context, scene, &METHOD));
        let pairs = a.image.pixels.iter().zip(&b.image.pixels);
        let different = pairs.filter(|(a, b)| a != b).count() as u64;
        let failed = counts(&a).marked_pixels + counts(&b).marked_pixels;
        assert!(different <= failed, "{name}: {different} of {failed}");
        let off = Comparison::new(&a.image, &b.image, F32).unwrap().max;
        assert!(off <= F32, "{name}: {off}");
    }
}

/// Meshes of every shading, an opaque one among them, interlocked and drawn by one call: as the oracle sees them.
#[test]
fn meshes_of_several_shadings_are_drawn_together() {
    let context = Context::headless().unwrap();
    let shadings = [
        Shading::None,
        Shading::Flat,
        Shading::Lit,
        Shading::TwoSided,
    ];
    let knot = |(number, shading): (usize, Shading)| {
        let mesh = torus_knot(&TorusKnot {
            p: 2 + number as u32,
            q: 7,
            ..TorusKnot::default()
        })
        .unwrap();
        let turned = number as f32 / 4.0;
        let mesh = mesh.painted(Rgba::new(turned, 0.5, 1.0 - turned, 0.3 + turned / 4.0));
        let mesh = match shading {
            Shading::Flat => mesh.with_face_normals(),
            _ => mesh,
        };
        Mesh {
            shading,
            inside: [0.9, 0.1, 0.2],
            ..mesh
        }
    };
    let mut meshes: Vec<Mesh> = shadings.into_iter().enumerate().map(knot).collect();
    let opaque = knot((4, Shading::Lit)).painted(Rgba::opaque([0.2, 0.7, 0.3]));
    meshes.insert(
        2,
        Mesh {
            opaque: true,
            ..opaque
        },
    );
    let mut scene = Scene::of("shadings", meshes);
    scene.size = [160, 120];
    let frame = render(&context, &scene, &METHOD);
    let off = error(&context, &scene, &frame);
    assert!(off <= F32, "{off}");
    assert!(counts(&frame).marked_pixels > 0);
    let blended = render(&context, &scene, &Method::Blend);
    assert!(error(&context, &scene, &blended) > 0.1);
}

/// Depths by 1/w are tested in the shader.
#[test]
fn depths_by_1_over_w_prove_the_order_too() {
    let context = Context::headless().unwrap();
    for name in ["teapot", "soup"] {
        let scene = example(name, [120, 90]);
        let mut renderer = Renderer::new(&context, 120, 90).unwrap().with_inverse_w();
        let frame = renderer.render(&scene, &METHOD).unwrap();
        let exact = renderer.render(&scene, &Method::Exact).unwrap();
        let hanging = exact.hanging.unwrap().drawn;
        let compared = Comparison::among(&frame.image, &exact.image, F32, |p| !hanging[p]).unwrap();
        assert!(compared.max <= F32, "{name}: {}", compared.max);
    }
}

/// The next frame sorts for its own camera.
#[test]
fn another_view_is_sorted_anew() {
    let context = Context::headless().unwrap();
    let mut scene = example("knots", [80, 60]);
    let mut renderer = Renderer::new(&context, 80, 60).unwrap();
    for turn in 0..4 {
        let eye = scene.camera.eye - scene.camera.target;
        scene.camera.eye = scene.camera.target + DVec3::new(eye.z, eye.y, -eye.x);
        let frame = renderer.render(&scene, &METHOD).unwrap();
        let off = error(&context, &scene, &frame);
        assert!(off <= F32, "{turn}: {off}");
    }
}

const CHANGES: [Change; 5] = [
    ["verified/number.glsl", "word.g +", "word.g -"],
    [
        "verified/hidden.glsl",
        "FRAGMENT_DEPTH >=",
        "FRAGMENT_DEPTH <",
    ],
    [
        "verified/list.glsl",
        "number % band.width",
        "(number + 1u) % band.width",
    ],
    [
        "verified/mark.frag",
        "1u << (here.x % 32u)",
        "2u << (here.x % 32u)",
    ],
    [
        "verified/place.frag",
        "list_number())",
        "list_number() + 1u)",
    ],
];

#[test]
fn a_changed_word_is_noticed() {
    let context = Context::headless().unwrap();
    // Opaque surfaces are among its meshes.
    let scene = example("molecule", [80, 60]);
    for change in CHANGES {
        let mut renderer = with_change(Renderer::new(&context, 80, 60).unwrap(), change);
        let frame = renderer.render(&scene, &METHOD).unwrap();
        let off = error(&context, &scene, &frame);
        println!("{change:?}: {off}");
        assert!(off > 1e-3, "{change:?}: {off}");
    }
}

/// OpenGL and the emulated pixel agree about every mark, depth and colour.
#[test]
fn the_proof_is_the_emulated_pixel_s() {
    let context = Context::headless().unwrap();
    let mut chance = Chance::new(9);
    let pixels = (0..60 * 60).map(|_| {
        let count = chance.below(9);
        let piece = |_| Piece {
            level: (chance.below(16) * usize::from(LEVELS) / 16) as u16,
            color: std::array::from_fn(|_| chance.below(256) as f32 / 255.0),
        };
        (0..count).map(piece).collect()
    });
    let stack = Stack {
        width: 60,
        pixels: pixels.collect(),
        opaque: Some(700),
    };
    let scene = stack.scene();
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    let resources = [&stage::RESOURCES, &RESOURCES];
    let mut gl = GlMachine::new(&context, scene.size).unwrap();
    allocate_maps(&mut gl, &resources, color, depth).unwrap();
    gl.set_geometry(Geometry::upload(&context, &scene, scene.size).unwrap());
    gl.begin_frame();
    let pixels = surfaces(&mut gl, &scene, stage::IMAGE_COLOR);
    let drawn: Vec<usize> = (0..pixels.len())
        .filter(|&pixel| pixels[pixel].len() > 1)
        .collect();
    let mut emulator = Emulator::new(pixels);
    allocate_maps(&mut emulator, &resources, color, depth).unwrap();
    gl.begin_frame();
    gl.set_defines(&[("OPAQUE", 1)]);
    let watched = vec![
        Watched {
            map: PROOF_DEPTH,
            format: depth,
        },
        Watched {
            map: stage::IMAGE_COLOR,
            format: color,
        },
    ];
    let mut both = LockStep::new(&mut gl, &mut emulator, watched, drawn, 0.0);
    for listing in [&stage::OPAQUE_FIRST, &BLEND_AND_PROVE] {
        run(listing, &[], Variables::new(), &mut both).unwrap();
    }
    assert!(both.compared > 5000, "{}", both.compared);
    let marks = emulator.stencils(PROOF_DEPTH).unwrap();
    assert!(marks.iter().any(|&mark| mark > 0) && marks.contains(&0));
}
