//! Scene files: every key is read. `scene/toml_refused.rs` has what is wrong with values.

use crate::kit::scene::square::{SQUARE, square};
use crate::kit::scene::{Folder, refused, toml};
use glam::DVec3;
use onionskin::{Rgba, Scene, Shading};

#[test]
fn every_key_of_the_top_is_read() {
    let scene = toml("size = [640, 480]\nbackground = [1, 0.5, 0.25]\n");
    assert_eq!(scene.size, [640, 480]);
    assert_eq!(scene.background, [1.0, 0.5, 0.25]);
    assert_eq!(scene.name, "scene");
}

#[test]
fn an_empty_file_is_a_black_picture() {
    let scene = toml("");
    assert_eq!(scene.size, Scene::DEFAULT_SIZE);
    assert_eq!(scene.background, [0.0; 3]);
    assert!(scene.meshes.is_empty());
    assert!(scene.camera.check().is_ok());
}

#[test]
fn every_key_of_the_camera_is_read() {
    let scene = toml(
        "[camera]\neye = [1, 2, 3]\ntarget = [4, 5, 6]\nup = [0, 0, 1]\nfov = 45\nnear = 0.5\nfar = 20.0\n",
    );
    let camera = scene.camera;
    assert_eq!(camera.eye, DVec3::new(1.0, 2.0, 3.0));
    assert_eq!(camera.target, DVec3::new(4.0, 5.0, 6.0));
    assert_eq!(camera.up, DVec3::Z);
    assert_eq!([camera.fov, camera.near, camera.far], [45.0, 0.5, 20.0]);
}

#[test]
fn colour_and_opacity_go_to_the_vertices() {
    let scene = square("color = [0.5, 0.25, 1]\nopacity = 0.75");
    let expected = Rgba::new(0.5, 0.25, 1.0, 0.75);
    assert!(scene.meshes[0].vertices.iter().all(|v| v.color == expected));
}

#[test]
fn a_mesh_is_opaque_if_its_opacity_is_1() {
    assert!(square("opacity = 1").meshes[0].opaque);
    assert!(!square("opacity = 0.999").meshes[0].opaque);
}

#[test]
fn every_shading_is_known() {
    let known = [
        ("none", Shading::None),
        ("flat", Shading::Flat),
        ("lit", Shading::Lit),
        ("two-sided", Shading::TwoSided),
    ];
    for (word, shading) in known {
        let scene = square(&format!("shading = \"{word}\""));
        assert_eq!(scene.meshes[0].shading, shading);
    }
}

#[test]
fn without_shading_a_mesh_is_unlit() {
    assert_eq!(square("").meshes[0].shading, Shading::None);
}

#[test]
fn flat_shading_gives_each_triangle_its_own_vertices() {
    assert_eq!(square("").meshes[0].vertices.len(), 4);
    assert_eq!(square("shading = \"flat\"").meshes[0].vertices.len(), 6);
}

#[test]
fn the_inside_has_its_own_colour_or_the_outsides() {
    let given = square("color = [1, 0, 0]\nshading = \"two-sided\"\ninside = [0, 1, 0]");
    assert_eq!(given.meshes[0].inside, [0.0, 1.0, 0.0]);
    let left_out = square("color = [1, 0, 0]\nshading = \"two-sided\"");
    assert_eq!(left_out.meshes[0].inside, [1.0, 0.0, 0.0]);
}

#[test]
fn an_inside_that_is_not_seen_is_a_notice() {
    let scene = square("inside = [0, 1, 0]");
    assert!(
        scene.notices[0].contains("scene.toml:3"),
        "{:?}",
        scene.notices
    );
}

#[test]
fn sorted_is_read() {
    assert!(square("sorted = true").meshes[0].sorted);
    assert!(!square("").meshes[0].sorted);
}

#[test]
fn a_transform_scales_then_rotates_then_moves() {
    let scene = square(
        "transform = { translate = [10, 0, 0], rotate = { axis = [0, 0, 2], degrees = 90 }, scale = [2, 3, 1] }",
    );
    // (1, 1, 0) scaled is (2, 3, 0), turned by 90 degrees about z (-3, 2, 0).
    let corner = scene.meshes[0].vertices[2].position;
    // The sine and cosine of 90 degrees are off by 6e-17, which the factors 2 and 3 multiply; sums near 7 round by 4e-16.
    assert!(
        corner.abs_diff_eq(DVec3::new(7.0, 2.0, 0.0), 2e-15),
        "{corner}"
    );
}

#[test]
fn a_transform_may_be_a_table_of_its_own() {
    let scene = square("[mesh.transform]\nscale = 2\ntranslate = [0, 0, 1]");
    assert_eq!(
        scene.meshes[0].vertices[2].position,
        DVec3::new(2.0, 2.0, 1.0)
    );
}

#[test]
fn normals_stay_perpendicular_under_an_uneven_scale() {
    let slope = "v 0 0 0\nv 0 0 -1\nv 1 1 0\nf 1 2 3\n";
    let scene = Folder::new()
        .with("m.obj", slope)
        .with(
            "s.toml",
            "[[mesh]]\nfile = \"m.obj\"\ntransform = { scale = [1, 4, 1] }\n",
        )
        .load("s.toml")
        .expect("it loads");
    let [a, b, c] = scene.meshes[0].corners(0);
    let across = (b.position - a.position)
        .cross(c.position - a.position)
        .normalize();
    // Both were rounded to f32 a few times.
    assert!(
        (across.as_vec3() - a.normal).length() < 1e-6,
        "{across} {}",
        a.normal
    );
}

#[test]
fn a_mirrored_mesh_keeps_its_outside_outside() {
    let scene = square("transform = { scale = [-1, 1, 1] }");
    let mesh = &scene.meshes[0];
    for triangle in 0..2 {
        let [a, b, c] = mesh.corners(triangle);
        let across = (b.position - a.position).cross(c.position - a.position);
        assert!(across.as_vec3().dot(a.normal) > 0.0);
    }
}

#[test]
fn paths_start_at_the_scene_files_folder() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("meshes")).expect("a folder");
    let folder = folder
        .with("meshes/m.obj", SQUARE)
        .with("s.toml", "[[mesh]]\nfile = \"meshes/m.obj\"\n");
    assert_eq!(folder.load("s.toml").expect("it loads").triangle_count(), 2);
}

#[test]
fn an_error_in_a_model_names_the_model() {
    let folder = Folder::new()
        .with("m.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        .with("s.toml", "[[mesh]]\nfile = \"m.obj\"\n");
    let error = refused(folder.load("s.toml"));
    assert_eq!(error.file, "m.obj");
    error.at(1, "0 0");
}
