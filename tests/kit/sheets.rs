//! A desk with scenes of sheets, and what the library makes of them.

use super::cli::{Answer, Desk};
use onionskin::options::DepthPeelingOptions;
use onionskin::{Context, Frame, Image, Method, Renderer, Scene};

/// Five sheets that cover the middle of the picture, shuffled, so that the order matters.
pub const SHEETS: &str = r#"
size = [40, 30]
background = [1.0, 1.0, 1.0]

[[mesh]]
generate = "quads"
count = 5
size = [1.0, 1.0]
spacing = 0.3
alpha = 0.5
order = "shuffled"
seed = 3
"#;

/// Two sheets of glass, the farther one first, before a wall.
pub const GLASS: &str = "mtllib glass.mtl
v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0
v 0 0 1\nv 1 0 1\nv 1 2 1\nv 0 2 1
v 0 0 2\nv 2 0 2\nv 2 1 2\nv 0 1 2
usemtl wall\nf 1 2 3 4\nusemtl red\nf 5 6 7 8\nusemtl green\nf 9 10 11 12
";

pub const MATERIALS: &str = "newmtl wall\nKd 0.5 0.5 0.5
newmtl red\nKd 0.9 0.1 0.1\nd 0.4
newmtl green\nKd 0.1 0.9 0.1\nd 0.6
";

/// The keys that a reader of the JSON may rely on.
pub const KEYS: [&str; 11] = [
    "scene",
    "method",
    "iterations",
    "geometry_passes",
    "fragments",
    "lost",
    "stopped",
    "bytes",
    "ms",
    "max_error",
    "rms_error",
];

/// f32 colours through at most a few roundings of 2^-24 for each of five layers: 1e-6.
pub const F32: f64 = 1e-6;

pub fn desk() -> Desk {
    Desk::new()
        .with("sheets.toml", SHEETS)
        .with("glass.obj", GLASS)
        .with("glass.mtl", MATERIALS)
}

/// What the library makes of a scene of the desk.
pub fn library(desk: &Desk, scene: &str, size: Option<[u32; 2]>, method: &Method) -> Frame {
    let scene = Scene::load_at(desk.path(scene), size).unwrap();
    let context = Context::headless().unwrap();
    let mut renderer = Renderer::new(&context, scene.size[0], scene.size[1]).unwrap();
    renderer.render(&scene, method).unwrap()
}

pub fn peeling(options: DepthPeelingOptions) -> Method {
    Method::DepthPeeling(options)
}

/// The only object of an answer that has nothing else.
#[track_caller]
pub fn object(answer: &Answer) -> serde_json::Map<String, serde_json::Value> {
    let mut objects = answer.objects();
    assert_eq!(objects.len(), 1, "{answer}");
    objects.remove(0)
}

#[track_caller]
pub fn holds_the_image_in_8_bits(desk: &Desk, name: &str, image: &Image) {
    let file = Image::load(desk.path(name)).unwrap();
    assert_eq!([file.width, file.height], [image.width, image.height]);
    for (file, pixel) in file.pixels.iter().zip(&image.pixels) {
        for (file, value) in file.to_array().into_iter().zip(pixel.to_array()) {
            // Half a step of 8 bits, and f32's rounding of the division by 255.
            assert!((file - value).abs() <= 0.5 / 255.0 + 1e-6);
        }
    }
}
