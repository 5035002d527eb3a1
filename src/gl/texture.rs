//! Textures, which are drawn into, looked up, copied and read back.

use glow::HasContext;

use super::context::Context;
use super::making::{Making, allocate};
use super::pixel_store::PixelStore;
use crate::error::Result;
use crate::steps::Format;

/// GL's sized internal format.
pub(super) const fn internal(format: Format) -> u32 {
    match format {
        Format::Rgba8 => glow::RGBA8,
        Format::Rgb10A2 => glow::RGB10_A2,
        Format::Rgba16F => glow::RGBA16F,
        Format::Rgba32F => glow::RGBA32F,
        Format::R32F => glow::R32F,
        Format::Rg32F => glow::RG32F,
        Format::R32Ui => glow::R32UI,
        Format::Rgba32Ui => glow::RGBA32UI,
        Format::Depth32FStencil8 => glow::DEPTH32F_STENCIL8,
        Format::Depth24Stencil8 => glow::DEPTH24_STENCIL8,
        Format::Rg16 => glow::RG16,
        Format::Depth16 => glow::DEPTH_COMPONENT16,
        Format::Depth24 => glow::DEPTH_COMPONENT24,
        Format::Depth32F => glow::DEPTH_COMPONENT32F,
    }
}

/// A two-dimensional texture of fixed size.
#[derive(Clone, Copy, Debug)]
pub(super) struct Texture {
    pub(super) raw: glow::Texture,
    pub(super) format: Format,
    pub(super) size: [u32; 2],
}

impl Texture {
    /// The texture of a map, its contents undefined. The context is current.
    pub(super) fn new(
        gl: &glow::Context,
        name: &dyn std::fmt::Display,
        format: Format,
        size: [u32; 2],
    ) -> Result<Self> {
        let [width, height] = size;
        let bytes = format.bytes() * u64::from(width) * u64::from(height);
        let what = format!("the map '{name}', a {width} x {height} texture ({format:?})");
        let mut making = Making::new(gl);
        let raw = making.texture()?;
        bound(gl, raw, || {
            allocate(gl, &what, bytes, || {
                let [width, height] = size.map(|side| side as i32);
                // SAFETY: the texture is bound, and its size is within the driver's limit, which the machine has checked.
                unsafe {
                    gl.tex_storage_2d(glow::TEXTURE_2D, 1, internal(format), width, height);
                }
            })
        })?;
        making.finish();
        Ok(Self { raw, format, size })
    }

    /// Bytes of its texels.
    pub(super) fn bytes(&self) -> u64 {
        self.format.bytes() * u64::from(self.size[0]) * u64::from(self.size[1])
    }

    /// Sets all texels of a texture of fixed-point numbers to 0.
    pub(super) fn clear(&self, context: &Context) {
        let zeros = vec![0_u8; self.bytes() as usize];
        let [width, height] = self.size.map(|side| side as i32);
        let (format, kind) = (glow::RG, glow::UNSIGNED_SHORT);
        let gl = context.glow();
        let _tight = PixelStore::own(context);
        // SAFETY: the texture is bound and of format RG16, and there are as many zeros as it has bytes.
        bound(gl, self.raw, || unsafe {
            let zeros = glow::PixelUnpackData::Slice(Some(&zeros));
            gl.tex_sub_image_2d(
                glow::TEXTURE_2D,
                0,
                0,
                0,
                width,
                height,
                format,
                kind,
                zeros,
            );
        });
    }

    /// A colour texture's texels as floats, bottom row first.
    pub(super) fn read_colors(&self, context: &Context) -> Vec<[f32; 4]> {
        let mut texels = vec![[0.0; 4]; (self.size[0] * self.size[1]) as usize];
        self.read(
            context,
            glow::RGBA,
            glow::FLOAT,
            bytemuck::cast_slice_mut(&mut texels),
        );
        texels
    }

    /// A depth texture's depths, bottom row first.
    pub(super) fn read_depths(&self, context: &Context) -> Vec<f32> {
        let mut texels = vec![0.0; (self.size[0] * self.size[1]) as usize];
        self.read(
            context,
            glow::DEPTH_COMPONENT,
            glow::FLOAT,
            bytemuck::cast_slice_mut(&mut texels),
        );
        texels
    }

    /// A depth texture's stencil values, bottom row first. They are 0 if it has none.
    pub(super) fn read_stencils(&self, context: &Context) -> Vec<u8> {
        let mut texels = vec![0; (self.size[0] * self.size[1]) as usize];
        if self.format.has_stencil() {
            self.read(
                context,
                glow::STENCIL_INDEX,
                glow::UNSIGNED_BYTE,
                &mut texels,
            );
        }
        texels
    }

    /// An integer texture's texels, bottom row first.
    pub(super) fn read_integers(&self, context: &Context) -> Vec<[u32; 4]> {
        let mut texels = vec![[0; 4]; (self.size[0] * self.size[1]) as usize];
        let into = bytemuck::cast_slice_mut(&mut texels);
        self.read(context, glow::RGBA_INTEGER, glow::UNSIGNED_INT, into);
        texels
    }

    /// The first channel of a texture that counts, bottom row first.
    pub(super) fn read_counts(&self, context: &Context) -> Vec<u32> {
        let mut counts = vec![0_u32; (self.size[0] * self.size[1]) as usize];
        let into: &mut [u8] = bytemuck::cast_slice_mut(&mut counts);
        match self.format {
            Format::R32F => {
                self.read(context, glow::RED, glow::FLOAT, into);
                counts
                    .iter_mut()
                    .for_each(|count| *count = f32::from_bits(*count) as u32);
            }
            Format::Depth32FStencil8 | Format::Depth24Stencil8 => {
                return self
                    .read_stencils(context)
                    .into_iter()
                    .map(u32::from)
                    .collect();
            }
            _ => self.read(context, glow::RED_INTEGER, glow::UNSIGNED_INT, into),
        }
        counts
    }

    fn read(&self, context: &Context, format: u32, kind: u32, into: &mut [u8]) {
        let gl = context.glow();
        let _tight = PixelStore::own(context);
        // SAFETY: the texture is bound, and `into` holds one texel of `format` and `kind` for each of its, tightly packed.
        bound(gl, self.raw, || unsafe {
            let into = glow::PixelPackData::Slice(Some(into));
            gl.get_tex_image(glow::TEXTURE_2D, 0, format, kind, into);
        });
    }
}

impl Context {
    /// Bits of alpha per texel, as the driver counts them.
    ///
    /// # Errors
    /// If the driver has no room for a texel.
    pub fn alpha_bits(&self, format: Format) -> Result<u32> {
        let gl = self.glow();
        let texture = Texture::new(gl, &"one texel", format, [1, 1])?;
        // SAFETY: the texture is bound, has a level 0, and is deleted after it has been asked.
        let bits = bound(gl, texture.raw, || unsafe {
            gl.get_tex_level_parameter_i32(glow::TEXTURE_2D, 0, glow::TEXTURE_ALPHA_SIZE)
        });
        // SAFETY: it was made above and is nobody else's.
        unsafe { gl.delete_texture(texture.raw) };
        Ok(u32::try_from(bits).unwrap_or(0))
    }
}

/// Does work with a texture bound, on a texture unit that no listing uses, so that a listing's bindings do not change.
fn bound<T>(gl: &glow::Context, texture: glow::Texture, work: impl FnOnce() -> T) -> T {
    const UNIT: u32 = glow::TEXTURE15;
    // SAFETY: the context is current; OpenGL 4.3 has at least 80 texture units; the active one and its texture are put back.
    unsafe {
        let active = gl.get_parameter_i32(glow::ACTIVE_TEXTURE) as u32;
        gl.active_texture(UNIT);
        let before = gl.get_parameter_texture(glow::TEXTURE_BINDING_2D);
        gl.bind_texture(glow::TEXTURE_2D, Some(texture));
        let result = work();
        gl.bind_texture(glow::TEXTURE_2D, before);
        gl.active_texture(active);
        result
    }
}
