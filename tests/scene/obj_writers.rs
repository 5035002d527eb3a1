//! One mesh as many programs would write it: whatever their quirks, it reads back as the same. And models of many
//! parts, which must not take longer than their size says.

use std::fmt::Write;

use crate::kit::scene::{Folder, obj};
use glam::{DVec3, Vec3};
use onionskin::{Rgba, Scene};
use proptest::prelude::*;

/// What a program makes of a model besides the model.
#[derive(Clone, Debug)]
struct Quirks {
    header: &'static str,
    end: &'static str,
    mark: bool,
    name: &'static [u8],
    /// How the material file is named and how it is called.
    library: (&'static str, &'static str),
    exponents: bool,
    comma: bool,
    relative: bool,
    first: bool,
    corner: Corners,
    continued: bool,
    weight: bool,
    clutter: bool,
    opacity: Opacity,
    extra: &'static str,
}

/// What stands in a corner besides its vertex.
#[derive(Clone, Copy, Debug)]
enum Corners {
    Plain,
    Slash,
    Slashes,
    Texture,
    LostTexture,
    BadNormal,
}

/// How a program writes opacity.
#[derive(Clone, Copy, Debug)]
enum Opacity {
    D,
    Tr,
    VtkTr,
    Both,
    BothAlike,
}

fn quirks() -> impl Strategy<Value = Quirks> {
    let header = prop::sample::select(vec![
        "",
        "# Blender 4.1.0\n# www.blender.org\n",
        "#  exported by\tC:\\tools\\\n",
        "####\n#\n# Object m.obj\n#\n####\n",
    ]);
    let names: Vec<&[u8]> = vec![
        b"m",
        b"gr\xfcn",
        b"a b",
        b"a#b",
        b"\xff\xfe",
        "ü/λ".as_bytes(),
        b"7",
    ];
    let libraries = vec![
        ("m.mtl", "m.mtl"),
        ("\"my m.mtl\"", "my m.mtl"),
        ("./m.mtl", "m.mtl"),
        ("C:\\out\\m.mtl", "m.mtl"),
        ("M.MTL", "m.mtl"),
        ("gone.mtl m.mtl", "m.mtl"),
    ];
    let corners = vec![
        Corners::Plain,
        Corners::Slash,
        Corners::Slashes,
        Corners::Texture,
        Corners::LostTexture,
        Corners::BadNormal,
    ];
    let opacities = vec![
        Opacity::D,
        Opacity::Tr,
        Opacity::VtkTr,
        Opacity::Both,
        Opacity::BothAlike,
    ];
    let extra = vec![
        "",
        "Ka nan nan nan\n",
        "Ks 1.#INF 0 0\n",
        "map_Bump x.png\n",
        "Ns -1\nillum z\n",
    ];
    let text = (
        header,
        prop::sample::select(vec!["\n", "\r\n", "\r"]),
        any::<bool>(),
        prop::sample::select(names),
        prop::sample::select(libraries),
        prop::sample::select(corners),
        prop::sample::select(opacities),
        prop::sample::select(extra),
    );
    let flags = any::<[bool; 7]>();
    (text, flags).prop_map(|(text, flags)| {
        let (header, end, mark, name, library, corner, opacity, extra) = text;
        let [
            exponents,
            comma,
            relative,
            first,
            continued,
            weight,
            clutter,
        ] = flags;
        Quirks {
            header,
            end,
            mark,
            name,
            library,
            exponents,
            comma,
            relative,
            first,
            corner,
            continued,
            weight,
            clutter,
            opacity,
            extra,
        }
    })
}

/// Vertices on a coarse grid, of which weights and commas change nothing, and triangles between them.
fn meshes() -> impl Strategy<Value = (Vec<DVec3>, Vec<[usize; 3]>)> {
    let number = || (-400..400_i32).prop_map(|n| f64::from(n) / 8.0);
    let vertex = (number(), number(), number()).prop_map(DVec3::from);
    prop::collection::vec(vertex, 3..12).prop_flat_map(|vertices| {
        let index = 0..vertices.len();
        let triangle = [index.clone(), index.clone(), index];
        let triangles = prop::collection::vec(triangle, 1..10);
        (Just(vertices), triangles)
    })
}

impl Quirks {
    fn number(&self, number: f64) -> String {
        let text = match self.exponents {
            true => format!("{number:.4e}"),
            false => format!("{number:.6}"),
        };
        match self.comma {
            true => text.replace('.', ","),
            false => text,
        }
    }

    fn vertices(&self, vertices: &[DVec3], out: &mut String) {
        for vertex in vertices {
            let scale = if self.weight { 2.0 } else { 1.0 };
            let [x, y, z] = vertex.to_array().map(|x| self.number(x * scale));
            let weight = if self.weight { " 2" } else { "" };
            let _ = writeln!(out, "v  {x} {y}\t{z}{weight} ");
        }
        match self.corner {
            Corners::Texture => out.push_str("vt 0,5 nan\n"),
            Corners::BadNormal => out.push_str("vn nan(ind) 0 0\n"),
            _ => {}
        }
    }

    fn faces(&self, triangles: &[[usize; 3]], count: usize, out: &mut String) {
        for triangle in triangles {
            if self.clutter {
                out.push_str("l 1\np\nf 1 2\nwibble\n# f 1 2 3 \\\n");
            }
            let corners = triangle.map(|corner| {
                let index = match self.relative {
                    true => (corner as i64 - count as i64).to_string(),
                    false => (corner + 1).to_string(),
                };
                match self.corner {
                    Corners::Plain => index,
                    Corners::Slash => format!("{index}/"),
                    Corners::Slashes => format!("{index}//"),
                    Corners::Texture => format!("{index}/1"),
                    Corners::LostTexture => format!("{index}/99/"),
                    Corners::BadNormal => {
                        format!("{index}//{}", if corner % 2 == 0 { 1 } else { 9 })
                    }
                }
            });
            let between = if self.continued { " \\\n" } else { " " };
            let _ = writeln!(out, "f {}", corners.join(between));
        }
    }

    fn model(&self, vertices: &[DVec3], triangles: &[[usize; 3]]) -> Vec<u8> {
        let mut text = format!("{}mtllib {}\n", self.header, self.library.0);
        // A face may come first if it does not count back.
        let faces_first = self.first && !self.relative;
        if !faces_first {
            self.vertices(vertices, &mut text);
        }
        text.push_str("usemtl NAME\n");
        self.faces(triangles, vertices.len(), &mut text);
        if faces_first {
            self.vertices(vertices, &mut text);
        }
        self.finished(&text)
    }

    fn materials(&self) -> Vec<u8> {
        let opacity = match self.opacity {
            Opacity::D => "d 0.25\n",
            Opacity::Tr => "Tr 0.75\n",
            Opacity::VtkTr => "Tr 0.25\n",
            Opacity::Both => "Tr 0.75\nd 0.25\n",
            Opacity::BothAlike => "d 0.25\nTr 0.25\n",
        };
        let comment = match self.opacity {
            Opacity::VtkTr => "# wavefront mtl file written by the visualization toolkit\n",
            _ => "",
        };
        let color = format!(
            "Kd {} {} {}",
            self.number(1.000_000_1),
            self.number(0.5),
            self.number(0.0)
        );
        let text = format!(
            "{comment}newmtl NAME\n{color}\n{}{opacity}newmtl NAME\nKd 0 0 1\n",
            self.extra
        );
        self.finished(&text)
    }

    /// With the name, the line ends and the mark that the program uses.
    fn finished(&self, text: &str) -> Vec<u8> {
        let text = text.replace('\n', self.end);
        let mut bytes = if self.mark {
            "\u{feff}".as_bytes().to_vec()
        } else {
            Vec::new()
        };
        for (i, part) in text.split("NAME").enumerate() {
            if i > 0 {
                bytes.extend_from_slice(self.name);
            }
            bytes.extend_from_slice(part.as_bytes());
        }
        bytes
    }
}

/// The corners of all triangles that have an area, with all that a driver gets of them.
fn corners(scene: &Scene) -> Vec<(DVec3, Vec3, Rgba)> {
    let meshes = scene.meshes.iter();
    let corners = meshes.flat_map(|mesh| (0..mesh.triangle_count()).flat_map(|i| mesh.corners(i)));
    corners
        .map(|corner| (corner.position, corner.normal, corner.color))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn a_mesh_reads_back_whoever_wrote_it((vertices, triangles) in meshes(), quirks in quirks()) {
        let mut plain = String::new();
        for vertex in &vertices {
            writeln!(plain, "v {} {} {} 1 0.5 0", vertex.x, vertex.y, vertex.z).expect("a string");
        }
        for [a, b, c] in &triangles {
            writeln!(plain, "f {} {} {}", a + 1, b + 1, c + 1).expect("a string");
        }
        let plain = corners(&obj(plain));
        let folder = Folder::new()
            .with("m.obj", quirks.model(&vertices, &triangles))
            .with(quirks.library.1, quirks.materials());
        let scene = folder.load("m.obj").map_err(|error| TestCaseError::fail(error.to_string()))?;
        let expected: Vec<(DVec3, Vec3, Rgba)> = plain
            .into_iter()
            .map(|(position, normal, color)| (position, normal, Rgba { a: 0.25, ..color }))
            .collect();
        prop_assert_eq!(corners(&scene), expected, "{:?}", scene.notices);
    }
}

#[test]
fn map_coordinates_are_kept_to_the_last_digit() {
    let scene = obj(
        "v 500000.123 5000000.456 100.001\nv 500001.123 5000000.456 100.001\nv 500000.123 5000001.457 100.002\nv 500000.5 5000000.7 100\nf 1 2 3\nf 1 4 2 3\n",
    );
    let vertices = &scene.meshes[0].vertices;
    assert_eq!(
        vertices[0].position,
        DVec3::new(500_000.123, 5_000_000.456, 100.001)
    );
    assert_eq!(
        vertices[2].position,
        DVec3::new(500_000.123, 5_000_001.457, 100.002)
    );
    assert!((vertices[0].normal.z - 1.0).abs() < 1e-5);
    // A concave quad: its last corner but two lies within the others.
    assert_eq!(scene.triangle_count(), 3);
    assert!(scene.notices.is_empty(), "{:?}", scene.notices);
}

#[test]
fn a_concave_polygon_far_away_is_as_one_nearby() {
    let polygon = |x: f64, y: f64| {
        let corners = [
            (-1.0, -1.0),
            (1.0, -1.0),
            (1.0, 1.0),
            (0.5, 1.0),
            (0.5, -0.5),
            (-0.5, -0.5),
            (-0.5, 1.0),
            (-1.0, 1.0),
        ];
        let lines: String = corners
            .iter()
            .map(|(a, b)| format!("v {} {} 0\n", a + x, b + y))
            .collect();
        obj(format!("{lines}f 1 2 3 4 5 6 7 8\n"))
            .meshes
            .remove(0)
            .triangles
    };
    assert_eq!(polygon(0.0, 0.0), polygon(500_000.0, 5_000_000.0));
}

/// A model of many meshes takes a second or so; if each part looked at all others, it would take days.
const MANY: usize = 600_000;

#[test]
fn many_meshes_load() {
    let mut model = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    for i in 0..MANY / 3 {
        let _ = write!(
            model,
            "o {i}\nf 1 2 3\ng {i}\nf 1 2 3\nusemtl {i}\ns {i}\nf 1 2 3\n"
        );
    }
    let scene = obj(model);
    // A change of material that is not defined starts none.
    assert_eq!(scene.meshes.len(), MANY * 2 / 3);
    assert_eq!(scene.triangle_count(), MANY);
}

#[test]
fn many_materials_and_many_quirks_load() {
    let mut model =
        String::from("mtllib m.mtl\nv 0 0 0 2 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 nan\nvn 0 0 0\n");
    let mut materials = String::new();
    for i in 0..MANY / 6 {
        let _ = write!(
            model,
            "v 1,5 0 0 nan 0 0\nf 1 2\nusemtl {i} # x\nf 1/9/1 2//9 3\nf 1 2 4\nl 1\nwibble\n"
        );
        let _ = write!(
            materials,
            "newmtl {i}\nKd 2 0 0\nTr 0.5\nd 0.5\nmap_Kd {i}.png\n"
        );
    }
    let folder = Folder::new().with("m.obj", model).with("m.mtl", materials);
    let scene = folder.load("m.obj").expect("it loads");
    assert_eq!(scene.meshes.len(), MANY / 6);
    assert!(scene.notices.len() < 20, "{}", scene.notices.len());
}

#[test]
fn a_long_name_is_not_kept_by_each_of_many_meshes() {
    let mut model = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\ng {}\n", "x".repeat(200_000));
    for _ in 0..MANY / 10 {
        model.push_str("usemtl a\nf 1 2 3\nusemtl\nf 1 2 3\n");
    }
    let folder = Folder::new()
        .with("m.mtl", "newmtl a\n")
        .with("m.obj", format!("mtllib m.mtl\n{model}"));
    let scene = folder.load("m.obj").expect("it loads");
    assert_eq!(scene.meshes.len(), MANY / 5);
    assert!(scene.meshes.iter().all(|mesh| mesh.name.len() < 100));
}

#[test]
fn a_line_that_goes_on_for_ever_loads() {
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for keyword in ["o", "usemtl", "mtllib", "l", "wibble", "#"] {
        let line = format!("{keyword} {}", "x \\\n".repeat(MANY / 4));
        let scene = obj(format!("{corners}{line}\nf 1 2 3\n"));
        assert_eq!(scene.triangle_count(), 1, "{keyword}");
    }
}
