//! What renderings take, asked for before it is taken.

use onionskin::methods::{CountBy, Frame};
use onionskin::{Method, Renderer, Result, Scene};

use super::setup::Setup;

/// What a frame takes at least: a colour and a depth for OpenGL, the colours that are read back, the image made of them, and
/// the bytes of its file.
const BYTES_PER_PIXEL: u64 = 16 + 8 + 16 + 16 + 16;

/// What the exact image keeps of a fragment: as it is read back, in a list that doubles as it grows, and sorted by pixels.
const BYTES_PER_FRAGMENT: u64 = 128;

/// No driver renders larger images, and it says so itself.
const LARGEST_SIDE: u32 = 32_768;

/// What a mesh takes of OpenGL besides its vertices and triangles: llvmpipe's buffers and their state.
const BYTES_PER_MESH: u64 = 4096;

impl Setup {
    /// The exact image. How many fragments it takes is counted before they are kept.
    pub(super) fn exact(&self, renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Frame> {
        let complexity = renderer.complexity(scene, CountBy::Blending)?;
        let fragments = complexity.fragments();
        self.memory()
            .check(fragments.saturating_mul(BYTES_PER_FRAGMENT))
            .map_err(|shortage| shortage.of(format!("the exact image's {fragments} fragments")))?;
        renderer.render(scene, &Method::Exact)
    }

    /// Asks for what layers take that are kept: as many as the deepest pixel has, at most `peels` unless that is 0.
    pub(super) fn check_layers(
        &self,
        renderer: &mut Renderer<'_>,
        scene: &Scene,
        peels: u32,
    ) -> Result<()> {
        let deepest = renderer.complexity(scene, CountBy::Blending)?.max();
        let layers = if peels > 0 {
            deepest.min(peels)
        } else {
            deepest
        };
        let [width, height] = scene.size;
        let pixels = u64::from(width) * u64::from(height);
        self.memory()
            .check(u64::from(layers).saturating_mul(pixels * BYTES_PER_PIXEL))
            .map_err(|shortage| {
                shortage.of(format!("{layers} layers of {width} x {height} pixels"))
            })
    }

    /// Asks for what every rendering takes: a copy of the geometry for OpenGL, and images.
    pub(super) fn check_memory(&self, scene: &Scene) -> Result<()> {
        let [width, height] = scene.size;
        if width.max(height) > LARGEST_SIDE {
            return Ok(());
        }
        let of_images = u64::from(width) * u64::from(height) * BYTES_PER_PIXEL;
        self.memory()
            .check(of_images)
            .map_err(|shortage| shortage.of(format!("images of {width} x {height} pixels")))?;
        let of_geometry = scene
            .meshes
            .iter()
            .map(|mesh| mesh.bytes() + BYTES_PER_MESH);
        let of_geometry = of_geometry.sum();
        self.memory().check(of_geometry).map_err(|shortage| {
            let triangles = scene.triangle_count();
            shortage.of(format!("{triangles} triangles, for OpenGL,"))
        })
    }
}
