//! Errata that only the print can show. Each test holds a few quoted words against the papers' texts where these are at
//! hand, beside the project's folder; where they are not, it says so and checks the reasoning alone.

use std::path::Path;

/// A paper's text without line breaks and signs of typesetting, if it is at hand.
fn text(file: &str) -> Option<String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/papers");
    let Ok(text) = std::fs::read_to_string(path.join(file)) else {
        println!("skipped: there is no {file}");
        return None;
    };
    // A word that is divided at a line's end is whole again.
    let text = text.replace("-\n", "").replace(['$', '\\', '*'], "");
    Some(text.split_whitespace().collect::<Vec<_>>().join(" "))
}

const EVERITT: &str = "everitt-2001.txt";
const VTK: &str = "vtk-wiki.txt";
const CARR: &str = "carr-2008.txt";
const CARR_SECOND_SCAN: &str = "carr-2008-second-scan.txt";
const LINDHOLM: &str = "lindholm-2015.txt";

/// The print has each of these words so many times.
#[track_caller]
fn prints(file: &str, quotations: &[(&str, usize)]) {
    let Some(text) = text(file) else { return };
    for &(quotation, times) in quotations {
        assert_eq!(
            text.matches(quotation).count(),
            times,
            "'{quotation}' in {file}"
        );
    }
}

#[test]
fn words_that_are_not_printed_would_be_noticed() {
    if text(EVERITT).is_some() {
        let wrong = std::panic::catch_unwind(|| prints(EVERITT, &[("triple peeling", 1)]));
        assert!(wrong.is_err());
    }
}

/// The internal formats that NV_texture_shader adds for pairs of high and low components.
const HILO_FORMATS: [&str; 4] = ["HILO_NV", "HILO16_NV", "SIGNED_HILO_NV", "SIGNED_HILO16_NV"];

#[test]
pub(crate) fn ex05_the_extension_s_unsigned_format_has_another_name() {
    prints(EVERITT, &[("GL_UNSIGNED_HILO_NV", 1)]);
    assert!(!HILO_FORMATS.contains(&"UNSIGNED_HILO_NV"));
}

#[test]
pub(crate) fn ex06_the_quotient_is_called_s_over_q_twice() {
    prints(
        EVERITT,
        &[
            (
                "interpolating window space depth in the same way that s/q does it",
                1,
            ),
            ("(zc/wc and s/q respectively)", 1),
            ("use the r/q quotient", 1),
            ("compute the r/q quotient", 1),
        ],
    );
}

#[test]
pub(crate) fn ex08_two_figures_have_one_number() {
    prints(
        EVERITT,
        &[
            ("Figure 5. This diagram", 1),
            ("Figure 5. The depth peeled layers", 1),
            ("Figure 6", 0),
            // The first in the text, and three times the second.
            ("Figure 5 illustrates the general operation", 1),
            ("Figure 5 illustrates the results of compositing", 1),
            ("the bottom two images in Figure 5", 1),
            ("the scene in Figure 5", 1),
            ("Figure 5", 6),
        ],
    );
}

#[test]
pub(crate) fn vx11_eight_bits_are_asked_for_by_a_boolean() {
    prints(
        VTK,
        &[
            ("at least 8 alpha bits", 1),
            ("vtkRenderWindow::SetAlphaBitPlanes(1)", 1),
            ("alpha bits (as initial value is 0 (false) )", 1),
        ],
    );
}

#[test]
pub(crate) fn cx18_z_min_prev_is_called_z_prev_min_once() {
    prints(
        CARR_SECOND_SCAN,
        &[("z_prev_min", 1), ("the value of z_prev_min", 1)],
    );
}

#[test]
pub(crate) fn cx25_five_passes_are_promised_and_then_saved_to() {
    prints(
        CARR,
        &[
            ("onto modern graphics hardware using five passes", 1),
            ("by a single pass bringing the total count to five", 1),
            ("(pass 5)", 1),
            ("(pass 6)", 1),
        ],
    );
}

#[test]
pub(crate) fn cx26_there_is_no_figure_5_1() {
    prints(CARR, &[("The logic in Figure 5.1 culls", 1)]);
    let figures = (1..=5).map(|number| format!("Figure {number}:"));
    let figures: Vec<_> = figures.collect();
    prints(
        CARR,
        &figures
            .iter()
            .map(|figure| (figure.as_str(), 1))
            .collect::<Vec<_>>(),
    );
    prints(CARR, &[("Figure 5.1:", 0), ("Figure 6", 0)]);
}

#[test]
pub(crate) fn cx27_a_minimum_is_printed_as_its_argument() {
    prints(
        CARR_SECOND_SCAN,
        &[
            ("argmin", 2),
            ("The depth z_min_prev", 1),
            ("The depth z_min_post", 1),
        ],
    );
}

#[test]
pub(crate) fn cx28_table_1_s_dragon_has_more_vertices_than_corners() {
    prints(
        CARR,
        &[
            ("This yields a 62x speed-up", 1),
            ("achieves a 52 to 1 speed improvement", 1),
            ("Dragon 150K f", 2),
            ("749K v", 2),
            ("Lucy 250K f", 2),
            ("125K v", 2),
        ],
    );
    // In thousands. A triangle has three corners. Of a closed mesh of triangles every edge has two of them, so by Euler's
    // formula it has half as many vertices as faces.
    let [dragon, lucy] = [(150, 749), (250, 125)];
    let possible = |(faces, vertices): (u32, u32)| vertices <= 3 * faces;
    assert!(!possible(dragon) && possible(lucy));
    assert_eq!(lucy.1 * 2, lucy.0);
}

#[test]
pub(crate) fn cx31_n_is_the_count_and_an_index() {
    let Some(text) = text(CARR) else { return };
    assert_eq!(text.matches("s_0 dots s_{n-1} in S be the list").count(), 1);
    assert_eq!(
        text.matches("Let D(s_n) be the first surface in depth")
            .count(),
        1
    );
}

#[test]
pub(crate) fn cx32_two_lists_are_mixed_up() {
    prints(
        CARR_SECOND_SCAN,
        &[
            ("This list of surfaces S\u{302} is given by: S\u{30c} =", 1),
            // Accents are signs of their own here. Both definitions end in the same question.
            ("if s\u{302} 6= /0", 2),
        ],
    );
}

/// Table 1's rows: model and view, then what variant A, variant B and layer peeling took.
const DRAGON: &str = "749K v 3 it,18 g 3 it,15 g 14";

#[test]
pub(crate) fn cx34_table_1_has_no_top_view_and_one_row_twice() {
    prints(
        CARR,
        &[
            ("We compare a top and side view of some models", 1),
            ("front 749K v 3 it,18 g 3 it,15 g", 1),
            ("side (Fig.5) 749K v 3 it,18 g 3 it,15 g", 1),
            (DRAGON, 2),
            ("Dragon 150K f 51 fps 53 fps 35 fps", 2),
            ("end on 125K v", 1),
            ("top 1", 0),
        ],
    );
}

#[test]
pub(crate) fn cx35_the_post_flag_is_not_among_what_is_available() {
    let algorithm = include_str!("../print/carr/algorithm-2.txt");
    assert!(algorithm.contains("zPostFlag"));
    let Some(text) = text(CARR) else { return };
    let (_, available) = text
        .split_once("Available to the rasterization shader would be:")
        .unwrap();
    let (available, _) = available.split_once("Algorithm 2 Ideal").unwrap();
    assert!(
        available.contains("z_{Peel}") && available.contains("z_1, z_2, z_3"),
        "{available}"
    );
    assert!(!available.contains("Flag"), "{available}");
}

#[test]
pub(crate) fn lx09_an_average_is_printed_as_a_maximum() {
    prints(
        LINDHOLM,
        &[
            ("performance gains of up to eight times", 1),
            (
                "about eightfold ppDP when averaged over all scenes and GPUs",
                1,
            ),
        ],
    );
    // Of gains that are at most 8 and not all 8 the average is less.
    let gains = [8.0, 8.0, 7.9];
    assert!(gains.iter().sum::<f64>() / 3.0 < 8.0);
}

#[test]
pub(crate) fn lx10_layers_past_the_last_segment_are_told_in_two_ways() {
    prints(
        LINDHOLM,
        &[
            ("if depth complexity(p)<= i then", 1),
            (
                "only the first 128 layers were resolved for baseline and ppAO",
                1,
            ),
        ],
    );
}

#[test]
pub(crate) fn lx13_two_scenes_have_other_names_once() {
    prints(
        LINDHOLM,
        &[
            ("128 (neuro and flow)", 1),
            ("protein, space, medical, and cfd", 1),
        ],
    );
}
