//! The memory of renderings, which is asked for before it is taken.

use onionskin::{CountBy, Frame, Method, Renderer, Result, Scene};

use super::setup::Rendering;

/// The least bytes per pixel of a frame: a colour and a depth for OpenGL, the colours that are read back, the image
/// made from them, and the bytes of its file.
const BYTES_PER_PIXEL: u64 = 16 + 8 + 16 + 16 + 16;

/// The bytes per fragment of the exact image: as it is read back, in a list that doubles as it grows, and sorted by
/// pixels.
const BYTES_PER_FRAGMENT: u64 = 128;

/// No driver renders larger images. A driver reports that itself.
const LARGEST_SIDE: u32 = 32_768;

/// The bytes of a mesh in OpenGL besides its vertices and triangles: llvmpipe's buffers and their state.
const BYTES_PER_MESH: u64 = 4096;

impl Rendering {
    /// Renders the exact image. Its fragments are counted before they are kept.
    pub(super) fn exact(&self, renderer: &mut Renderer<'_>, scene: &Scene) -> Result<Frame> {
        let complexity = renderer.complexity(scene, CountBy::Blending)?;
        let fragments = complexity.fragments();
        self.memory()
            .check(fragments.saturating_mul(BYTES_PER_FRAGMENT))
            .map_err(|shortage| shortage.of(format!("the exact image's {fragments} fragments")))?;
        renderer.render(scene, &Method::Exact)
    }

    /// Asks for the memory of kept layers. There are as many as the deepest pixel has, and at most `peels` unless that
    /// is 0.
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

    /// Asks for the memory of any rendering: a copy of the geometry for OpenGL, and images.
    pub(super) fn check_memory(&self, scene: &Scene) -> Result<()> {
        let [width, height] = scene.size;
        if width.max(height) > LARGEST_SIDE {
            return Ok(());
        }
        let of_images = u64::from(width) * u64::from(height) * BYTES_PER_PIXEL;
        self.memory()
            .check(of_images)
            .map_err(|shortage| shortage.of(format!("images of {width} x {height} pixels")))?;
        self.memory().check(of_geometry(scene)).map_err(|shortage| {
            let triangles = scene.triangle_count();
            shortage.of(format!("{triangles} triangles, for OpenGL,"))
        })
    }

    /// Asks for the memory of so many methods at once, each with images and two copies of the geometry.
    pub(super) fn check_methods(&self, scene: &Scene, methods: usize) -> Result<()> {
        let [width, height] = scene.size.map(u64::from);
        let of_one = (width * height)
            .saturating_mul(BYTES_PER_PIXEL)
            .saturating_add(of_geometry(scene).saturating_mul(2));
        self.memory()
            .check(of_one.saturating_mul(methods as u64))
            .map_err(|shortage| {
                shortage.of(format!(
                    "{methods} methods at once (-m names fewer), each with images and geometry of its own,"
                ))
            })
    }
}

fn of_geometry(scene: &Scene) -> u64 {
    let meshes = scene.meshes.iter();
    meshes.map(|mesh| mesh.bytes() + BYTES_PER_MESH).sum()
}
