//! Bindings: programs, framebuffers, buffers, images, and the textures and samplers of every unit.

use glow::HasContext;

use super::super::context::Context;

/// A machine binds textures to no unit from here on: 7 and one for each of 32 volumes.
pub(in crate::low_level::gl) const UNITS: u32 = 40;
/// Shaders declare no storage block, image or uniform block from here on.
const STORAGE_BLOCKS: u32 = 8;
const IMAGES: u32 = 8;
const UNIFORM_BLOCKS: u32 = 4;

#[derive(Debug)]
pub(super) struct Bindings {
    program: Option<glow::Program>,
    vertex_array: Option<glow::VertexArray>,
    framebuffers: [Option<glow::Framebuffer>; 2],
    /// In the order of [`buffer_targets`].
    buffers: Vec<Option<glow::Buffer>>,
    storage_blocks: Vec<Range>,
    uniform_blocks: Vec<Range>,
    images: Vec<Image>,
    active: u32,
    units: Vec<Unit>,
}

/// A buffer, or a part of it, that is bound to an index.
#[derive(Clone, Copy, Debug)]
struct Range {
    buffer: u32,
    start: i64,
    /// 0 if the whole buffer is bound.
    size: i64,
}

#[derive(Clone, Copy, Debug)]
struct Image {
    texture: u32,
    level: i32,
    layered: bool,
    layer: i32,
    access: u32,
    format: u32,
}

#[derive(Clone, Copy, Debug)]
struct Unit {
    /// In the order of [`TEXTURES`].
    textures: [Option<glow::Texture>; TEXTURES.len()],
    sampler: Option<glow::Sampler>,
}

/// The targets that a machine binds textures to, and the names of their bindings.
const TEXTURES: [(u32, u32); 4] = [
    (glow::TEXTURE_2D, glow::TEXTURE_BINDING_2D),
    (glow::TEXTURE_3D, glow::TEXTURE_BINDING_3D),
    (glow::TEXTURE_BUFFER, glow::TEXTURE_BINDING_BUFFER),
    (glow::TEXTURE_RECTANGLE, glow::TEXTURE_BINDING_RECTANGLE),
];

const FRAMEBUFFERS: [(u32, u32); 2] = [
    (glow::DRAW_FRAMEBUFFER, glow::DRAW_FRAMEBUFFER_BINDING),
    (glow::READ_FRAMEBUFFER, glow::READ_FRAMEBUFFER_BINDING),
];

/// OpenGL 4.4 has queries that answer into a buffer.
pub(super) fn has_query_buffer(context: &Context) -> bool {
    let driver = context.driver();
    driver.version >= (4, 4) || driver.has("GL_ARB_query_buffer_object")
}

/// The element buffer is its vertex array's, and pixel buffers are owned by each transfer.
fn buffer_targets(context: &Context) -> impl Iterator<Item = (u32, u32)> {
    let query = (glow::QUERY_BUFFER, glow::QUERY_BUFFER_BINDING);
    [
        (glow::ARRAY_BUFFER, glow::ARRAY_BUFFER_BINDING),
        (
            glow::SHADER_STORAGE_BUFFER,
            glow::SHADER_STORAGE_BUFFER_BINDING,
        ),
        (glow::UNIFORM_BUFFER, glow::UNIFORM_BUFFER_BINDING),
    ]
    .into_iter()
    .chain(has_query_buffer(context).then_some(query))
}

impl Bindings {
    pub(super) fn read(context: &Context) -> Self {
        let gl = context.glow();
        let range = |[binding, start, size]: [u32; 3], index| {
            // SAFETY: the context is current, and has so many blocks; each is a single number.
            unsafe {
                Range {
                    buffer: gl.get_parameter_indexed_i32(binding, index) as u32,
                    start: gl.get_parameter_indexed_i64(start, index),
                    size: gl.get_parameter_indexed_i64(size, index),
                }
            }
        };
        let storage = [
            glow::SHADER_STORAGE_BUFFER_BINDING,
            glow::SHADER_STORAGE_BUFFER_START,
            glow::SHADER_STORAGE_BUFFER_SIZE,
        ];
        let uniform = [
            glow::UNIFORM_BUFFER_BINDING,
            glow::UNIFORM_BUFFER_START,
            glow::UNIFORM_BUFFER_SIZE,
        ];
        // SAFETY: as above.
        unsafe {
            let active = gl.get_parameter_i32(glow::ACTIVE_TEXTURE) as u32;
            let units = (0..UNITS).map(|unit| {
                gl.active_texture(glow::TEXTURE0 + unit);
                Unit {
                    textures: TEXTURES.map(|(_, binding)| gl.get_parameter_texture(binding)),
                    sampler: gl.get_parameter_sampler(glow::SAMPLER_BINDING),
                }
            });
            let units = units.collect();
            gl.active_texture(active);
            Self {
                program: gl.get_parameter_program(glow::CURRENT_PROGRAM),
                vertex_array: gl.get_parameter_vertex_array(glow::VERTEX_ARRAY_BINDING),
                framebuffers: FRAMEBUFFERS.map(|(_, name)| gl.get_parameter_framebuffer(name)),
                buffers: buffer_targets(context)
                    .map(|(_, binding)| gl.get_parameter_buffer(binding))
                    .collect(),
                storage_blocks: (0..STORAGE_BLOCKS).map(|i| range(storage, i)).collect(),
                uniform_blocks: (0..UNIFORM_BLOCKS).map(|i| range(uniform, i)).collect(),
                images: (0..IMAGES).map(|unit| Image::read(gl, unit)).collect(),
                active,
                units,
            }
        }
    }

    /// The program in use, if it was deleted and only exists while it is in use, so that it could not be restored.
    pub(super) fn doomed_program(&self, context: &Context) -> Option<glow::Program> {
        // SAFETY: the context is current, and the program exists while it is in use.
        self.program.filter(|&program| unsafe {
            context
                .glow()
                .get_program_parameter_i32(program, glow::DELETE_STATUS)
                != 0
        })
    }

    pub(super) fn set(&self, context: &Context) {
        let gl = context.glow();
        // SAFETY: the context is current; the objects are the host's, who has not had the time to delete them.
        unsafe {
            for (unit, there) in (0..).zip(&self.units) {
                gl.active_texture(glow::TEXTURE0 + unit);
                for ((target, _), texture) in TEXTURES.iter().zip(there.textures) {
                    gl.bind_texture(*target, texture);
                }
                gl.bind_sampler(unit, there.sampler);
            }
            gl.active_texture(self.active);
            for (unit, image) in (0..).zip(&self.images) {
                image.set(gl, unit);
            }
            for (index, range) in (0..).zip(&self.storage_blocks) {
                range.set(context, glow::SHADER_STORAGE_BUFFER, index);
            }
            for (index, range) in (0..).zip(&self.uniform_blocks) {
                range.set(context, glow::UNIFORM_BUFFER, index);
            }
            // This comes after the indexed bindings, which change it.
            for ((target, _), buffer) in buffer_targets(context).zip(&self.buffers) {
                gl.bind_buffer(target, *buffer);
            }
            for ((target, _), framebuffer) in FRAMEBUFFERS.iter().zip(self.framebuffers) {
                gl.bind_framebuffer(*target, framebuffer);
            }
            gl.bind_vertex_array(self.vertex_array);
            gl.use_program(self.program);
        }
    }
}

impl Range {
    fn set(self, context: &Context, target: u32, index: u32) {
        let buffer = std::num::NonZeroU32::new(self.buffer).map(glow::NativeBuffer);
        let (start, size) = (i32::try_from(self.start), i32::try_from(self.size));
        // SAFETY: the context is current, and this is how the buffer was bound.
        unsafe {
            match (buffer, start, size) {
                (None, ..) => context.glow().bind_buffer_base(target, index, None),
                (_, Ok(0), Ok(0)) => context.glow().bind_buffer_base(target, index, buffer),
                (_, Ok(start), Ok(size)) => {
                    context
                        .glow()
                        .bind_buffer_range(target, index, buffer, start, size);
                }
                // glow's offsets have 31 bits.
                _ => {
                    let range = [self.start, self.size];
                    context.more().bind_range(target, index, self.buffer, range);
                }
            }
        }
    }
}

impl Image {
    fn read(gl: &glow::Context, unit: u32) -> Self {
        // SAFETY: the context is current, and has so many image units; each is a single number.
        let number = |name| unsafe { gl.get_parameter_indexed_i32(name, unit) };
        Self {
            texture: number(glow::IMAGE_BINDING_NAME) as u32,
            level: number(glow::IMAGE_BINDING_LEVEL),
            layered: number(glow::IMAGE_BINDING_LAYERED) != 0,
            layer: number(glow::IMAGE_BINDING_LAYER),
            access: number(glow::IMAGE_BINDING_ACCESS) as u32,
            format: number(glow::IMAGE_BINDING_FORMAT) as u32,
        }
    }

    fn set(self, gl: &glow::Context, unit: u32) {
        let texture = std::num::NonZeroU32::new(self.texture).map(glow::NativeTexture);
        // SAFETY: the context is current, and this is how the texture was bound.
        unsafe {
            gl.bind_image_texture(
                unit,
                texture,
                self.level,
                self.layered,
                self.layer,
                self.access,
                self.format,
            );
        }
    }
}
