//! The claims of Lindholm et al. 2015 about depth complexity, the Fill Step and global memory, L01 to L08, each under its
//! key. `gl/claims_lindholm_resolve.rs` has the others that need no volume, `gl/a_buffer.rs` L21.

use onionskin::generate::{SubmissionOrder, TorusKnot, torus_knot};
use onionskin::options::{ABufferOptions, Fill, Manager};
use onionskin::{Context, CountBy, Renderer, Scene};

use crate::kit::a_buffer::*;
use crate::kit::stack::row;

#[test]
pub(crate) fn l01_atomic_counters_give_the_depth_complexity_image_and_its_histogram() {
    let context = Context::headless().unwrap();
    let stack = row(&[0, 1, 3, 3, 8, 20]);
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
pub(crate) fn l02_closed_geometry_makes_even_depth_complexities_dominate() {
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
pub(crate) fn l03_most_pixels_of_the_molecule_lie_far_below_the_maximum() {
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
pub(crate) fn l04_three_managers_give_the_same_image() {
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
pub(crate) fn l05_base_offsets_keep_every_pixel_s_list_to_itself() {
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
        // A record for every fragment and no more; the rest are the offsets, if there is any.
        let scan = counts.list_bytes - frame.stats.fragments * 32;
        let expected = match frame.stats.fragments {
            0 => 0,
            _ => onionskin::low_level::gl::GlMachine::scan_bytes(u64::from(size[0] * size[1])),
        };
        assert_eq!(scan, expected, "{size:?}");
    }
}

/// Taken from a pool by atomics, as the paper has it; in order, without atomics, behind DFB's base offsets.
#[test]
pub(crate) fn l06_linked_lists_take_a_node_and_a_link_for_each_fragment() {
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
/// stacks with ties of `gl/a_buffer.rs`).
#[test]
pub(crate) fn l07_a_record_has_16_bytes() {
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
pub(crate) fn l08_a_layer_of_a_fixed_buffer_takes_12_6_megabytes_which_are_12_mebibytes() {
    let context = Context::headless().unwrap();
    let mut scene = sheets(3, SubmissionOrder::BackToFront);
    scene.size = [1024, 768];
    let mut renderer = Renderer::new(&context, 1024, 768).unwrap();
    let fixed = ABufferOptions {
        manager: Manager::Ffb,
        budget: Some(u64::MAX),
        ..ABufferOptions::DEFAULT
    };
    let (_, counts) = render(&mut renderer, &scene, fixed);
    let layer = counts.list_bytes as f64 / 3.0;
    assert_eq!(format!("{:.1} MB", layer / 1e6), "12.6 MB");
    assert_eq!(format!("{:.1} MiB", layer / f64::from(1 << 20)), "12.0 MiB");
}
