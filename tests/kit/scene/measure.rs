//! Measures of meshes that share no code with what makes them.

use std::collections::{BTreeSet, HashMap};

use onionskin::{Error, Mesh};

/// How many triangles each edge between two places belongs to.
pub fn edges(mesh: &Mesh) -> HashMap<[u32; 2], usize> {
    let mut edges = HashMap::new();
    for &[a, b, c] in &mesh.triangles {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            *edges.entry([from.min(to), from.max(to)]).or_insert(0) += 1;
        }
    }
    edges
}

/// Vertices less edges plus triangles.
pub fn euler(mesh: &Mesh) -> i64 {
    let used: BTreeSet<u32> = mesh.triangles.iter().flatten().copied().collect();
    used.len() as i64 - edges(mesh).len() as i64 + mesh.triangle_count() as i64
}

/// The volume that a closed surface encloses; positive if its triangles face outwards.
pub fn volume(mesh: &Mesh) -> f64 {
    let sixfold = (0..mesh.triangle_count()).map(|i| {
        let [a, b, c] = mesh.corners(i).map(|corner| corner.position);
        a.dot(b.cross(c))
    });
    sixfold.sum::<f64>() / 6.0
}

/// The smallest cosine between a triangle's own normal and those of its corners.
pub fn worst_agreement(mesh: &Mesh) -> f32 {
    let cosines = (0..mesh.triangle_count()).flat_map(|i| {
        let corners = mesh.corners(i);
        let [a, b, c] = corners.map(|corner| corner.position);
        let across = (b - a).cross(c - a).normalize();
        corners.map(|corner| corner.normal.dot(across.as_vec3()))
    });
    cosines.fold(f32::INFINITY, f32::min)
}

/// The error of a generator, which must be one of the scene and say this.
#[track_caller]
pub fn unusable(result: Result<Mesh, Error>, part: &str) {
    match result {
        Err(Error::Scene { what, .. }) => assert!(what.contains(part), "{what}"),
        other => panic!("{other:?}"),
    }
}
