//! Coplanar surfaces: which methods have all of them, in which order, and the detector that tells.

use crate::kit::bounds::F32;
use crate::kit::render::render;
use crate::kit::stack;
use onionskin::generate::{Plane, plane};
use onionskin::low_level::methods::coplanar::shown;
use onionskin::low_level::steps::{Amendment, Reason, gl::*};
use onionskin::options::{
    CoplanarDepthPeelingOptions, DepthPeelingOptions, DualDepthPeelingOptions,
};
use onionskin::{Comparison, Context, Format, Frame, Method, Renderer, Scene, registry, steps};
use proptest::test_runner::TestCaseError;

use crate::kit::stack::{Piece, Stack, runner, stacks};

const COPLANAR: Method = Method::CoplanarDepthPeeling(CoplanarDepthPeelingOptions {
    maximum_number_of_peels: 0,
});
const DUAL: Method = Method::DualDepthPeeling(DualDepthPeelingOptions {
    maximum_number_of_peels: 0,
    occlusion_ratio: 0.0,
    amendments: &[],
});

fn single() -> Method {
    Method::DepthPeeling(DepthPeelingOptions::default())
}

#[test]
pub(crate) fn vx03_coplanar_peeling_has_every_tie_in_the_order_of_submission() {
    let context = Context::headless().unwrap();
    let renderer = std::cell::RefCell::new(Renderer::new(&context, 3, 2).unwrap());
    for (levels, distinct) in [(stack::LEVELS, true), (5, false), (1, false)] {
        let outcome = runner(64).run(&stacks(levels, distinct), |stack| {
            let frame = renderer.borrow_mut().render(&stack.scene(), &COPLANAR);
            let frame = frame.unwrap();
            let (fragments, _) = stack.counts();
            let right = over(&frame, &stack) == 0
                && frame.stats.fragments == fragments
                && frame.stats.lost == Some(0);
            right
                .then_some(())
                .ok_or_else(|| TestCaseError::fail(format!("{:?}", frame.stats)))
        });
        stack::expect_none(outcome);
    }
}

#[test]
pub(crate) fn vx03_red_and_green_at_one_depth_are_red_before_green() {
    // By hand, over black: the first half covers, the second a quarter.
    let context = Context::headless().unwrap();
    let [red, green] = [[1.0, 0.0, 0.0, 0.5], [0.0, 1.0, 0.0, 0.5]];
    for (first, second) in [(red, green), (green, red)] {
        let scene = coplanar_quads(first, second);
        for method in [COPLANAR, DUAL, Method::Exact] {
            let pixel = render(&context, &scene, &method).image.pixels[0].to_array();
            for channel in 0..3 {
                let expected = 0.5 * first[channel] + 0.25 * second[channel];
                assert!(
                    (pixel[channel] - expected).abs() < 1e-6,
                    "{method}: {pixel:?}"
                );
            }
        }
        // Plain peeling keeps the first alone, and says so.
        let frame = render(&context, &scene, &single());
        assert_eq!(frame.stats.lost, Some(frame.image.pixels.len() as u64));
        assert_eq!(
            frame.image.pixels[0].to_array()[..3],
            first[..3].iter().map(|c| c * 0.5).collect::<Vec<_>>()[..]
        );
    }
}

#[test]
fn a_layer_takes_two_geometry_passes_and_the_end_one() {
    let context = Context::headless().unwrap();
    for layers in 0..5_u16 {
        let list = (0..layers).flat_map(|n| [piece(n * 100), piece(n * 100)]);
        let stack = Stack {
            width: 3,
            pixels: vec![list.collect(); 6],
            opaque: None,
        };
        let stats = render(&context, &stack.scene(), &COPLANAR).stats;
        assert_eq!(
            (stats.layers, stats.geometry_passes, stats.stopped),
            (
                Some(u32::from(layers)),
                2 * u64::from(layers) + 1,
                Some(Reason::EmptyLayer)
            )
        );
    }
}

#[test]
fn a_limit_leaves_the_farther_depths_out_and_counts_their_fragments() {
    let context = Context::headless().unwrap();
    let list = [300, 100, 100, 300, 200, 300].map(piece);
    let stack = Stack {
        width: 3,
        pixels: vec![list.to_vec(); 6],
        opaque: None,
    };
    for (peels, lost) in [(1, 24), (2, 18), (3, 0)] {
        let method = Method::CoplanarDepthPeeling(CoplanarDepthPeelingOptions {
            maximum_number_of_peels: peels,
        });
        let stats = render(&context, &stack.scene(), &method).stats;
        assert_eq!((stats.layers, stats.lost), (Some(peels), Some(lost)));
    }
}

#[test]
pub(crate) fn real_meshes_with_duplicated_faces_lose_none() {
    // VX04: a scan with duplicated faces. The teapot with every third triangle submitted twice.
    let context = Context::headless().unwrap();
    let scene = with_duplicates(&example("teapot"));
    let exact = render(&context, &scene, &Method::Exact);
    for method in [COPLANAR, DUAL] {
        let frame = render(&context, &scene, &method);
        let error = Comparison::new(&frame.image, &exact.image, F32).unwrap();
        assert_eq!((error.over, frame.stats.lost), (0, Some(0)), "{method}");
    }
    let plain = render(&context, &scene, &single());
    let error = Comparison::new(&plain.image, &exact.image, F32).unwrap();
    println!(
        "plain peeling: {} pixels off, {:?} fragments lost",
        error.over, plain.stats.lost
    );
    assert!(error.over > 100 && plain.stats.lost > Some(100));
}

#[test]
fn the_detector_finds_what_plain_peeling_drops_and_agrees_with_its_own_count() {
    let context = Context::headless().unwrap();
    let scene = with_duplicates(&example("teapot"));
    let format = Format::Depth32FStencil8;
    let lost = render(&context, &scene, &single()).stats.lost.unwrap();
    let found = shown(&context, &scene, &single(), format).unwrap();
    assert_eq!((found.missing(), found.doubled()), (lost, 0));
    for method in [
        COPLANAR,
        DUAL,
        Method::Blend,
        Method::Painter,
        Method::Exact,
    ] {
        let found = shown(&context, &scene, &method, format).unwrap();
        assert_eq!((found.missing(), found.doubled()), (0, 0), "{method}");
    }
}

#[test]
fn the_detector_agrees_with_every_methods_own_count() {
    let context = Context::headless().unwrap();
    let scene = with_duplicates(&example("teapot"));
    for entry in registry() {
        if !entry.runs_on(context.driver()) {
            println!("skipped: {} ({:?})", entry.name, entry.needs);
            continue;
        }
        let lost = render(&context, &scene, &entry.method).stats.lost;
        let found = shown(&context, &scene, &entry.method, Format::Depth32FStencil8).unwrap();
        assert_eq!(
            (Some(found.missing()), found.doubled()),
            (lost, 0),
            "{}",
            entry.name
        );
    }
}

#[test]
fn the_detector_finds_what_blending_by_max_merges() {
    // Dual peeling as it was published, for the back: one blend equation for all draw buffers.
    const MAX_FOR_ALL: &[Amendment] = &[Amendment {
        key: "",
        kind: onionskin::low_level::steps::Kind::Correction,
        place: "",
        printed: steps! { glBlendFunci(2, ONE_MINUS_DST_ALPHA, ONE); },
        amended: steps! { glBlendEquationi(2, MAX); },
        why: "to see whether it is noticed",
        test: "",
    }];
    let context = Context::headless().unwrap();
    let list = [100, 500, 500, 500].map(piece);
    let stack = Stack {
        width: 3,
        pixels: vec![list.to_vec(); 6],
        opaque: None,
    };
    let missing = |amendments| {
        let method = Method::DualDepthPeeling(DualDepthPeelingOptions {
            amendments,
            ..Default::default()
        });
        let found = shown(&context, &stack.scene(), &method, Format::Depth32FStencil8);
        found.unwrap().missing()
    };
    assert_eq!((missing(&[]), missing(MAX_FOR_ALL)), (0, 12));
}

#[test]
fn the_detector_counts_stacks_as_they_were_made() {
    // Nothing here comes from a capture but `submitted`, which has to be the stack's.
    let context = Context::headless().unwrap();
    let counts = [0, 1, 7, 30, 200, 2_u16];
    let list = |count: u16| (0..count).map(|n| piece(n / 2 * 4)).collect::<Vec<_>>();
    let stack = Stack {
        width: 3,
        pixels: counts.map(list).to_vec(),
        opaque: None,
    };
    let format = Format::Depth32FStencil8;
    let all = counts.map(u32::from);
    let halves = counts.map(|count| u32::from(count).div_ceil(2));
    let found = shown(&context, &stack.scene(), &COPLANAR, format).unwrap();
    assert_eq!((found.submitted, found.shown), (all.to_vec(), all.to_vec()));
    let found = shown(&context, &stack.scene(), &single(), format).unwrap();
    assert_eq!(
        (found.submitted, found.shown),
        (all.to_vec(), halves.to_vec())
    );
}

#[test]
fn what_lies_on_an_opaque_surface_is_hidden_in_every_method() {
    let context = Context::headless().unwrap();
    // Finished pixels, pixels that are not, and ties on the opaque surface itself.
    let pixels = [
        vec![500, 500],
        vec![100, 500, 500],
        vec![100, 100, 500],
        vec![],
        vec![600, 500],
        vec![100, 200, 300, 400, 500],
    ];
    let stack = Stack {
        width: 3,
        pixels: pixels
            .map(|list| list.into_iter().map(piece).collect())
            .to_vec(),
        opaque: Some(500),
    };
    for method in [COPLANAR, DUAL, Method::Exact] {
        let frame = render(&context, &stack.scene(), &method);
        assert_eq!(over(&frame, &stack), 0, "{method}");
        assert_eq!((frame.stats.fragments, frame.stats.lost), (7, Some(0)));
    }
}

/// Two quads over the whole image, exactly equal but for their colour.
fn coplanar_quads(first: [f32; 4], second: [f32; 4]) -> Scene {
    let quad = |color: [f32; 4]| plane(&Plane::default()).unwrap().painted(color.into());
    let mut scene = Scene::of("quads", vec![quad(first), quad(second)]);
    scene.size = [16, 12];
    // From straight above and so near that the plane covers everything.
    let bounds = scene.bounds().unwrap();
    let middle = (bounds.min + bounds.max) / 2.0;
    let extent = bounds.max - bounds.min;
    let axis = [glam::DVec3::X, glam::DVec3::Y, glam::DVec3::Z];
    let flat = axis
        .into_iter()
        .find(|axis| extent.dot(*axis) == 0.0)
        .unwrap();
    let size = extent.max_element();
    scene.camera.eye = middle + flat * size / 8.0;
    scene.camera.target = middle;
    scene.camera.up = if flat == glam::DVec3::Y {
        glam::DVec3::X
    } else {
        glam::DVec3::Y
    };
    scene.camera.near = size / 100.0;
    scene.camera.far = size;
    scene
}

/// Every third triangle of each mesh once more at the mesh's end.
fn with_duplicates(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    for mesh in &mut scene.meshes {
        let again: Vec<_> = mesh.triangles.iter().step_by(3).copied().collect();
        mesh.triangles.extend(again);
    }
    scene
}

fn piece(level: u16) -> Piece {
    Piece {
        level,
        color: [f32::from(level) / 1000.0, 0.5, 0.25, 0.5],
    }
}

fn example(name: &str) -> Scene {
    crate::kit::render::example(name, [160, 120])
}

/// How many pixels of the frame are not the stack's.
fn over(frame: &Frame, stack: &Stack) -> usize {
    let error = Comparison::new(&frame.image, &stack.expected(), F32);
    error.unwrap().over
}
