//! The claims of Lindholm et al. 2015 that need no volume, L01 to L15, L18 and L21, each under its key, and what happens
//! when ppAO and ppDP are run as printed.

use onionskin::image::Comparison;
use onionskin::methods::{
    ABufferCounts, ABufferOptions, CountBy, Fill, Frame, Manager, RecordColor, Sort,
};
use onionskin::scene::Camera;
use onionskin::scene::generate::{Order, Quads, TorusKnot, quads, torus_knot};
use onionskin::{Context, Method, Renderer, Scene};

#[path = "common/stack.rs"]
#[allow(dead_code)]
mod stack;
use stack::{Piece, Stack};

#[path = "common/pp_dp.rs"]
mod pp_dp;
use pp_dp::{Rule, peel};

/// f32 colours; see `gl_a_buffer.rs`.
const F32: f64 = 1e-5;

const MANAGERS: [Manager; 3] = [Manager::Ffb, Manager::Dfb, Manager::Ppll];

fn options() -> ABufferOptions {
    ABufferOptions {
        color: RecordColor::Float,
        sort: Sort::Insertion,
        ..ABufferOptions::DEFAULT
    }
}

fn render(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    options: ABufferOptions,
) -> (Frame, ABufferCounts) {
    let frame = renderer.render(scene, &Method::ABuffer(options)).unwrap();
    let counts = frame.stats.a_buffer.unwrap();
    (frame, counts)
}

fn bundled(file: &str, size: [u32; 2]) -> Scene {
    let path = format!("{}/examples/scenes/{file}", env!("CARGO_MANIFEST_DIR"));
    Scene::load_at(path, Some(size)).unwrap()
}

#[test]
fn l01_atomic_counters_give_the_depth_complexity_image_and_its_histogram() {
    let context = Context::headless().unwrap();
    let stack = alike(&[0, 1, 3, 3, 8, 20]);
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    let complexity = renderer
        .complexity(&stack.scene(), CountBy::Atomics)
        .unwrap();
    assert_eq!(complexity.counts, [0, 1, 3, 3, 8, 20]);
    let of = |bin: u32| -> Vec<u64> {
        complexity
            .histogram(bin)
            .iter()
            .map(|bin| bin.pixels)
            .collect()
    };
    assert_eq!(of(8), [4, 1, 1]);
    assert_eq!(of(1)[3], 2);
}

/// A ray enters a closed surface as often as it leaves it.
#[test]
fn l02_closed_geometry_makes_even_depth_complexities_dominate() {
    let context = Context::headless().unwrap();
    let mut mesh = torus_knot(&TorusKnot::default()).unwrap();
    for vertex in &mut mesh.vertices {
        vertex.color.a = 0.5;
    }
    mesh.opaque = false;
    let mut scene = Scene::of("knot", vec![mesh]);
    scene.size = [320, 240];
    let mut renderer = Renderer::new(&context, 320, 240).unwrap();
    let closed = renderer.complexity(&scene, CountBy::Blending).unwrap();
    let odd = |counts: &[u32]| counts.iter().filter(|&&c| c % 2 == 1).count();
    assert!(closed.covered() > 5000, "{}", closed.covered());
    // A triangle's edge has one owner, so that not even a silhouette is odd.
    assert_eq!(odd(&closed.counts), 0);
    // The control: with a third of it cut open there are odd ones.
    let kept = scene.meshes[0].triangles.len() * 2 / 3;
    scene.meshes[0].triangles.truncate(kept);
    let open = renderer.complexity(&scene, CountBy::Blending).unwrap();
    assert!(odd(&open.counts) > 100);
}

/// The paper's protein: 68% of the pixels at 8 or less, 6.6% over 17, maximum 46. The bundled molecule is another one.
#[test]
fn l03_most_pixels_of_the_molecule_lie_far_below_the_maximum() {
    let context = Context::headless().unwrap();
    let scene = bundled("molecule.toml", [512, 384]);
    let mut renderer = Renderer::new(&context, 512, 384).unwrap();
    let complexity = renderer.complexity(&scene, CountBy::Blending).unwrap();
    let max = complexity.max();
    let (few, many) = (
        complexity.part_up_to(max / 4),
        1.0 - complexity.part_up_to(max / 2),
    );
    println!(
        "maximum {max}, {:.1}% at {} or less, {:.1}% over {}; 8 or less: {:.1}%, over 17: {:.1}%",
        few * 100.0,
        max / 4,
        many * 100.0,
        max / 2,
        complexity.part_up_to(8) * 100.0,
        (1.0 - complexity.part_up_to(17)) * 100.0
    );
    assert!(max >= 24, "{max}");
    assert!(few > 0.5, "{few}");
    assert!(many < 0.15, "{many}");
    assert!(complexity.percentile(0.5) * 3 < max);
}

#[test]
fn l04_three_managers_give_the_same_image() {
    let context = Context::headless().unwrap();
    let scene = bundled("soup.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let images = MANAGERS.map(|manager| {
        let options = ABufferOptions {
            manager,
            ..options()
        };
        render(&mut renderer, &scene, options).0.image
    });
    assert!(images[0] == images[1] && images[1] == images[2]);
}

/// 768 x 5 + 1 numbers need three levels; a scan that was wrong anywhere would give two pixels the same records.
#[test]
fn l05_base_offsets_keep_every_pixel_s_list_to_itself() {
    let context = Context::headless().unwrap();
    for size in [[1, 1], [64, 1], [65, 1], [63, 65], [257, 129]] {
        let mut scene = bundled("soup.toml", [160, 120]);
        scene.size = size;
        let mut renderer = Renderer::new(&context, size[0], size[1]).unwrap();
        let dynamic = ABufferOptions {
            manager: Manager::Dfb,
            ..options()
        };
        let (frame, counts) = render(&mut renderer, &scene, dynamic);
        let fixed = ABufferOptions {
            manager: Manager::Ffb,
            ..options()
        };
        assert!(
            frame.image == render(&mut renderer, &scene, fixed).0.image,
            "{size:?}"
        );
        // A record for every fragment and no more; the rest are the offsets.
        let scan = counts.list_bytes - frame.stats.fragments * 32;
        assert_eq!(
            scan,
            onionskin::gl::GlMachine::scan_bytes(u64::from(size[0] * size[1]))
        );
    }
}

/// Taken from a pool by atomics, as the paper has it; in order, without atomics, behind DFB's base offsets.
#[test]
fn l06_linked_lists_take_a_node_and_a_link_for_each_fragment() {
    let context = Context::headless().unwrap();
    let scene = bundled("soup.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let mut bytes = |manager, fill| {
        let options = ABufferOptions {
            manager,
            fill,
            ..ABufferOptions::DEFAULT
        };
        let (frame, counts) = render(&mut renderer, &scene, options);
        assert_eq!(frame.stats.lost, Some(0));
        (counts.list_bytes, frame.stats.fragments)
    };
    let (by_atomics, fragments) = bytes(Manager::Ppll, Fill::Atomics);
    assert_eq!(by_atomics, fragments * (16 + 4) + 16);
    if context.driver().has("GL_EXT_shader_framebuffer_fetch") {
        let (in_order, _) = bytes(Manager::Ppll, Fill::Ordered);
        let (dynamic, _) = bytes(Manager::Dfb, Fill::Ordered);
        assert_eq!(in_order, dynamic + fragments * 4);
    }
}

/// z f32, id i32, colour 4 x f16: the bytes follow from what is allocated, the bits of the id from how ties come out (the
/// stacks with ties of `gl_a_buffer.rs`).
#[test]
fn l07_a_record_has_16_bytes() {
    assert_eq!(
        ABufferOptions {
            manager: Manager::Ffb,
            ..ABufferOptions::DEFAULT
        }
        .record_bytes(),
        16
    );
    assert_eq!(
        ABufferOptions {
            manager: Manager::Dfb,
            ..ABufferOptions::DEFAULT
        }
        .record_bytes(),
        16
    );
    // A link more.
    assert_eq!(ABufferOptions::DEFAULT.record_bytes(), 20);
}

/// "Approximately 12.6 MiB per depth layer at 1024 x 768": 1024 x 768 x 16 bytes are 12.58 MB, or 12.0 MiB. The unit is
/// wrong, the number of bytes is right.
#[test]
fn l08_a_layer_of_a_fixed_buffer_takes_12_6_megabytes_which_are_12_mebibytes() {
    let context = Context::headless().unwrap();
    let mut scene = sheets(3, Order::BackToFront);
    scene.size = [1024, 768];
    let mut renderer = Renderer::new(&context, 1024, 768).unwrap();
    let fixed = ABufferOptions {
        manager: Manager::Ffb,
        ..ABufferOptions::DEFAULT
    };
    let (_, counts) = render(&mut renderer, &scene, fixed);
    let layer = counts.list_bytes as f64 / 3.0;
    assert_eq!(format!("{:.1} MB", layer / 1e6), "12.6 MB");
    assert_eq!(format!("{:.1} MiB", layer / f64::from(1 << 20)), "12.0 MiB");
}

#[test]
fn l09_a_static_array_loses_everything_past_n_and_says_so() {
    let context = Context::headless().unwrap();
    let counts = [3, 8, 9, 20, 64, 100];
    let stack = alike(&counts);
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    for manager in MANAGERS {
        for array in [8, 64] {
            let options = ABufferOptions {
                manager,
                array,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &stack.scene(), options);
            let lost: usize = counts
                .iter()
                .map(|&c| c.saturating_sub(array as usize))
                .sum();
            let pixels = counts.iter().filter(|&&c| c > array as usize).count();
            assert_eq!(frame.stats.lost, Some(lost as u64));
            assert_eq!(cost.truncated_pixels, pixels as u64);
            assert_eq!(frame.stats.stopped_text(), "local array full");
            let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
            assert_eq!(error.over, pixels, "the others are right: {error:?}");
        }
    }
}

#[test]
fn l10_the_fill_counts_and_no_geometry_pass_is_added() {
    let context = Context::headless().unwrap();
    let scene = bundled("soup.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    for as_printed in [false, true] {
        let (plain, static_cost) = render(&mut renderer, &scene, options());
        let (frame, cost) = render(
            &mut renderer,
            &scene,
            ABufferOptions {
                pp_ao: true,
                as_printed,
                ..options()
            },
        );
        assert_eq!(frame.stats.geometry_passes, plain.stats.geometry_passes);
        assert!(frame.image == plain.image);
        // Figure 5's grey areas: less is reserved, as much is used.
        assert_eq!(cost.slots_used, static_cost.slots_used);
        assert!(cost.slots_reserved * 4 < static_cost.slots_reserved);
        // Every covered pixel in one segment.
        let covered = renderer
            .complexity(&scene, CountBy::Blending)
            .unwrap()
            .covered();
        assert_eq!(cost.resolved, covered);
    }
}

/// Each pixel's array is the smallest of 8, 16, 32 and 64 that holds its fragments.
#[test]
fn l10_every_pixel_is_resolved_by_the_smallest_segment_that_holds_it() {
    let context = Context::headless().unwrap();
    for complexity in [1, 7, 8, 9, 16, 17, 32, 33, 64] {
        let mut renderer = Renderer::new(&context, 2, 1).unwrap();
        let options = ABufferOptions {
            pp_ao: true,
            ..options()
        };
        let (_, cost) = render(&mut renderer, &alike(&[complexity; 2]).scene(), options);
        let smallest = [8, 16, 32, 64]
            .into_iter()
            .find(|&n| n >= complexity)
            .unwrap();
        assert_eq!(cost.slots_reserved, 2 * smallest as u64, "{complexity}");
    }
}

/// 255 and more in one segment, none lost, by the amended counter and ppDP.
#[test]
fn l11_complexities_of_255_and_more_share_the_last_segment_and_none_is_lost() {
    let context = Context::headless().unwrap();
    let stack = alike(&[254, 255, 256, 257, 300, 600]);
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    let options = ABufferOptions {
        pp_ao: true,
        pp_dp: true,
        ..options()
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), options);
    assert_eq!((frame.stats.lost, cost.resolved), (Some(0), 6));
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!(error.over, 0, "{error:?}");
}

/// Erratum L5: `depth complexity(p) <= i` holds in no segment.
#[test]
fn l11_as_printed_the_stencil_loses_what_lies_past_the_last_segment() {
    let context = Context::headless().unwrap();
    let stack = alike(&[64, 65, 100, 300]);
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    for pp_dp in [false, true] {
        let options = ABufferOptions {
            pp_ao: true,
            pp_dp,
            as_printed: true,
            ..options()
        };
        let (frame, _) = render(&mut renderer, &stack.scene(), options);
        assert_eq!(frame.stats.lost, Some(65 + 100 + 300));
    }
}

/// Errata L6 and L7 on the driver's own stencil buffer: INVERT puts a complexity of 127 to 128, which is another segment's.
#[test]
fn l07_as_printed_pixels_are_resolved_twice() {
    let context = Context::headless().unwrap();
    let counts = [100, 126, 127, 128];
    let stack = alike(&counts);
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    let printed = ABufferOptions {
        pp_ao: true,
        array: 256,
        as_printed: true,
        ..options()
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), printed);
    // 256 is clamped to 255, so that its segment takes 127 and 128 twice; 128 is resolved in it for the first time.
    assert!(cost.resolved > 4, "{}", cost.resolved);
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert!(error.over > 0, "blended twice: {error:?}");
    let amended = ABufferOptions {
        as_printed: false,
        ..printed
    };
    let (frame, cost) = render(&mut renderer, &stack.scene(), amended);
    assert_eq!(cost.resolved, 4);
    let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
    assert_eq!(error.over, 0, "{error:?}");
}

/// The bound, and that it is not reached: the pseudocode resolves n, not n - 1 (erratum L2).
#[test]
fn l12_a_pixel_takes_at_most_d_over_n_minus_1_subpasses() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 1, 1).unwrap();
    for complexity in [1, 7, 8, 9, 24, 64, 65, 200] {
        for n in [2, 5, 8, 13] {
            let options = ABufferOptions {
                pp_dp: true,
                peel: n,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &alike(&[complexity]).scene(), options);
            assert_eq!(frame.stats.lost, Some(0));
            assert!(cost.most_subpasses as usize <= complexity.div_ceil(n as usize - 1));
            assert_eq!(
                cost.most_subpasses as usize,
                complexity.div_ceil(n as usize)
            );
            assert_eq!(
                cost.records_read,
                u64::from(cost.most_subpasses) * complexity as u64
            );
        }
    }
}

/// Errata L1 and L4: what the printed rule loses, fragment by fragment, is what a twin in Rust says it must; and the
/// amended rule loses none.
#[test]
fn l13_as_printed_ties_are_lost_where_a_buffer_ends_and_amended_none() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 4, 1).unwrap();
    let mut lost_in_all = 0;
    for levels in [1, 3, 12, 64] {
        for complexity in [8, 20, 24] {
            let stack = tied(complexity, levels);
            let scene = stack.scene();
            let printed = ABufferOptions {
                pp_dp: true,
                as_printed: true,
                ..options()
            };
            let (frame, cost) = render(&mut renderer, &scene, printed);
            let mut expected = (0, 0);
            for pieces in &stack.pixels {
                let depths: Vec<u32> = pieces
                    .iter()
                    .map(|piece| u32::from(piece.level) + 1)
                    .collect();
                let twin = peel(&depths, 8, Rule::Printed);
                expected.0 += twin.lost as u64;
                expected.1 += twin.subpasses as u64;
            }
            assert_eq!(frame.stats.lost, Some(expected.0), "{levels} {complexity}");
            assert_eq!(cost.subpasses, expected.1, "{levels} {complexity}");
            lost_in_all += expected.0;

            let amended = ABufferOptions {
                as_printed: false,
                ..printed
            };
            let (frame, _) = render(&mut renderer, &scene, amended);
            assert_eq!(frame.stats.lost, Some(0));
            let error = Comparison::new(&frame.image, &stack.expected(), F32).unwrap();
            assert_eq!(error.over, 0, "{error:?}");
        }
    }
    assert!(
        lost_in_all > 50,
        "{lost_in_all}: there is something to lose"
    );
}

#[test]
fn l14_pp_ao_and_pp_dp_together_give_the_exact_image_too() {
    let context = Context::headless().unwrap();
    let scene = bundled("slices.toml", [160, 120]);
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap();
    for manager in MANAGERS {
        let both = ABufferOptions {
            manager,
            pp_ao: true,
            pp_dp: true,
            array: 16,
            ..options()
        };
        let (frame, cost) = render(&mut renderer, &scene, both);
        assert_eq!(frame.stats.lost, Some(0));
        let error = Comparison::new(&frame.image, &exact.image, F32).unwrap();
        assert_eq!(error.over, 0, "{error:?}");
        assert!(cost.most_subpasses > 3, "{}", cost.most_subpasses);
    }
}

/// What a ray has not seen when it ends weighs less than the threshold, and no colour is over 1.
#[test]
fn l15_early_ray_termination_errs_by_less_than_its_threshold_and_saves_work() {
    let context = Context::headless().unwrap();
    let mut scene = sheets(64, Order::Shuffled);
    scene.size = [64, 48];
    for vertex in &mut scene.meshes[0].vertices {
        vertex.color.a = 0.3;
    }
    let mut renderer = Renderer::new(&context, 64, 48).unwrap();
    for pp_dp in [false, true] {
        let whole = ABufferOptions { pp_dp, ..options() };
        let (exact, all) = render(&mut renderer, &scene, whole);
        let (ended, some) = render(
            &mut renderer,
            &scene,
            ABufferOptions {
                termination: 0.02,
                ..whole
            },
        );
        let error = Comparison::new(&ended.image, &exact.image, 0.02).unwrap();
        assert!(error.max > 1e-4 && error.over == 0, "{error:?}");
        // 0.7^11 < 0.02: eleven of 64 are composited.
        let pixels = 64 * 48;
        assert_eq!(ended.stats.lost, Some(pixels * (64 - 11)));
        assert_eq!(ended.stats.stopped_text(), "early ray termination");
        if pp_dp {
            assert_eq!((all.most_subpasses, some.most_subpasses), (8, 2));
            assert_eq!(some.records_read * 4, all.records_read);
        }
    }
}

/// Figure 7: 64 screen-filling quads, alpha 0.05, random order in depth: ppAO reserves what the static array does, ppDP
/// reads the lists eight times and needs an eighth of the array.
#[test]
fn l18_sixty_four_quads_cost_what_figure_7_says_they_must() {
    let context = Context::headless().unwrap();
    let mut scene = sheets(64, Order::Shuffled);
    scene.size = [64, 48];
    let mut renderer = Renderer::new(&context, 64, 48).unwrap();
    let exact = renderer.render(&scene, &Method::Exact).unwrap();
    let complexity = renderer.complexity(&scene, CountBy::Blending).unwrap();
    let pixels = 64 * 48;
    assert_eq!(complexity.histogram(1)[64].pixels, pixels);
    let mut cost = |pp_ao, pp_dp| {
        let (frame, counts) = render(
            &mut renderer,
            &scene,
            ABufferOptions {
                pp_ao,
                pp_dp,
                ..options()
            },
        );
        let error = Comparison::new(&frame.image, &exact.image, F32).unwrap();
        assert_eq!((error.over, frame.stats.lost), (0, Some(0)), "{error:?}");
        [counts.slots_reserved, counts.records_read, counts.subpasses].map(|n| n / pixels)
    };
    assert_eq!(cost(false, false), [64, 64, 1]);
    assert_eq!(cost(true, false), [64, 64, 1]);
    assert_eq!(cost(false, true), [8, 8 * 64, 8]);
    assert_eq!(cost(true, true), [64, 64, 1]);
}

/// Pixels with so many fragments each.
fn alike(counts: &[usize]) -> Stack {
    let pixel = |(pixel, &count): (usize, &usize)| pieces(count, pixel, 997);
    Stack {
        width: counts.len() as u32,
        pixels: counts.iter().enumerate().map(pixel).collect(),
        opaque: None,
    }
}

/// Four pixels with so many fragments on so many levels.
fn tied(count: usize, levels: usize) -> Stack {
    Stack {
        width: 4,
        pixels: (0..4)
            .map(|pixel| pieces(count, pixel * 31, levels))
            .collect(),
        opaque: None,
    }
}

fn pieces(count: usize, seed: usize, levels: usize) -> Vec<Piece> {
    let part = |number: usize, step: usize| ((number + seed) * step % 101) as f32 / 100.0;
    let piece = |number: usize| Piece {
        level: ((number + seed) * 389 % 997 % levels) as u16,
        color: [
            part(number, 7),
            part(number, 13),
            part(number, 29),
            0.02 + 0.1 * part(number, 37),
        ],
    };
    (0..count).map(piece).collect()
}

/// Figure 7's quads, each over the whole view.
fn sheets(count: u32, order: Order) -> Scene {
    let parameters = Quads {
        count,
        size: [40.0, 30.0],
        spacing: 0.1,
        alpha: 0.05,
        order,
        seed: 7,
        ..Quads::default()
    };
    let mut scene = Scene::of("sheets", vec![quads(&parameters).unwrap()]);
    scene.background = [1.0; 3];
    scene.camera = Camera {
        eye: glam::DVec3::new(0.0, 0.0, 3.0),
        target: glam::DVec3::ZERO,
        up: glam::DVec3::Y,
        fov: 60.0,
        near: 0.5,
        far: 20.0,
    };
    scene
}
