//! Quads, planes, cones and slices are what they say, by closed forms that share no code with them.

use std::f64::consts::TAU;

use crate::kit::scene::measure::{edges, euler, unusable, worst_agreement};
use crate::kit::scene::toml;
use glam::{DVec3, Vec3};
use onionskin::generate::{
    Cone, Plane, Quads, Slices, SubmissionOrder, cone, plane, quads, slices,
};
use onionskin::{Mesh, Shading};

/// The z of each quad in the order of submission.
fn depths(mesh: &Mesh) -> Vec<f64> {
    let firsts = mesh.triangles.chunks(2).map(|pair| pair[0][0]);
    firsts
        .map(|corner| mesh.vertices[corner as usize].position.z)
        .collect()
}

#[test]
fn quads_are_two_triangles_each_and_face_the_viewer() {
    let mesh = quads(&Quads::default()).expect("defaults are in range");
    assert_eq!(mesh.triangle_count(), 16);
    assert_eq!(worst_agreement(&mesh), 1.0);
    assert!(mesh.vertices.iter().all(|v| v.normal == Vec3::Z));
}

#[test]
fn quads_lie_one_spacing_apart() {
    let stack = Quads {
        count: 4,
        spacing: 0.25,
        order: SubmissionOrder::FrontToBack,
        ..Quads::default()
    };
    assert_eq!(
        depths(&quads(&stack).expect("in range")),
        [0.0, -0.25, -0.5, -0.75]
    );
}

#[test]
fn quads_back_to_front_are_the_reverse_of_front_to_back() {
    let front = Quads {
        depths: vec![0.5, 0.25, 0.5, 0.0],
        count: 4,
        order: SubmissionOrder::FrontToBack,
        ..Quads::default()
    };
    let back = Quads {
        order: SubmissionOrder::BackToFront,
        ..front.clone()
    };
    let colors =
        |mesh: Mesh| -> Vec<_> { mesh.vertices.chunks(4).map(|quad| quad[0].color).collect() };
    let front = quads(&front).expect("in range");
    let mut back_colors = colors(quads(&back).expect("in range"));
    back_colors.reverse();
    assert_eq!(depths(&front), [0.0, -0.25, -0.5, -0.5]);
    assert_eq!(colors(front), back_colors);
}

#[test]
fn equal_depths_make_ties_in_the_order_of_the_list() {
    let red_then_blue = Quads {
        count: 2,
        depths: vec![0.5, 0.5],
        colors: vec![[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]],
        order: SubmissionOrder::FrontToBack,
        ..Quads::default()
    };
    let mesh = quads(&red_then_blue).expect("in range");
    assert_eq!(mesh.vertices[0].position.z, mesh.vertices[4].position.z);
    assert_eq!(
        [mesh.vertices[0].color.r, mesh.vertices[4].color.b],
        [1.0, 1.0]
    );
}

#[test]
fn shuffled_quads_are_the_same_quads_and_the_seed_decides_their_order() {
    let shuffled = |seed| {
        let stack = Quads {
            count: 50,
            order: SubmissionOrder::Shuffled,
            seed,
            ..Quads::default()
        };
        depths(&quads(&stack).expect("in range"))
    };
    let (a, b) = (shuffled(1), shuffled(2));
    assert_eq!(a, shuffled(1));
    assert_ne!(a, b);
    let sorted = |mut depths: Vec<f64>| {
        depths.sort_by(f64::total_cmp);
        depths
    };
    assert_eq!(sorted(a), sorted(b));
}

#[test]
fn quads_with_alpha_1_are_opaque() {
    let mesh = |alpha| {
        quads(&Quads {
            alpha,
            ..Quads::default()
        })
        .expect("in range")
    };
    assert!(mesh(1.0).opaque);
    assert!(!mesh(0.5).opaque);
}

#[test]
fn quads_out_of_range_are_refused() {
    let of = |change: fn(&mut Quads)| {
        let mut stack = Quads::default();
        change(&mut stack);
        quads(&stack)
    };
    unusable(of(|q| q.count = 0), "count");
    unusable(of(|q| q.count = 10_000_001), "20000002 triangles");
    unusable(of(|q| q.alpha = f32::NAN), "alpha");
    unusable(of(|q| q.size = [0.0, 1.0]), "size");
    unusable(of(|q| q.spacing = f32::INFINITY), "spacing");
    unusable(of(|q| q.colors = Vec::new()), "colors");
    unusable(of(|q| q.colors = vec![[0.0, 0.0, 1.1]]), "colors");
    unusable(of(|q| q.depths = vec![1.0]), "depths");
    unusable(of(|q| q.depths = vec![f32::NAN; 8]), "depths");
}

#[test]
fn a_scene_files_depths_are_as_many_quads() {
    let scene = toml(
        "[[mesh]]\ngenerate = \"quads\"\ndepths = [0.0, 1.0, 1.0]\norder = \"front-to-back\"\n",
    );
    assert_eq!(depths(&scene.meshes[0]), [0.0, -1.0, -1.0]);
}

#[test]
fn the_plane_has_its_size_and_faces_up() {
    let mesh = plane(&Plane {
        size: [4.0, 6.0],
        cells: 3,
    })
    .expect("in range");
    assert_eq!(mesh.triangle_count(), 18);
    let bounds = mesh.bounds().expect("vertices");
    assert_eq!(bounds.min, DVec3::new(-2.0, 0.0, -3.0));
    assert_eq!(bounds.max, DVec3::new(2.0, 0.0, 3.0));
    assert_eq!(worst_agreement(&mesh), 1.0);
    assert!(mesh.vertices.iter().all(|v| v.normal == Vec3::Y));
}

#[test]
fn the_plane_is_white_and_opaque_until_it_is_painted() {
    let mesh = plane(&Plane::default()).expect("in range");
    assert!(mesh.opaque);
    assert_eq!(mesh.inside, [1.0; 3]);
    let painted = mesh.painted([1.0, 0.0, 0.0, 0.5].into());
    assert!(!painted.opaque);
    assert_eq!(painted.inside, [1.0, 0.0, 0.0]);
    assert_eq!(painted.shading, Shading::None);
}

#[test]
fn a_cone_to_a_point_has_one_triangle_per_side() {
    let mesh = cone(&Cone {
        sides: 12,
        ..Cone::default()
    })
    .expect("in range");
    assert_eq!(mesh.triangle_count(), 12);
    let upside_down = cone(&Cone {
        bottom: 0.0,
        top: 1.0,
        sides: 12,
        ..Cone::default()
    });
    assert_eq!(upside_down.expect("in range").triangle_count(), 12);
}

#[test]
fn a_cone_cut_off_has_two_triangles_per_side_and_two_rims() {
    let mesh = cone(&Cone {
        top: 0.5,
        sides: 12,
        ..Cone::default()
    })
    .expect("in range");
    assert_eq!(mesh.triangle_count(), 24);
    let rims = edges(&mesh)
        .into_values()
        .filter(|&count| count == 1)
        .count();
    assert_eq!(rims, 24);
    assert_eq!(euler(&mesh), 0, "a tube");
}

#[test]
fn a_cones_area_is_that_of_its_side() {
    let mesh = cone(&Cone {
        bottom: 1.0,
        top: 0.0,
        height: 2.0,
        sides: 2000,
    })
    .expect("in range");
    let area: f64 = (0..mesh.triangle_count())
        .map(|i| {
            let [a, b, c] = mesh.corners(i).map(|corner| corner.position);
            (b - a).cross(c - a).length() / 2.0
        })
        .sum();
    let exact = TAU / 2.0 * 5.0_f64.sqrt();
    // The chord of an angle a is shorter than its arc by a^2 / 24, here 4e-7; the triangles' heights by less.
    assert!((area / exact - 1.0).abs() < 2e-6);
}

#[test]
fn a_cone_faces_outwards() {
    let mesh = cone(&Cone {
        top: 0.3,
        sides: 64,
        ..Cone::default()
    })
    .expect("in range");
    for vertex in &mesh.vertices {
        assert!(
            vertex
                .normal
                .dot(vertex.position.as_vec3() * Vec3::new(1.0, 0.0, 1.0))
                > 0.0
        );
    }
    // Normals turn by 360/64 degrees from side to side.
    assert!(worst_agreement(&mesh) > (TAU / 64.0).cos() as f32);
}

#[test]
fn a_cone_out_of_range_is_refused() {
    let of = |change: fn(&mut Cone)| {
        let mut shell = Cone::default();
        change(&mut shell);
        cone(&shell)
    };
    unusable(of(|c| c.bottom = 0.0), "both 0");
    unusable(of(|c| c.sides = 2), "sides");
    unusable(of(|c| c.sides = u32::MAX), "triangles");
    unusable(of(|c| c.height = -1.0), "height");
    unusable(of(|c| c.top = f32::NAN), "top");
}

#[test]
fn slices_fill_their_cube_evenly() {
    let mesh = slices(&Slices {
        count: 5,
        size: 4.0,
        cells: 2,
        ..Slices::default()
    })
    .expect("in range");
    assert_eq!(mesh.triangle_count(), 5 * 8);
    let z: Vec<f64> = mesh
        .vertices
        .chunks(9)
        .map(|slice| slice[0].position.z)
        .collect();
    assert_eq!(z, [-2.0, -1.0, 0.0, 1.0, 2.0]);
    assert_eq!(mesh.bounds().expect("vertices").size(), DVec3::splat(4.0));
}

#[test]
fn the_cloud_is_dense_inside_and_nothing_at_the_sides() {
    let mesh = slices(&Slices {
        alpha: 0.5,
        ..Slices::default()
    })
    .expect("in range");
    let alphas = mesh.vertices.iter().map(|v| v.color.a);
    let densest = alphas.fold(0.0, f32::max);
    assert!(densest > 0.4 && densest <= 0.5, "{densest}");
    let at_a_side = mesh
        .vertices
        .iter()
        .filter(|v| v.position.abs().max_element() >= 1.0);
    assert!(at_a_side.clone().count() > 1000);
    assert!(at_a_side.into_iter().all(|v| v.color.a == 0.0));
}

#[test]
fn the_cloud_is_smooth() {
    // From one vertex of a slice to the next, a twentieth of the cube, the density changes by less than its slope
    // allows: no ball is steeper than sqrt(2 rate / e) = 3, and the window no steeper than 2.
    let mesh = slices(&Slices {
        count: 9,
        cells: 40,
        alpha: 1.0,
        ..Slices::default()
    })
    .expect("in range");
    for row in mesh.vertices.chunks(41) {
        for pair in row.windows(2) {
            assert!((pair[0].color.a - pair[1].color.a).abs() < 5.0 / 20.0);
        }
    }
}

#[test]
fn slices_out_of_range_are_refused() {
    let of = |change: fn(&mut Slices)| {
        let mut stack = Slices::default();
        change(&mut stack);
        slices(&stack)
    };
    unusable(of(|s| s.count = 0), "count");
    unusable(of(|s| s.count = u32::MAX), "triangles");
    unusable(of(|s| s.cells = u32::MAX), "cells");
    unusable(of(|s| s.alpha = 1.5), "alpha");
    unusable(of(|s| s.size = 0.0), "size");
}
