//! From `tobj`'s runs of triangles to meshes.

use glam::{DVec3, Vec3};

use super::Paint;
use super::check::NO_COLOR;
use crate::fragment::Rgba;
use crate::scene::mesh::{Mesh, Vertex};
use crate::scene::normals;

/// The colour of what has no other.
const DEFAULT_COLOR: [f32; 3] = [1.0, 1.0, 1.0];

/// One mesh per run, in their order.
pub(super) fn meshes(
    models: Vec<tobj::Model>,
    materials: &[tobj::Material],
    paint: &Paint,
) -> Vec<Mesh> {
    let drawn = models.into_iter().filter(|m| !m.mesh.indices.is_empty());
    drawn
        .map(|model| {
            let material = model.mesh.material_id.and_then(|id| materials.get(id));
            mesh(&model, material, paint)
        })
        .collect()
}

fn mesh(model: &tobj::Model, material: Option<&tobj::Material>, paint: &Paint) -> Mesh {
    let positions: Vec<DVec3> = vectors(&model.mesh.positions)
        .into_iter()
        .map(DVec3::from)
        .collect();
    let triangles: Vec<[u32; 3]> = model.mesh.indices.as_chunks().0.to_vec();
    let normals = all_normals(&positions, &vectors(&model.mesh.normals), &triangles);
    let color = paint
        .color
        .or(material.and_then(|m| m.diffuse.or(m.ambient)))
        .unwrap_or(DEFAULT_COLOR);
    let alpha = paint.opacity.or(material.and_then(opacity)).unwrap_or(1.0);
    let own_colors = vectors(&model.mesh.vertex_color);
    let vertices = positions.iter().zip(normals).enumerate();
    let vertices = vertices.map(|(i, (&position, normal))| {
        let own = own_colors.get(i).filter(|own| own.x != NO_COLOR);
        let [r, g, b] = own.map_or(color, Vec3::to_array);
        Vertex {
            position,
            normal,
            color: Rgba::new(r, g, b, alpha),
        }
    });
    Mesh {
        inside: color,
        ..Mesh::new(name(model, material), vertices.collect(), triangles)
    }
}

/// `d`, or 1 less `Tr`, which `tobj` hands on as it stands.
fn opacity(material: &tobj::Material) -> Option<f32> {
    let transparency = || material.unknown_param.get("Tr")?.parse::<f32>().ok();
    material.dissolve.or_else(|| Some(1.0 - transparency()?))
}

/// The file's normals at unit length; smooth ones where it has none, or one of length zero.
fn all_normals(positions: &[DVec3], given: &[Vec3], triangles: &[[u32; 3]]) -> Vec<Vec3> {
    let unit = |normal: &Vec3| normal.as_dvec3().try_normalize().map(|unit| unit.as_vec3());
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

fn vectors(numbers: &[f32]) -> Vec<Vec3> {
    let (triples, _) = numbers.as_chunks();
    triples
        .iter()
        .map(|&triple| Vec3::from_array(triple))
        .collect()
}

fn name(model: &tobj::Model, material: Option<&tobj::Material>) -> String {
    match material {
        Some(material) => format!("{} ({})", model.name, material.name),
        None => model.name.clone(),
    }
}
