//! Table 1: iterations and geometry passes of coherent layer peeling and of layer peeling, on the meshes at hand.

use crate::error::Result;
use crate::low_level::edition::figures::plots::times_taken_on;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::{Method, Stats, Variant};
use crate::scene::generate::{Teapot, TorusKnot, teapot, torus_knot};
use crate::scene::{Camera, Mesh, Scene};

pub(super) const FIGURE: Figure = Figure {
    key: "carr-table-1",
    source: "Carr et al. 2008, table 1",
    title: "Coherent layer peeling and layer peeling, mesh by mesh",
    make,
};

/// "These typically represented the range in performance": the directions from which a mesh is seen.
pub const VIEWS: [(&str, [f64; 3]); 3] = [
    ("front", [0.0, 0.0, 1.0]),
    ("side", [1.0, 0.0, 0.0]),
    ("top", [0.0, 1.0, 0.02]),
];

/// The width and height of the images that are counted. Iterations depend on them a little: a larger image has deeper pixels.
pub const SIZE: [u32; 2] = [96, 72];
/// The meshes of the quick edition.
const FEW: [&str; 3] = ["teapot", "torus knot", "ribbon"];

/// The paper's rows: faces, iterations of coherent layer peeling and of layer peeling, and frames per second of A, of B and of
/// layer peeling.
const PAPER: [(&str, &str, [u32; 2], [f64; 3]); 9] = [
    ("engine", "133K", [7, 22], [22.0, 23.0, 21.0]),
    ("dragon, front", "150K", [3, 14], [51.0, 53.0, 35.0]),
    ("dragon, side", "150K", [3, 14], [51.0, 53.0, 35.0]),
    ("Lucy, end on", "250K", [3, 22], [37.0, 41.0, 15.0]),
    ("Lucy, front", "250K", [3, 12], [36.0, 40.0, 27.0]),
    ("Sponza, end on", "66K", [3, 26], [36.0, 40.0, 12.0]),
    ("Sponza, front", "66K", [3, 16], [56.0, 50.0, 35.0]),
    ("car, front", "730K", [11, 36], [0.28, 0.34, 0.27]),
    ("Siebel Center, front", "357K", [20, 50], [0.71, 0.83, 0.86]),
];

/// Meshes that are made, and those of the bundled scene `molecule`, each with its name and semi-transparent.
///
/// # Errors
/// None but a fault of the generators.
pub fn models(molecule: &Scene) -> Result<Vec<(String, Mesh)>> {
    let mut models = vec![
        ("teapot".to_owned(), teapot(&Teapot::default())?),
        ("torus knot".to_owned(), torus_knot(&TorusKnot::default())?),
    ];
    let names = ["ligand", "ribbon", "potential +", "potential -", "surface"];
    let meshes = molecule.meshes.iter().cloned();
    models.extend(names.map(String::from).into_iter().zip(meshes));
    for (_, mesh) in &mut models {
        mesh.vertices
            .iter_mut()
            .for_each(|vertex| vertex.color.a = 0.4);
        mesh.opaque = false;
    }
    Ok(models)
}

/// The whole mesh, from this direction.
pub fn seen_from(mesh: &Mesh, direction: [f64; 3], size: [u32; 2]) -> Scene {
    let mut scene = Scene::of("model", vec![mesh.clone()]);
    scene.size = size;
    if let Some(bounds) = scene.bounds() {
        let far = (bounds.max - bounds.min).length() * 1.6;
        let eye = bounds.centre() + glam::DVec3::from(direction).normalize() * far;
        scene.camera = Camera::looking(eye, bounds.centre());
    }
    scene
}

/// Coherent layer peeling A and B, and layer peeling.
pub fn methods() -> [Method; 3] {
    [
        Method::CoherentLayerPeeling(Variant::A.into()),
        Method::CoherentLayerPeeling(Variant::B.into()),
        Method::LayerPeeling(Default::default()),
    ]
}

fn make(studio: &Studio) -> Result<Drawn> {
    let mut rows = Vec::new();
    for (name, mesh) in models(&studio.scene("molecule", SIZE)?)? {
        if studio.quick && !FEW.contains(&name.as_str()) {
            continue;
        }
        for (view, direction) in VIEWS {
            let scene = seen_from(&mesh, direction, SIZE);
            let mut renderer = studio.renderer(&scene)?;
            let stats = methods().map(|method| match studio.quick {
                true => Ok(renderer.render(&scene, &method)?.stats),
                false => Ok(renderer.measure(&scene, &method, 3)?.stats),
            });
            let [a, b, layers] = stats;
            rows.push(row(
                &format!("{name}, {view}"),
                mesh.triangles.len(),
                [a?, b?, layers?],
                !studio.quick,
            ));
        }
    }
    let mut columns = vec![
        "mesh and view",
        "faces",
        "coherent A",
        "coherent B",
        "layer peeling",
        "iterations, layers / A",
    ];
    if !studio.quick {
        columns.push("time, layers / A");
        columns.push("time, layers / B");
    }
    let caption = format!(
        "Iterations (it) and geometry passes (g) here, {} x {} pixels",
        SIZE[0], SIZE[1]
    );
    let caption = match studio.quick {
        true => caption,
        false => times_taken_on(&caption, studio),
    };
    let drawn = Drawn::new(
        "Read the columns of ratios. The paper's models gain 2.5 to 8.7 times in iterations, and 0.8 to 3 times in time: an \
         iteration of A draws everything six times, one of layer peeling twice. The meshes here gain as much where they are \
         deep, and less where they are shallow: three iterations of four layers are not a gain. The last iteration finds nothing \
         in each method.",
    );
    Ok(drawn.table(&caption, &columns, rows).table(
        "The paper's table: frames per second on an NVIDIA 8800 GTX, as ratios",
        &[
            "model",
            "faces",
            "coherent A",
            "coherent B",
            "layer peeling",
            "iterations, layers / A",
            "time, layers / A",
            "time, layers / B",
        ],
        PAPER.iter().map(paper_s).collect(),
    ))
}

fn row(name: &str, faces: usize, [a, b, layers]: [Stats; 3], timed: bool) -> Vec<String> {
    let cell = |stats: &Stats| format!("{} it, {} g", stats.iterations, stats.geometry_passes);
    let ratio = f64::from(layers.iterations) / f64::from(a.iterations);
    let mut row = vec![
        name.into(),
        faces.to_string(),
        cell(&a),
        cell(&b),
        cell(&layers),
        format!("{ratio:.1}"),
    ];
    if timed {
        row.extend([&a, &b].map(|stats| format!("{:.2}", layers.ms / stats.ms)));
    }
    row
}

fn paper_s(
    &(name, faces, [coherent, layers], [a, b, peel]): &(&str, &str, [u32; 2], [f64; 3]),
) -> Vec<String> {
    let cell = |iterations: u32, passes: u32| format!("{iterations} it, {} g", iterations * passes);
    vec![
        name.into(),
        faces.into(),
        cell(coherent, 6),
        cell(coherent, 5),
        cell(layers, 2),
        format!("{:.1}", f64::from(layers) / f64::from(coherent)),
        format!("{:.2}", a / peel),
        format!("{:.2}", b / peel),
    ]
}
