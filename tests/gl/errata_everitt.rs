//! Errata of Everitt 2001 that show when his listings are executed. Those that only the print can show are in
//! `papers/errata_in_print.rs`.

use glam::DMat4;
use onionskin::low_level::gl::ClassicState;
use onionskin::low_level::papers::everitt_2001::{
    COMBINED_AS_IT_IS, ENABLED, INTO_ALPHA, LISTING_2, LOOKED_UP_AS_2D, MODULATED, SGIX_GEQUAL,
    SGIX_LEQUAL, TEXELS,
};
use onionskin::low_level::steps::{
    Amendment, Call, ClassicCall, Recorder, TexEnvValue, Variables, gl::*, run,
};
use onionskin::options::{Compositing, DepthPeelingOptions, DepthUnit0, Reading};
use onionskin::{Context, Layer, Method, Renderer, steps};

use crate::kit::changed::changed;
use crate::kit::everitt_scenes::{peel, soup_scene};

/// The calls of Listing 2, and the state that they leave.
fn listing_2(amendments: &[Amendment]) -> (Vec<Call>, ClassicState) {
    let mut recorder = Recorder::new();
    run(&LISTING_2, amendments, Variables::new(), &mut recorder).unwrap();
    let mut state = ClassicState::new(DMat4::IDENTITY, DMat4::IDENTITY);
    for call in &recorder.calls {
        if let Call::Classic(call) = call {
            state.perform(call).unwrap();
        }
    }
    (recorder.calls, state)
}

/// Layers peeled as in 2001, with the paper's silence filled but for what `without` leaves as it stands.
fn layers(
    context: &Context,
    depth_unit_0: DepthUnit0,
    reading: Reading,
    without: &'static [Amendment],
) -> Vec<Layer> {
    let options = DepthPeelingOptions {
        maximum_number_of_peels: 3,
        compositing: Compositing::KeepLayers,
        depth_unit_0,
        reading,
        amendments: without,
        ..DepthPeelingOptions::default()
    };
    peel(context, &soup_scene(11), options).layers
}

fn same_depths(a: &Layer, b: &Layer) -> bool {
    a.depth == b.depth
}

/// All layers have the nearest depths.
fn nothing_is_peeled(layers: &[Layer]) -> bool {
    layers.len() == 3 && layers.iter().all(|layer| same_depths(layer, &layers[0]))
}

#[test]
pub(crate) fn ex01_listing_2_enables_nothing() {
    let (calls, state) = listing_2(&[]);
    let enables = |call: &&Call| {
        matches!(
            call,
            Call::Enable { .. } | Call::Classic(ClassicCall::Enable { .. })
        )
    };
    assert_eq!(calls.iter().filter(enables).count(), 0);
    // The operations that would need it are there.
    assert_eq!(state.units[1].operation, TexEnvValue::DotProduct);
    assert_eq!(
        state.units[2].operation,
        TexEnvValue::DotProductDepthReplace
    );
    assert_eq!(state.depth_replace(), None);
    let (calls, state) = listing_2(&[ENABLED]);
    assert_eq!(calls.iter().filter(enables).count(), 1);
    assert!(state.depth_replace().is_some());
}

/// So the depth that is stored is not the one that is compared, as if there were no Listing 2.
#[test]
pub(crate) fn ex01_without_the_enabling_the_rasteriser_s_depth_is_stored() {
    const WITHOUT: &[Amendment] = &[changed(ENABLED.printed, ENABLED.printed)];
    let context = Context::headless().unwrap();
    let of = |unit, without| layers(&context, unit, Reading::Amended, without);
    let filled = of(DepthUnit0::ClassicDepthReplace, &[]);
    let printed = of(DepthUnit0::ClassicDepthReplace, WITHOUT);
    let no_listing_2 = of(DepthUnit0::Classic, &[]);
    let rasteriser_s = layers(&context, DepthUnit0::Sampler, Reading::Amended, &[]);
    assert!(same_depths(&printed[0], &rasteriser_s[0]));
    assert!(!same_depths(&filled[0], &rasteriser_s[0]));
    for (a, b) in printed.iter().zip(&no_listing_2) {
        assert!(same_depths(a, b) && a.color == b.color);
    }
    assert!(!same_depths(&printed[1], &rasteriser_s[1]), "it mis-peels");
}

#[test]
pub(crate) fn ex02_unit_3_s_environment_drops_the_comparison() {
    let (_, state) = listing_2(&[]);
    assert_eq!(state.units[3].environment, TexEnvValue::None);
    assert_eq!(
        ClassicState::new(DMat4::IDENTITY, DMat4::IDENTITY).units[3].environment,
        TexEnvValue::Modulate
    );
}

#[test]
pub(crate) fn ex02_by_unit_3_s_printed_environment_nothing_is_peeled() {
    const WITHOUT: &[Amendment] = &[changed(MODULATED.printed, MODULATED.printed)];
    let context = Context::headless().unwrap();
    let of = |without| {
        let unit = DepthUnit0::ClassicDepthReplace;
        layers(&context, unit, Reading::Amended, without)
    };
    assert!(nothing_is_peeled(&of(WITHOUT)));
    assert!(!nothing_is_peeled(&of(&[])));
}

#[test]
pub(crate) fn ex03_unit_3_has_no_texel_coordinates() {
    let (_, state) = listing_2(&[]);
    assert_eq!(state.units[3].operation, TexEnvValue::TextureRectangle);
    assert_eq!(
        [1, 2, 3].map(|unit| state.units[unit].texgen),
        [true, true, false]
    );
    assert_eq!(state.texture_matrix(3), DMat4::IDENTITY);
    assert_ne!(state.texture_matrix(2), DMat4::IDENTITY);
}

/// Where the shadow map is a texture of two dimensions there is no rectangle to look up; where it is a rectangle, all pixels
/// look up the texels of one corner.
#[test]
pub(crate) fn ex03_with_coordinates_from_0_to_1_the_printed_rectangle_does_not_peel() {
    const NO_2D: &[Amendment] = &[changed(LOOKED_UP_AS_2D.printed, LOOKED_UP_AS_2D.printed)];
    const NO_TEXELS: &[Amendment] = &[changed(TEXELS.printed, TEXELS.printed)];
    let context = Context::headless().unwrap();
    let of = |unit, without| layers(&context, unit, Reading::Amended, without);
    let two_d = of(DepthUnit0::ClassicDepthReplace, &[]);
    let rectangle = of(DepthUnit0::ClassicRectangle, &[]);
    assert!(!nothing_is_peeled(&two_d));
    for (a, b) in two_d.iter().zip(&rectangle) {
        assert!(same_depths(a, b) && a.color == b.color);
    }
    assert!(nothing_is_peeled(&of(
        DepthUnit0::ClassicDepthReplace,
        NO_2D
    )));
    // In that corner nothing is drawn, and nothing lies behind nothing.
    let one_corner = of(DepthUnit0::ClassicRectangle, NO_TEXELS);
    assert!(one_corner.len() == 1 && same_depths(&one_corner[0], &rectangle[0]));
}

#[test]
pub(crate) fn ex04_a_luminance_leaves_alpha_as_it_is_and_nothing_is_peeled() {
    const WITHOUT: &[Amendment] = &[changed(INTO_ALPHA.printed, INTO_ALPHA.printed)];
    let context = Context::headless().unwrap();
    for unit in [DepthUnit0::Classic, DepthUnit0::ClassicDepthReplace] {
        let of = |without| layers(&context, unit, Reading::Amended, without);
        let (luminance, alpha) = (of(WITHOUT), of(&[]));
        assert!(nothing_is_peeled(&luminance) && !nothing_is_peeled(&alpha));
    }
}

/// What a GeForce3 had in 2001: LEQUAL, a luminance, and register combiners that carry its inverse into alpha. The layers are
/// those of GREATER, bit for bit, ties included.
#[test]
pub(crate) fn ex04_sgix_shadow_peels_by_what_lequal_does_not_pass() {
    const GREATER_AS_PRINTED: &[Amendment] = &[changed(SGIX_LEQUAL.printed, SGIX_LEQUAL.printed)];
    let context = Context::headless().unwrap();
    let of = |unit| layers(&context, unit, Reading::Amended, &[]);
    let sgix = of(DepthUnit0::ClassicSgix);
    assert!(sgix.len() == 3 && !nothing_is_peeled(&sgix));
    for (a, b) in sgix.iter().zip(&of(DepthUnit0::ClassicDepthReplace)) {
        assert!(same_depths(a, b) && a.color == b.color);
    }
    // GREATER is none of SGIX_shadow's.
    let printed = DepthPeelingOptions {
        depth_unit_0: DepthUnit0::ClassicSgix,
        maximum_number_of_peels: 3,
        amendments: GREATER_AS_PRINTED,
        ..DepthPeelingOptions::default()
    };
    let scene = soup_scene(11);
    let [width, height] = scene.size;
    let mut renderer = Renderer::new(&context, width, height).unwrap();
    let refused = renderer.render(&scene, &Method::DepthPeeling(printed));
    let error = refused.unwrap_err().to_string();
    assert!(error.contains("SGIX_shadow cannot perform"), "{error}");
}

/// Without an inverse, what SGIX_shadow passes is drawn: by GEQUAL what lies at the depth that was peeled, and by LEQUAL what
/// lies before it as well.
#[test]
pub(crate) fn ex04_by_gequal_equal_depths_pass_and_every_layer_is_the_first() {
    const GEQUAL: &[Amendment] = &[SGIX_GEQUAL, COMBINED_AS_IT_IS];
    const LEQUAL: &[Amendment] = &[SGIX_LEQUAL, COMBINED_AS_IT_IS];
    let context = Context::headless().unwrap();
    for amendments in [GEQUAL, LEQUAL] {
        let unit = DepthUnit0::ClassicSgix;
        let same = layers(&context, unit, Reading::Amended, amendments);
        assert!(nothing_is_peeled(&same));
    }
}

/// The texts on depth unit 0 without what fills their silence: the loop ends after as many peels as it is told to make, and
/// all of them are the first one.
#[test]
fn literally_the_depth_unit_0_of_2001_peels_nothing() {
    let context = Context::headless().unwrap();
    for unit in [
        DepthUnit0::Classic,
        DepthUnit0::ClassicDepthReplace,
        DepthUnit0::ClassicRectangle,
    ] {
        let of = |reading| layers(&context, unit, reading, &[]);
        // A luminance makes black what it does not pass, and leaves its alpha.
        let alpha = |layer: &Layer| -> Vec<f32> {
            layer.color.pixels.iter().map(|color| color.a).collect()
        };
        let first = |layers: &[Layer]| layers.iter().all(|it| alpha(it) == alpha(&layers[0]));
        let (literal, filled) = (of(Reading::Literal), of(Reading::AsPrinted));
        assert_eq!((literal.len(), filled.len()), (3, 3));
        assert!(first(&literal) && !first(&filled), "{unit:?}");
    }
}

/// A depth that texture shaders make is not clamped to the depth range, as one that a shader of today writes is: the fragment
/// is rejected.
#[test]
fn a_replaced_depth_outside_of_the_depth_range_rejects_the_fragment() {
    // Depths from -0.5 to 0.5 instead of from 0 to 1.
    const NEARER: &[Amendment] = &[changed(
        steps! { glTranslatef(0.0, 0.0, 0.5); },
        steps! { glTranslatef(0.0, 0.0, 0.0); },
    )];
    let context = Context::headless().unwrap();
    let of = |without| {
        let unit = DepthUnit0::ClassicDepthReplace;
        layers(&context, unit, Reading::Amended, without).remove(0)
    };
    let (right, nearer) = (of(&[]), of(NEARER));
    let mut rejected = 0;
    for (&depth, &moved) in right.depth.iter().zip(&nearer.depth) {
        assert!(moved > 0.0, "{moved}: it would have been clamped");
        if depth < 1.0 {
            // Where the nearest is rejected, there is a farther one or none.
            let rejects = depth < 0.499;
            let kept = (moved - (depth - 0.5)).abs() < 1e-3;
            assert!(
                rejects != kept || (0.499..0.501).contains(&depth),
                "{depth} {moved}"
            );
            rejected += usize::from(rejects);
        }
    }
    assert!(rejected > 100, "{rejected}");
}

#[test]
pub(crate) fn ex04_gequal_peels_nothing_and_not_lequal_peels() {
    const GEQUAL: &[Amendment] = &[changed(
        steps! { set depth func to GREATER; },
        steps! { set depth func to GEQUAL; },
    )];
    let context = Context::headless().unwrap();
    let scene = soup_scene(11);
    let layers = |amendments| {
        let options = DepthPeelingOptions {
            maximum_number_of_peels: 3,
            compositing: Compositing::KeepLayers,
            amendments,
            ..DepthPeelingOptions::default()
        };
        peel(&context, &scene, options).layers
    };
    let (greater, gequal) = (layers(&[]), layers(GEQUAL));
    assert!(gequal.iter().all(|layer| layer.depth == gequal[0].depth));
    assert!(greater[1].depth != greater[0].depth);
    assert!(greater[0].depth == gequal[0].depth);
    // What LEQUAL does not pass is what GREATER passes, whatever is compared but NaN.
    for pair in [[0.25, 0.5], [0.5, 0.5], [0.5, 0.25]] {
        let [fragment, texel] = pair;
        assert_eq!(
            GREATER.holds(fragment, texel),
            !LEQUAL.holds(fragment, texel),
            "{pair:?}"
        );
    }
}
