//! Models that cannot be used: each is refused with its file, line and word, and with what to do.

mod scene_kit;

use std::fs::File;

use scene_kit::{Folder, Refused, bad_obj, refused};

/// Three vertices, so that the next line is the fourth.
const THREE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// The error of a model whose fourth line is this, and the last one a face.
#[track_caller]
fn bad_line(line: &str) -> Refused {
    bad_obj(format!("{THREE}{line}\nf 1 2 3\n"))
}

/// The error of a model with materials of this content.
#[track_caller]
fn bad_materials(materials: impl AsRef<[u8]>) -> Refused {
    let folder = Folder::new()
        .with("m.obj", format!("mtllib m.mtl\n{THREE}usemtl a\nf 1 2 3\n"))
        .with("m.mtl", materials);
    let error = refused(folder.load("m.obj"));
    assert_eq!(error.file, "m.mtl");
    error
}

#[test]
fn a_missing_file() {
    let error = refused(Folder::new().load("gone.obj"));
    assert_eq!(error.file, "gone.obj");
    error.says("no such file");
}

#[test]
fn a_directory() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("d.obj")).expect("a folder");
    refused(folder.load("d.obj")).says("directory");
}

#[test]
#[cfg(unix)]
fn a_device_that_never_ends() {
    let folder = Folder::new();
    std::os::unix::fs::symlink("/dev/zero", folder.path("d.obj")).expect("a link");
    refused(folder.load("d.obj")).says("device");
}

#[test]
fn another_extension() {
    let folder = Folder::new().with("m.stl", "solid");
    refused(folder.load("m.stl"))
        .says("neither")
        .suggests(".obj");
}

#[test]
fn an_empty_file() {
    bad_obj("").says("empty");
}

#[test]
fn a_file_of_comments() {
    bad_obj("# nothing\n\n").says("no faces");
}

#[test]
fn vertices_without_faces() {
    bad_obj(THREE).says("no faces, only vertices");
}

#[test]
fn lines_without_faces() {
    bad_obj(format!("{THREE}l 1 2 3\n")).says("only lines");
}

#[test]
fn a_binary_file() {
    bad_obj(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR")
        .says("binary")
        .suggests("UTF-8");
}

#[test]
fn a_file_in_utf_16() {
    let utf16: Vec<u8> = "v 0 0 0\n"
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    bad_obj(utf16).says("UTF-16");
}

#[test]
fn bytes_that_are_not_utf_8() {
    let error = bad_obj(b"v 0 0 0\nv 1 \xff\xfe 0\n");
    assert_eq!(error.line, Some(2));
    error.says("UTF-8");
}

#[test]
fn a_gigantic_file_is_refused_by_its_size() {
    let folder = Folder::new();
    let file = File::create(folder.path("huge.obj")).expect("a file");
    // Sparse: it takes no room on the disk, and reading it would take minutes and all memory.
    file.set_len((2 << 30) + 1).expect("a sparse file");
    refused(folder.load("huge.obj")).says("2 GiB");
}

#[test]
fn a_large_file_of_zeroes_is_refused_by_its_head() {
    let folder = Folder::new();
    let file = File::create(folder.path("zero.obj")).expect("a file");
    file.set_len(2 << 30).expect("a sparse file");
    refused(folder.load("zero.obj")).says("binary");
}

#[test]
fn a_vertex_cut_off() {
    bad_obj(format!("{THREE}f 1 2 3\nv 1.0 2"))
        .at(5, "1.0 2")
        .says("2 numbers")
        .suggests("cut off");
}

#[test]
fn a_vertex_with_five_numbers() {
    bad_line("v 1 2 3 4 5").at(4, "1 2 3 4 5").says("5 numbers");
}

#[test]
fn a_face_cut_off_after_two_corners() {
    bad_obj(format!("{THREE}f 1 2"))
        .at(4, "1 2")
        .says("three corners")
        .suggests("cut off");
}

#[test]
fn a_face_cut_off_after_a_slash() {
    bad_obj(format!("{THREE}f 1/"))
        .at(4, "1/")
        .says("missing")
        .suggests("cut off");
}

#[test]
fn a_face_cut_off_after_its_keyword() {
    bad_obj(format!("{THREE}f")).says("three corners");
}

#[test]
fn a_normal_index_cut_off() {
    bad_obj(format!("{THREE}vn 0 0 1\nf 1//1 2//1 3//"))
        .at(5, "3//")
        .says("normal");
}

#[test]
fn a_word_that_is_not_a_number() {
    bad_line("v 1,0 2 3").at(4, "1,0").says("not a number");
}

#[test]
fn a_vertex_of_nan() {
    bad_line("v 0 NaN 0").at(4, "NaN").says("finite");
}

#[test]
fn an_infinite_vertex() {
    bad_line("v 0 0 -inf").at(4, "-inf").says("finite");
}

#[test]
fn a_number_beyond_32_bits() {
    bad_line("v 1e39 0 0").at(4, "1e39").says("finite");
}

#[test]
fn a_weight_of_zero() {
    bad_line("v 1 1 1 0").at(4, "0").says("divided");
}

#[test]
fn a_normal_of_nan() {
    bad_line("vn 0 nan 0").at(4, "nan").says("finite");
}

#[test]
fn a_colour_from_0_to_255() {
    bad_line("v 0 0 0 255 128 0").at(4, "255").suggests("255");
}

#[test]
fn an_index_of_zero() {
    bad_line("f 0 1 2")
        .at(4, "0")
        .says("no vertex 0")
        .suggests("count from 1");
}

#[test]
fn an_index_beyond_the_vertices() {
    bad_line("f 1 2 4")
        .at(4, "4")
        .says("no vertex 4: 3 are defined");
}

#[test]
fn a_negative_index_before_the_first_vertex() {
    bad_line("f -1 -2 -4").at(4, "-4").says("no vertex -4");
}

#[test]
fn an_index_beyond_64_bits() {
    bad_line("f 1 2 99999999999999999999").at(4, "99999999999999999999");
}

#[test]
fn the_smallest_64_bit_index() {
    bad_line("f 1 2 -9223372036854775808").says("no vertex");
}

#[test]
fn an_index_with_a_fraction() {
    bad_line("f 1 2 2.5").at(4, "2.5").says("not the index");
}

#[test]
fn a_normal_index_beyond_the_normals() {
    bad_line("f 1//1 2//1 3//1")
        .at(4, "1//1")
        .says("no normal 1");
}

#[test]
fn a_texture_index_beyond_the_texture_coordinates() {
    bad_line("vt 0 0\nf 1/1 2/1 3/2")
        .at(5, "3/2")
        .says("no texture coordinate 2");
}

#[test]
fn a_corner_with_four_indices() {
    bad_line("f 1/1/1/1 2 3").says("normal 1");
    bad_line("vn 0 0 1\nf 1//1/1 2 3")
        .at(5, "1//1/1")
        .says("at most three");
}

#[test]
fn a_face_of_absurdly_many_corners() {
    bad_line(&format!("f{}", " 1".repeat(70_000))).says("70000 corners");
}

#[test]
fn a_material_without_a_name() {
    bad_line("usemtl").at(4, "usemtl").says("name");
}

#[test]
fn a_material_of_a_colour_cut_off() {
    bad_materials("newmtl a\nKd 0.5 0.")
        .at(2, "0.5 0.")
        .says("2");
}

#[test]
fn a_material_of_a_colour_that_is_no_number() {
    bad_materials("newmtl a\nKd red\n")
        .at(2, "red")
        .says("not a number");
}

#[test]
fn a_material_of_a_colour_out_of_range() {
    bad_materials("newmtl a\nKd 0 0 2\n")
        .at(2, "2")
        .says("between 0 and 1");
}

#[test]
fn a_material_of_an_opacity_out_of_range() {
    bad_materials("newmtl a\n\nd 1.5\n")
        .at(3, "1.5")
        .says("between 0 and 1");
}

#[test]
fn a_material_without_its_opacity() {
    bad_materials("newmtl a\nd\n").at(2, "d").says("missing");
}

#[test]
fn a_material_of_nan() {
    bad_materials("newmtl a\nTr nan\n")
        .at(2, "nan")
        .says("finite");
}

#[test]
fn a_material_of_spectral_colours() {
    bad_materials("newmtl a\nKd spectral a.rfl\n").at(2, "spectral");
}

#[test]
fn a_colour_of_no_material() {
    bad_materials("Kd 1 1 1\n")
        .at(1, "1 1 1")
        .says("no material");
}

#[test]
fn a_nameless_material() {
    bad_materials("newmtl\n").at(1, "newmtl").says("name");
}

#[test]
fn a_binary_material_file() {
    bad_materials(b"a\0b").says("binary");
}

#[test]
fn a_long_word_is_cut_in_the_message() {
    let error = bad_line(&format!("v {} 0 0", "x".repeat(1_000_000)));
    assert!(error.token.expect("a token").chars().count() <= 41);
}
