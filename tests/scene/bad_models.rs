//! Models that cannot be used: each is refused with its file, line and word, and with what to do.

use std::fs::File;

use crate::kit::scene::{Folder, Refused, bad_obj, refused};

/// Three vertices, so that the next line is the fourth.
const THREE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

/// The error of a model whose fourth line is this, and the last one a face.
#[track_caller]
fn bad_line(line: &str) -> Refused {
    bad_obj(format!("{THREE}{line}\nf 1 2 3\n"))
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
fn faces_whose_vertices_all_have_no_place() {
    bad_obj("v 0 0 0\nv 1 0 1.#INF\nv 0 1 0\nf 1 2 3\n")
        .at(2, "1.#INF")
        .says("no place that can be read")
        .suggests("finite");
}

#[test]
fn faces_that_all_have_too_few_corners() {
    bad_obj(format!("{THREE}f 1 2\nf 1/\n"))
        .at(4, "1 2")
        .says("fewer than three corners")
        .suggests("cut off");
}

#[test]
fn a_corner_without_a_vertex() {
    bad_line("f 1 2 /3").at(4, "/3").says("missing");
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
fn a_face_of_absurdly_many_corners() {
    bad_line(&format!("f{}", " 1".repeat(70_000))).says("70000 corners");
}

#[test]
fn a_long_word_is_cut_in_the_message() {
    let error = bad_line(&format!("f 1 2 {}", "x".repeat(1_000_000)));
    assert!(error.token.expect("a token").chars().count() <= 41);
}
