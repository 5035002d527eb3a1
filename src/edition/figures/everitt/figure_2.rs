//! Figure 2: shadow mapping.

use glam::DVec3;

use crate::error::Result;
use crate::fragment::Rgba;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::methods::shadows::shadowed;
use crate::report::depths;
use crate::scene::{Camera, Mesh, Scene, Vertex};

pub(super) const FIGURE: Figure = Figure {
    key: "everitt-2",
    source: "Everitt 2001, figure 2",
    title: "A shadow map is a depth buffer seen from the light",
    make,
};

const TARGET: DVec3 = DVec3::new(0.0, 0.4, 0.0);

fn make(studio: &Studio) -> Result<Drawn> {
    let scene = scene(studio.size([320, 320]));
    let light = looking(DVec3::new(-2.5, 6.0, 1.0));
    let with = shadowed(studio.context, &scene, light, 0.002)?;
    let without = shadowed(studio.context, &scene, light, 0.0)?;
    Ok(Drawn::new(
        "A pixel is in shadow if the light's map holds a lesser depth there. This is a depth test whose buffer another view \
         has filled. A texel's depth is not that of every fragment that falls into it. So without a small bias the floor \
         shadows itself. For depth peeling the map is the camera's own, pixel by pixel.",
    )
    .picture(
        "map",
        &depths(scene.size[0], &with.map),
        "the depths from the light: darker is nearer",
        "a floor in grey from above, and on it a smaller and darker square",
    )
    .picture(
        "shadows",
        &with.image,
        "from the eye: black lies behind the map",
        "a floor with a square above it, which throws a black shadow",
    )
    .picture(
        "without",
        &without.image,
        "the same without a bias",
        "the same floor, covered with black stripes",
    ))
}

fn looking(eye: DVec3) -> Camera {
    Camera {
        fov: 50.0,
        near: 1.0,
        far: 20.0,
        ..Camera::looking(eye, TARGET)
    }
}

/// A floor, and a smaller quad above it.
fn scene(size: [u32; 2]) -> Scene {
    let floor = quad(3.0, 0.0, [0.85, 0.8, 0.7]);
    let blind = quad(0.8, 1.2, [0.3, 0.5, 0.8]);
    Scene {
        size,
        background: [1.0; 3],
        camera: looking(DVec3::new(0.5, 5.0, 6.0)),
        ..Scene::of("floor and blind", vec![floor, blind])
    }
}

fn quad(half: f64, height: f64, color: [f32; 3]) -> Mesh {
    let corner = |(x, z)| Vertex {
        position: DVec3::new(x * half, height, z * half),
        normal: glam::Vec3::Y,
        color: Rgba::opaque(color),
    };
    let corners = [(-1.0, -1.0), (-1.0, 1.0), (1.0, 1.0), (1.0, -1.0)];
    Mesh {
        opaque: true,
        ..Mesh::new(
            "quad",
            corners.map(corner).to_vec(),
            vec![[0, 1, 2], [0, 2, 3]],
        )
    }
}
