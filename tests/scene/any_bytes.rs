//! Whatever the bytes, there is a scene or an error: no panic, and nothing but finite numbers.

use crate::kit::scene::Folder;
use onionskin::{Error, Scene};
use proptest::prelude::*;

/// A result as it should be: an error about the input, or a scene that can be drawn.
fn check(result: Result<Scene, Error>) -> Result<(), TestCaseError> {
    match result {
        Err(Error::Input { remedy, .. }) => prop_assert!(!remedy.is_empty()),
        Err(Error::Memory { .. }) => {}
        Err(other) => prop_assert!(false, "{other:?}"),
        Ok(scene) => {
            prop_assert!(scene.camera.check().is_ok(), "{:?}", scene.camera);
            for mesh in &scene.meshes {
                prop_assert!(mesh.is_finite());
                let count = mesh.vertices.len() as u32;
                prop_assert!(mesh.triangles.as_flattened().iter().all(|&v| v < count));
            }
        }
    }
    Ok(())
}

/// Words that mean something to one of the readers, and some that almost do.
fn word() -> impl Strategy<Value = String> {
    let obj = prop::sample::select(vec![
        "v", "vn", "vt", "f", "l", "p", "o", "g", "usemtl", "mtllib", "newmtl", "Kd", "Ka", "d",
        "Tr", "s", "#", "\\", "0", "1", "2", "3", "-1", "-2", "1/1", "1//1", "1/1/1", "/", "//",
        "0.5", "1e38", "-1e38", "1e-45", "nan", "inf", "m.mtl", "red", "é", "\u{feff}",
    ]);
    let toml = prop::sample::select(vec![
        "size",
        "background",
        "[camera]",
        "[[mesh]]",
        "[[volume]]",
        "=",
        "[",
        "]",
        "{",
        "}",
        ",",
        "eye",
        "fov",
        "generate",
        "file",
        "\"teapot\"",
        "\"quads\"",
        "\"soup\"",
        "\"m.obj\"",
        "count",
        "cells",
        "transform",
        "scale",
        "0x10",
        "1_0",
        "true",
        "1979-05-27",
        "'",
        "\"\"\"",
    ]);
    prop_oneof![obj.prop_map(str::to_owned), toml.prop_map(str::to_owned)]
}

fn lines() -> impl Strategy<Value = String> {
    let line = prop::collection::vec(word(), 0..8).prop_map(|words| words.join(" "));
    prop::collection::vec(line, 0..20).prop_map(|lines| lines.join("\n"))
}

/// Mostly valid models: three vertices, then anything.
fn models() -> impl Strategy<Value = String> {
    let number = prop::sample::select(vec!["0", "1", "-1", "0.5", "3e38", "-3e38", "1e-40"]);
    let vertex = prop::collection::vec(number, 3..=3).prop_map(|n| format!("v {}", n.join(" ")));
    let face = prop::collection::vec(-4..=4_i32, 3..6).prop_map(|indices| {
        let words = indices.into_iter().map(|i| if i == 0 { 1 } else { i });
        format!(
            "f {}",
            words.map(|i| i.to_string()).collect::<Vec<_>>().join(" ")
        )
    });
    let vertices = prop::collection::vec(vertex, 4..8);
    let faces = prop::collection::vec(prop_oneof![4 => face, 1 => lines()], 1..6);
    (vertices, faces).prop_map(|(vertices, faces)| [vertices, faces].concat().join("\n"))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn no_bytes_make_the_obj_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        check(Folder::new().with("m.obj", bytes).load("m.obj"))?;
    }

    #[test]
    fn no_words_make_the_obj_reader_panic(text in lines()) {
        check(Folder::new().with("m.obj", text).load("m.obj"))?;
    }

    #[test]
    fn no_model_is_drawn_with_anything_but_finite_numbers(text in models()) {
        check(Folder::new().with("m.obj", text).load("m.obj"))?;
    }

    #[test]
    fn no_words_make_the_mtl_reader_panic(text in lines()) {
        let model = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n";
        let text = format!("newmtl red\n{text}");
        check(Folder::new().with("m.obj", model).with("m.mtl", text).load("m.obj"))?;
    }

    #[test]
    fn no_bytes_make_the_toml_reader_panic(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        check(Folder::new().with("s.toml", bytes).load("s.toml"))?;
    }

    #[test]
    fn no_words_make_the_toml_reader_panic(text in lines()) {
        check(Folder::new().with("s.toml", text).load("s.toml"))?;
    }

    #[test]
    fn no_cut_makes_a_scene_file_panic(cut in 0_usize..600) {
        let whole = include_str!("../../examples/scenes/teapot.toml");
        let end = whole.floor_char_boundary(cut.min(whole.len()));
        check(Folder::new().with("s.toml", &whole[..end]).load("s.toml"))?;
    }
}
