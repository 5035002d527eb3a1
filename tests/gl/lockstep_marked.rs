//! The whole verified painter on the emulated pixel, with the lists of the pixels that failed, and OpenGL's frame of it. Both
//! are exact, so they may sort in other orders: what one proves, the other may take from a list.

use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::edition::{
    BACKGROUND_BEHIND, FAILED, NOTHING_OPAQUE, OPAQUE_BEHIND, PLACE_RESOLVED, PROOF_DEPTH,
    RESOLVED, RESOURCES, VERIFIED_PAINTER,
};
use onionskin::low_level::papers::lindholm_2015 as paper;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{
    Amendment, Call, Listing, Machine, Variables, Workspace, gl::*, run,
};
use onionskin::{Context, Format, Method, Renderer, Scene};

use crate::kit::both::{blending_bound, surfaces_of, transparent_pixels};
use crate::kit::stack::Stack;
use crate::lockstep::random_stack;
use crate::lockstep_order::{places, shuffled};

fn emulator(context: &Context, scene: &Scene) -> Emulator {
    let mut emulator = Emulator::new(surfaces_of(context, scene));
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(
        &mut emulator,
        &[&stage::RESOURCES, &RESOURCES],
        color,
        depth,
    )
    .unwrap();
    for map in [paper::COUNTER, paper::ANCHOR] {
        emulator.allocate(map, Format::R32Ui).unwrap();
    }
    emulator.allocate(RESOLVED, color).unwrap();
    let targets = [
        (paper::CLEARED, Some(paper::COUNTER), None),
        (paper::FILL, None, Some(PROOF_DEPTH)),
        (paper::RESOLVED, Some(RESOLVED), None),
    ];
    for (target, color, depth) in targets {
        emulator
            .framebuffer_with(target, color.as_slice(), depth)
            .unwrap();
    }
    emulator.set_order(Some(&places(scene, &shuffled(scene, 5))));
    emulator
}

fn defines(has_opaque: bool, lists: bool) -> Vec<(&'static str, u32)> {
    let mut defines = vec![("OPAQUE", u32::from(has_opaque))];
    if lists {
        defines.extend([
            ("MARKED", 1),
            ("FFB", 0),
            ("DFB", 1),
            ("PPLL", 2),
            ("MANAGER", 1),
            ("FLOAT_COLOR", 1),
            ("PP_DP", 1),
            ("FIRST_SEGMENT", 8),
            ("LAST_SEGMENT", 64),
        ]);
    }
    defines
}

/// As the method does it, with all lists in one band.
fn paint(emulator: &mut Emulator, scene: &Scene) {
    let has_opaque = scene.meshes.iter().any(|mesh| mesh.opaque);
    let [red, green, blue] = scene.background;
    let alpha = 1.0;
    let perform = |emulator: &mut Emulator, calls: &[Call]| {
        calls
            .iter()
            .for_each(|call| emulator.perform(call).unwrap());
    };
    let go = |emulator: &mut Emulator, listing: &Listing, amendments: &[Amendment]| {
        let segments = Variables::new().with("num_segments", 4.0);
        run(listing, amendments, segments, emulator).unwrap();
    };
    perform(
        emulator,
        &[Call::ClearColor {
            red,
            green,
            blue,
            alpha,
        }],
    );
    emulator.set_defines(&defines(has_opaque, false));
    let nothing_opaque: &[_] = if has_opaque { &[] } else { &NOTHING_OPAQUE };
    go(emulator, &VERIFIED_PAINTER, nothing_opaque);
    let failed = emulator.samples(FAILED).unwrap();
    assert!((1000..9000).contains(&failed), "{failed}");
    // Lists are filled in the order of submission.
    emulator.set_order(None);
    let behind = match has_opaque {
        true => OPAQUE_BEHIND,
        false => BACKGROUND_BEHIND,
    };
    go(emulator, &behind, &[]);
    perform(emulator, &[glEnable(STENCIL_TEST)]);
    emulator.set_defines(&defines(has_opaque, true));
    go(emulator, &paper::CLEAR_AND_FILL, &[paper::BEGIN_AT_OFFSETS]);
    let by_counter = [paper::BY_COUNTER, paper::NO_STENCIL, paper::MARKED];
    go(emulator, &paper::PP_AO, &by_counter);
}

/// By how much the emulated image is off OpenGL's, at the pixels with transparent surfaces.
fn apart(context: &Context, scene: &Scene, emulator: &Emulator) -> f32 {
    let [width, height] = scene.size;
    let renderer = Renderer::new(context, width, height).unwrap();
    let mut renderer = renderer.with_given_planes();
    let frame = renderer.render(scene, &Method::VerifiedPainter).unwrap();
    let image = emulator.colors(stage::IMAGE_COLOR).unwrap();
    let (width, height) = (width as usize, height as usize);
    let off = |pixel: usize| {
        // The frame's first row is the highest.
        let row = height - 1 - pixel / width;
        let on_gl = frame.image.pixels[row * width + pixel % width].to_array();
        let channels = on_gl.into_iter().zip(image[pixel]);
        let off = channels.map(|(a, b)| (a - b).abs());
        off.max_by(f32::total_cmp).unwrap()
    };
    let pixels = transparent_pixels(&surfaces_of(context, scene));
    let off = pixels.into_iter().map(off);
    off.max_by(f32::total_cmp).unwrap()
}

#[test]
fn ten_thousand_sequences_by_the_whole_verified_painter() {
    let context = Context::headless().unwrap();
    for opaque in [Some(700), None] {
        let stack = random_stack(30);
        let scene = Stack { opaque, ..stack }.scene();
        let mut emulator = emulator(&context, &scene);
        paint(&mut emulator, &scene);
        // Without the lists the pixels that failed are wrong.
        let off = apart(&context, &scene, &emulator);
        assert!(off > 0.1, "{off}");
        run(&PLACE_RESOLVED, &[], Variables::new(), &mut emulator).unwrap();
        let off = apart(&context, &scene, &emulator);
        assert!(off <= 2.0 * blending_bound(), "{off}");
        let stencils = emulator.stencils(PROOF_DEPTH).unwrap();
        for (pixel, &stencil) in stencils.iter().enumerate() {
            // What was not marked has no list.
            assert_eq!(stencil == 0, emulator.list(pixel).is_empty(), "{pixel}");
        }
    }
}
