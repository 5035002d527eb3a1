//! OBJ models: their materials and colours.

mod scene_kit;

use onionskin::fragment::Rgba;
use onionskin::scene::Shading;
use scene_kit::model::{CORNERS, colors, of_material_a, with_materials};
use scene_kit::{Folder, obj, obj_mesh};

#[test]
fn kd_is_the_colour_and_d_the_opacity() {
    let scene = with_materials(
        &of_material_a(),
        "newmtl a\nKa 0 0 0\nKd 0.5 0.25 1\nd 0.75\n",
    );
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::new(0.5, 0.25, 1.0, 0.75));
    assert!(!scene.meshes[0].opaque);
}

#[test]
fn without_kd_ka_is_the_colour() {
    let scene = with_materials(&of_material_a(), "newmtl a\nKa 0.5 0.5 0\n");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([0.5, 0.5, 0.0]));
}

#[test]
fn tr_is_transparency() {
    let scene = with_materials(&of_material_a(), "newmtl a\nTr 0.25\n");
    assert_eq!(colors(&scene.meshes[0])[0].a, 0.75);
}

#[test]
fn d_wins_over_tr_whichever_comes_first() {
    for materials in ["newmtl a\nd 0.5\nTr 0.75\n", "newmtl a\nTr 0.75\nd 0.5\n"] {
        let scene = with_materials(&of_material_a(), materials);
        assert_eq!(colors(&scene.meshes[0])[0].a, 0.5, "{materials}");
    }
}

#[test]
fn one_number_is_a_grey() {
    let scene = with_materials(&of_material_a(), "newmtl a\nKd 0.5\n");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([0.5; 3]));
}

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
fn textures_are_a_notice() {
    let scene = with_materials(
        &of_material_a(),
        "newmtl a\nmap_Kd wood.png\nKs 1 1 1\nillum 2\n",
    );
    assert!(scene.notices[0].contains("textures"), "{:?}", scene.notices);
}

#[test]
fn vertex_colours_come_before_the_scene_files_colour() {
    let scene = Folder::new()
        .with(
            "s.toml",
            "[[mesh]]\nfile = \"m.obj\"\ncolor = [0, 0, 1]\nopacity = 0.5\n",
        )
        .with(
            "m.obj",
            "v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3\n",
        )
        .load("s.toml")
        .expect("it loads");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::new(1.0, 0.0, 0.0, 0.5));
}

#[test]
fn the_scene_files_colour_and_opacity_come_before_the_materials() {
    let scene = Folder::new()
        .with(
            "s.toml",
            "[[mesh]]\nfile = \"m.obj\"\ncolor = [0, 0, 1]\nopacity = 0.5\n",
        )
        .with("m.obj", of_material_a())
        .with("m.mtl", "newmtl a\nKd 1 0 0\nd 0.25\n")
        .load("s.toml")
        .expect("it loads");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::new(0.0, 0.0, 1.0, 0.5));
}

#[test]
fn without_any_colour_a_model_is_white_and_opaque() {
    let mesh = obj_mesh(format!("{CORNERS}f 1 2 3\n"));
    assert_eq!(colors(&mesh)[0], Rgba::opaque([1.0; 3]));
    assert!(mesh.opaque);
}

#[test]
fn a_bare_model_is_lit_and_named_after_its_file() {
    let scene = obj(format!("{CORNERS}f 1 2 3\n"));
    assert_eq!(scene.meshes[0].shading, Shading::Lit);
    assert_eq!(scene.name, "model");
}
