//! Making meshes from `tobj`'s runs of triangles.

use glam::{DVec3, Vec3};

use crate::fragment::Rgba;
use crate::scene::mesh::{Mesh, Vertex};
use crate::scene::normals;

/// The look that a scene file gives to a model. It takes precedence over materials, and vertex colours take precedence
/// over it.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::low_level::scene) struct Paint {
    pub(in crate::low_level::scene) color: Option<[f32; 3]>,
    pub(in crate::low_level::scene) opacity: Option<f32>,
}

/// The colour of meshes without a colour of their own.
const DEFAULT_COLOR: [f32; 3] = [1.0, 1.0, 1.0];

/// The names and colours for which `tobj` was given numbers.
pub(super) struct Legend {
    pub(super) names: Vec<String>,
    pub(super) materials: Vec<String>,
    pub(super) colors: Vec<Option<[f32; 4]>>,
}

/// One mesh per run, in the order of the runs.
pub(super) fn meshes(
    models: Vec<tobj::Model>,
    materials: &[tobj::Material],
    legend: &Legend,
    paint: &Paint,
) -> Vec<Mesh> {
    let drawn = models.into_iter().filter(|m| !m.mesh.indices.is_empty());
    drawn
        .map(|model| {
            let material = model.mesh.material_id.and_then(|id| materials.get(id));
            mesh(&model, material, legend, paint)
        })
        .collect()
}

fn mesh(
    model: &tobj::Model,
    material: Option<&tobj::Material>,
    legend: &Legend,
    paint: &Paint,
) -> Mesh {
    let positions: Vec<DVec3> = vectors(&model.mesh.positions).collect();
    let triangles: Vec<[u32; 3]> = model.mesh.indices.as_chunks().0.to_vec();
    let given: Vec<DVec3> = vectors(&model.mesh.normals).collect();
    let normals = all_normals(&positions, &given, &triangles);
    let diffuse = || Some(material?.diffuse?.map(|channel| channel as f32));
    let color = paint.color.or_else(diffuse).unwrap_or(DEFAULT_COLOR);
    let dissolve = || Some(material?.dissolve? as f32);
    let alpha = paint.opacity.or_else(dissolve).unwrap_or(1.0);
    let mut own_colors = vectors(&model.mesh.vertex_color).map(|place| {
        let own = legend.colors.get(place.x as usize);
        own.copied().flatten()
    });
    let vertices = positions.iter().zip(normals).map(|(&position, normal)| {
        let own = own_colors.next().flatten();
        let [r, g, b, own_alpha] = own.unwrap_or([color[0], color[1], color[2], 1.0]);
        Vertex {
            position,
            normal,
            color: Rgba::new(r, g, b, alpha * own_alpha),
        }
    });
    Mesh {
        inside: color,
        ..Mesh::new(name(model, material, legend), vertices.collect(), triangles)
    }
}

/// The file's normals at unit length. Where the file has no normal, or one of length zero, the normal is smooth.
fn all_normals(positions: &[DVec3], given: &[DVec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let unit = |normal: &DVec3| normal.try_normalize().map(|unit| unit.as_vec3());
    let given: Vec<Option<Vec3>> = given.iter().map(unit).collect();
    if given.len() == positions.len() && given.iter().all(Option::is_some) {
        return given.into_iter().flatten().collect();
    }
    let smooth = normals::smooth(positions, triangles)
        .into_iter()
        .enumerate();
    smooth
        .map(|(i, smooth)| given.get(i).copied().flatten().unwrap_or(smooth))
        .collect()
}

fn vectors(numbers: &[f64]) -> impl Iterator<Item = DVec3> {
    let (triples, _) = numbers.as_chunks();
    triples.iter().map(|&triple| DVec3::from_array(triple))
}

fn name(model: &tobj::Model, material: Option<&tobj::Material>, legend: &Legend) -> String {
    // Faces before the first name have `tobj`'s own name.
    let name = named(&legend.names, &model.name);
    let name = name.map_or("unnamed_object", String::as_str);
    let material = material.and_then(|material| named(&legend.materials, &material.name));
    match material {
        Some(material) => format!("{name} ({material})"),
        None => name.to_owned(),
    }
}

/// The name that a number stands for, or `None` if the name is empty.
fn named<'a>(names: &'a [String], number: &str) -> Option<&'a String> {
    let number: usize = number.parse().ok()?;
    names.get(number).filter(|name| !name.is_empty())
}
