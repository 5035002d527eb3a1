//! OBJ models: their materials and colours.

use crate::kit::scene::model::{CORNERS, colors, of_material_a, with_materials};
use crate::kit::scene::{Folder, obj, obj_mesh};
use onionskin::fragment::Rgba;
use onionskin::scene::{Scene, Shading};

/// Whether the scene has this notice.
#[track_caller]
fn said(scene: &Scene, part: &str) {
    let notices = &scene.notices;
    assert!(
        notices.iter().any(|notice| notice.contains(part)),
        "{notices:?}"
    );
}

/// The colour that a triangle has whose material `a` is defined like this.
fn color_of(materials: impl AsRef<[u8]>) -> (Rgba, Scene) {
    let scene = with_materials(of_material_a(), materials);
    (colors(&scene.meshes[0])[0], scene)
}

#[test]
fn kd_is_the_colour_and_d_the_opacity() {
    let scene = with_materials(
        of_material_a(),
        "newmtl a\nKa 0 0 0\nKd 0.5 0.25 1\nd 0.75\n",
    );
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::new(0.5, 0.25, 1.0, 0.75));
    assert!(!scene.meshes[0].opaque);
}

#[test]
fn without_kd_ka_is_the_colour() {
    let scene = with_materials(of_material_a(), "newmtl a\nKa 0.5 0.5 0\n");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([0.5, 0.5, 0.0]));
}

#[test]
fn tr_is_transparency() {
    let scene = with_materials(of_material_a(), "newmtl a\nTr 0.25\n");
    assert_eq!(colors(&scene.meshes[0])[0].a, 0.75);
}

#[test]
fn d_wins_over_tr_whichever_comes_first() {
    for materials in ["newmtl a\nd 0.5\nTr 0.75\n", "newmtl a\nTr 0.75\nd 0.5\n"] {
        let scene = with_materials(of_material_a(), materials);
        assert_eq!(colors(&scene.meshes[0])[0].a, 0.5, "{materials}");
    }
}

#[test]
fn one_number_is_a_grey() {
    let scene = with_materials(of_material_a(), "newmtl a\nKd 0.5\n");
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
fn textures_and_opacity_maps_are_notices() {
    let scene = with_materials(
        of_material_a(),
        "newmtl a\nmap_Kd wood.png\nKs 1 1 1\nillum 2\nmap_d holes.png\nmap_Ks s.png\n",
    );
    said(
        &scene,
        "m.mtl:5: an opacity map in 1 material, the first is 'holes.png'",
    );
    said(
        &scene,
        "m.mtl:2: a texture in 1 material, the first is 'wood.png'",
    );
    said(&scene, "m.mtl:6: other textures in 1 material");
    assert_eq!(scene.notices.len(), 3);
}

#[test]
fn textures_of_materials_that_are_not_used_are_no_notice() {
    let scene = with_materials(of_material_a(), "newmtl a\nnewmtl b\nmap_Kd wood.png\n");
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
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

#[test]
fn tr_is_opacity_where_its_writer_writes_that() {
    for comment in [
        "# wavefront mtl file written by the visualization toolkit",
        "#\n# Wavefront material file\n# Converted by Meshlab Group\n#",
        "# Wavefront material file written by MeshLab",
        "# exported by PyVista",
    ] {
        let (color, scene) = color_of(format!("{comment}\n\nnewmtl a\nTr 0.25\nnewmtl b\nTr 1\n"));
        assert_eq!(color.a, 0.25, "{comment}");
        said(&scene, "`Tr` without `d` in 1 material: taken as opacity");
    }
}

#[test]
fn the_writer_may_be_named_in_the_model_only() {
    let model = format!("# OBJ File Generated by Meshlab\n{}", of_material_a());
    let scene = with_materials(model, "newmtl a\nTr 0.25\n");
    assert_eq!(colors(&scene.meshes[0])[0].a, 0.25);
    said(&scene, "MeshLab");
}

#[test]
fn tr_without_d_is_said_whatever_it_is_taken_for() {
    let (color, scene) = color_of("# by hand\nnewmtl a\nTr 0.25\n");
    assert_eq!(color.a, 0.75);
    said(
        &scene,
        "m.mtl:3: `Tr` without `d` in 1 material: taken as transparency",
    );
}

#[test]
fn a_tr_by_which_nothing_could_be_seen_is_taken_the_other_way() {
    let (color, scene) = color_of("newmtl a\nTr 1.000000\nnewmtl b\nTr 1.0\n");
    assert_eq!(color.a, 1.0);
    said(&scene, "taken as opacity: as transparency it would");
    let (color, scene) = color_of("# by MeshLab\nnewmtl a\nTr 0.000000\n");
    assert_eq!(color.a, 1.0);
    said(&scene, "taken as transparency: as opacity it would");
}

#[test]
fn the_d_of_other_materials_tells_what_tr_is() {
    let (color, scene) = color_of("newmtl a\nTr 0.3\nnewmtl b\nd 0.9\nTr 0.9\n");
    assert_eq!(color.a, 0.3);
    said(&scene, "equal to it");
    let (color, _) = color_of("newmtl a\nTr 0.3\nnewmtl b\nd 0.9\nTr 0.1\n");
    assert_eq!(color.a, 0.7);
}

#[test]
fn a_tr_that_does_not_fit_its_d_is_said_and_one_that_does_is_not() {
    for wrong in ["0.9", "2", "nan", "", "x"] {
        let (color, scene) = color_of(format!("newmtl a\nTr {wrong}\nd 0.75\n"));
        assert_eq!(color.a, 0.75);
        said(
            &scene,
            &format!("`Tr {wrong}` does not fit the `d` beside it"),
        );
    }
    let (color, scene) = color_of("newmtl a\nTr 0.2500\nd 0.75\n");
    assert_eq!(color.a, 0.75);
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
}

#[test]
fn meshes_that_cannot_be_seen_are_said() {
    let (_, scene) = color_of("newmtl a\nd 0\n");
    said(
        &scene,
        "m.obj: the only mesh is wholly transparent and invisible, the first is 'unnamed_object (a)'",
    );
    let (_, scene) = color_of("newmtl a\nTr 1\nnewmtl b\nTr 0.5\n");
    said(&scene, "invisible");
    let (_, scene) = color_of("newmtl a\nd 0.01\n");
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
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

#[test]
fn names_match_by_their_bytes() {
    let model = [
        &b"mtllib m.mtl\n"[..],
        CORNERS.as_bytes(),
        b"o W\xfcrfel\nusemtl gr\xfcn\nf 1 2 3\n",
    ]
    .concat();
    let scene = with_materials(
        model,
        b"newmtl gr\xfan\nKd 1 0 0\nnewmtl gr\xfcn\nKd 0 1 0\n",
    );
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([0.0, 1.0, 0.0]));
    assert_eq!(scene.meshes[0].name, "W\u{fffd}rfel (gr\u{fffd}n)");
}

#[test]
fn a_material_without_a_name_is_the_white_one() {
    let model = format!("mtllib m.mtl\n{CORNERS}usemtl red\nf 1 2 3\nusemtl\nf 1 3 4\n");
    let scene = with_materials(model, "newmtl red\nKd 1 0 0\nnewmtl\nKd 0 1 0\n");
    assert_eq!(colors(&scene.meshes[0])[0], Rgba::opaque([1.0, 0.0, 0.0]));
    assert_eq!(colors(&scene.meshes[1])[0], Rgba::opaque([1.0; 3]));
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
}

#[test]
fn names_may_have_spaces_signs_and_comments() {
    for (used, defined) in [
        ("dark red", "dark red"),
        ("a#b", "a#b"),
        ("a # the first", "a"),
        ("\u{1f534} [rot]/2:x", "\u{1f534} [rot]/2:x"),
        ("none", "none"),
        ("0", "0"),
    ] {
        let model = format!("mtllib m.mtl\n{CORNERS}usemtl {used}\nf 1 2 3\n");
        let scene = with_materials(model, format!("newmtl {defined}\nKd 1 0 0\n"));
        assert_eq!(
            colors(&scene.meshes[0])[0],
            Rgba::opaque([1.0, 0.0, 0.0]),
            "{used}"
        );
    }
}

#[test]
fn what_is_not_used_of_a_material_may_be_anything() {
    for line in [
        "Ka 1.2 1 1",
        "Ka nan nan nan",
        "Ka spectral a.rfl 1",
        "Ka",
        "Ks -1.#IND x",
        "Ns 1e400",
        "illum 0x10",
        "Ni",
        "Tf xyz 1 1 1",
        "sharpness many",
        "\u{fffd}",
    ] {
        let (color, scene) = color_of(format!("newmtl a\nKd 1 0 0\n{line}\n"));
        assert_eq!(color, Rgba::opaque([1.0, 0.0, 0.0]), "{line}");
        assert!(scene.notices.is_empty(), "{:?}", scene.notices);
    }
}

#[test]
fn a_number_beyond_its_range_is_brought_there() {
    let cases = [
        ("Kd 1.0000001 0 0", [1.0, 0.0, 0.0, 1.0]),
        ("Kd 1.003 0.5 -0.1", [1.0, 0.5, 0.0, 1.0]),
        ("Kd 2.5 0 0.25", [1.0, 0.0, 0.25, 1.0]),
        ("Kd 0 0 2", [0.0, 0.0, 1.0, 1.0]),
        ("d 1.000001", [1.0; 4]),
        ("d 100", [1.0; 4]),
        ("Tr -0.00001\nTr -0.00001", [1.0; 4]),
    ];
    for (line, expected) in cases {
        let (color, scene) = color_of(format!("newmtl a\n{line}\n"));
        assert_eq!(color, Rgba::from(expected), "{line}");
        said(&scene, "beyond 0 to 1 in 1 material");
    }
}

#[test]
fn a_colour_of_bytes_is_divided_by_255() {
    let (color, scene) = color_of("newmtl a\nKd 255 51 0\n");
    assert_eq!(color, Rgba::opaque([1.0, 0.2, 0.0]));
    said(
        &scene,
        "m.mtl:2: a colour of whole numbers up to 255 in 1 material, the first is '255 51 0'",
    );
}

#[test]
fn a_colour_or_an_opacity_that_cannot_be_read_is_said_and_left_out() {
    for line in [
        "Kd red",
        "Kd 0.5 0.",
        "Kd nan 0 0",
        "Kd 1.#INF 0 0",
        "Kd",
        "Kd spectral a.rfl",
        "Kd xyz 1 1 1",
        "d nan",
        "d",
        "d x",
        "Tr -1.#IND",
    ] {
        let (color, scene) = color_of(format!("newmtl a\n{line}\n"));
        assert_eq!(color, Rgba::opaque([1.0; 3]), "{line}");
        assert_eq!(scene.notices.len(), 1, "{:?}", scene.notices);
        said(&scene, "m.mtl:2: ");
    }
}

#[test]
fn a_fourth_number_of_a_colour_is_left_out() {
    let (color, scene) = color_of("newmtl a\nKd 1 0 0 0.5\n");
    assert_eq!(color, Rgba::opaque([1.0, 0.0, 0.0]));
    said(&scene, "more than three numbers");
}

#[test]
fn an_opacity_may_depend_on_the_angle() {
    let (color, scene) = color_of("newmtl a\nd -halo 0.5\n");
    assert_eq!(color.a, 0.5);
    said(&scene, "-halo");
}

#[test]
fn keywords_of_materials_may_be_in_any_case() {
    let (color, _) = color_of("NewMtl a\nKD 1 0 0\nD 0.5\n");
    assert_eq!(color, Rgba::new(1.0, 0.0, 0.0, 0.5));
}

#[test]
fn what_belongs_to_no_material_is_skipped() {
    let (color, scene) = color_of("Kd 0 0 1\nd 0.5\nnewmtl a\nKd 1 0 0\n");
    assert_eq!(color, Rgba::opaque([1.0, 0.0, 0.0]));
    said(
        &scene,
        "m.mtl:1: what stands before the first material is skipped",
    );
}
