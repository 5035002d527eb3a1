//! The numbers in the edition's figures of Carr, Měch and Miller 2008 are those that the paper's claims have here.

use onionskin::Context;

use crate::kit::edition::{numbers, quick_figure, row};
use crate::kit::figures::expect_figures;

#[test]
fn figure_1_has_the_iterations_of_its_claim() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "carr-1");
    let iterations = |head| numbers(&row(&drawn.tables[0], head)[1]);
    expect_figures("C03", 0, &iterations("hybrid layer peeling"));
    expect_figures("C03", 1, &iterations("layer peeling"));
}

/// The values are those of `gl/figure_2.rs`: the paper's but for D(s9), which pass 3 cannot write (CX01).
#[test]
fn figure_2_has_the_paper_s_stencil_values_and_all_but_one_of_its_depths() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "carr-2");
    let table = &drawn.tables[0];
    for (pass, stencil, depth, printed) in [
        ("1", "3", "D(s3)", "D(s3)"),
        ("2", "1", "D(s2)", "D(s2)"),
        ("3", "251", "D(s7)", "D(s9)"),
        ("4", "255", "D(s10)", "D(s10)"),
    ] {
        assert_eq!(row(table, pass), [stencil, stencil, printed, depth]);
    }
    assert_eq!(table.rows.len(), 6);
}

/// C04, C20 and C27 at 16 to 128 slices: the cone has two layers, and one iteration finds nothing.
#[test]
fn figure_3_grows_for_layer_peeling_only() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "carr-3");
    for cells in &drawn.tables[0].rows {
        let slices: f64 = cells[0].parse().unwrap();
        let [layers, hybrid, a, b] = [1, 2, 3, 4].map(|n| numbers(&cells[n]));
        assert_eq!(layers, [slices + 3.0, 2.0 * (slices + 3.0) - 1.0]);
        assert_eq!(hybrid, [3.0, 8.0]);
        assert_eq!([a[0], 6.0 * a[0]], a[..]);
        assert_eq!([a[0], 5.0 * a[0]], b[..]);
    }
    let at = |slices| numbers(&row(&drawn.tables[0], slices)[2])[0];
    assert_eq!([at("32"), at("64"), at("128")], [6.0; 3]);
    assert_eq!(drawn.charts[0].lines.len(), 4);
}

/// C20 in each row, here and in the paper's own table; the last iteration of layer peeling takes one pass here.
#[test]
fn table_1_has_six_five_and_two_passes_an_iteration() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "carr-table-1");
    for (table, empty) in drawn.tables.iter().zip([1.0, 0.0]) {
        for cells in &table.rows {
            let [a, b, layers] = [2, 3, 4].map(|n| numbers(&cells[n]));
            assert_eq!((a[1], b[1]), (6.0 * a[0], 5.0 * b[0]), "{cells:?}");
            assert_eq!(layers[1], 2.0 * layers[0] - empty, "{cells:?}");
            let ratio = layers[0] / a[0];
            // Half of the last digit that is shown.
            assert!((numbers(&cells[5])[0] - ratio).abs() <= 0.051, "{cells:?}");
        }
    }
    let ratios = drawn.tables[1]
        .rows
        .iter()
        .map(|cells| numbers(&cells[5])[0]);
    let [least, most] = [f64::min as fn(f64, f64) -> f64, f64::max]
        .map(|pick| ratios.clone().reduce(pick).unwrap());
    let claims = onionskin::low_level::papers::papers()
        .iter()
        .flat_map(|it| it.claims);
    let claim = claims.into_iter().find(|claim| claim.key == "C21").unwrap();
    let printed = claim.figures[0].paper.unwrap();
    assert_eq!(printed, format!("{least:.1} to {most:.1}"));
}

/// CX16 and CX22: what is printed loses fragments, or composites them again, and what is amended does neither.
#[test]
fn as_printed_sections_6_and_7_are_wrong_and_as_amended_right() {
    let context = Context::headless().unwrap();
    let section_6 = quick_figure(&context, "carr-section-6");
    let in_image = |head| numbers(&row(&section_6.tables[0], head)[1]);
    let amended = in_image("as the sentence says");
    assert_eq!(amended[0], amended[1]);
    let printed = in_image("as printed");
    assert!(printed[0] < printed[1], "{printed:?}");

    let ideal = quick_figure(&context, "carr-ideal");
    let Some(table) = ideal.tables.first() else {
        println!("skipped: {}", ideal.caption);
        return;
    };
    for cells in &table.rows {
        let error = numbers(&cells[3])[0];
        let is_printed = cells[0].ends_with("as printed");
        // Blending a dozen layers in 32 bits, and what composites again.
        assert!(
            if is_printed {
                error > 0.01
            } else {
                error < 1e-5
            },
            "{cells:?}"
        );
    }
}

/// Each iteration leaves what a later one has to add: the last has everything, and the first does not.
#[test]
fn every_iteration_adds_to_the_image() {
    let context = Context::headless().unwrap();
    let hybrid = quick_figure(&context, "carr-hybrid-buffers");
    let fragments: Vec<f64> = hybrid.tables[0]
        .rows
        .iter()
        .map(|row| numbers(&row[1])[0])
        .collect();
    assert_eq!(fragments.len(), 3);
    assert!(
        fragments.windows(2).all(|pair| pair[0] < pair[1]),
        "{fragments:?}"
    );
    let coherent = quick_figure(&context, "carr-iterations");
    let [layers, runs] = [0, 1].map(|line| &coherent.charts[0].lines[line].points);
    assert!(runs.len() < layers.len());
    for (layer, run) in layers.iter().zip(runs) {
        assert!(layer[1] <= run[1], "{layer:?} {run:?}");
    }
    // Pass 3's inverted counts, and pass 4's 255.
    let buffers = quick_figure(&context, "carr-buffers");
    let stencils = |pass| numbers(&row(&buffers.tables[0], pass)[0]);
    assert!(stencils("1")[1] < 129.0 && stencils("2")[1] <= 1.0);
    assert!(stencils("3")[1] > 128.0);
    assert_eq!(stencils("4")[1], 255.0);
    // Beside the listings: stencil and depth, then colour.
    for (pass, pictures) in [(1, 2), (2, 2), (3, 2), (4, 2), (5, 1), (6, 1)] {
        let drawn = quick_figure(&context, &format!("carr-pass-{pass}"));
        assert_eq!(drawn.pictures.len(), pictures, "{pass}");
    }
}

#[test]
fn the_order_of_figure_2_names_every_surface() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "carr-2-order");
    let (svg, _) = &drawn.drawings[0];
    assert_eq!(svg.matches("<tspan").count(), 11);
    assert_eq!(svg.matches("class=\"run\"").count(), 3);
}
