//! Shadows from a light's own view (Everitt 2001, figure 2 and "Shadow Mapping"; E14): the same comparison by which layers
//! are peeled, with a map that a light has made. The camera's own map is the special case.

use glam::DVec3;
use onionskin::low_level::methods::shadows;
use onionskin::{Camera, Context, Mesh, Rgba, Scene, Vertex};

const SIZE: [u32; 2] = [96, 96];

fn quad(corners: [[f64; 3]; 4]) -> Mesh {
    let vertex = |place: [f64; 3]| Vertex {
        position: place.into(),
        normal: glam::Vec3::Y,
        color: Rgba::opaque([1.0; 3]),
    };
    Mesh {
        name: "quad".into(),
        vertices: corners.map(vertex).to_vec(),
        triangles: vec![[0, 1, 2], [0, 2, 3]],
        opaque: true,
        ..Mesh::default()
    }
}

/// A floor, and a smaller quad above it.
fn floor_and_blind() -> Scene {
    let floor = [
        [-3.0, 0.0, -3.0],
        [-3.0, 0.0, 3.0],
        [3.0, 0.0, 3.0],
        [3.0, 0.0, -3.0],
    ];
    let blind = [
        [-0.8, 1.2, -0.8],
        [-0.8, 1.2, 0.8],
        [0.8, 1.2, 0.8],
        [0.8, 1.2, -0.8],
    ];
    let mut scene = Scene::of("floor and blind", vec![quad(floor), quad(blind)]);
    scene.size = SIZE;
    scene.background = [0.0; 3];
    scene.camera = looking(DVec3::new(0.5, 5.0, 6.0));
    scene
}

fn looking(eye: DVec3) -> Camera {
    Camera {
        fov: 50.0,
        near: 1.0,
        far: 20.0,
        ..Camera::looking(eye, DVec3::new(0.0, 0.4, 0.0))
    }
}

fn light() -> Camera {
    looking(DVec3::new(-2.5, 6.0, 1.0))
}

/// The scene with the shadows of a light: each pixel's colour, row by row from the bottom, black in shadow.
fn shadowed(context: &Context, scene: &Scene, light: Camera, bias: f32) -> Vec<[f32; 4]> {
    let image = shadows::shadowed(context, scene, light, bias)
        .unwrap()
        .image;
    let rows = image.pixels.chunks_exact(SIZE[0] as usize).rev();
    rows.flatten().map(|color| color.to_array()).collect()
}

/// What lies at a pixel's middle, in f64: the nearest point of the scene there, or `None`.
fn seen(scene: &Scene, pixel: usize) -> Option<DVec3> {
    let [x, y] = [pixel % SIZE[0] as usize, pixel / SIZE[0] as usize].map(|n| n as f64 + 0.5);
    let camera = scene.camera;
    let back = (camera.projection(SIZE[0], SIZE[1]) * camera.view()).inverse();
    let at = |z: f64| {
        let place = glam::DVec3::new(x / 48.0 - 1.0, y / 48.0 - 1.0, z);
        back.project_point3(place)
    };
    let direction = (at(1.0) - at(-1.0)).normalize();
    nearest(scene, camera.eye, direction).map(|t| camera.eye + direction * t)
}

/// The distance of the nearest of the horizontal quads along a ray.
fn nearest(scene: &Scene, from: DVec3, direction: DVec3) -> Option<f64> {
    let hits = scene.meshes.iter().filter_map(|mesh| {
        let [low, _, high, _] = [0, 1, 2, 3].map(|n| mesh.vertices[n].position);
        let t = (low.y - from.y) / direction.y;
        let at = from + direction * t;
        let inside = at.x >= low.x && at.x <= high.x && at.z >= low.z && at.z <= high.z;
        (t > 1e-9 && inside).then_some(t)
    });
    hits.reduce(f64::min)
}

/// Whether the light sees a point, by a ray between the two.
fn is_lit(scene: &Scene, point: DVec3, light: DVec3) -> bool {
    let way = point - light;
    let found = nearest(scene, light, way.normalize()).unwrap_or(f64::INFINITY);
    found > way.length() - 1e-6
}

/// Whether a point's answer is that of its surroundings, as far as a texel of the shadow map reaches.
fn is_certain(scene: &Scene, point: DVec3, light: Camera) -> bool {
    // A texel at the light's distance of at most 8 is 2 x 8 x tan(25) / 96 = 0.08 wide, and longer where it falls aslant.
    const REACH: f64 = 0.2;
    let lit = is_lit(scene, point, light.eye);
    [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)]
        .map(|(x, z)| point + DVec3::new(x, 0.0, z) * REACH)
        .into_iter()
        .all(|near| is_lit(scene, near, light.eye) == lit)
}

#[test]
pub(crate) fn e14_a_light_s_own_depth_map_throws_the_shadows_that_rays_find() {
    let context = Context::headless().unwrap();
    let scene = floor_and_blind();
    let image = shadowed(&context, &scene, light(), 0.002);
    let (mut lit, mut dark) = (0, 0);
    for (pixel, color) in image.iter().enumerate() {
        let Some(point) = seen(&scene, pixel) else {
            continue;
        };
        if !is_certain(&scene, point, light()) {
            continue;
        }
        let expected = is_lit(&scene, point, light().eye);
        assert_eq!(color[0] > 0.5, expected, "pixel {pixel}: {point}");
        *(if expected { &mut lit } else { &mut dark }) += 1;
    }
    println!("{lit} pixels lit, {dark} in shadow, and found so by rays");
    assert!(lit > 2000 && dark > 150, "{lit} {dark}");
}

/// Without a bias half of what is lit shadows itself: the texel's depth is not the fragment's.
#[test]
pub(crate) fn e14_without_a_bias_lit_surfaces_shadow_themselves() {
    let context = Context::headless().unwrap();
    let scene = floor_and_blind();
    let wrong = |bias| {
        let image = shadowed(&context, &scene, light(), bias);
        let is_wrong = |(pixel, color): (usize, &[f32; 4])| {
            seen(&scene, pixel).is_some_and(|point| {
                is_certain(&scene, point, light())
                    && (color[0] > 0.5) != is_lit(&scene, point, light().eye)
            })
        };
        image
            .iter()
            .enumerate()
            .filter(|&case| is_wrong(case))
            .count()
    };
    let [none, some] = [0.0, 0.002].map(wrong);
    println!("wrong without a bias: {none}, with: {some}");
    assert!(none > 500 && some == 0, "{none} {some}");
}

/// "We make the orientation and resolution of the shadow map identical to that of the camera": the light where the eye is.
/// Then every visible surface is lit, and no fragment falls between texels.
#[test]
pub(crate) fn e14_the_camera_s_own_map_is_the_special_case() {
    let context = Context::headless().unwrap();
    let scene = floor_and_blind();
    // What is left is the last bits of r/q against window z (E06).
    let image = shadowed(&context, &scene, scene.camera, 1e-6);
    let mut covered = 0;
    for (pixel, color) in image.iter().enumerate() {
        if color[3] > 0.0 {
            covered += 1;
            // White, interpolated.
            assert!(
                color[..3].iter().all(|&c| c > 1.0 - 1e-6),
                "pixel {pixel}: {color:?}"
            );
        }
    }
    assert!(covered > 3000, "{covered}");
    // Moved by a unit, the eye sees shadows.
    let image = shadowed(
        &context,
        &scene,
        looking(scene.camera.eye + DVec3::X),
        0.002,
    );
    assert!(
        image
            .iter()
            .filter(|color| color[3] > 0.0 && color[0] == 0.0)
            .count()
            > 20
    );
}
