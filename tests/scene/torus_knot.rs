//! Torus knots are closed, face outwards, and wind as often as they say.

use std::f64::consts::TAU;

use crate::kit::scene::measure::{edges, euler, unusable, volume, worst_agreement};
use glam::DVec3;
use onionskin::generate::{TorusKnot, torus_knot};

#[test]
fn a_torus_knot_is_closed() {
    let mesh = torus_knot(&TorusKnot::default()).expect("in range");
    assert!(edges(&mesh).into_values().all(|count| count == 2));
    assert_eq!(euler(&mesh), 0);
}

#[test]
fn an_open_tube_is_told_from_a_closed_one() {
    // The control of the test above.
    let mut mesh = torus_knot(&TorusKnot::default()).expect("in range");
    mesh.triangles.pop();
    assert!(edges(&mesh).into_values().any(|count| count == 1));
    assert_ne!(euler(&mesh), 0);
}

#[test]
fn a_plain_torus_has_the_volume_of_one() {
    let torus = TorusKnot {
        p: 1,
        q: 0,
        radius: 1.5,
        winding: 0.5,
        tube: 0.25,
        segments: 1000,
        sides: 1000,
    };
    let exact = TAU * 2.0 * (TAU / 2.0) * 0.25 * 0.25;
    let found = volume(&torus_knot(&torus).expect("in range"));
    // A polygon of n sides has 1 - (2 pi / n)^2 / 6 of its circle's area; here twice, 1.3e-5 less in all.
    assert!((found / exact - 1.0).abs() < 2e-5, "{found} {exact}");
    assert!(found < exact);
}

#[test]
fn a_torus_knots_triangles_and_normals_face_outwards() {
    for (p, q) in [(2, 3), (3, 2), (1, 0), (2, 5), (1, 1)] {
        let mesh = torus_knot(&TorusKnot {
            p,
            q,
            ..TorusKnot::default()
        })
        .expect("in range");
        assert!(volume(&mesh) > 0.0);
        // Sides turn by 15 degrees, segments by up to 10: no corner's normal is further than their sum from its faces'.
        assert!(
            worst_agreement(&mesh) > 25.0_f32.to_radians().cos(),
            "{p} {q}"
        );
    }
}

#[test]
fn a_torus_knots_normals_are_those_of_finite_differences() {
    let (segments, sides) = (2000, 200);
    let knot = TorusKnot {
        segments,
        sides,
        ..TorusKnot::default()
    };
    let mesh = torus_knot(&knot).expect("in range");
    let at = |i: u32, j: u32| {
        let index = (j % segments) * sides + i % sides;
        mesh.vertices[index as usize]
    };
    for (i, j) in [(0, 0), (17, 300), (50, 999), (120, 1500), (199, 1999)] {
        let along_u = at(i + 1, j).position - at(i + sides - 1, j).position;
        let along_v = at(i, j + 1).position - at(i, j + segments - 1).position;
        let differences = along_u.cross(along_v).normalize();
        // Central differences are off by the step squared (0.03 around, 0.006 along, times the curve's speed of 4);
        // positions by 6e-8 of the steps' 0.01.
        let off = (at(i, j).normal.as_dvec3() - differences).length();
        assert!(off < 1e-3, "{off} at {i} {j}");
    }
}

#[test]
fn a_torus_knot_goes_around_its_axis_p_times() {
    for (p, q) in [(2, 3), (3, 5), (5, 1)] {
        let knot = TorusKnot {
            p,
            q,
            sides: 3,
            ..TorusKnot::default()
        };
        let mesh = torus_knot(&knot).expect("in range");
        let along: Vec<DVec3> = mesh
            .vertices
            .iter()
            .step_by(3)
            .map(|v| v.position)
            .collect();
        let turns = (0..along.len()).map(|j| {
            let (from, to) = (along[j], along[(j + 1) % along.len()]);
            from.truncate().angle_to(to.truncate())
        });
        let found = turns.sum::<f64>() / TAU;
        // A sum of 256 angles; anything but a whole number is wrong.
        assert!((found - f64::from(p)).abs() < 1e-3, "{found} {p}");
    }
}

#[test]
fn a_torus_knot_out_of_range_is_refused() {
    let of = |change: fn(&mut TorusKnot)| {
        let mut knot = TorusKnot::default();
        change(&mut knot);
        torus_knot(&knot)
    };
    unusable(of(|k| (k.p, k.q) = (2, 4)), "divisible by 2");
    unusable(of(|k| (k.p, k.q) = (2, 0)), "divisible by 2");
    unusable(of(|k| k.p = 0), "p");
    unusable(of(|k| k.winding = 1.0), "winding");
    unusable(of(|k| k.tube = 0.0), "tube");
    unusable(of(|k| k.segments = 2), "segments");
    unusable(
        of(|k| (k.segments, k.sides) = (u32::MAX, u32::MAX)),
        "triangles",
    );
}
