//! Everitt's Listing 2: as text, in f64 against his equations 1 to 4, and running; and depth peeling as he ran it in
//! 2001, which leans on it.

use crate::kit::bounds::F32;
use crate::kit::driver::interpolates_true_corners;

use crate::kit::render::render;
use glam::{DMat4, DVec3, DVec4};
use onionskin::generate::{Soup, soup};
use onionskin::low_level::gl::{CapturedFragment, ClassicState, Geometry, GlMachine};
use onionskin::low_level::papers::everitt_2001::{ENABLED, LISTING_2, SHADOW_AS_DEPTH_TEST};
use onionskin::low_level::steps::{
    Call, Capability, ClassicCall, Machine, Map, Objects, Query, Shader, Step, Target, Variables,
    gl::*, print, run,
};
use onionskin::options::{Compositing, DepthPeelingOptions, DepthUnit0};
use onionskin::{Camera, Comparison, Context, Error, Format, Frame, Method, Result, Rgba, Scene};

use crate::kit::lists::Lists;

#[test]
pub(crate) fn e08_listing_2_prints_as_the_paper_has_it() {
    let transcript = include_str!("../print/everitt/listing-2.txt");
    assert_eq!(print::listing(&LISTING_2, &[]), transcript);
}

#[test]
pub(crate) fn e08_the_dot_products_are_homogeneous_window_z_and_w() {
    // R1 = zc/2 + wc/2 and R2 = wc, and their quotient is what a depth range from 0 to 1 makes of zc/wc.
    for (camera, seed) in [(camera(0.5, 50.0), 1), (camera(0.01, 100.0), 2)] {
        let (view, projection) = (camera.view(), camera.projection(4, 3));
        let state = set_up(view, projection);
        assert_eq!(state.depth_replace(), Some([1, 2]));
        for world in points(seed, 1000) {
            let eye = view * world.extend(1.0);
            let clip = projection * eye;
            let [r1, r2] = [1, 2].map(|unit| dot_product(&state, unit, eye));
            close(r1, 0.5 * clip.z + 0.5 * clip.w);
            close(r2, clip.w);
            close(r1 / r2, 0.5 * (clip.z / clip.w) + 0.5);
        }
    }
}

#[test]
pub(crate) fn e08_with_one_word_changed_it_is_something_else() {
    let camera = camera(0.5, 50.0);
    let (view, projection) = (camera.view(), camera.projection(4, 3));
    let eye = view * points(3, 1)[0].extend(1.0);
    let clip = projection * eye;
    let dropped = |listing: &[Step], without: usize| {
        let mut state = ClassicState::new(view, projection);
        let calls = listing.iter().filter_map(|step| match step {
            Step::Call(Call::Classic(call)) => Some(call),
            _ => None,
        });
        for (_, call) in calls.enumerate().filter(|(number, _)| *number != without) {
            state.perform(call).unwrap();
        }
        [1, 2].map(|unit| dot_product(&state, unit, eye))
    };
    let right = dropped(LISTING_2.steps, usize::MAX);
    close(right[0] / right[1], 0.5 * (clip.z / clip.w) + 0.5);
    // Without the translation, the scale, m, or either projection.
    for step in [15, 16, 17, 31, 32] {
        let wrong = dropped(LISTING_2.steps, step);
        assert!(
            (wrong[0] / wrong[1] - right[0] / right[1]).abs() > 1e-3,
            "step {step}: {wrong:?}"
        );
    }
}

/// Every step, left out of a state that is not OpenGL's initial one: the coordinates, the state or the calls' success change.
/// What nobody can notice is named with its reason.
#[test]
pub(crate) fn e07_e08_every_step_of_listing_2_is_missed() {
    let camera = camera(0.5, 50.0);
    let (view, projection) = (camera.view(), camera.projection(4, 3));
    let eye = view * points(3, 1)[0].extend(1.0);
    // Matrices, modes and units that something else has left behind.
    let dirty = [
        glMatrixMode(GL_MODELVIEW),
        glTranslatef(0.1, 0.2, 0.3),
        glActiveTextureARB(GL_TEXTURE1_ARB),
        glMatrixMode(GL_TEXTURE),
        glScalef(2.0, 2.0, 2.0),
        glActiveTextureARB(GL_TEXTURE2_ARB),
        glScalef(3.0, 3.0, 3.0),
        glActiveTextureARB(GL_TEXTURE3_ARB),
    ];
    let calls = |steps: &[Step]| -> Vec<ClassicCall> {
        let classic = steps.iter().filter_map(|step| match step {
            Step::Call(Call::Classic(call)) => Some(*call),
            _ => None,
        });
        classic.collect()
    };
    let run = |listing: &[ClassicCall]| {
        let mut state = ClassicState::new(view, projection);
        let before = dirty.map(Step::Call);
        for call in calls(&before).iter().chain(listing) {
            state.perform(call).map_err(|error| error.to_string())?;
        }
        let products = [1, 2].map(|unit| dot_product(&state, unit, eye));
        Ok::<_, String>((products.map(f64::to_bits), format!("{state:?}")))
    };
    let listing = calls(LISTING_2.steps);
    let right = run(&listing);
    assert!(right.is_ok());
    let mut unnoticed = Vec::new();
    let mut in_numbers = 0;
    for number in 0..listing.len() {
        let mut without = listing.clone();
        without.remove(number);
        let changed = run(&without);
        let moved = changed.as_ref().map(|(products, _)| *products)
            != right.as_ref().map(|(products, _)| *products);
        in_numbers += usize::from(moved);
        if changed == right {
            unnoticed.push(format!("{:?}", listing[number]));
        }
    }
    println!(
        "{} steps, {in_numbers} of them change r or q; unnoticed: {unnoticed:#?}",
        listing.len()
    );
    assert!(in_numbers >= 12, "{in_numbers}");
    assert_eq!(unnoticed, UNNOTICED);
}

/// The texture of (0, 0, 1) is the machine's, and the input of both dot products is the only one there is.
const UNNOTICED: [&str; 3] = [
    "BindUnsignedHilo",
    "TexEnv { target: TextureShader, pname: PreviousTextureInput, param: Unit(0) }",
    "TexEnv { target: TextureShader, pname: PreviousTextureInput, param: Unit(0) }",
];

#[test]
pub(crate) fn e06_equations_1_to_4_are_one_number_in_exact_arithmetic() {
    // Two points of a segment in clip space, any place between them in window space.
    let camera = camera(0.5, 50.0);
    let state = set_up(camera.view(), camera.projection(4, 3));
    let points = points(4, 400);
    for (n, pair) in points.chunks_exact(2).enumerate() {
        let eye = [0, 1].map(|i| camera.view() * pair[i].extend(1.0));
        let [[r1, q1], [r2, q2]] = eye.map(|eye| [1, 2].map(|unit| dot_product(&state, unit, eye)));
        let t = n as f64 / 200.0;
        // (1): window z, linear in window space.
        let window_z = r1 / q1 * (1.0 - t) + r2 / q2 * t;
        // (2) and (3): r and q, linear in clip space, hyperbolic in window space.
        let denominator = (1.0 - t) / q1 + t / q2;
        let r = (r1 / q1 * (1.0 - t) + r2 / q2 * t) / denominator;
        let q = (q1 / q1 * (1.0 - t) + q2 / q2 * t) / denominator;
        // (4): the two sides of the comparison.
        close(r / q, window_z);
    }
}

#[test]
pub(crate) fn e06_equations_1_to_4_are_not_one_number_in_32_bits() {
    let camera = camera(0.5, 50.0);
    let state = set_up(camera.view(), camera.projection(4, 3));
    let mut differ = 0;
    for (n, pair) in points(5, 2000).chunks_exact(2).enumerate() {
        let eye = [0, 1].map(|i| camera.view() * pair[i].extend(1.0));
        let corners = eye.map(|eye| [1, 2].map(|unit| dot_product(&state, unit, eye) as f32));
        let [[r1, q1], [r2, q2]] = corners;
        let t = n as f32 / 1000.0;
        let window_z = r1 / q1 * (1.0 - t) + r2 / q2 * t;
        let denominator = (1.0 / q1) * (1.0 - t) + (1.0 / q2) * t;
        let r = (r1 / q1 * (1.0 - t) + r2 / q2 * t) / denominator;
        let q = 1.0 / denominator;
        differ += u32::from(r / q != window_z);
        // Six roundings of 2^-24 each of numbers up to 1.
        assert!((r / q - window_z).abs() <= 6.0 * 2.0_f32.powi(-24));
    }
    println!("{differ} of 1000 differ in the last bits");
    assert!(differ > 100);
}

#[test]
pub(crate) fn e08_listing_2_runs_and_stores_window_z() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(21, [0.5, 50.0]);
    let [replaced, window_z] = [true, false].map(|replace| nearest(&context, &scene, replace));
    let mut same = 0;
    let mut largest = 0.0_f32;
    for (a, b) in replaced.iter().zip(&window_z) {
        same += usize::from(a == b);
        largest = largest.max((a - b).abs());
    }
    println!(
        "{same} of {} pixels have the same bits, largest difference {largest:e}",
        replaced.len()
    );
    // r and q up to 50 with a rounding of 2^-24 each at the corners and in interpolation; a dozen of them.
    assert!(largest <= 12.0 * 2.0_f32.powi(-24), "{largest:e}");
    assert!(
        same < replaced.len(),
        "the last bits are what the paper is about"
    );
}

#[test]
pub(crate) fn e04_peeling_as_in_2001_with_depth_replace_equals_the_exact_image() {
    let context = Context::headless().unwrap();
    if !interpolates_true_corners(&context) {
        return;
    }
    for seed in 30..33 {
        let scene = soup_scene(seed, [1.0, 20.0]);
        let exact = render(&context, &scene, &Method::Exact);
        let lists = Lists::of(&context, &scene);
        for compositing in [Compositing::OnTheFly, Compositing::KeepLayers] {
            let options = DepthPeelingOptions {
                depth_unit_0: DepthUnit0::ClassicDepthReplace,
                compositing,
                maximum_number_of_peels: lists.complexity() as u32 + 2,
                ..Default::default()
            };
            let frame = render(&context, &scene, &Method::DepthPeeling(options));
            let wrong = wrong_pixels(&frame, &exact);
            println!(
                "seed {seed}, {compositing:?}: {} pixels wrong, {:?} lost",
                wrong.len(),
                frame.stats.lost
            );
            // Each of them is explained: r/q orders two fragments of nearly one depth in another way than window z, or
            // ties them.
            for &pixel in &wrong {
                let list = &lists.pixels[pixel];
                assert!(closest(list) <= 12.0 * 2.0_f32.powi(-24), "{list:?}");
            }
            assert!(wrong.len() < 10);
        }
    }
}

#[test]
pub(crate) fn e06_peeling_as_in_2001_without_depth_replace_mis_peels() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(30, [1.0, 20.0]);
    let exact = render(&context, &scene, &Method::Exact);
    let options = DepthPeelingOptions {
        depth_unit_0: DepthUnit0::Classic,
        maximum_number_of_peels: 40,
        ..Default::default()
    };
    let frame = render(&context, &scene, &Method::DepthPeeling(options));
    let wrong = wrong_pixels(&frame, &exact).len();
    let covered = Lists::of(&context, &scene).samples(0);
    println!(
        "{wrong} of {covered} covered pixels mis-peeled, {:?}",
        frame.stats.stopped
    );
    assert!(wrong as u64 > covered / 4);
}

#[test]
pub(crate) fn e04_a_fragment_of_alpha_0_never_passes_the_alpha_test_and_nobody_misses_it() {
    let context = Context::headless().unwrap();
    let mut scene = soup_scene(31, [1.0, 20.0]);
    for vertex in scene.meshes[0].vertices.iter_mut().take(300) {
        vertex.color.a = 0.0;
    }
    let exact = render(&context, &scene, &Method::Exact);
    let options = DepthPeelingOptions {
        depth_unit_0: DepthUnit0::ClassicDepthReplace,
        maximum_number_of_peels: 40,
        ..Default::default()
    };
    let frame = render(&context, &scene, &Method::DepthPeeling(options));
    assert!(wrong_pixels(&frame, &exact).len() < 10);
    assert!(frame.stats.lost > Some(1000), "{:?}", frame.stats);
}

/// A sum or product of a few numbers up to 100, each rounded to 2^-53.
fn close(found: f64, expected: f64) {
    assert!(
        (found - expected).abs() <= 1e-11 * expected.abs().max(1.0),
        "{found} is not {expected}"
    );
}

fn set_up(view: DMat4, projection: DMat4) -> ClassicState {
    struct Alone(ClassicState);
    impl Machine for Alone {
        fn perform(&mut self, call: &Call) -> Result<()> {
            match call {
                Call::Classic(call) => self.0.perform(call),
                _ => Err(Error::usage("not a classic call", "Listing 2 has no other")),
            }
        }
        fn samples(&mut self, _: Query) -> Result<u64> {
            Err(Error::usage("no query", "Listing 2 has none"))
        }
    }
    let mut alone = Alone(ClassicState::new(view, projection));
    run(&LISTING_2, &[ENABLED], Variables::new(), &mut alone).unwrap();
    alone.0
}

/// (S, T, R) of a stage with the unsigned HILO's (0, 0, 1), in f64.
fn dot_product(state: &ClassicState, unit: usize, eye: DVec4) -> f64 {
    let planes = state.units[unit].eye_planes;
    let generated = DVec4::from_array(planes.map(|plane| plane.dot(eye)));
    let coordinates = state.texture_matrix(unit) * generated;
    coordinates.truncate().dot(DVec3::new(0.0, 0.0, 1.0))
}

fn camera(near: f64, far: f64) -> Camera {
    Camera {
        eye: DVec3::new(0.3, -0.2, 5.0),
        target: DVec3::new(0.1, 0.0, 0.0),
        up: DVec3::Y,
        fov: 40.0,
        near,
        far,
    }
}

/// In a cube of side 4 about the origin.
fn points(seed: u64, count: usize) -> Vec<DVec3> {
    let triangles = Soup {
        seed,
        count: count as u32,
        extent: 2.0,
        ..Soup::default()
    };
    let mesh = soup(&triangles).unwrap();
    (0..count).map(|n| mesh.corners(n)[0].position).collect()
}

fn soup_scene(seed: u64, [near, far]: [f64; 2]) -> Scene {
    let parameters = Soup {
        seed,
        count: 150,
        triangle_size: [0.5, 1.5],
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [128, 96];
    let extent = scene.bounds().unwrap();
    let size = (extent.max - extent.min).length();
    scene.camera = Camera {
        eye: DVec3::Z * (near + size * 0.75),
        target: DVec3::ZERO,
        up: DVec3::Y,
        fov: 40.0,
        near,
        far,
    };
    scene
}

/// The nearest depths, by Listing 2 or by the rasteriser.
fn nearest(context: &Context, scene: &Scene, replace: bool) -> Vec<f32> {
    const DEPTH: Map = Map::named("depth");
    const TARGET: Target = Target("nearest");
    let mut machine = GlMachine::new(context, scene.size).unwrap();
    machine.allocate(DEPTH, Format::Depth32F).unwrap();
    machine.framebuffer(TARGET, None, Some(DEPTH)).unwrap();
    machine.set_geometry(Geometry::upload(context, scene, scene.size).unwrap());
    machine.begin_frame();
    run(&LISTING_2, &[ENABLED], Variables::new(), &mut machine).unwrap();
    run(&SHADOW_AS_DEPTH_TEST, &[], Variables::new(), &mut machine).unwrap();
    let program = if replace {
        "classic/depth_replace"
    } else {
        "classic/fixed"
    };
    for call in [
        Call::Enable {
            cap: Capability::DepthTest,
        },
        Call::Clear {
            mask: DEPTH_BUFFER_BIT,
        },
        Call::UseProgram {
            program: Shader(program),
        },
        Call::Draw {
            objects: Objects::Scene,
        },
    ] {
        machine.perform(&call).unwrap();
    }
    machine.read_depths(DEPTH).unwrap()
}

/// Pixels that are off by more than the f32 bound of every exact method.
fn wrong_pixels(frame: &Frame, exact: &Frame) -> Vec<usize> {
    let all = Comparison::new(&frame.image, &exact.image, F32).unwrap();
    let pairs = frame.image.pixels.iter().zip(&exact.image.pixels);
    let off = |(a, b): (&Rgba, &Rgba)| {
        let pairs = a.to_array().into_iter().zip(b.to_array());
        pairs
            .map(|(a, b)| f64::from((a - b).abs()))
            .fold(0.0, f64::max)
            > F32
    };
    let wrong: Vec<_> = pairs
        .enumerate()
        .filter(|(_, pair)| off(*pair))
        .map(|(pixel, _)| pixel)
        .collect();
    assert_eq!(wrong.len(), all.over);
    wrong
}

/// The smallest distance of neighbours in a list.
fn closest(list: &[CapturedFragment]) -> f32 {
    let pairs = list.windows(2);
    pairs
        .map(|pair| pair[1].depth - pair[0].depth)
        .fold(f32::INFINITY, f32::min)
}
