//! OBJ models as programs write them: what the image does not need stops nothing, and is said.

use crate::kit;
use crate::kit::scene::model::{CORNERS, colors};
use crate::kit::scene::{obj, obj_mesh};
use glam::Vec3;
use onionskin::{Mesh, Rgba, Scene};

/// Whether the scene has this notice.
#[track_caller]
fn said(scene: &Scene, part: &str) {
    let notices = &scene.notices;
    assert!(
        notices.iter().any(|notice| notice.contains(part)),
        "{notices:?}"
    );
}

/// The scene of the square's corners with these lines, of which nothing is to be said.
#[track_caller]
fn quiet(lines: &str) -> Scene {
    let scene = obj(format!("{CORNERS}{lines}"));
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
    scene
}

fn normals(mesh: &Mesh, triangle: usize) -> [Vec3; 3] {
    mesh.corners(triangle).map(|corner| corner.normal)
}

#[test]
fn empty_indices_stand_for_none() {
    for face in [
        "f 1// 2// 3//",
        "f 1/ 2/ 3/",
        "f 1/1/ 2/1/ 3/1/",
        "f 1//1 2//1 3//",
    ] {
        let scene = obj(format!("{CORNERS}vt 0 0\nvn 1 0 0\n{face}\n"));
        assert_eq!(scene.triangle_count(), 1, "{face}");
        assert_eq!(normals(&scene.meshes[0], 0)[2], Vec3::Z, "{face}");
        assert_eq!(scene.notices.len(), 1, "{:?}", scene.notices);
    }
}

#[test]
fn normals_that_cannot_be_used_are_replaced_and_counted() {
    for normal in [
        "vn nan 0 1",
        "vn 0 0 0",
        "vn 1.#QNAN 0 0",
        "vn 1 0",
        "vn",
        "vn 1e-300 0 0",
        "vn 1e300 0 0",
        "",
    ] {
        let scene = obj(format!("{CORNERS}{normal}\nf 1//1 2//1 3//1 4//1\n"));
        assert_eq!(normals(&scene.meshes[0], 0), [Vec3::Z; 3], "{normal}");
        said(&scene, "4 corners without the normal that they name");
        said(&scene, "the first is '1//1'");
    }
}

#[test]
fn bad_normals_are_averaged_as_missing_ones_are() {
    // Two faces that meet at a right angle in the edge from 1 to 2; each names another bad normal.
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvn nan nan nan\nvn 0 0 0\n";
    let bad = obj(format!("{corners}f 1//1 2//1 3//1\nf 2//2 1//9 4//2\n"));
    let missing = obj(format!("{corners}f 1 2 3\nf 2 1 4\n"));
    let smooth = missing.meshes[0].vertices[0].normal;
    assert_eq!(smooth, Vec3::new(0.0, 1.0, 1.0).normalize());
    assert_eq!(bad.meshes[0].vertices, missing.meshes[0].vertices);
}

#[test]
fn texture_indices_may_be_anything() {
    for face in [
        "f 1/9 2/9 3/9",
        "f 1/x 2/1.5 3/-9",
        "f 1/0/1 2/99999999999999999999/1 3/\u{e4}/1",
    ] {
        let scene = obj(format!("{CORNERS}vt nan inf\nvn 1 0 0\n{face}\n"));
        assert_eq!(scene.triangle_count(), 1, "{face}");
        said(
            &scene,
            "3 corners without the texture coordinates that they name",
        );
        assert_eq!(scene.notices.len(), 1, "{:?}", scene.notices);
    }
}

#[test]
fn texture_coordinates_are_not_looked_at() {
    quiet("vt\nvt 1 2 3 4\nvt nan x\nf 1/1 2/2 3/3\n");
}

#[test]
fn indices_beyond_the_third_are_left_out() {
    let scene = obj(format!(
        "{CORNERS}vt 0 0\nvn 1 0 0\nf 1/1/1/1 2//1/1 3//1/x\n"
    ));
    assert_eq!(normals(&scene.meshes[0], 0), [Vec3::X; 3]);
    said(&scene, "3 corners with more than three indices");
}

#[test]
fn faces_of_too_few_corners_are_skipped() {
    let scene = obj(format!("{CORNERS}f\nf 1\nf 1 2\nf 1 2 3\nf 1/"));
    assert_eq!(scene.triangle_count(), 1);
    said(
        &scene,
        "model.obj:5: 4 faces with fewer than three corners skipped",
    );
}

#[test]
fn lines_and_points_of_any_kind_are_skipped() {
    let scene = obj(format!("{CORNERS}l\nl 1\nl 1 x\np\np 99\nf 1 2 3\n"));
    said(&scene, "3 line elements skipped");
    said(&scene, "2 point elements skipped");
}

#[test]
fn a_vertex_without_a_place_takes_its_faces_with_it_and_no_others() {
    for bad in [
        "v 1.#INF 0 0",
        "v 0 -1.#IND 0",
        "v 0 0 nan(ind)",
        "v 1e400 0 0",
        "v 0x10 0 0",
        "v 1 2",
        "v",
        "v 1 x 2",
        "v 0 0 0 0",
        "v 1 1 1 nan",
        "v \u{661} 0 0",
        "v 1,5,0 0 0",
        "v 1.5,0 0 0",
    ] {
        let scene = obj(format!(
            "{CORNERS}{bad}\nf 1 2 5\nf 1 2 3\nf 5 2 3 4\nf 1 3 4\n"
        ));
        assert_eq!(scene.triangle_count(), 2, "{bad}");
        assert_eq!(scene.meshes[0].vertices.len(), 4, "{bad}");
        said(
            &scene,
            "model.obj:5: 1 vertex has no place that can be read",
        );
        said(
            &scene,
            "model.obj:6: 2 faces skipped for a vertex without a place, the first is '5'",
        );
    }
}

#[test]
fn a_vertex_without_a_place_that_no_face_needs_is_said() {
    let scene = obj(format!("{CORNERS}f 1 2 3\nv 1.0 2"));
    assert_eq!(scene.triangle_count(), 1);
    said(
        &scene,
        "model.obj:6: 1 vertex has no place that can be read",
    );
    said(&scene, "the first at '1.0 2'");
    assert_eq!(scene.notices.len(), 1);
}

#[test]
fn a_number_of_any_bytes_is_no_number() {
    let scene = obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 \xff\xfe 0\nf 1 2 3\n");
    assert_eq!(scene.triangle_count(), 1);
    said(&scene, "model.obj:4: 1 vertex has no place");
}

#[test]
fn a_decimal_comma_is_read_as_a_point_and_said() {
    let scene = obj("v 0,0 0 0\nv 1,5 0 0\nv 0 -2,5e-1 0\nf 1 3 2\n");
    let places: Vec<Vec3> = scene.meshes[0]
        .vertices
        .iter()
        .map(|v| v.position.as_vec3())
        .collect();
    assert_eq!(
        places,
        [
            Vec3::ZERO,
            Vec3::new(0.0, -0.25, 0.0),
            Vec3::new(1.5, 0.0, 0.0)
        ]
    );
    said(
        &scene,
        "model.obj:1: 3 lines of numbers with a decimal comma",
    );
}

#[test]
fn numbers_that_mean_nothing_are_left_out() {
    let scene = obj("v 0 0 0 1 2\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(scene.triangle_count(), 1);
    said(
        &scene,
        "model.obj:1: 1 vertex has numbers that mean nothing here",
    );
}

#[test]
fn a_seventh_number_is_the_vertexs_opacity() {
    let scene = obj("v 0 0 0 1 0 0 0.5\nv 1 0 0 1 0 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n");
    let alphas: Vec<f32> = colors(&scene.meshes[0]).iter().map(|c| c.a).collect();
    assert_eq!(alphas, [0.5, 0.0, 1.0]);
    said(&scene, "model.obj:1: 2 vertices have a seventh number");
    assert!(!scene.meshes[0].opaque);
}

#[test]
fn a_vertexs_opacity_multiplies_the_models() {
    let scene = kit::scene::Folder::new()
        .with("s.toml", "[[mesh]]\nfile = \"m.obj\"\nopacity = 0.5\n")
        .with(
            "m.obj",
            "v 0 0 0 1 0 0 0.5\nv 1 0 0 1 0 0 1\nv 0 1 0 1 0 0 1\nf 1 2 3\n",
        )
        .load("s.toml")
        .expect("it loads");
    let alphas: Vec<f32> = colors(&scene.meshes[0]).iter().map(|c| c.a).collect();
    assert_eq!(alphas, [0.25, 0.5, 0.5]);
}

#[test]
fn a_vertex_colour_a_hair_over_1_is_1() {
    let scene = obj("v 0 0 0 1.0000001 0 0\nv 1 0 0 1.003 -1e-9 0\nv 0 1 0 0.5 0 0\nf 1 2 3\n");
    let reds: Vec<Rgba> = colors(&scene.meshes[0]);
    assert_eq!(
        reds,
        [1.0, 1.0, 0.5].map(|red| Rgba::opaque([red, 0.0, 0.0]))
    );
    said(
        &scene,
        "model.obj:1: 2 vertices have a colour beyond 0 to 1, the first at '1.0000001'",
    );
}

#[test]
fn vertex_colours_of_bytes_are_divided_by_255() {
    let scene = obj("v 0 0 0 255 51 0\nv 1 0 0 0 0 0 51\nv 0 1 0 0 1 255\nf 1 2 3\n");
    let expected = [
        Rgba::opaque([1.0, 0.2, 0.0]),
        Rgba::new(0.0, 0.0, 0.0, 0.2),
        Rgba::opaque([0.0, 1.0 / 255.0, 1.0]),
    ];
    assert_eq!(colors(&scene.meshes[0]), expected);
    said(&scene, "whole numbers up to 255");
}

#[test]
fn a_vertex_colour_that_cannot_be_read_is_the_models() {
    let scene = obj("v 0 0 0 nan 0 0\nv 1 0 0 1 0 0 x\nv 0 1 0 0 0 1\nf 1 2 3\n");
    let expected = [[1.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]].map(Rgba::opaque);
    assert_eq!(colors(&scene.meshes[0]), expected);
    said(
        &scene,
        "model.obj:1: 1 vertex has a colour that cannot be read, the first at 'nan'",
    );
    said(
        &scene,
        "model.obj:2: 1 vertex has numbers that mean nothing here, the first at 'x'",
    );
}

#[test]
fn comments_do_not_continue() {
    quiet("# C:\\models\\\nf 1 2 3\n");
    let scene = quiet("f 1 2 3 # C:\\models\\\nf 1 3 4\n   # \\\nf 1 2 4\n");
    assert_eq!(scene.triangle_count(), 3);
}

#[test]
fn statements_continue() {
    assert_eq!(quiet("f 1 \\\n 2 \\\r\n\\\n3 4\n").triangle_count(), 2);
    assert_eq!(quiet("f 1 2\\\n 3\n").triangle_count(), 1);
    // A comment ends the whole statement.
    assert_eq!(
        quiet("f 1 2 \\\n 3 # and 4 \\\nf 1 3 4").triangle_count(),
        2
    );
    assert_eq!(quiet("o a \\\nb\nf 1 2 3\n").meshes[0].name, "a  b");
    assert_eq!(quiet("f 1 2 3 \\").triangle_count(), 1);
}

#[test]
fn names_that_end_in_a_backslash_do_not_continue() {
    let scene = quiet("o C:\\models\\\nf 1 2 3\n");
    assert_eq!(scene.meshes[0].name, "C:\\models\\");
}

#[test]
fn lines_end_as_on_any_system() {
    for end in ["\n", "\r\n", "\r"] {
        let scene = obj(format!("{CORNERS}wibble\nf 1 2 3\n").replace('\n', end));
        assert_eq!(scene.triangle_count(), 1);
        said(&scene, "model.obj:5: 1 line with an unknown keyword");
    }
    // Each of these ends one line, whatever the others end in.
    let scene = obj("v 0 0 0\rv 1 0 0\nv 0 1 0\r\n\r\nwibble\n\rf 1 2 3\x1a");
    said(&scene, "model.obj:5: 1 line");
    assert_eq!(scene.triangle_count(), 1);
}

#[test]
fn objects_and_groups_may_have_any_names() {
    let scene =
        quiet("o\nf 1 2 3\ng\nf 1 2 3\ng a b  c\nf 1 2 3\no 7\nf 1 2 3\ng \u{1f34b}\nf 1 2 3\n");
    let names: Vec<&str> = scene.meshes.iter().map(|mesh| mesh.name.as_str()).collect();
    assert_eq!(
        names,
        [
            "unnamed_object",
            "unnamed_object",
            "a b  c",
            "7",
            "\u{1f34b}"
        ]
    );
    let long = obj(format!(
        "{CORNERS}o {}\nf 1 2 3\n",
        "\u{1f34b}".repeat(100_000)
    ));
    assert_eq!(long.meshes[0].name.chars().count(), 61);
    let latin = obj([CORNERS.as_bytes(), b"o W\xfcrfel\nf 1 2 3\n"].concat());
    assert_eq!(latin.meshes[0].name, "W\u{fffd}rfel");
}

#[test]
fn a_face_may_stand_before_its_vertices() {
    let mesh = obj_mesh("f 1//1 2//1 3//1\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn 1 0 0\n");
    assert_eq!(mesh.triangle_count(), 1);
    assert_eq!(normals(&mesh, 0), [Vec3::X; 3]);
}

/// Two triangles that meet at a right angle in an edge.
const BENT: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

#[test]
fn without_smoothing_a_model_has_facets() {
    for off in ["s off", "s 0", "s", "s OFF", "s 00"] {
        let scene = obj(format!("{BENT}{off}\nf 1 2 3\nf 2 1 4\n"));
        assert_eq!(normals(&scene.meshes[0], 0), [Vec3::Z; 3], "{off}");
        assert_eq!(normals(&scene.meshes[0], 1), [Vec3::Y; 3], "{off}");
    }
}

#[test]
fn without_a_word_about_smoothing_a_model_is_smooth() {
    let edge = Vec3::new(0.0, 1.0, 1.0).normalize();
    let mesh = obj_mesh(format!("{BENT}f 1 2 3\nf 2 1 4\n"));
    assert_eq!(normals(&mesh, 0), [edge, edge, Vec3::Z]);
    assert_eq!(mesh.vertices.len(), 4);
}

#[test]
fn normals_are_averaged_within_a_group_and_not_across() {
    let edge = Vec3::new(0.0, 1.0, 1.0).normalize();
    for (first, second, smooth) in [
        ("1", "1", true),
        ("1", "2", false),
        ("on", "on", true),
        ("1", "off", false),
        ("7", "1\ns 7", true),
    ] {
        let mesh = obj_mesh(format!("{BENT}s {first}\nf 1 2 3\ns {second}\nf 2 1 4\n"));
        let expected = if smooth { edge } else { Vec3::Z };
        assert_eq!(normals(&mesh, 0)[0], expected, "{first} {second}");
    }
}

#[test]
fn a_facet_of_many_corners_has_one_normal() {
    let mesh = obj_mesh("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\ns off\nf 1 2 3 4 5\n");
    assert_eq!(mesh.vertices.len(), 5);
    assert!(mesh.vertices.iter().all(|vertex| vertex.normal == Vec3::Z));
}

#[test]
fn the_files_normals_come_before_its_smoothing_groups() {
    let mesh = obj_mesh(format!(
        "{BENT}vn 1 0 0\ns off\nf 1//1 2//1 3//1\nf 2//1 1//1 4\n"
    ));
    assert_eq!(normals(&mesh, 0), [Vec3::X; 3]);
    assert_eq!(normals(&mesh, 1), [Vec3::X, Vec3::X, Vec3::Y]);
    // Corners with a normal are shared, whatever the facet.
    assert_eq!(mesh.vertices.len(), 4);
}
