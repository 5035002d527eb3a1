//! The numbers in the edition's figures of Lindholm et al. 2015 are those that the paper's claims have here, or follow from the
//! histogram.

use onionskin::low_level::edition::figures::Studio;
use onionskin::{Complexity, Context, CountBy};

use crate::kit::edition::{numbers, quick_figure, row};
use crate::kit::figures::expect_figures;

/// A number in each of these rows.
fn column(
    table: &onionskin::low_level::edition::figures::Table,
    heads: &[&str],
    at: usize,
) -> Vec<f64> {
    let cell = |head: &&str| numbers(&row(table, head)[at])[0];
    heads.iter().map(cell).collect()
}

/// The depth complexity of a scene as the quick edition shows it.
fn complexity(context: &Context, name: &str, whole: [u32; 2]) -> Complexity {
    let studio = Studio::new(context, true).unwrap();
    let scene = studio.scene(name, whole).unwrap();
    let mut renderer = studio.renderer(&scene).unwrap();
    renderer.complexity(&scene, CountBy::Blending).unwrap()
}

#[test]
fn figure_6_has_the_elements_and_records_of_its_claim() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-6");
    let medical = ["medical, static", "medical, ppAO", "medical, ppDP"];
    expect_figures("L19", 0, &column(&drawn.tables[0], &medical, 0));
    expect_figures("L19", 1, &column(&drawn.tables[0], &medical, 2));
}

#[test]
fn figure_7_has_the_elements_and_records_of_its_claim_where_the_quads_fill_the_screen() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-7");
    let ways = ["static", "ppAO", "ppDP"];
    expect_figures("L18", 0, &column(&drawn.tables[0], &ways, 0));
    expect_figures("L18", 1, &column(&drawn.tables[0], &ways, 1));
    for chart in &drawn.charts {
        for line in &chart.lines {
            let middle = line.points.len() / 2;
            // The quads grow, and shrink again in the same way.
            assert!(line.points[0][1] < line.points[middle][1], "{line:?}");
            assert_eq!(line.points[0][1], line.points[line.points.len() - 1][1]);
        }
    }
}

/// What the Fill Step's counters hold is what blending counts, and the Resolve Step reads each fragment once.
#[test]
fn figure_3_s_counters_hold_every_fragment_once() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-3");
    let fragments = complexity(&context, "knots", [384, 288]).fragments() as f64;
    let table = &drawn.tables[0];
    assert_eq!(numbers(&row(table, "Fill")[0])[0], fragments);
    assert_eq!(numbers(&row(table, "Resolve")[0])[0], fragments);
    let slots = numbers(&row(table, "Resolve")[1]);
    assert_eq!(slots[1], fragments);
    assert!(slots[0] > slots[1]);
}

#[test]
fn figure_5_s_elements_follow_from_the_histogram() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-5");
    let complexity = complexity(&context, "molecule", [288, 216]);
    let counts = || complexity.counts.iter().filter(|&&count| count > 0);
    let sum = |of: fn(u32) -> u32| -> f64 { counts().map(|&count| f64::from(of(count))).sum() };
    let ways = ["static", "ppAO", "ppDP"];
    let [reserved, used, read] = [0, 1, 2].map(|at| column(&drawn.tables[0], &ways, at));
    let fragments = sum(|count| count);
    let segment = |count: u32| count.next_power_of_two().max(8);
    assert_eq!(reserved, [sum(|_| 64), sum(segment), sum(|_| 8)]);
    assert_eq!(used, [fragments, fragments, sum(|count| count.min(8))]);
    assert_eq!(
        read,
        [fragments, fragments, sum(|count| count * count.div_ceil(8))]
    );
}

/// Read back from OpenGL in the figure, and here from the counts alone.
#[test]
fn segments_and_subpasses_follow_from_the_histogram() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-segments");
    let complexity = complexity(&context, "molecule", [384, 288]);
    let pixels = |is: &dyn Fn(u32) -> bool| {
        let counts = complexity.counts.iter().copied();
        counts
            .filter(|&count| count > 0 && is(count))
            .count()
            .to_string()
    };
    for array in [8, 16, 32, 64_u32] {
        let segment = |count: u32| count.next_power_of_two().max(8) == array;
        assert_eq!(
            row(&drawn.tables[0], &array.to_string()),
            [pixels(&segment)]
        );
    }
    for cells in &drawn.tables[1].rows {
        let number: u32 = cells[0].parse().unwrap();
        assert_eq!(cells[1], pixels(&|count| count.div_ceil(8) == number));
    }
}

/// FFB's bytes are those of the deepest pixel everywhere, and no image differs (L04, L08).
#[test]
fn figure_4_s_fixed_buffers_are_as_deep_as_the_deepest_pixel() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-4");
    let complexity = complexity(&context, "molecule", [624, 468]);
    let rows = &drawn.tables[0].rows;
    assert_eq!(rows.len(), 4);
    assert!(rows.iter().all(|cells| cells[4] == "yes"), "{rows:?}");
    let bytes = 16.0 * f64::from(complexity.max()) * complexity.counts.len() as f64;
    let each = bytes / complexity.fragments() as f64;
    assert_eq!(rows[0][3], format!("{each:.1}"));
}

/// As the prose has it, less light is stopped before the eye leaves the first volume than really is, and then the wrong one.
#[test]
fn the_ray_of_section_6_begins_inside_and_ends_at_what_is_opaque() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-ray");
    let [amended, printed] = [0, 1].map(|table| &drawn.tables[table].rows);
    assert_eq!(
        (amended[0][2].as_str(), printed[0][2].as_str()),
        ("volume 0", "none")
    );
    // Depth 0.88 between the planes at 1 and 6: 6 / (6 - 0.88 x 5).
    let end = 6.0 / (6.0 - 0.88 * 5.0);
    let last = |rows: &Vec<Vec<String>>| numbers(&rows[rows.len() - 1][1])[0];
    // Half of the last digit that is shown.
    assert!((last(amended) - end).abs() <= 5e-4, "{amended:?}");
    assert!(last(printed) > end + 0.1);
}

/// Twice as many slices halve the difference at least, and hybrid layer peeling takes the same iterations for all of them.
#[test]
fn slices_come_nearer_to_rays() {
    let context = Context::headless().unwrap();
    let drawn = quick_figure(&context, "lindholm-fog");
    let table = &drawn.tables[0];
    let iterations: Vec<_> = table.rows.iter().map(|cells| &cells[3]).collect();
    assert!(
        iterations.windows(2).all(|pair| pair[0] == pair[1]),
        "{iterations:?}"
    );
    let rms = &drawn.charts[0].lines[1].points;
    // An error of order 1 in the distance of slices, within a fifth.
    assert!(
        rms.windows(2).all(|pair| pair[1][1] < 0.6 * pair[0][1]),
        "{rms:?}"
    );
}

/// Frame 0 is the measure of all costs, and a bar has no more than all pixels.
#[test]
fn figures_1_and_2_show_the_molecule_as_it_is_counted() {
    let context = Context::headless().unwrap();
    let figure_1 = quick_figure(&context, "lindholm-1");
    assert_eq!(figure_1.pictures.len(), 4);
    let most = numbers(&row(&figure_1.tables[0], "most layers")[1])[0];
    let [(svg, _)] = &figure_1.drawings[..] else {
        panic!("one histogram")
    };
    assert!(svg.contains(&format!("at most {most} layers")), "{most}");
    let figure_2 = quick_figure(&context, "lindholm-2");
    assert_eq!(figure_2.pictures.len(), 4);
    assert!(figure_2.drawings[0].0.contains("list records read"));
}
