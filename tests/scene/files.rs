//! The scenes that come with the crate.

use std::path::Path;

use glam::DVec3;
use onionskin::{Mesh, Scene, Shading, Volume};

fn load(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    Scene::load(folder.join(name)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn the_molecule_has_its_five_meshes_with_every_triangle_that_covers_something() {
    let scene = load("molecule.toml");
    let counts: Vec<usize> = scene.meshes.iter().map(|m| m.triangle_count()).collect();
    // `grep -c "^f"` of the five files, which hold triangles only, less those with two corners in one place: 40 and 18
    // of the isosurfaces, whose coordinates were rounded to three digits (counted with numpy).
    assert_eq!(counts, [12816, 3920, 62640 - 40, 33808 - 18, 49472]);
    assert_eq!(scene.notices.len(), 2, "{:?}", scene.notices);
}

/// Loads it and looks at what every bundled scene must be: translucent somewhere, in view, and without notices.
#[track_caller]
fn check(name: &str, meshes: usize) -> Scene {
    let scene = load(name);
    assert_eq!(scene.meshes.len(), meshes);
    assert!(scene.meshes.iter().any(|mesh| !mesh.opaque));
    assert!(scene.camera.check().is_ok());
    assert_eq!(scene.notices, Vec::<String>::new());
    scene
}

#[test]
fn the_teapot_stands_on_its_plane_red_outside_and_green_inside() {
    let scene = check("teapot.toml", 2);
    let [plane, pot] = &scene.meshes[..] else {
        panic!("two meshes")
    };
    let bounds = |mesh: &Mesh| mesh.bounds().expect("vertices");
    assert!(
        bounds(plane).max.y < bounds(pot).min.y,
        "they must not be coplanar"
    );
    assert!(pot.vertices[0].color.r > 0.9 && pot.inside[1] > 0.8);
    assert!(plane.vertices[0].color.b > 0.9 && plane.inside[2] > 0.9);
    assert_eq!(pot.shading, Shading::TwoSided);
}

#[test]
fn the_slices_are_sorted_and_the_cone_is_not() {
    let scene = check("slices.toml", 2);
    assert_eq!(
        [scene.meshes[0].sorted, scene.meshes[1].sorted],
        [true, false]
    );
}

#[test]
fn the_quads_are_six() {
    assert_eq!(check("quads.toml", 1).triangle_count(), 12);
}

#[test]
fn the_knots_go_through_each_other() {
    let scene = check("knots.toml", 3);
    let boxes: Vec<_> = scene.meshes.iter().filter_map(Mesh::bounds).collect();
    for (a, b) in [(0, 1), (1, 2), (2, 0)] {
        let overlap = boxes[a].max.min(boxes[b].max) - boxes[a].min.max(boxes[b].min);
        assert!(overlap.cmpgt(DVec3::ZERO).all());
    }
}

#[test]
fn the_soup_has_a_thousand_triangles() {
    assert_eq!(check("soup.toml", 1).triangle_count(), 1000);
}

#[test]
fn the_molecules_camera_is_the_one_written_down() {
    let camera = load("molecule.toml").camera;
    assert_eq!(
        [camera.fov, camera.near, camera.far],
        [23.5, 95.6533, 166.8219]
    );
}

#[test]
fn the_fog_has_a_vortex_and_a_ring() {
    let scene = check("fog.toml", 1);
    let names: Vec<_> = scene
        .volumes
        .iter()
        .map(|volume| volume.name.as_str())
        .collect();
    assert_eq!(names, ["ball", "swirl"]);
}

/// The two potentials of the molecule, and its two isosurfaces, which are other files: the lobes at +2 and at -2 kT/e.
fn potentials() -> ([Volume; 2], [(Mesh, f64); 2]) {
    let scene = load("molecule_fused.toml");
    let lobes: Vec<Mesh> = scene.meshes[2..4].to_vec();
    let lobes = lobes.try_into().expect("two meshes");
    let [positive, negative]: [Mesh; 2] = lobes;
    let volumes = scene.volumes.try_into().expect("two volumes");
    (volumes, [(positive, 2.0), (negative, -2.0)])
}

/// How far the values at an isosurface's vertices are from the isosurface's own: the median and the most.
fn off(volume: &Volume, mesh: &Mesh, value: f64, moved: DVec3) -> (f64, f64) {
    let at = mesh.vertices.iter().map(|vertex| vertex.position + moved);
    let mut off: Vec<f64> = at
        .filter_map(|point| Some((volume.at(point)? - value).abs()))
        .collect();
    assert!(off.len() > 1000);
    off.sort_by(f64::total_cmp);
    (off[off.len() / 2], off[off.len() - 1])
}

#[test]
fn the_molecules_potential_is_two_where_its_isosurface_is() {
    let ([wide, fine], lobes) = potentials();
    for (mesh, value) in &lobes {
        let (median, most) = off(&fine, mesh, *value, DVec3::ZERO);
        println!("fine at {value}: {median} in the median, {most} at most");
        // The vertices lie on edges of the lattice, where it is linear. Rounding to 1/64 moves a value by 1/128 at most;
        // coordinates of three digits by 0.0005 of the slope along each axis, on edges that cross the value at most 13.8,
        // 11.1 and 12.8 kT/e per angstrom.
        assert!(most < 1.0 / 128.0 + 0.0005 * (13.8 + 11.1 + 12.8), "{most}");
        let (median, _) = off(&fine, mesh, *value, DVec3::X * 0.75);
        assert!(median > 0.1, "a volume one sample off is noticed: {median}");
        let (median, _) = off(&wide, mesh, *value, DVec3::ZERO);
        println!("wide at {value}: {median} in the median");
        // Smoothed, it is flatter, and no bound is known; one of its own samples off is as far as the fine one.
        assert!(median < 0.3, "{median}");
    }
}
