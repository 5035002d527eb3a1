//! Polygons of OBJ models: triangles cover what lies within by the even-odd rule, once. The rule is applied to the
//! polygon here without any triangulation.

use std::fmt::Write;

use crate::kit::scene::{obj, obj_mesh};
use glam::{DVec2, DVec3};
use onionskin::Mesh;
use proptest::prelude::*;

/// A model of one polygon.
pub(super) fn model(corners: &[DVec3]) -> String {
    let mut model = String::new();
    for corner in corners {
        writeln!(model, "v {} {} {}", corner.x, corner.y, corner.z).expect("a string");
    }
    let indices: Vec<String> = (1..=corners.len()).map(|i| i.to_string()).collect();
    writeln!(model, "f {}", indices.join(" ")).expect("a string");
    model
}

pub(super) fn flat(corners: &[DVec2]) -> Vec<DVec3> {
    corners.iter().map(|corner| corner.extend(0.0)).collect()
}

/// Whether a ray to the right crosses the outline an odd number of times.
pub(super) fn is_within(outline: &[DVec2], point: DVec2) -> bool {
    let mut within = false;
    for (i, &a) in outline.iter().enumerate() {
        let b = outline[(i + 1) % outline.len()];
        if (a.y > point.y) != (b.y > point.y) {
            let x = a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
            within ^= x > point.x;
        }
    }
    within
}

/// The triangles on the xy plane.
pub(super) fn triangles(mesh: &Mesh) -> Vec<[DVec2; 3]> {
    let corners = |i| mesh.corners(i).map(|corner| corner.position.truncate());
    (0..mesh.triangle_count()).map(corners).collect()
}

/// How many triangles have the point inside.
fn layers(triangles: &[[DVec2; 3]], point: DVec2) -> usize {
    let has = |&&[a, b, c]: &&[DVec2; 3]| {
        let edges = [(a, b), (b, c), (c, a)];
        let sides = edges.map(|(from, to)| (to - from).perp_dot(point - from));
        sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0)
    };
    triangles.iter().filter(has).count()
}

/// Whether rounding decides on which side of an edge the point lies: positions of about 10 are kept in 32 bits, 6e-7
/// each.
pub(super) fn is_near(outline: &[DVec2], triangles: &[[DVec2; 3]], point: DVec2) -> bool {
    let near = |from: DVec2, to: DVec2| {
        let along = to - from;
        let at = (point - from).dot(along) / along.length_squared().max(f64::MIN_POSITIVE);
        point.distance(from + along * at.clamp(0.0, 1.0)) < 1e-5
    };
    let around = |corners: &[DVec2]| {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).any(|(&from, &to)| near(from, to))
    };
    around(outline) || triangles.iter().any(|triangle| around(triangle))
}

/// Whether each point of a grid is covered once if it lies within the outline, and else not at all.
pub(super) fn check(outline: &[DVec2], triangles: &[[DVec2; 3]]) -> Result<(), TestCaseError> {
    const SIDE: u32 = 60;
    let low = outline.iter().copied().reduce(DVec2::min).expect("corners");
    let high = outline.iter().copied().reduce(DVec2::max).expect("corners");
    for i in 0..SIDE * SIDE {
        // Nowhere near round numbers, on which corners lie.
        let at = DVec2::new(f64::from(i % SIDE) + 0.513, f64::from(i / SIDE) + 0.487);
        let point = low + (high - low) * at / f64::from(SIDE);
        if !is_near(outline, triangles, point) {
            let within = is_within(outline, point);
            let layers = layers(triangles, point);
            prop_assert_eq!(layers, usize::from(within), "at {} of {:?}", point, outline);
        }
    }
    Ok(())
}

/// The area by the triangles, each counted as positive.
fn area(triangles: &[[DVec2; 3]]) -> f64 {
    let areas = triangles
        .iter()
        .map(|[a, b, c]| (*b - *a).perp_dot(*c - *a).abs() / 2.0);
    areas.sum()
}

fn covered(corners: &[(f64, f64)]) -> Vec<[DVec2; 3]> {
    let corners: Vec<DVec2> = corners.iter().map(|&corner| corner.into()).collect();
    let covered = triangles(&obj_mesh(model(&flat(&corners))));
    check(&corners, &covered).expect("covered once");
    covered
}

#[test]
fn a_polygon_that_is_covered_wrongly_would_be_noticed() {
    let chevron = [(-1.0, -1.0), (0.0, -0.2), (1.0, -1.0), (0.0, 1.0)].map(DVec2::from);
    let [a, b, c, d] = chevron;
    assert!(check(&chevron, &[[a, b, c], [a, c, d]]).is_err());
    assert!(check(&chevron, &[[a, b, d]]).is_err());
    assert!(check(&chevron, &[[a, b, d], [b, c, d]]).is_ok());
    assert!(check(&chevron, &[[a, b, d], [b, c, d], [b, c, d]]).is_err());
}

#[test]
fn concave_polygons_are_covered_once() {
    let chevron = covered(&[(-1.0, -1.0), (0.0, -0.2), (1.0, -1.0), (0.0, 1.0)]);
    assert_eq!(chevron.len(), 2);
    let u = [
        (-1.0, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (0.5, 1.0),
        (0.5, -0.5),
        (-0.5, -0.5),
        (-0.5, 1.0),
        (-1.0, 1.0),
    ];
    assert_eq!(area(&covered(&u)), 2.5);
    // The same from behind.
    let mut behind = u;
    behind.reverse();
    let back = covered(&behind);
    assert!(
        back.iter()
            .all(|[a, b, c]| (*b - *a).perp_dot(*c - *a) < 0.0)
    );
}

#[test]
fn convex_polygons_stay_fans() {
    let pentagon = covered(&[(0.0, 0.0), (2.0, 0.0), (3.0, 1.0), (2.0, 2.0), (0.0, 2.0)]);
    assert!(pentagon.iter().all(|[first, ..]| *first == DVec2::ZERO));
    assert_eq!(pentagon.len(), 3);
}

#[test]
fn a_bridge_leads_to_a_hole() {
    let corners =
        "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -.5 -.5 0\nv -.5 .5 0\nv .5 .5 0\nv .5 -.5 0\n";
    let by_index = obj_mesh(format!("{corners}f 1 2 3 4 1 5 6 7 8 5\n"));
    assert_eq!(area(&triangles(&by_index)), 3.0);
    assert_eq!(by_index.vertices.len(), 8);
    let ring = [
        (-1.0, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (-1.0, 1.0),
        (-1.0, -1.0),
        (-0.5, -0.5),
        (-0.5, 0.5),
        (0.5, 0.5),
        (0.5, -0.5),
        (-0.5, -0.5),
    ];
    assert_eq!(area(&covered(&ring)), 3.0);
    // A hole that runs the same way around as the rim.
    let same = [
        (-1.0, -1.0),
        (1.0, -1.0),
        (1.0, 1.0),
        (-1.0, 1.0),
        (-1.0, -1.0),
        (-0.5, -0.5),
        (0.5, -0.5),
        (0.5, 0.5),
        (-0.5, 0.5),
        (-0.5, -0.5),
    ];
    assert_eq!(area(&covered(&same)), 3.0);
}

#[test]
fn corners_on_a_line_and_repeated_ones_do_no_harm() {
    let scene = obj(model(&flat(
        &[
            (0.0, 0.0),
            (1.0, 0.0),
            (2.0, 0.0),
            (2.0, 2.0),
            (1.0, 0.5),
            (1.0, 0.5),
            (0.0, 2.0),
            (0.0, 1.0),
        ]
        .map(DVec2::from),
    )));
    assert_eq!(area(&triangles(&scene.meshes[0])), 2.5);
    // A neighbour may have a corner there, so that it has to stay one.
    let corner = |at: (f64, f64)| {
        scene.meshes[0]
            .vertices
            .iter()
            .any(|v| v.position.truncate().to_array() == [at.0, at.1])
    };
    assert!([(1.0, 0.0), (0.0, 1.0)].into_iter().all(corner));
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
    assert_eq!(
        covered(&[(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (1.0, 1.0)]).len(),
        1
    );
}

#[test]
fn polygons_may_touch_themselves() {
    // A corner on an edge; two corners at one place; an edge that is run along in part again.
    covered(&[(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (2.0, 0.0), (0.0, 2.0)]);
    covered(&[
        (0.0, 0.0),
        (2.0, 1.0),
        (4.0, 0.0),
        (4.0, 2.0),
        (2.0, 1.0),
        (0.0, 2.0),
    ]);
    covered(&[
        (0.0, 0.0),
        (4.0, 0.0),
        (4.0, 4.0),
        (4.0, 1.0),
        (3.0, 1.0),
        (3.0, 3.0),
        (4.0, 3.0),
        (0.0, 4.0),
    ]);
    // There and back again.
    covered(&[
        (0.0, 0.0),
        (2.0, 0.0),
        (2.0, 2.0),
        (3.0, 3.0),
        (2.0, 2.0),
        (0.0, 2.0),
    ]);
}

#[test]
fn edges_that_cross_are_said() {
    let bow = [(0.0, 0.0), (2.0, 2.0), (2.0, 0.0), (0.0, 2.0)];
    let scene = obj(model(&flat(&bow.map(DVec2::from))));
    assert!(
        scene.notices[0].contains("1 polygon has edges that cross"),
        "{:?}",
        scene.notices
    );
    assert_eq!(area(&covered(&bow)), 2.0);
    // A star in one line, whose middle is outside by the rule.
    let star: Vec<(f64, f64)> = (0..5)
        .map(|i| (f64::from(i * 2) * std::f64::consts::TAU / 5.0).sin_cos())
        .collect();
    assert_eq!(covered(&star).len(), 5);
}

#[test]
fn a_crossing_has_the_colour_and_the_place_between() {
    let mesh = obj_mesh("v 0 0 0 1 0 0\nv 2 2 2 0 0 1\nv 2 0 1 0 1 0\nv 0 2 1 0 1 0\nf 1 2 3 4\n");
    let crossing = mesh
        .vertices
        .iter()
        .find(|v| v.position.truncate() == DVec2::ONE);
    let crossing = crossing.expect("a vertex where the edges cross");
    assert_eq!(crossing.position.z, 1.0);
    let expected = [[0.5, 0.0, 0.5, 1.0], [0.0, 1.0, 0.0, 1.0]];
    assert!(
        expected.contains(&crossing.color.to_array()),
        "{:?}",
        crossing.color
    );
}

#[test]
fn polygons_that_enclose_nothing_are_skipped_and_said() {
    let scene = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 2\nf 1 2 3\n");
    assert_eq!(scene.triangle_count(), 1);
    assert!(
        scene.notices[0].contains("1 polygon enclosing nothing"),
        "{:?}",
        scene.notices
    );
    // Twice around is not nothing.
    assert_eq!(area(&covered_plainly("f 1 2 3 4 1 2 3 4")), 1.0);
    assert_eq!(covered_plainly("f 1 1 1 1 1").len(), 0);
}

fn covered_plainly(face: &str) -> Vec<[DVec2; 3]> {
    let scene = obj(format!("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n{face}\n"));
    scene.meshes.iter().flat_map(triangles).collect()
}

#[test]
fn a_polygon_with_a_million_crossings_ends() {
    // Each of 2001 edges crosses all others.
    let star: Vec<DVec2> = (0..2001)
        .map(|i| {
            (f64::from(i * 1000) * std::f64::consts::TAU / 2001.0)
                .sin_cos()
                .into()
        })
        .collect();
    let scene = obj(model(&flat(&star)));
    assert!(
        scene.notices[0].contains("run over each other too often"),
        "{:?}",
        scene.notices
    );
}

/// How many triangles a polygon has, and that nothing had to be said.
fn count(corners: Vec<DVec2>) -> usize {
    let scene = obj(model(&flat(&corners)));
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
    scene.triangle_count()
}

#[test]
fn long_rows_of_corners_on_a_line_take_no_longer_than_others() {
    // Each would take minutes if every corner changed what the others have.
    const SIDE: usize = 15_000;
    let at = |i: usize| i as f64 / SIDE as f64;
    let base = || (0..SIDE).map(|i| DVec2::new(at(i), 0.0));
    let top = |height: fn(usize) -> f64| (0..SIDE).map(move |i| DVec2::new(1.0 - at(i), height(i)));
    assert_eq!(
        count(
            base()
                .chain([DVec2::ONE, DVec2::new(0.5, 0.1), DVec2::Y])
                .collect()
        ),
        SIDE + 1
    );
    assert_eq!(count(base().chain(top(|_| 1e-3)).collect()), 2 * SIDE - 2);
    assert_eq!(
        count(
            base()
                .chain(top(|i| if i % 2 == 0 { 0.2 } else { 0.1 }))
                .collect()
        ),
        2 * SIDE - 2
    );
}

#[test]
fn a_polygon_that_runs_over_itself_again_and_again_ends() {
    // Rounding puts the corners beside the lines on which they lie, and the long edges run along them.
    let corners = [DVec2::ZERO, DVec2::X, DVec2::new(0.4, 0.3), DVec2::ZERO];
    let row = |from: usize| {
        (0..8000).map(move |i| corners[from].lerp(corners[from + 1], f64::from(i) / 8000.0))
    };
    let outline: Vec<DVec2> = (0..9).flat_map(|i| row(i % 3).step_by(1 + i / 3)).collect();
    let scene = obj(model(&flat(&outline)));
    assert!(
        scene.notices[0].contains("run over each other too often"),
        "{:?}",
        scene.notices
    );
    let stride: Vec<DVec2> = (0..60_000)
        .map(|i| DVec2::new(f64::from(i * 7919 % 60_000), f64::from(i % 9000 / 8999)))
        .collect();
    assert!(obj(model(&flat(&stride))).triangle_count() > 0);
}
