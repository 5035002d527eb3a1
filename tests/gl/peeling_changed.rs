//! Depth peeling when a word of the listing is changed.

use crate::kit::bounds::F32;
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Amendment, Map, Shader, Step};
use onionskin::options::DepthPeelingOptions;
use onionskin::{Comparison, Context, Method, Renderer, Scene, steps};

use crate::kit::changed::changed;
use crate::kit::peeling::peel;
use crate::kit::stack::{Piece, Stack};

#[test]
fn a_listing_with_one_changed_word_gives_another_image() {
    let context = Context::headless().unwrap();
    let (_, stack) = exemplary();
    let expected = stack.expected();
    let off = |amendments: &'static [Amendment], reading| {
        let options = DepthPeelingOptions {
            maximum_number_of_peels: 12,
            reading,
            amendments,
            ..Default::default()
        };
        Comparison::new(
            &peel(&context, &stack.scene(), options).image,
            &expected,
            F32,
        )
        .unwrap()
        .over
    };
    assert_eq!(off(&[], onionskin::options::Reading::Amended), 0);
    for (name, change) in CHANGES {
        assert!(
            off(change, onionskin::options::Reading::Amended) > 0,
            "{name} was not noticed"
        );
    }
    // As printed, a layer's pixels are not told from background by their depth, so the colours must be clear.
    const COLOR: &[Amendment] = &[changed(steps! { clear color buffer; }, steps! {})];
    assert!(
        off(COLOR, onionskin::options::Reading::AsPrinted) > 0,
        "a dropped colour clear was not noticed"
    );
}

#[test]
fn swapping_a_and_b_throughout_changes_names_only() {
    // 'A and B swapped' in both places where they are set, or in both where they are used, makes the same program.
    const SET: &[Amendment] = &[changed(
        steps! { A = i % 2; B = (i + 1) % 2; },
        steps! { A = (i + 1) % 2; B = i % 2; },
    )];
    let context = Context::headless().unwrap();
    let (_, stack) = exemplary();
    let options = DepthPeelingOptions {
        amendments: SET,
        ..Default::default()
    };
    let frame = peel(&context, &stack.scene(), options);
    assert_eq!(
        Comparison::new(&frame.image, &stack.expected(), F32)
            .unwrap()
            .over,
        0
    );
}

/// One changed word each.
const CHANGES: &[(&str, &[Amendment])] = &[
    (
        "GREATER to LESS",
        &[changed(
            steps! { set depth func to GREATER; },
            steps! { set depth func to LESS; },
        )],
    ),
    (
        "LESS to GREATER",
        &[changed(
            steps! { set depth func to LESS; },
            steps! { set depth func to GREATER; },
        )],
    ),
    (
        "A for B in unit 1",
        &[changed(steps! { B = (i + 1) % 2; }, steps! { B = i % 2; })],
    ),
    (
        "the depth buffer not started anew",
        &[changed(FROM_OPAQUE, steps! {})],
    ),
    (
        "depth writes left disabled",
        &[changed(
            steps! { enable depth writes; },
            steps! { disable depth writes; },
        )],
    ),
];

const FROM_OPAQUE: &[Step] =
    steps! { glCopyImageSubData(Map::named("opaque depth"), Map::at("depth buffer", "B")); };

/// Five layers in no particular order, and the scene.
fn exemplary() -> (Scene, Stack) {
    let levels = [700, 100, 900, 300, 500];
    let piece = |level: u16| Piece {
        level,
        color: [f32::from(level) / 1000.0, 0.5, 0.25, 0.5],
    };
    let stack = Stack {
        width: 3,
        pixels: vec![levels.map(piece).to_vec(); 6],
        opaque: None,
    };
    (stack.scene(), stack)
}

#[test]
fn a_user_s_amendment_that_misspells_a_name_is_refused_before_a_frame_is_drawn() {
    const SHADER: &[Amendment] = &[changed(
        steps! { glUseProgram(stage::PEEL_SURFACE); },
        steps! { glUseProgram(Shader("peal")); },
    )];
    // Not even the first round would come to it.
    const NEVER: &[Amendment] = &[changed(
        steps! { enable depth writes; },
        steps! { if (i == 99) { glBindTexture(Map::named("opaque dpeth")); } },
    )];
    let context = Context::headless().unwrap();
    let (_, stack) = exemplary();
    let mut renderer = Renderer::new(&context, 8, 8).unwrap();
    for (amendments, meant) in [(SHADER, "'peel'"), (NEVER, "'opaque depth'")] {
        for reading in [
            onionskin::options::Reading::Amended,
            onionskin::options::Reading::AsPrinted,
        ] {
            let method = Method::DepthPeeling(DepthPeelingOptions {
                maximum_number_of_peels: 2,
                reading,
                amendments,
                ..Default::default()
            });
            let refused = renderer.render(&stack.scene(), &method);
            let error = refused.unwrap_err().to_string();
            assert!(error.contains(meant), "{error}");
        }
    }
}
