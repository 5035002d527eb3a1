//! What the methods of Carr, Měch and Miller (2008) cost, in iterations, passes, triangles and fragments, and how it grows
//! (figure 3, section 8), with section 2's batches and section 9's proposals (C01, C04, C05, C25 to C27). Counts, not times.

use crate::kit::bounds::F32;
use crate::kit::carr_scenes::{HYBRID, LAYERS, error, figure_1};
use crate::kit::driver::interpolates_true_corners;
use crate::kit::figures::expect_figures;
use crate::kit::render::{example, render};
use onionskin::Camera;
use onionskin::generate::{Quads, SubmissionOrder, quads};
use onionskin::options::{CoherentOptions, TriangleSort, Variant};
use onionskin::{Comparison, Context, Method, Scene, Stats};

/// Small, because layer peeling draws each of 512 slices a thousand times.
const SMALL: [u32; 2] = [16, 12];

fn coherent(options: CoherentOptions) -> Method {
    Method::CoherentLayerPeeling(options)
}

fn stats(context: &Context, scene: &Scene, method: &Method) -> Stats {
    let stats = render(context, scene, method).stats;
    assert_eq!(stats.lost, Some(0), "{method}");
    stats
}

/// "The worst case algorithmic complexity of layer peeling is O(n²)": twice as many layers are four times the triangles.
#[test]
pub(crate) fn c01_layer_peeling_s_work_grows_with_the_square_of_the_layers() {
    let context = Context::headless().unwrap();
    let mut before: Option<u64> = None;
    for n in [16, 32, 64, 128] {
        let work = stats(&context, &stack(n, SubmissionOrder::FrontToBack), &LAYERS);
        // n layers of two passes each and one that finds nothing, each of all 2 n triangles.
        assert_eq!(work.triangles, u64::from((2 * n + 1) * 2 * n), "{n}");
        if let Some(before) = before {
            let growth = work.triangles as f64 / before as f64;
            assert!((3.8..=4.0).contains(&growth), "{growth}");
        }
        before = Some(work.triangles);
    }
}

/// Figure 3 to 512 slices. Hybrid layer peeling stays at 3 iterations. Coherent layer peeling stays constant up to 192
/// slices only, because "we can process at most 128 surfaces in one iteration" (section 5.1), and past that this
/// cone leaves longer runs of slices (CX29).
#[test]
pub(crate) fn c04_c27_past_192_slices_the_128_an_iteration_show() {
    let context = Context::headless().unwrap();
    let mut rows = Vec::new();
    println!("slices  layer  hybrid  coherent A  coherent B");
    for count in [64, 128, 192, 256, 512] {
        let layers = stats(&context, &figure_1(count, SMALL), &LAYERS).iterations;
        let scene = figure_1(count, [64, 48]);
        let hybrid = stats(&context, &scene, &HYBRID).iterations;
        let [a, b] = [Variant::A, Variant::B]
            .map(|variant| stats(&context, &scene, &coherent(variant.into())).iterations);
        println!("{count:6}  {layers:5}  {hybrid:6}  {a:10}  {b:10}");
        assert_eq!((layers, hybrid), (count + 3, 3));
        assert_eq!(a, b);
        // All slices in iterations of 128 at most, and the one that finds nothing.
        assert!(a > count.div_ceil(128));
        rows.push(a);
    }
    assert_eq!(rows, [6, 6, 6, 7, 9]);
}

/// The buckets' number decides at 512 slices that are submitted back to front: 256 buckets hold two slices each, in the
/// wrong order.
#[test]
pub(crate) fn c04_too_few_buckets_cost_an_iteration_a_bucket_and_the_scene_s_own_number_none() {
    let context = Context::headless().unwrap();
    let mut scene = figure_1(512, SMALL);
    let slices = &mut scene.meshes[0];
    slices.triangles.reverse();
    let iterations = |sorting| {
        let options = CoherentOptions {
            sorting,
            ..Variant::A.into()
        };
        stats(&context, &scene, &coherent(options)).iterations
    };
    let [few, many, own] = [
        TriangleSort::Buckets(256),
        TriangleSort::Buckets(4096),
        TriangleSort::Automatic,
    ]
    .map(iterations);
    println!(
        "512 slices back to front: {few} iterations with 256 buckets, {many} with 4096, {own} by the scene"
    );
    assert!(few > 250, "{few}");
    assert_eq!(own, many);
    assert!(own < 10, "{own}");
    // And more buckets cost the other scenes nothing.
    for name in ["knots", "teapot"] {
        let scene = example(name, [160, 120]);
        let [own, few] = [TriangleSort::Automatic, TriangleSort::Buckets(256)].map(|sorting| {
            let options = CoherentOptions {
                sorting,
                ..Variant::A.into()
            };
            stats(&context, &scene, &coherent(options)).iterations
        });
        println!("{name}: {few} iterations with 256 buckets, {own} by the scene");
        assert!(own <= few, "{name}");
    }
}

/// Passes over the slices and passes over the cone, from what was drawn in all.
fn passes(stats: &Stats, scene: &Scene) -> [u64; 2] {
    let [slices, cone] = [0, 1].map(|mesh| scene.meshes[mesh].triangles.len() as u64);
    // s + c = passes, s x slices + c x cone = triangles.
    let over_slices = (stats.triangles as i64 - (stats.geometry_passes * cone) as i64)
        / (slices as i64 - cone as i64);
    [
        over_slices as u64,
        stats.geometry_passes - over_slices as u64,
    ]
}

/// Section 8: "for 256 layers, hybrid layer peeling achieves a 52 to 1 speed improvement over layer peeling. Coherent layer
/// peeling is slower by a constant factor of approximately 6". Here in fragments that are rasterised: a driver's depth test
/// spares some of them the shader, and a time has other parts.
#[test]
pub(crate) fn c05_at_256_slices_hybrid_draws_over_52_times_fewer_fragments_and_coherent_6_times_more_than_hybrid()
 {
    let context = Context::headless().unwrap();
    println!("slices  layer / hybrid  coherent A / hybrid  coherent B / hybrid");
    let mut factors = Vec::new();
    for count in [64, 128, 256] {
        let scene = figure_1(count, SMALL);
        let fragments = [0, 1].map(|mesh| {
            let mut alone = scene.clone();
            alone.meshes = vec![scene.meshes[mesh].clone()];
            stats(&context, &alone, &Method::Blend).fragments
        });
        let all: u64 = fragments.iter().sum();
        let hybrid = stats(&context, &scene, &HYBRID);
        // "The volume slices only need to be rendered for the compositing pass": once an iteration.
        let [over_slices, over_cone] = passes(&hybrid, &scene);
        assert_eq!((over_slices, over_cone), (3, 5));
        let by_hybrid = (over_slices * fragments[0] + over_cone * fragments[1]) as f64;
        let work = |method: &Method| (stats(&context, &scene, method).geometry_passes * all) as f64;
        let layers = work(&LAYERS) / by_hybrid;
        let [a, b] = [Variant::A, Variant::B].map(|v| work(&coherent(v.into())) / by_hybrid);
        println!("{count:6}  {layers:14.1}  {a:19.1}  {b:19.1}");
        factors.push([layers, a, b]);
    }
    let [[l64, a64, b64], [l128, ..], [l256, a256, b256]] = factors[..] else {
        panic!("three rows")
    };
    assert!(l256 > 52.0, "{l256}");
    // It grows with the number of slices.
    assert!(l128 > 1.8 * l64 && l256 > 1.8 * l128);
    // "A constant factor": 6 and more, the same for four times as many slices but for one iteration.
    for (few, many) in [(a64, a256), (b64, b256)] {
        assert!(
            (6.0..18.0).contains(&few) && (6.0..18.0).contains(&many),
            "{few} {many}"
        );
        assert!(many / few < 1.25, "{few} {many}");
    }
    assert!(b256 < a256);
}

/// Sheets across the view, each over the whole image.
fn stack(count: u32, order: SubmissionOrder) -> Scene {
    let parameters = Quads {
        count,
        size: [4.0, 3.0],
        spacing: 1.0 / count as f32,
        alpha: 0.02,
        order,
        seed: 25,
        ..Quads::default()
    };
    let mut scene = Scene::of("stack", vec![quads(&parameters).unwrap()]);
    scene.size = SMALL;
    scene.camera = Camera::looking(glam::DVec3::Z * 4.0, glam::DVec3::ZERO);
    scene
}

/// Section 2, after Wexler et al.: batches of a fixed size that do not overlap in depth make the work grow with n instead of
/// with its square. Each batch is peeled coherently, in the scene's random order of submission.
#[test]
pub(crate) fn c25_batches_of_a_fixed_size_make_the_work_linear() {
    const IN_A_BATCH: u32 = 8;
    let context = Context::headless().unwrap();
    println!("    n  iterations  with batches  triangles  with batches");
    let mut rows: Vec<[f64; 4]> = Vec::new();
    for n in [32, 64, 128] {
        let scene = stack(n, SubmissionOrder::Shuffled);
        let exact = render(&context, &scene, &Method::Exact);
        let [whole, batched] = [0, n / IN_A_BATCH].map(|batches| {
            let options = CoherentOptions {
                sorting: TriangleSort::Submission,
                batches,
                ..Variant::A.into()
            };
            let frame = render(&context, &scene, &coherent(options));
            assert!(error(&frame, &exact) <= F32, "{n}, {batches}");
            assert_eq!(frame.stats.lost, Some(0));
            frame.stats
        });
        println!(
            "{n:5}  {:10}  {:12}  {:9}  {:12}",
            whole.iterations, batched.iterations, whole.triangles, batched.triangles
        );
        rows.push([
            f64::from(whole.iterations),
            f64::from(batched.iterations),
            whole.triangles as f64,
            batched.triangles as f64,
        ]);
    }
    let column = |column: usize| rows.iter().map(|row| row[column]).collect::<Vec<_>>();
    expect_figures("C25", 0, &column(2));
    // Where corners are snapped, a batch takes what lies farther beside it.
    if interpolates_true_corners(&context) {
        expect_figures("C25", 1, &column(3));
    }
    for pair in rows.windows(2) {
        let growth = |column: usize| pair[1][column] / pair[0][column];
        // Iterations grow with n either way: a batch has about as many as half of its sheets.
        assert!(
            (1.6..2.4).contains(&growth(0)) && (1.6..2.4).contains(&growth(1)),
            "{pair:?}"
        );
        assert!(growth(2) > 3.2, "the square of n: {pair:?}");
        assert!(growth(3) < 2.4, "linear: {pair:?}");
    }
    assert!(rows[2][3] * 8.0 < rows[2][2], "{rows:?}");
}

/// "This algorithm works well when batches do not overlap each other much in depth": triangles of a soup reach into many.
#[test]
pub(crate) fn c25_batches_that_overlap_draw_triangles_again() {
    let context = Context::headless().unwrap();
    let scene = example("soup", [60, 45]);
    let [whole, batched] = [0, 64].map(|batches| {
        let options = CoherentOptions {
            batches,
            ..Variant::A.into()
        };
        stats(&context, &scene, &coherent(options))
    });
    println!(
        "soup: {} iterations, {} triangles; in 64 batches {} iterations, {} triangles",
        whole.iterations, whole.triangles, batched.iterations, batched.triangles
    );
    assert!(batched.iterations > 2 * whole.iterations);
    assert!(
        batched.triangles > whole.triangles,
        "more work than without batches"
    );
}

/// Section 9: "exploitation of z-culling ... is still an area of future work". Triangles that lie before D(sc) are culled
/// between iterations: the same image in the same iterations, with less geometry.
#[test]
pub(crate) fn c26_culling_what_is_finished_saves_triangles_and_changes_nothing_else() {
    let context = Context::headless().unwrap();
    println!("scene     variant  iterations  triangles  culled");
    for name in ["knots", "teapot", "slices"] {
        let scene = example(name, [80, 60]);
        for variant in [Variant::A, Variant::B] {
            let [plain, culled] = [false, true].map(|cull| {
                let options = CoherentOptions {
                    cull,
                    ..variant.into()
                };
                render(&context, &scene, &coherent(options))
            });
            println!(
                "{name:9} {variant:?}        {:10}  {:9}  {:6}",
                plain.stats.iterations, plain.stats.triangles, culled.stats.triangles
            );
            assert!(plain.image == culled.image, "{name}, {variant:?}");
            assert_eq!(culled.stats.lost, Some(0));
            assert_eq!(
                culled.stats.iterations, plain.stats.iterations,
                "{name}, {variant:?}"
            );
            assert_eq!(culled.stats.stopped, plain.stats.stopped);
            assert!(
                culled.stats.triangles * 4 < plain.stats.triangles * 3,
                "{name}, {variant:?}"
            );
        }
    }
}

/// The last iteration finds nothing, and with culling it has nothing to draw.
#[test]
pub(crate) fn c26_with_culling_the_empty_iteration_draws_nothing() {
    let context = Context::headless().unwrap();
    let scene = stack(20, SubmissionOrder::FrontToBack);
    let options = CoherentOptions {
        cull: true,
        ..Variant::A.into()
    };
    let stats = stats(&context, &scene, &coherent(options));
    assert_eq!(
        (stats.iterations, stats.geometry_passes, stats.triangles),
        (2, 6, 6 * 40)
    );
}

/// Section 4: "data can be sorted up front ... and updated periodically as the camera moves". The image is right with any old
/// sort, but for ties; an older one costs iterations.
#[test]
pub(crate) fn c26_a_sort_that_is_kept_stays_good_for_some_degrees() {
    let context = Context::headless().unwrap();
    let mut scene = example("knots", [120, 90]);
    let first = scene.camera;
    let from = first.eye - first.target;
    println!("degrees  iterations with a fresh sort  with the first frame's");
    let mut kept_at = Vec::new();
    for degrees in [0.0_f64, 5.0, 30.0, 90.0, 180.0] {
        let turn = glam::DMat3::from_rotation_y(degrees.to_radians());
        scene.camera.eye = first.target + turn * from;
        let exact = render(&context, &scene, &Method::Exact);
        let [fresh, kept] = [None, Some(first)].map(|sorted_for| {
            let options = CoherentOptions {
                sorted_for,
                ..Variant::A.into()
            };
            let frame = render(&context, &scene, &coherent(options));
            // Of equal depths the first after sorting lies in front: a pixel may have such a tie.
            let off = Comparison::new(&frame.image, &exact.image, F32).unwrap();
            assert!(off.over <= 1, "{degrees}: {off:?}");
            assert_eq!(frame.stats.lost, Some(0));
            frame.stats.iterations
        });
        println!("{degrees:7}  {fresh:28}  {kept:22}");
        kept_at.push((fresh, kept));
    }
    assert_eq!(kept_at[0].0, kept_at[0].1);
    // A few degrees cost an iteration at most, from behind it is the wrong order.
    assert!(kept_at[1].1 <= kept_at[1].0 + 1, "{kept_at:?}");
    let (fresh, kept) = kept_at[4];
    assert!(kept > fresh + 1, "{kept_at:?}");
}
