//! The claims of Lindholm et al. 2015 about depth complexity, the Fill Step and global memory, L01 to L08, each under its
//! key. `gl/claims_lindholm_resolve.rs` has the others that need no volume, `gl/a_buffer.rs` L21.

use onionskin::generate::{SubmissionOrder, TorusKnot, torus_knot};
use onionskin::options::{ABufferOptions, Fill, Keep, Manager, RecordColor};
use onionskin::{Comparison, Context, CountBy, Frame, Method, Renderer, Scene};

use crate::kit::a_buffer::*;
use crate::kit::records::records;
use crate::kit::stack::{Piece, Stack, row};

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

/// The paper counts "all geometries", opaque ones and what they hide, too; and its shares are of all pixels. What a
/// resolve has to sort is less. Both are counted here.
#[test]
pub(crate) fn l01_all_geometry_is_counted_as_in_the_paper_beside_what_is_resolved() {
    let context = Context::headless().unwrap();
    let stack = Stack {
        opaque: Some(500),
        ..row(&[0, 1, 3, 3, 8, 20])
    };
    let mut renderer = Renderer::new(&context, 6, 1).unwrap();
    let mut count = |by| renderer.complexity(&stack.scene(), by).unwrap();
    let all = count(CountBy::AllGeometry);
    // The opaque surface is one more everywhere.
    assert_eq!(all.counts, [1, 2, 4, 4, 9, 21]);
    let shown = |pieces: &Vec<Piece>| pieces.iter().filter(|piece| piece.level < 500).count();
    let seen: Vec<_> = stack.pixels.iter().map(|list| shown(list) as u32).collect();
    assert_eq!(count(CountBy::Atomics).counts, seen);
    assert!(seen.iter().sum::<u32>() < 35, "something is hidden");
    // Of six pixels, an empty one included, and of five covered ones.
    let without = row(&[0, 1, 3, 3, 8, 20]);
    let counted = renderer
        .complexity(&without.scene(), CountBy::AllGeometry)
        .unwrap();
    assert_eq!(counted.part_of_image_up_to(3), 4.0 / 6.0);
    assert_eq!(counted.part_up_to(3), 3.0 / 5.0);
}

/// The boxes of volumes are in both. The paper's protein: 68% of all pixels have 8 or less, 6.6% over 17, at most 46.
#[test]
pub(crate) fn l01_the_paper_s_counting_of_the_molecule_finds_more_than_is_resolved() {
    let context = Context::headless().unwrap();
    let scene = bundled("molecule_fused.toml", [256, 192]);
    let mut renderer = Renderer::new(&context, 256, 192).unwrap();
    let [ours, paper] = [CountBy::Blending, CountBy::AllGeometry]
        .map(|by| renderer.complexity(&scene, by).unwrap());
    for (name, counted) in [("what is resolved", &ours), ("all geometry", &paper)] {
        println!(
            "{name}: at most {}, 8 or less: {:.1}% of all pixels, {:.1}% of the covered ones; over 17: {:.1}%",
            counted.max(),
            counted.part_of_image_up_to(8) * 100.0,
            counted.part_up_to(8) * 100.0,
            (1.0 - counted.part_of_image_up_to(17)) * 100.0
        );
    }
    let pairs = ours.counts.iter().zip(&paper.counts);
    assert!(pairs.clone().all(|(ours, paper)| ours <= paper));
    assert!(pairs.filter(|(ours, paper)| ours < paper).count() > 100);
    // The claim holds either way: most pixels are far below the maximum.
    for counted in [&ours, &paper] {
        assert!(counted.part_of_image_up_to(counted.max() / 4) > 0.5);
    }
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

/// "All giving the same image" holds up to N. Of a longer list, FFB and DFB keep what was submitted first, and PPLL what was
/// submitted last: the paper does not say which fragments are lost (LX12), and it depends on the manager.
#[test]
pub(crate) fn l04_past_n_the_managers_lose_as_many_fragments_but_not_the_same() {
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, 160, 120).unwrap();
    let scene = bundled("slices.toml", [160, 120]);
    let exact = renderer.render(&scene, &Method::Exact).unwrap().image;
    let frames = MANAGERS.map(|manager| {
        let options = ABufferOptions {
            manager,
            array: 32,
            ..options()
        };
        render(&mut renderer, &scene, options).0
    });
    let [ffb, dfb, ppll] = &frames;
    assert!(ffb.image == dfb.image && ffb.image != ppll.image);
    assert_eq!(ffb.stats.lost, dfb.stats.lost);
    assert_eq!(ffb.stats.lost, ppll.stats.lost);
    assert!(ffb.stats.lost > Some(1000), "{:?}", ffb.stats.lost);
    let error = |frame: &Frame| Comparison::new(&frame.image, &exact, 0.0).unwrap().max;
    println!(
        "{:?} fragments lost: FFB and DFB err by {:.4}, PPLL by {:.4}",
        ffb.stats.lost,
        error(ffb),
        error(ppll)
    );
    assert!((error(ffb) - error(ppll)).abs() > 0.01);
    // The nearest N would be the same with every manager.
    let nearest = MANAGERS.map(|manager| {
        let options = ABufferOptions {
            manager,
            array: 32,
            keep: Keep::Nearest,
            ..options()
        };
        render(&mut renderer, &scene, options).0.image
    });
    assert!(nearest[0] == nearest[1] && nearest[1] == nearest[2]);
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

/// z f32, id i32, colour 4 x f16: read back from the pool, byte by byte.
#[test]
pub(crate) fn l07_a_record_s_16_bytes_are_z_id_and_four_half_floats() {
    let context = Context::headless().unwrap();
    // With the camera's own planes depths are known.
    let mut renderer = Renderer::new(&context, 1, 1).unwrap().with_given_planes();
    // Halves are exact here: 0 01111 0000000000 is 1, 0.5 and 0.25 have smaller exponents, 0.75 has one bit more.
    let stack = Stack {
        width: 1,
        pixels: vec![vec![
            Piece {
                level: 700,
                color: [1.0, 0.5, 0.25, 0.75],
            },
            Piece {
                level: 100,
                color: [0.0, 0.75, 1.0, 0.5],
            },
        ]],
        opaque: None,
    };
    const HALVES: [[[u8; 2]; 4]; 2] = [
        [[0x00, 0x3C], [0x00, 0x38], [0x00, 0x34], [0x00, 0x3A]],
        [[0x00, 0x00], [0x00, 0x3A], [0x00, 0x3C], [0x00, 0x38]],
    ];
    for (manager, fill) in MANAGERS
        .into_iter()
        .flat_map(|m| [Fill::Atomics, Fill::Automatic].map(|f| (m, f)))
    {
        let options = ABufferOptions {
            manager,
            fill,
            color: RecordColor::Half,
            ..options()
        };
        let records = records(&mut renderer, &stack.scene(), options);
        assert_eq!(records.len(), 2 * 16, "{manager:?}");
        // On llvmpipe, and in order, the first submitted is the first in the pool.
        for (place, record) in records.chunks_exact(16).enumerate() {
            let z = f32::from_le_bytes(record[..4].try_into().unwrap());
            let id = u32::from_le_bytes(record[4..8].try_into().unwrap());
            // Two triangles are a quad, and only one of them covers the pixel's middle. Bits 31 and 30: a surface.
            assert_eq!(id >> 1, place as u32, "{manager:?}: {id:#x}");
            // Planes at 1 and 4, and a level's distance between them: z = (4 - 4/d) / 3.
            let distance = 1.0 + 3.0 * (f64::from(stack.pixels[0][place].level) + 1.0) / 1002.0;
            let expected = (4.0 - 4.0 / distance) / 3.0;
            // A dozen roundings of 2^-24 of numbers up to 4, in the projection and in the interpolation.
            assert!((f64::from(z) - expected).abs() < 3e-6, "{z} {expected}");
            assert_eq!(
                record[8..],
                HALVES[place].concat(),
                "{manager:?}, record {place}"
            );
        }
    }
    // A record of 32-bit colours has another word.
    let float = ABufferOptions {
        manager: Manager::Ffb,
        ..options()
    };
    assert_eq!(records(&mut renderer, &stack.scene(), float).len(), 2 * 32);
    // A link more.
    assert_eq!(ABufferOptions::DEFAULT.record_bytes(), 20);
}

/// The id holds the source's type and number by bits: 30 for a volume's box, 29 where the ray leaves it, then the number.
#[test]
pub(crate) fn l07_the_id_s_bits_tell_surfaces_from_the_boxes_of_volumes() {
    let context = Context::headless().unwrap();
    let mut scene = bundled("molecule_fused.toml", [8, 6]);
    scene.meshes.clear();
    let mut renderer = Renderer::new(&context, 8, 6).unwrap();
    let options = ABufferOptions {
        manager: Manager::Dfb,
        color: RecordColor::Half,
        ..options()
    };
    let records = records(&mut renderer, &scene, options);
    let mut seen = std::collections::BTreeMap::<u32, usize>::new();
    for record in records.chunks_exact(16) {
        let id = u32::from_le_bytes(record[4..8].try_into().unwrap());
        *seen.entry(id).or_default() += 1;
        // "The color component is left uninitialized": here it is 0.
        assert_eq!(record[8..], [0; 8]);
    }
    println!("{seen:x?}");
    let expected = [
        1 << 30,
        1 << 30 | 1,
        1 << 30 | 1 << 29,
        1 << 30 | 1 << 29 | 1,
    ];
    assert!(seen.keys().copied().eq(expected), "{seen:x?}");
    // Every ray that enters a box leaves it.
    assert_eq!(seen[&expected[0]], seen[&expected[2]]);
    assert_eq!(seen[&expected[1]], seen[&expected[3]]);
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
