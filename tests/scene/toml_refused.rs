//! Scene files: what is wrong with a value is said where it stands.

use crate::kit::scene::square::square_with;
use crate::kit::scene::{Folder, Refused, bad_toml, refused};

/// The error of a mesh with this as its third line.
#[track_caller]
fn bad_mesh(keys: &str) -> Refused {
    refused(square_with(keys))
}

/// The error of a camera with this as its second line.
#[track_caller]
fn bad_camera(keys: &str) -> Refused {
    bad_toml(&format!("[camera]\n{keys}\n"))
}

#[test]
fn a_missing_scene_file() {
    refused(Folder::new().load("gone.toml")).says("no such file");
}

#[test]
fn a_missing_model_says_where_paths_start() {
    let folder = Folder::new().with("s.toml", "[[mesh]]\nfile = \"gone.obj\"\n");
    refused(folder.load("s.toml"))
        .says("no such file")
        .suggests("scene file's folder");
}

#[test]
fn a_file_that_is_not_toml() {
    bad_toml("size = [1, 2\nbackground = 3\n").says("not TOML");
}

#[test]
fn a_repeated_key() {
    let error = bad_toml("size = [1, 2]\nsize = [1, 2]\n").says("not TOML");
    assert_eq!(error.line, Some(2));
}

#[test]
fn a_file_that_is_not_utf_8() {
    let folder = Folder::new().with("s.toml", b"# a\n# \xff\n");
    let error = refused(folder.load("s.toml")).says("UTF-8");
    assert_eq!(error.line, Some(2));
}

#[test]
fn a_binary_file() {
    let folder = Folder::new().with("s.toml", b"\0\0");
    refused(folder.load("s.toml")).says("binary");
}

#[test]
fn an_unknown_key_at_the_top_is_told_from_a_misspelt_one() {
    bad_toml("\nsise = [1, 1]\n")
        .at(2, "sise")
        .suggests("Did you mean 'size'?");
    let error = bad_toml("wibble = 1\n").at(1, "wibble");
    assert!(!error.remedy.contains("Did you mean"), "{error:?}");
    error.suggests("size, background, camera, path, mesh");
}

#[test]
fn the_first_unknown_key_in_the_file_is_named() {
    bad_toml("zz = 1\naa = 2\n").at(1, "zz");
}

#[test]
fn an_unknown_key_of_the_camera() {
    bad_camera("eyes = [0, 0, 1]")
        .at(2, "eyes")
        .says("[camera]")
        .suggests("'eye'");
}

#[test]
fn an_unknown_key_of_a_mesh() {
    bad_mesh("colour = [0, 0, 1]")
        .at(3, "colour")
        .says("[[mesh]]")
        .suggests("'color'");
}

#[test]
fn an_unknown_key_of_a_transform() {
    bad_mesh("transform = { move = [0, 0, 1] }")
        .at(3, "move")
        .suggests("translate");
    bad_mesh("transform = { rotate = { axis = [0, 0, 1], angle = 3 } }").at(3, "angle");
}

#[test]
fn a_parameter_of_another_generator_is_an_unknown_key() {
    bad_toml("[[mesh]]\ngenerate = \"quads\"\nsegments = 3\n")
        .at(3, "segments")
        .suggests("spacing");
}

#[test]
fn a_generator_with_colours_of_its_own_takes_no_other() {
    bad_toml("[[mesh]]\ngenerate = \"quads\"\ncolor = [1, 0, 0]\n")
        .at(3, "color")
        .suggests("colors");
}

#[test]
fn an_unknown_generator() {
    bad_toml("[[mesh]]\ngenerate = \"teepot\"\n")
        .at(2, "\"teepot\"")
        .suggests("\"teapot\"");
}

#[test]
fn an_unknown_shading() {
    bad_mesh("shading = \"twosided\"")
        .at(3, "\"twosided\"")
        .suggests("\"two-sided\"");
}

#[test]
fn a_mesh_without_geometry() {
    bad_toml("[[mesh]]\ncolor = [1, 0, 0]\n")
        .says("without geometry")
        .suggests("torus-knot");
}

#[test]
fn a_mesh_with_two_geometries() {
    bad_mesh("generate = \"soup\"")
        .at(3, "\"soup\"")
        .says("either");
}

#[test]
fn a_model_in_another_format() {
    bad_toml("[[mesh]]\nfile = \"m.ply\"\n")
        .at(2, "\"m.ply\"")
        .suggests(".obj");
}

#[test]
fn meshes_as_one_table() {
    bad_toml("[mesh]\nfile = \"m.obj\"\n").suggests("[[mesh]]");
}

#[test]
fn a_size_of_0() {
    bad_toml("size = [0, 100]\n")
        .at(1, "0")
        .suggests("1 to 65535");
}

#[test]
fn a_size_beyond_65535() {
    bad_toml("size = [100, 65536]\n").at(1, "65536");
}

#[test]
fn a_negative_size() {
    bad_toml("size = [-1, 100]\n")
        .at(1, "-1")
        .suggests("1 to 65535");
}

#[test]
fn a_size_with_a_fraction() {
    bad_toml("size = [1.5, 100]\n")
        .at(1, "1.5")
        .says("a number")
        .suggests("whole number");
}

#[test]
fn a_size_of_three() {
    bad_toml("size = [1, 2, 3]\n")
        .at(1, "[1, 2, 3]")
        .suggests("two whole numbers");
}

#[test]
fn a_size_that_is_text() {
    bad_toml("size = \"large\"\n")
        .at(1, "\"large\"")
        .says("text");
}

#[test]
fn a_background_out_of_range() {
    bad_toml("background = [0, 0, 1.5]\n")
        .at(1, "1.5")
        .suggests("0 to 1");
}

#[test]
fn colours_of_nan_and_infinity() {
    bad_mesh("color = [nan, 0, 0]").at(3, "nan");
    bad_mesh("color = [0, inf, 0]").at(3, "inf");
    bad_mesh("color = [0, 0, -0.1]").at(3, "-0.1");
}

#[test]
fn an_opacity_out_of_range() {
    bad_mesh("opacity = 1.01")
        .at(3, "1.01")
        .says("out of range");
    bad_mesh("opacity = -0.01").at(3, "-0.01");
    bad_mesh("opacity = nan").at(3, "nan");
    bad_mesh("opacity = \"half\"")
        .at(3, "\"half\"")
        .suggests("number from 0 to 1");
}

#[test]
fn an_inside_out_of_range() {
    bad_mesh("shading = \"two-sided\"\ninside = [2, 0, 0]").at(4, "2");
}

#[test]
fn sorted_that_is_a_number() {
    bad_mesh("sorted = 1").at(3, "1").suggests("true or false");
}

#[test]
fn a_field_of_view_out_of_range() {
    bad_camera("fov = 0").at(2, "0");
    bad_camera("fov = 180")
        .at(2, "180")
        .suggests("less than 180");
    bad_camera("fov = nan").at(2, "nan");
}

#[test]
fn a_near_plane_that_is_not_in_front() {
    bad_camera("near = 0").at(2, "0");
    bad_camera("near = -1").at(2, "-1");
    bad_camera("near = inf").at(2, "inf");
}

#[test]
fn a_far_plane_that_is_not_beyond_near() {
    bad_camera("near = 2\nfar = 1").at(3, "1").says("far");
    bad_camera("near = 2\nfar = 2").at(3, "2").says("far");
}

#[test]
fn an_eye_at_the_target() {
    bad_camera("eye = [1, 2, 3]\ntarget = [1, 2, 3]")
        .at(3, "[1, 2, 3]")
        .says("where the eye is");
}

#[test]
fn an_up_along_the_view() {
    bad_camera("eye = [0, 0, 5]\ntarget = [0, 0, 0]\nup = [0, 0, 1]")
        .at(4, "[0, 0, 1]")
        .says("view direction");
}

#[test]
fn an_up_of_zero() {
    bad_camera("up = [0, 0, 0]").at(2, "[0, 0, 0]");
}

#[test]
fn an_eye_of_nan() {
    bad_camera("eye = [0, nan, 0]").at(2, "nan");
    bad_camera("eye = [0, 0, 1e300]")
        .at(2, "1e300")
        .suggests("32 bits");
}

#[test]
fn a_scale_of_zero() {
    bad_mesh("transform = { scale = 0 }")
        .at(3, "0")
        .says("out of range");
    bad_mesh("transform = { scale = [1, 0, 1] }").at(3, "0");
}

#[test]
fn a_rotation_without_an_axis_or_an_angle() {
    bad_mesh("transform = { rotate = { degrees = 3 } }").says("`axis` is missing");
    bad_mesh("transform = { rotate = { axis = [0, 1, 0] } }").says("`degrees` is missing");
    bad_mesh("transform = { rotate = { axis = [0, 0, 0], degrees = 3 } }").says("length zero");
}

#[test]
fn a_transform_out_of_range() {
    let folder = Folder::new()
        .with("m.obj", "v 0 0 0\nv 3e38 0 0\nv 0 1 0\nf 1 2 3\n")
        .with(
            "s.toml",
            "[[mesh]]\nfile = \"m.obj\"\ntransform = { scale = 2 }\n",
        );
    refused(folder.load("s.toml"))
        .at(3, "{ scale = 2 }")
        .says("out of the range");
}

#[test]
fn a_generators_parameter_out_of_range_stands_at_its_line() {
    bad_toml("[[mesh]]\ngenerate = \"quads\"\ncount = 0\n")
        .at(3, "0")
        .says("count");
    bad_toml("[[mesh]]\ngenerate = \"quads\"\nalpha = 2.0\n")
        .at(3, "2.0")
        .says("alpha");
    bad_toml("[[mesh]]\ngenerate = \"soup\"\nseed = -1\n").at(3, "-1");
}

#[test]
fn too_many_generated_triangles_in_one_mesh() {
    bad_toml("[[mesh]]\ngenerate = \"soup\"\ncount = 20_000_001\n")
        .at(3, "20_000_001")
        .says("20000000");
}

#[test]
fn too_many_generated_triangles_in_all() {
    let one = "[[mesh]]\ngenerate = \"plane\"\ncells = 700\n";
    // 2 x 700 x 700 and 2 x 3100 x 3100; either alone is fine.
    let error = bad_toml(&format!(
        "{one}[[mesh]]\ngenerate = \"plane\"\ncells = 3100\n"
    ))
    .at(5, "\"plane\"");
    error.says("20200000 triangles");
}

#[test]
fn the_message_as_a_whole_reads_well() {
    let folder = Folder::new().with("s.toml", "[camera]\nfov = 200\n");
    let error = folder.load("s.toml").expect_err("out of range").to_string();
    let (place, rest) = error.split_once("s.toml").expect("the file's name");
    assert!(!place.is_empty());
    assert_eq!(
        rest,
        ":2: '200': `fov` is out of range\n  This must be an angle in degrees, more than 0 and less than 180."
    );
}
