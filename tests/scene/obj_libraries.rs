//! OBJ models: the files that their materials are in.

use super::obj_materials::{color_of, said};
use crate::kit::scene::model::{CORNERS, colors, of_material_a, with_materials};
use crate::kit::scene::{Folder, obj};
use onionskin::Rgba;

#[test]
fn materials_may_come_from_several_files_in_one_line() {
    let scene = Folder::new()
        .with(
            "m.obj",
            format!("mtllib a.mtl b.mtl\n{CORNERS}usemtl b\nf 1 2 3\n"),
        )
        .with("a.mtl", "newmtl a\nKd 1 0 0\n")
        .with("b.mtl", "newmtl b\nKd 0 1 0\n")
        .load("m.obj")
        .expect("it loads");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([0.0, 1.0, 0.0]));
    assert!(scene.notices.is_empty());
}

#[test]
fn a_material_files_name_may_have_spaces() {
    let scene = Folder::new()
        .with(
            "m.obj",
            format!("mtllib my colours.mtl\n{CORNERS}usemtl a\nf 1 2 3\n"),
        )
        .with("my colours.mtl", "newmtl a\nKd 1 0 0\n")
        .load("m.obj")
        .expect("it loads");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([1.0, 0.0, 0.0]));
}

#[test]
fn a_missing_material_file_is_a_notice_and_the_model_is_white() {
    let scene = obj(format!("{CORNERS}mtllib gone.mtl\nusemtl red\nf 1 2 3\n"));
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([1.0; 3]));
    assert_eq!(scene.notices.len(), 2, "{:?}", scene.notices);
    assert!(
        scene.notices[0].contains("model.obj:5: the material file"),
        "{}",
        scene.notices[0]
    );
    assert!(
        scene.notices[1].contains("the material 'red' is not defined"),
        "{}",
        scene.notices[1]
    );
}

#[test]
fn many_missing_materials_are_one_notice() {
    let scene = obj(format!(
        "{CORNERS}usemtl b\nf 1 2 3\nusemtl a\nf 1 2 3\nusemtl c\nf 1 2 3\n"
    ));
    assert_eq!(scene.notices.len(), 1, "{:?}", scene.notices);
    let notice = &scene.notices[0];
    assert!(
        notice.contains("model.obj:5: the material 'b' and 2 others are not defined"),
        "{notice}"
    );
}

#[test]
fn a_material_file_without_a_name_is_no_file() {
    let scene = obj(format!("{CORNERS}mtllib\nf 1 2 3\n"));
    assert_eq!(scene.triangle_count(), 1);
}

#[test]
fn a_million_names_of_material_files_are_not_all_looked_for() {
    for line in [
        "mtllib gone.mtl gone again.mtl ",
        "mtllib a b c d e f g h i j ",
    ] {
        let mut model = of_material_a();
        for i in 0..20_000 {
            model.push_str(&format!("{line}{i}.mtl\n"));
        }
        model.push_str(&line.repeat(100_000));
        let scene = with_materials(model, "newmtl a\nKd 1 0 0\n");
        assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([1.0, 0.0, 0.0]));
        said(&scene, "more than are looked for");
    }
}

#[test]
fn the_first_of_several_files_wins() {
    for line in ["mtllib a.mtl b.mtl", "mtllib a.mtl\nmtllib b.mtl"] {
        let scene = Folder::new()
            .with("m.obj", format!("{line}\n{CORNERS}usemtl g\nf 1 2 3\n"))
            .with("a.mtl", "newmtl g\nKd 1 0 0\n")
            .with("b.mtl", "newmtl g\nKd 0 1 0\nd 0.25\n")
            .load("m.obj")
            .expect("it loads");
        assert_eq!(
            colors(&scene.meshes[0])[0],
            Rgba::opaque([1.0, 0.0, 0.0]),
            "{line}"
        );
    }
}

#[test]
fn the_first_definition_of_a_file_wins_and_that_is_said() {
    let (color, scene) = color_of("newmtl a\nKd 1 0 0\nnewmtl a\nKd 0 1 0\n");
    assert_eq!(color, Rgba::opaque([1.0, 0.0, 0.0]));
    said(
        &scene,
        "m.mtl:3: 1 material defined more than once, the first is 'a'",
    );
}

#[test]
fn a_material_file_is_found_by_the_name_that_a_program_gave_it() {
    let names: [(&[u8], &str); 9] = [
        (b"\"m.mtl\"", "m.mtl"),
        (b"'my m.mtl'", "my m.mtl"),
        (b".\\m.mtl", "m.mtl"),
        (b"C:\\models\\old ones\\m.mtl", "m.mtl"),
        (b"/home/someone/m.mtl", "m.mtl"),
        (b"M.MTL", "m.mtl"),
        (b"m.mtl", "M.Mtl"),
        (b"gr\xfcn.mtl", "gr\u{fc}n.mtl"),
        (b"gone.mtl my m.mtl", "my m.mtl"),
    ];
    for (name, file) in names {
        let model = [
            b"mtllib ",
            name,
            b"\n",
            of_material_a().replace("mtllib m.mtl\n", "").as_bytes(),
        ]
        .concat();
        let folder = Folder::new()
            .with("m.obj", model)
            .with(file, "newmtl a\nKd 1 0 0\n");
        let scene = folder.load("m.obj").expect("it loads");
        let red = Rgba::opaque([1.0, 0.0, 0.0]);
        assert_eq!(
            colors(&scene.meshes[0])[0],
            red,
            "{}",
            String::from_utf8_lossy(name)
        );
    }
}

#[test]
#[cfg(unix)]
fn a_material_file_may_be_named_in_any_bytes() {
    use std::os::unix::ffi::OsStrExt;
    let model = [b"mtllib gr\xfcn.mtl\n", of_material_a().as_bytes()].concat();
    let folder = Folder::new().with("m.obj", model);
    let path = folder
        .path("")
        .join(std::ffi::OsStr::from_bytes(b"gr\xfcn.mtl"));
    std::fs::write(path, "newmtl a\nKd 1 0 0\n").expect("a file");
    let scene = folder.load("m.obj").expect("it loads");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([1.0, 0.0, 0.0]));
}

#[test]
fn a_material_file_that_cannot_be_used_is_as_good_as_missing() {
    let scene = with_materials(of_material_a(), b"newmtl a\0");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([1.0; 3]));
    said(&scene, "m.mtl:1: this is a binary file");
    let folder = Folder::new().with("m.obj", of_material_a());
    std::fs::create_dir(folder.path("m.mtl")).expect("a folder");
    let scene = folder.load("m.obj").expect("it loads");
    said(&scene, "the material file 'm.mtl' is missing");
}
