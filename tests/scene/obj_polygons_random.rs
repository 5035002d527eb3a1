//! Random polygons of OBJ models, against the even-odd rule.

use super::obj_polygons::{check, flat, is_near, is_within, model, triangles};
use crate::kit::scene::{obj, obj_mesh};
use glam::{DMat3, DVec2, DVec3};
use proptest::prelude::*;

/// Corners around the origin at growing angles: seen from there each is visible.
fn star() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec(0.1..1.0_f64, 4..40).prop_map(|radii| {
        let step = std::f64::consts::TAU / radii.len() as f64;
        let corner = |(i, &radius): (usize, &f64)| DVec2::from_angle(step * i as f64) * radius;
        radii.iter().enumerate().map(corner).collect()
    })
}

/// Teeth of random heights on a bar, some with a corner in the middle of a side.
fn comb() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((0.2..3.0_f64, any::<bool>()), 2..20).prop_map(|teeth| {
        let mut corners = Vec::new();
        for (i, &(height, extra)) in teeth.iter().enumerate() {
            let x = i as f64;
            corners.extend([DVec2::new(x, 0.0), DVec2::new(x + 0.25, height)]);
            if extra {
                corners.push(DVec2::new(x + 0.5, height));
            }
            corners.extend([DVec2::new(x + 0.75, height), DVec2::new(x + 1.0, 0.0)]);
        }
        corners.extend([DVec2::new(teeth.len() as f64, -1.0), DVec2::new(0.0, -1.0)]);
        corners.reverse();
        corners
    })
}

/// A band wound around itself.
fn spiral() -> impl Strategy<Value = Vec<DVec2>> {
    (8..60_u32, 0.3..0.9_f64).prop_map(|(count, width)| {
        let place = |i: u32, out: f64| {
            let angle = f64::from(i) * 0.45;
            DVec2::from_angle(angle) * (1.0 + angle / std::f64::consts::TAU + out)
        };
        let outside = (0..count).map(|i| place(i, width));
        outside
            .chain((0..count).rev().map(|i| place(i, 0.0)))
            .collect()
    })
}

/// A square with square holes side by side, each at the end of a bridge.
fn holes() -> impl Strategy<Value = Vec<DVec2>> {
    prop::collection::vec((0.1..0.4_f64, any::<bool>()), 1..6).prop_map(|holes| {
        let width = holes.len() as f64;
        let mut corners = vec![DVec2::ZERO];
        for (i, &(size, same)) in holes.iter().enumerate() {
            let middle = DVec2::new(i as f64 + 0.5, 0.5);
            let foot = DVec2::new(middle.x - size, 0.0);
            let mut hole = [
                (-1.0, -1.0),
                (-1.0, 1.0),
                (1.0, 1.0),
                (1.0, -1.0),
                (-1.0, -1.0),
            ]
            .map(|corner| middle + DVec2::from(corner) * size);
            if same {
                hole.reverse();
            }
            corners.push(foot);
            corners.extend(hole);
            corners.push(foot);
        }
        corners.extend([
            DVec2::new(width, 0.0),
            DVec2::new(width, 1.0),
            DVec2::new(0.0, 1.0),
        ]);
        corners
    })
}

/// Any corners of a coarse grid: they coincide, touch and cross at will.
fn scribble() -> impl Strategy<Value = Vec<DVec2>> {
    let corner = (0..5_u8, 0..5_u8).prop_map(|(x, y)| DVec2::new(x.into(), y.into()));
    prop::collection::vec(corner, 4..12)
}

/// Any corners at all.
fn tangle() -> impl Strategy<Value = Vec<DVec2>> {
    let corner = (-1.0..1.0_f64, -1.0..1.0_f64).prop_map(DVec2::from);
    prop::collection::vec(corner, 4..10)
}

/// The triangles of a polygon, turned in space, back on its plane.
fn turned(outline: &[DVec2], axis: DVec3, angle: f64) -> Vec<[DVec2; 3]> {
    let turn = DMat3::from_axis_angle(axis.normalize(), angle);
    let corners: Vec<DVec3> = outline
        .iter()
        .map(|corner| turn * corner.extend(0.0))
        .collect();
    let scene = obj(model(&corners));
    let back = |corner: onionskin::Vertex| (turn.transpose() * corner.position).truncate();
    let meshes = scene.meshes.iter();
    let corners =
        meshes.flat_map(|mesh| (0..mesh.triangle_count()).map(|i| mesh.corners(i).map(back)));
    corners.collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn simple_polygons_are_covered_once(outline in prop_oneof![star(), comb(), spiral(), holes()]) {
        check(&outline, &triangles(&obj_mesh(model(&flat(&outline)))))?;
    }

    #[test]
    fn polygons_in_space_are_covered_once(
        outline in prop_oneof![star(), comb(), spiral(), holes()],
        axis in (-1.0..1.0_f64, -1.0..1.0_f64, 0.1..1.0_f64),
        angle in 0.0..6.0_f64,
    ) {
        check(&outline, &turned(&outline, axis.into(), angle))?;
    }

    #[test]
    fn any_polygon_is_covered_by_the_even_odd_rule(outline in prop_oneof![scribble(), tangle()]) {
        let covered: Vec<[DVec2; 3]> = obj(model(&flat(&outline))).meshes.iter().flat_map(triangles).collect();
        let grid = |i: i32| -2.0 + f64::from(i) * 0.0803;
        let grid = (0..90 * 90).map(|i| DVec2::new(grid(i % 90), grid(i / 90)));
        // An outline that is run along twice encloses nothing by the rule, and is drawn once all the same.
        let mut grid = grid.filter(|&point| !is_near(&outline, &[], point));
        if grid.any(|point| is_within(&outline, point)) {
            check(&outline, &covered)?;
        }
    }

    #[test]
    fn polygons_that_are_not_flat_are_covered_once_as_seen(
        outline in star(),
        heights in prop::collection::vec(-0.05..0.05_f64, 40),
    ) {
        let corners: Vec<DVec3> = outline.iter().zip(heights).map(|(corner, z)| corner.extend(z)).collect();
        check(&outline, &triangles(&obj_mesh(model(&corners))))?;
    }
}
