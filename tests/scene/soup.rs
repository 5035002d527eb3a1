//! Random triangles: the same ones for a seed for ever; and what can be done with the triangles of any mesh.

use crate::kit::scene::measure::unusable;
use glam::DVec3;
use onionskin::generate::{MAX_TRIANGLES, Soup, TorusKnot, soup, torus_knot};

/// The corners of seed 42's first triangle, as bits.
const FIRST_SOUP: [[u32; 3]; 3] = [
    [1053177995, 1038722664, 1058320396],
    [1049011578, 1042949948, 1060236460],
    [1037805120, 3194865064, 1059844550],
];

#[test]
fn a_soup_stays_in_its_pot() {
    let mesh = soup(&Soup {
        extent: 2.0,
        triangle_size: [0.5, 1.0],
        alpha: [0.25, 0.5],
        ..Soup::default()
    });
    let mesh = mesh.expect("in range");
    assert_eq!(mesh.triangle_count(), 1000);
    for vertex in &mesh.vertices {
        assert!(vertex.position.abs().max_element() <= 2.5);
        assert!((0.25..=0.5).contains(&vertex.color.a));
        assert!(vertex.normal.is_normalized());
    }
}

#[test]
fn a_soups_triangles_are_no_larger_than_asked_for() {
    let mesh = soup(&Soup {
        triangle_size: [0.1, 0.2],
        ..Soup::default()
    })
    .expect("in range");
    for i in 0..mesh.triangle_count() {
        let [a, b, c] = mesh.corners(i).map(|corner| corner.position);
        let size = (a.max(b).max(c) - a.min(b).min(c)).max_element();
        // Positions near 1 are rounded to 6e-8.
        assert!(size <= 0.2 + 2e-7, "{size}");
    }
}

#[test]
fn a_soup_is_the_same_for_ever() {
    let mesh = soup(&Soup {
        count: 1,
        seed: 42,
        ..Soup::default()
    })
    .expect("in range");
    let [a, b, c] = mesh.corners(0);
    let bits = |v: DVec3| v.as_vec3().to_array().map(f32::to_bits);
    // From pcg32's published first output for this seed, 0xa15c02b7: the top 24 bits, 0xa15c02, over 2^24.
    let first = 0xa15c02 as f32 / (1 << 24) as f32;
    let middle = (a.position + b.position + c.position) / 3.0;
    assert!((middle.x - f64::from(2.0 * first - 1.0)).abs() <= 0.4);
    // What it was when this was written; a picture made from a seed may never change.
    assert_eq!(
        [bits(a.position), bits(b.position), bits(c.position)],
        FIRST_SOUP,
        "{a:?} {b:?} {c:?}"
    );
}

#[test]
fn a_larger_soup_starts_with_the_smaller_one() {
    let of = |count| {
        soup(&Soup {
            count,
            ..Soup::default()
        })
        .expect("in range")
        .vertices
    };
    assert_eq!(of(10), of(100)[..30]);
}

#[test]
fn seeds_make_different_soups() {
    let of = |seed| {
        soup(&Soup {
            seed,
            ..Soup::default()
        })
        .expect("in range")
        .vertices
    };
    assert_ne!(of(1), of(2));
    assert_eq!(of(1), of(1));
}

#[test]
fn a_soup_out_of_range_is_refused() {
    let of = |change: fn(&mut Soup)| {
        let mut pot = Soup::default();
        change(&mut pot);
        soup(&pot)
    };
    unusable(of(|s| s.count = 0), "count");
    unusable(of(|s| s.count = MAX_TRIANGLES as u32 + 1), "triangles");
    unusable(of(|s| s.triangle_size = [0.5, 0.25]), "starts at 0.5");
    unusable(of(|s| s.alpha = [0.0, 2.0]), "alpha");
    unusable(of(|s| s.extent = f32::NAN), "extent");
}

#[test]
fn face_normals_unshare_vertices_and_keep_triangles() {
    let mesh = torus_knot(&TorusKnot::default()).expect("in range");
    let flat = mesh.with_face_normals();
    assert_eq!(flat.vertices.len(), 3 * mesh.triangle_count());
    for i in 0..mesh.triangle_count() {
        let (before, after) = (mesh.corners(i), flat.corners(i));
        assert_eq!(before.map(|c| c.position), after.map(|c| c.position));
        assert_eq!(before.map(|c| c.color), after.map(|c| c.color));
        assert_eq!(after[0].normal, after[1].normal);
        let [a, b, c] = after.map(|corner| corner.position);
        let across = (b - a).cross(c - a).normalize().as_vec3();
        assert_eq!(after[0].normal, across);
    }
}

#[test]
fn shuffling_changes_the_order_of_triangles_and_nothing_else() {
    let mesh = soup(&Soup::default()).expect("in range");
    let shuffled = mesh.shuffled(7);
    assert_eq!(shuffled.vertices, mesh.vertices);
    assert_ne!(shuffled.triangles, mesh.triangles);
    assert_eq!(shuffled.triangles, mesh.shuffled(7).triangles);
    assert_ne!(shuffled.triangles, mesh.shuffled(8).triangles);
    let sorted = |mut triangles: Vec<[u32; 3]>| {
        triangles.sort_unstable();
        triangles
    };
    assert_eq!(sorted(shuffled.triangles), sorted(mesh.triangles));
}
