//! Depth peeling on the emulated pixel by the comparisons that SGIX_shadow had in 2001.

use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::methods::allocate_maps;
use onionskin::low_level::papers::everitt_2001::{SGIX_GEQUAL, SGIX_LEQUAL};
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{Amendment, DepthUnits, Map, Variables, run};
use onionskin::{Format, steps};

use crate::emulator_exhaustive::sequences_with_ties;
use crate::kit::changed::changed;
use crate::kit::peels::{Pixel, depth_of, pixel};

const PEELS: usize = 5;

/// The depths of the layers at each pixel, of at most `PEELS` peels.
fn layers(pixels: &[Pixel], amendments: &[Amendment]) -> Vec<Vec<f32>> {
    let mut emulator = Emulator::new(pixels.to_vec());
    let resources = [&stage::RESOURCES, &vtk::PEELING];
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(&mut emulator, &resources, color, depth).unwrap();
    let variables = Variables::new()
        .with("num_passes", PEELS as f64)
        .with("occlusion_ratio", 0.0)
        .with("window_area", pixels.len() as f64);
    let mut units = DepthUnits::new(&mut emulator);
    let outcome = run(&vtk::KEEP_LAYERS, amendments, variables, &mut units).unwrap();
    let found = outcome.variables.get("num_layers").unwrap() as u32;
    let mut layers = vec![Vec::new(); pixels.len()];
    for layer in 0..found {
        let depths = emulator
            .depths(Map::numbered("layer depth", layer))
            .unwrap();
        for (layers, &depth) in layers.iter_mut().zip(depths) {
            // Where nothing was found, the depth is the cleared one.
            layers.extend((depth < 1.0).then_some(depth));
        }
    }
    layers
}

/// Every sequence of up to four surfaces, with every tie: GREATER peels one surface of each depth. GEQUAL passes what lies at
/// the depth that was peeled, and LEQUAL what lies before it too, so every peel is the first.
#[test]
pub(crate) fn ex04_every_peel_by_gequal_or_lequal_finds_the_nearest_again() {
    let of_ranks = |ranks: Vec<usize>| pixel(ranks.into_iter().map(|rank| depth_of(rank, 8)));
    let pixels: Vec<Pixel> = (1..=4)
        .flat_map(sequences_with_ties)
        .map(of_ranks)
        .collect();
    assert!(pixels.len() > 80, "{}", pixels.len());
    let sorted = |pixel: &Pixel| {
        let mut depths: Vec<f32> = pixel.iter().map(|it| it.fragment.depth).collect();
        depths.sort_by(f32::total_cmp);
        depths
    };
    let mut ties = 0;
    for (pixel, peeled) in pixels.iter().zip(layers(&pixels, &[])) {
        let mut distinct = sorted(pixel);
        distinct.dedup();
        ties += pixel.len() - distinct.len();
        assert_eq!(peeled, distinct, "{pixel:?}");
    }
    assert!(ties > 50, "{ties}");
    for amendment in [SGIX_GEQUAL, SGIX_LEQUAL] {
        for (pixel, peeled) in pixels.iter().zip(layers(&pixels, &[amendment])) {
            assert_eq!(peeled, [sorted(pixel)[0]; PEELS], "{pixel:?}");
        }
    }
}

/// So the comparison decides how many layers there are.
#[test]
fn a_comparison_that_passes_nothing_ends_after_the_first_peel() {
    const NEVER: Amendment = changed(
        steps! { set depth func to GREATER; },
        steps! { set depth func to NEVER; },
    );
    let pixels = [pixel([0.5, 0.25])];
    assert_eq!(layers(&pixels, &[NEVER]), [[0.25]]);
}
