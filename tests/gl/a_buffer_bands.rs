//! A-buffers in horizontal bands: the same image, and what fits.

use onionskin::options::{ABufferOptions, Manager};
use onionskin::{Comparison, Context, Method, Renderer};

use crate::kit::a_buffer::*;

#[test]
fn bands_of_any_height_give_the_same_image_bit_for_bit() {
    let context = Context::headless().unwrap();
    for size in [[1, 1], [1, 7], [7, 1], [127, 95], [128, 96]] {
        let mut scene = soup_scene(4);
        scene.size = size;
        let mut renderer = Renderer::new(&context, size[0], size[1]).unwrap();
        for manager in MANAGERS {
            let whole = ABufferOptions {
                pp_dp: true,
                ..small(manager)
            };
            let unbanded = renderer.render(&scene, &Method::ABuffer(whole)).unwrap();
            let counts = unbanded.stats.a_buffer.unwrap();
            assert_eq!(counts.bands, 1);
            for parts in [2, 5] {
                let budget = (counts.list_bytes / parts).max(64 * u64::from(size[0]) * 16);
                let options = ABufferOptions {
                    budget: Some(budget),
                    ..whole
                };
                let banded = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
                let in_bands = banded.stats.a_buffer.unwrap();
                assert!(in_bands.list_bytes <= budget);
                assert!(in_bands.bands > 1 || counts.list_bytes <= budget);
                assert!(banded.image == unbanded.image, "{size:?} {options:?}");
                assert_eq!(banded.stats.lost, Some(0));
                assert_eq!(in_bands.records_read, counts.records_read);
            }
        }
    }
}

/// Bands take turns in the same buffers: what has been allocated is what the largest band needs, in whatever order they
/// come, and besides the lists only the maps.
#[test]
fn bands_share_buffers_that_are_as_large_as_the_largest_needs() {
    let context = Context::headless().unwrap();
    let scene = soup_scene(4);
    let [width, height] = scene.size;
    for manager in MANAGERS {
        let mut renderer = Renderer::new(&context, width, height).unwrap();
        let mut beside_lists = |budget| {
            let options = ABufferOptions {
                budget,
                ..small(manager)
            };
            let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
            let counts = frame.stats.a_buffer.unwrap();
            (frame.stats.bytes - counts.list_bytes, counts)
        };
        let (maps, whole) = beside_lists(None);
        let (maps_of_bands, banded) = beside_lists(Some(whole.list_bytes / 4 * 3));
        assert!(banded.bands > 1, "{manager:?}: {banded:?}");
        assert_eq!(maps_of_bands, maps, "{manager:?}");
    }
}

/// The large sizes once, with the manager that the prefix scan serves, over an odd size and a budget.
#[test]
fn large_images_are_the_same_in_bands() {
    const MIB: u64 = 1 << 20;
    let context = Context::headless().unwrap();
    for (size, budgets) in [
        ([1023, 767], [4 * MIB, 64 * MIB]),
        ([1024, 768], [4 * MIB, 64 * MIB]),
        ([4096, 2304], [60 * MIB, 512 * MIB]),
    ] {
        let mut scene = soup_scene(5);
        scene.size = size;
        let mut renderer = Renderer::new(&context, size[0], size[1]).unwrap();
        let mut images = Vec::new();
        for budget in budgets {
            let options = ABufferOptions {
                budget: Some(budget),
                pp_dp: true,
                ..small(Manager::Dfb)
            };
            let frame = renderer.render(&scene, &Method::ABuffer(options)).unwrap();
            assert_eq!(frame.stats.lost, Some(0));
            let counts = frame.stats.a_buffer.unwrap();
            assert!(counts.list_bytes <= budget);
            images.push((frame.image, counts.bands));
        }
        assert!(images[0].1 > images[1].1, "{size:?}: as many bands");
        assert!(images[0].0 == images[1].0, "{size:?}");
        if size[0] < 2000 {
            let peeled = renderer
                .render(&scene, &"depth-peeling".parse::<Method>().unwrap())
                .unwrap();
            let error = Comparison::new(&images[0].0, &peeled.image, F16).unwrap();
            assert!(
                error.over as u64 <= peeled.stats.lost.unwrap(),
                "{size:?}: {error:?}"
            );
        }
    }
}

#[test]
fn a_budget_that_takes_no_row_is_refused_with_the_numbers() {
    let context = Context::headless().unwrap();
    let options = ABufferOptions {
        budget: Some(1000),
        ..small(Manager::Ffb)
    };
    let refused = Renderer::new(&context, 160, 120)
        .unwrap()
        .render(&soup_scene(0), &Method::ABuffer(options))
        .unwrap_err()
        .to_string();
    assert!(refused.contains("in the deepest pixel"), "{refused}");
    assert!(refused.contains("dfb"), "{refused}");
}
