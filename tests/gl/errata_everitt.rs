//! Errata of Everitt 2001 that show when his listings are executed. Those that only the print can show are in
//! `papers/errata_in_print.rs`.

use glam::DMat4;
use onionskin::low_level::gl::ClassicState;
use onionskin::low_level::methods::{Compositing, DepthPeelingOptions};
use onionskin::low_level::papers::everitt_2001::LISTING_2;
use onionskin::low_level::steps::{
    Amendment, Call, ClassicCall, Recorder, TexEnvValue, Variables, gl::*, run,
};
use onionskin::{Context, steps};

use crate::kit::changed::changed;
use crate::kit::everitt_scenes::{peel, soup_scene};

/// The calls of Listing 2, and the state that they leave.
fn listing_2() -> (Vec<Call>, ClassicState) {
    let mut recorder = Recorder::new();
    run(&LISTING_2, &[], Variables::new(), &mut recorder).unwrap();
    let mut state = ClassicState::new(DMat4::IDENTITY, DMat4::IDENTITY);
    for call in &recorder.calls {
        if let Call::Classic(call) = call {
            state.perform(call).unwrap();
        }
    }
    (recorder.calls, state)
}

#[test]
pub(crate) fn ex01_listing_2_enables_nothing() {
    let (calls, state) = listing_2();
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
}

#[test]
pub(crate) fn ex02_unit_3_s_environment_drops_the_comparison() {
    let (_, state) = listing_2();
    assert_eq!(state.units[3].environment, TexEnvValue::None);
    assert_eq!(
        ClassicState::new(DMat4::IDENTITY, DMat4::IDENTITY).units[3].environment,
        TexEnvValue::Modulate
    );
}

#[test]
pub(crate) fn ex03_unit_3_has_no_texel_coordinates() {
    let (_, state) = listing_2();
    assert_eq!(state.units[3].operation, TexEnvValue::TextureRectangle);
    assert_eq!(
        [1, 2, 3].map(|unit| state.units[unit].texgen),
        [true, true, false]
    );
    assert_eq!(state.texture_matrix(3), DMat4::IDENTITY);
    assert_ne!(state.texture_matrix(2), DMat4::IDENTITY);
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
