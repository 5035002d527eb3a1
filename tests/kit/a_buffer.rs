//! What the tests of A-buffers on OpenGL have in common.

use onionskin::generate::{Quads, Soup, SubmissionOrder, quads, soup};
use onionskin::low_level::methods::ABufferCounts;
use onionskin::options::{ABufferOptions, ArraySort, Manager, RecordColor};
use onionskin::{Camera, Frame, Method, Renderer, Scene};

/// A half float has 11 significant bits, so a colour is off by at most 2^-12 and an alpha by at most alpha x 2^-11 when
/// rounded to nearest, twice that when cut. Colours are weighted by what adds up to 1; so are the alphas' relative errors.
/// Cut: 2^-11 + 2^-10.
pub const F16: f64 = 1.5e-3;

pub const MANAGERS: [Manager; 3] = [Manager::Ffb, Manager::Dfb, Manager::Ppll];

/// The defaults with a sort that compiles at once.
pub fn small(manager: Manager) -> ABufferOptions {
    ABufferOptions {
        manager,
        sort: ArraySort::Insertion,
        ..ABufferOptions::DEFAULT
    }
}

/// The defaults, exact, with a sort that compiles at once.
pub fn options() -> ABufferOptions {
    ABufferOptions {
        color: RecordColor::Float,
        sort: ArraySort::Insertion,
        ..ABufferOptions::DEFAULT
    }
}

/// A frame and what its lists have cost.
pub fn render(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    options: ABufferOptions,
) -> (Frame, ABufferCounts) {
    let frame = renderer.render(scene, &Method::ABuffer(options)).unwrap();
    let counts = frame.stats.a_buffer.unwrap();
    (frame, counts)
}

/// A scene of `examples/scenes`.
pub fn bundled(file: &str, size: [u32; 2]) -> Scene {
    let path = format!("{}/examples/scenes/{file}", env!("CARGO_MANIFEST_DIR"));
    Scene::load_at(path, Some(size)).unwrap()
}

/// 400 random triangles.
pub fn soup_scene(seed: u64) -> Scene {
    let parameters = Soup {
        count: 400,
        seed,
        ..Soup::default()
    };
    let mut scene = Scene::of("soup", vec![soup(&parameters).unwrap()]);
    scene.size = [160, 120];
    scene.background = [0.2, 0.4, 0.6];
    scene
}

/// Figure 7's quads, each over the whole view.
pub fn sheets(count: u32, order: SubmissionOrder) -> Scene {
    let parameters = Quads {
        count,
        size: [40.0, 30.0],
        spacing: 0.1,
        alpha: 0.05,
        order,
        seed: 7,
        ..Quads::default()
    };
    let mut scene = Scene::of("sheets", vec![quads(&parameters).unwrap()]);
    scene.background = [1.0; 3];
    scene.camera = Camera {
        eye: glam::DVec3::new(0.0, 0.0, 3.0),
        target: glam::DVec3::ZERO,
        up: glam::DVec3::Y,
        fov: 60.0,
        near: 0.5,
        far: 20.0,
    };
    scene
}
