//! OBJ models: what is read, and how.

use crate::kit::scene::model::{CORNERS, colors, with_materials};
use crate::kit::scene::{Folder, obj, obj_mesh, toml};
use glam::{DVec3, Vec3};
use onionskin::{Mesh, Rgba};

fn positions(mesh: &Mesh, triangle: usize) -> [Vec3; 3] {
    mesh.corners(triangle)
        .map(|corner| corner.position.as_vec3())
}

#[test]
fn a_triangle_keeps_its_corners_in_their_order() {
    let mesh = obj_mesh(format!("{CORNERS}f 2 3 1\n"));
    assert_eq!(
        positions(&mesh, 0),
        [Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::ZERO]
    );
}

#[test]
fn faces_keep_the_order_of_the_file() {
    let mesh = obj_mesh(format!("{CORNERS}f 2 3 4\nf 1 2 3\nf 4 1 2\n"));
    let firsts: Vec<Vec3> = (0..3).map(|i| positions(&mesh, i)[0]).collect();
    assert_eq!(firsts, [Vec3::X, Vec3::ZERO, Vec3::Y]);
}

#[test]
fn negative_indices_count_back_from_the_latest_vertex() {
    let mesh = obj_mesh(format!("{CORNERS}f -4 -3 -2\nv 5 5 5\nf -2 1 -1\n"));
    assert_eq!(
        positions(&mesh, 0),
        [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0)]
    );
    assert_eq!(positions(&mesh, 1), [Vec3::Y, Vec3::ZERO, Vec3::splat(5.0)]);
}

#[test]
fn a_quad_is_two_triangles() {
    assert_eq!(
        obj_mesh(format!("{CORNERS}f 1 2 3 4\n")).triangle_count(),
        2
    );
}

#[test]
fn a_polygon_is_a_fan_with_the_polygons_area() {
    let corners: String = (0..7)
        .map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 7.0).sin_cos();
            format!("v {cos} {sin} 0\n")
        })
        .collect();
    let mesh = obj_mesh(format!("{corners}f 1 2 3 4 5 6 7\n"));
    let areas = (0..5).map(|i| {
        let [a, b, c] = positions(&mesh, i).map(|p| p.as_dvec3());
        (b - a).cross(c - a).z / 2.0
    });
    let exact = 7.0 / 2.0 * (std::f64::consts::TAU / 7.0).sin();
    // Coordinates are rounded to f32, 6e-8 relative; a handful of them add up.
    assert!((areas.sum::<f64>() - exact).abs() < 1e-6);
}

#[test]
fn normals_of_the_file_are_kept_at_unit_length() {
    let mesh = obj_mesh(format!("{CORNERS}vn 0 3 4\nf 1//1 2//1 3//1\n"));
    assert!(
        mesh.vertices
            .iter()
            .all(|v| v.normal == Vec3::new(0.0, 0.6, 0.8))
    );
}

#[test]
fn missing_normals_are_those_of_the_faces() {
    let mesh = obj_mesh(format!("{CORNERS}f 1 2 3 4\n"));
    assert!(mesh.vertices.iter().all(|v| v.normal == Vec3::Z));
}

#[test]
fn smooth_normals_weigh_faces_by_their_area() {
    // At the origin three faces meet that span areas 1/2, 1 and 3/2 across x, y and z.
    let mesh = obj_mesh("v 0 0 0\nv 1 0 0\nv 0 3 0\nv 0 0 1\nv 2 0 0\nf 1 2 3\nf 1 4 5\nf 1 3 4\n");
    let at_origin = mesh.vertices.iter().find(|v| v.position == DVec3::ZERO);
    let expected = DVec3::new(3.0, 2.0, 3.0).normalize().as_vec3();
    // One rounding from f64 to f32 on either side.
    assert!((at_origin.expect("vertex 1").normal - expected).length() < 2e-7);
}

#[test]
fn normals_that_only_some_corners_have_are_completed() {
    let mesh = obj_mesh(format!("{CORNERS}vn 1 0 0\nf 1//1 2//1 3//1\nf 1 3 4\n"));
    let normals = |triangle: usize| mesh.corners(triangle).map(|corner| corner.normal);
    assert_eq!(normals(0), [Vec3::X; 3]);
    assert_eq!(normals(1), [Vec3::Z; 3]);
}

#[test]
fn a_normal_of_length_zero_is_replaced() {
    let mesh = obj_mesh(format!("{CORNERS}vn 0 0 0\nf 1//1 2//1 3//1\n"));
    assert!(mesh.vertices.iter().all(|v| v.normal == Vec3::Z));
}

#[test]
fn texture_coordinates_do_not_split_vertices() {
    let mesh = obj_mesh(format!(
        "{CORNERS}vt 0 0\nvt 1 1\nf 1/1 2/1 3/1\nf 1/2 3/2 4/2\n"
    ));
    assert_eq!(mesh.vertices.len(), 4);
}

#[test]
fn vertices_with_texture_and_normal_indices_are_read() {
    let mesh = obj_mesh(format!(
        "{CORNERS}vt 0 0\nvn 0 0 2\nf 1/1/1 2/1/1 3/1/1\nf -4/-1/-1 -2/-1/-1 -1/-1/-1\n"
    ));
    assert_eq!(mesh.triangle_count(), 2);
    assert!(mesh.vertices.iter().all(|v| v.normal == Vec3::Z));
}

#[test]
fn a_weight_divides_the_coordinates() {
    let mesh = obj_mesh("v 2 0 0 2\nv 0 2 0 2\nv 0 0 2 2\nf 1 2 3\n");
    assert_eq!(positions(&mesh, 0), [Vec3::X, Vec3::Y, Vec3::Z]);
}

#[test]
fn vertex_colours_are_read() {
    let mesh = obj_mesh("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n");
    let expected = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Rgba::opaque);
    assert_eq!(colors(&mesh), expected);
}

#[test]
fn vertices_without_a_colour_among_coloured_ones_take_the_models() {
    let mesh = obj_mesh("v 0 0 0\nv 1 0 0 0 1 0\nv 0 2 0 2\nf 1 2 3\n");
    let white = Rgba::opaque([1.0; 3]);
    assert_eq!(colors(&mesh), [white, Rgba::opaque([0.0, 1.0, 0.0]), white]);
    assert_eq!(positions(&mesh, 0)[2], Vec3::Y);
}

#[test]
fn objects_groups_and_materials_each_start_a_mesh() {
    let model = format!(
        "mtllib m.mtl\n{CORNERS}o pot\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\nf 2 3 4\ng lid\nf 1 2 4\nusemtl red\nf 1 2 3\n"
    );
    let scene = with_materials(&model, "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
    let found: Vec<(&str, usize)> = scene
        .meshes
        .iter()
        .map(|mesh| (mesh.name.as_str(), mesh.triangle_count()))
        .collect();
    let expected = [
        ("pot (red)", 1),
        ("pot (blue)", 2),
        ("lid (blue)", 1),
        ("lid (red)", 1),
    ];
    assert_eq!(found, expected);
}

#[test]
fn lines_and_points_are_skipped_and_counted() {
    let scene = obj(format!("{CORNERS}l 1 2 3 4\nl 1 2\np 1\nf 1 2 3\n"));
    assert_eq!(scene.triangle_count(), 1);
    assert!(
        scene.notices[0].contains("2 line elements skipped"),
        "{:?}",
        scene.notices
    );
    assert!(
        scene.notices[1].contains("1 point element skipped"),
        "{:?}",
        scene.notices
    );
}

#[test]
fn unknown_keywords_are_skipped_and_counted() {
    let scene = obj(format!("{CORNERS}wibble 1 2\nwobble\nf 1 2 3\n"));
    assert!(
        scene.notices[0].contains("model.obj:5: 2 lines with an unknown keyword"),
        "{:?}",
        scene.notices
    );
    assert!(scene.notices[0].contains("'wibble'"), "{:?}", scene.notices);
}

#[test]
fn degenerate_triangles_are_skipped_and_counted() {
    // A repeated index, a repeated place, three corners on a line.
    let scene =
        obj("v 0 0 0\nv 1 1 1\nv 2 2 2\nv 1 1 1\nv 0 1 0\nf 1 1 5\nf 2 4 5\nf 1 2 3\nf 1 2 5\n");
    assert_eq!(scene.triangle_count(), 1);
    assert!(
        scene.notices[0].contains("3 triangles without area"),
        "{:?}",
        scene.notices
    );
}

#[test]
fn degenerate_triangles_do_not_spoil_normals() {
    let scene = obj("v 0 0 0\nv 1 1 1\nv 2 2 2\nv 0 1 0\nf 1 2 3\nf 1 2 4\n");
    assert!(
        scene.meshes[0]
            .vertices
            .iter()
            .all(|v| v.normal.is_normalized())
    );
}

#[test]
fn a_tiny_triangle_is_not_degenerate() {
    // The smallest normal f32 is 1.2e-38; the product of two such lengths is far below it, but not below f64's.
    assert_eq!(
        obj_mesh("v 0 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n").triangle_count(),
        1
    );
}

#[test]
fn comments_may_end_a_line_and_be_in_any_encoding() {
    let mesh = obj_mesh(b"# Gr\xf6\xdfe\nv 0 0 0 # origin\nv 1 0 0\nv 0 1 0\nf 1 2 3 # face\n");
    assert_eq!(mesh.triangle_count(), 1);
}

#[test]
fn windows_line_ends_indents_and_a_byte_order_mark_are_accepted() {
    let mesh = obj_mesh("\u{feff}v 0 0 0\r\n  v 1 0 0\r\n\tv\t0 1 0\r\n\r\nf 1 2 3\r\n");
    assert_eq!(mesh.triangle_count(), 1);
}

#[test]
fn a_backslash_continues_a_line() {
    let mesh = obj_mesh("v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 \\\n2 \\\n3\n");
    assert_eq!(mesh.triangle_count(), 1);
}

#[test]
fn the_last_line_needs_no_end() {
    assert_eq!(obj_mesh(format!("{CORNERS}f 1 2 3")).triangle_count(), 1);
}

#[test]
fn several_models_in_a_scene_keep_their_order() {
    let folder = Folder::new()
        .with("a.obj", format!("{CORNERS}o a\nf 1 2 3\n"))
        .with("b.obj", format!("{CORNERS}o b\nf 1 2 3\n"))
        .with(
            "s.toml",
            "[[mesh]]\nfile = \"b.obj\"\n[[mesh]]\nfile = \"a.obj\"\n",
        );
    let scene = folder.load("s.toml").expect("it loads");
    let names: Vec<&str> = scene.meshes.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["b", "a"]);
}

#[test]
fn a_hundred_thousand_triangles_load_whole() {
    use std::fmt::Write;
    const SIDE: usize = 224;
    let mut model = String::new();
    for i in 0..=SIDE {
        for j in 0..=SIDE {
            writeln!(model, "v {i}.25 {j}.5 {}", (i * j) % 7).expect("a string");
        }
    }
    for i in 0..SIDE {
        for j in 1..=SIDE {
            let (a, b) = (i * (SIDE + 1) + j, (i + 1) * (SIDE + 1) + j);
            writeln!(model, "f {a} {b} {} {}", b + 1, a + 1).expect("a string");
        }
    }
    let folder = Folder::new().with("m.obj", model);
    let scene = folder.load("m.obj").expect("it loads");
    assert_eq!(scene.triangle_count(), 2 * SIDE * SIDE);
}

#[test]
fn a_scene_file_without_meshes_has_a_background_all_the_same() {
    let scene = toml("background = [0.5, 0.25, 0]\n");
    assert_eq!(scene.background, [0.5, 0.25, 0.0]);
    assert_eq!(scene.triangle_count(), 0);
}
