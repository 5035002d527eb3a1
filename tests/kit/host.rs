//! A host of a context: sets every state to an odd value, and takes down every state.

#![allow(unsafe_code, dead_code)] // a host calls GL

use std::collections::BTreeMap;

use glow::HasContext;
use onionskin::Backend;

use super::loader;

mod odd;

pub use odd::ODD;

/// A function of OpenGL's that glow does not have, or has not in this form.
macro_rules! gl_call {
    ($host:expr, $name:literal($($argument:expr => $kind:ty),*) $(-> $result:ty)?) => {{
        type Function = unsafe extern "system" fn($($kind),*) $(-> $result)?;
        let function = loader::function($host.backend, $name);
        assert!(!function.is_null(), $name);
        std::mem::transmute::<*const std::ffi::c_void, Function>(function)($($argument),*)
    }};
}
pub(crate) use gl_call;

pub struct Host<'g> {
    pub gl: &'g glow::Context,
    pub backend: Backend,
    objects: Objects,
}

/// The host's own, to be bound where onionskin binds its own.
struct Objects {
    buffers: Vec<glow::Buffer>,
    textures: Vec<(u32, glow::Texture)>,
    sampler: glow::Sampler,
    array: glow::VertexArray,
    framebuffers: [glow::Framebuffer; 2],
    renderbuffer: glow::Renderbuffer,
    program: glow::Program,
    pipeline: u32,
    feedback: glow::TransformFeedback,
}

/// Everything that was asked, by name.
pub type State = BTreeMap<String, Vec<u64>>;

/// A state that can be set to an odd value by itself.
pub type Odd = (&'static str, unsafe fn(&Host<'_>));

const UNITS: u32 = 48;

impl<'g> Host<'g> {
    /// The context is current.
    pub fn new(gl: &'g glow::Context, backend: Backend) -> Self {
        // SAFETY: the context is current; every object is set up before it is used.
        unsafe {
            let buffers: Vec<_> = (0..8)
                .map(|_| {
                    let buffer = gl.create_buffer().unwrap();
                    gl.bind_buffer(glow::ARRAY_BUFFER, Some(buffer));
                    gl.buffer_data_size(glow::ARRAY_BUFFER, 1 << 16, glow::STREAM_COPY);
                    buffer
                })
                .collect();
            gl.bind_buffer(glow::ARRAY_BUFFER, None);
            let textures = TEXTURES.map(|(target, _)| {
                let texture = gl.create_texture().unwrap();
                gl.bind_texture(target, Some(texture));
                match target {
                    glow::TEXTURE_2D => gl.tex_storage_2d(target, 1, glow::RGBA32F, 4, 4),
                    glow::TEXTURE_3D => gl.tex_storage_3d(target, 1, glow::R32F, 4, 4, 4),
                    glow::TEXTURE_RECTANGLE => gl.tex_storage_2d(target, 1, glow::RGBA8, 4, 4),
                    _ => {}
                }
                gl.bind_texture(target, None);
                (target, texture)
            });
            let framebuffers = [(); 2].map(|()| gl.create_framebuffer().unwrap());
            for framebuffer in framebuffers {
                gl.bind_framebuffer(glow::FRAMEBUFFER, Some(framebuffer));
                let (colour, raw) = (glow::COLOR_ATTACHMENT0, Some(textures[0].1));
                gl.framebuffer_texture_2d(glow::FRAMEBUFFER, colour, glow::TEXTURE_2D, raw, 0);
            }
            gl.bind_framebuffer(glow::FRAMEBUFFER, None);
            let mut pipeline = 0;
            let mut host = Self {
                gl,
                backend,
                objects: Objects {
                    buffers,
                    textures: textures.to_vec(),
                    sampler: gl.create_sampler().unwrap(),
                    array: gl.create_vertex_array().unwrap(),
                    framebuffers,
                    renderbuffer: gl.create_renderbuffer().unwrap(),
                    program: program(gl),
                    pipeline: 0,
                    feedback: gl.create_transform_feedback().unwrap(),
                },
            };
            gl_call!(host, "glGenProgramPipelines"(1 => i32, &raw mut pipeline => *mut u32));
            host.objects.pipeline = pipeline;
            assert_eq!(gl.get_error(), glow::NO_ERROR);
            host
        }
    }

    /// Sets everything.
    pub fn set_all(&self) {
        for (name, set) in ODD {
            self.set(name, *set);
        }
    }

    pub fn set(&self, name: &str, set: unsafe fn(&Host<'_>)) {
        // SAFETY: the context is current, and the host's objects are alive.
        let error = unsafe {
            set(self);
            self.gl.get_error()
        };
        assert_eq!(error, glow::NO_ERROR, "{name}");
    }

    /// Active and not paused; its program is in use and writes into a buffer of the host's.
    pub fn begin_feedback(&self) {
        // SAFETY: the context is current, and the host's objects are alive.
        unsafe {
            let gl = self.gl;
            gl.use_program(Some(self.objects.program));
            gl.bind_transform_feedback(glow::TRANSFORM_FEEDBACK, Some(self.objects.feedback));
            let buffer = Some(self.objects.buffers[7]);
            gl.bind_buffer_base(glow::TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
            gl.begin_transform_feedback(glow::TRIANGLES);
            assert_eq!(gl.get_error(), glow::NO_ERROR);
        }
    }

    pub fn end_feedback(&self) {
        // SAFETY: it is active.
        unsafe {
            self.gl.end_transform_feedback();
            assert_eq!(self.gl.get_error(), glow::NO_ERROR);
        }
    }

    pub fn program(&self) -> glow::Program {
        self.objects.program
    }

    /// Everything that can be asked.
    pub fn state(&self) -> State {
        // SAFETY: the context is current; every answer has room for what the longest state has.
        let state = unsafe {
            let mut state = State::new();
            for &name in NUMBERS {
                state.insert(format!("0x{name:04X}"), self.integers(name));
            }
            for &name in FLOATS {
                let mut floats = [0_f32; 16];
                gl_call!(self, "glGetFloatv"(name => u32, floats.as_mut_ptr() => *mut f32));
                let bits = floats.iter().map(|f| u64::from(f.to_bits())).collect();
                state.insert(format!("float 0x{name:04X}"), bits);
            }
            for &name in CAPABILITIES {
                let on = self.gl.is_enabled(name);
                state.insert(format!("enabled 0x{name:04X}"), vec![u64::from(on)]);
            }
            for (names, indices) in INDEXED {
                for (&name, index) in names
                    .iter()
                    .flat_map(|n| (0..*indices).map(move |i| (n, i)))
                {
                    let mut numbers = [0_i32; 16];
                    gl_call!(self, "glGetIntegeri_v"(name => u32, index => u32, numbers.as_mut_ptr() => *mut i32));
                    let bits = numbers.iter().map(|n| *n as u64).collect();
                    state.insert(format!("0x{name:04X}[{index}]"), bits);
                }
            }
            for (name, index) in [glow::VIEWPORT, glow::DEPTH_RANGE]
                .into_iter()
                .flat_map(|name| (0..4).map(move |index| (name, index)))
            {
                let mut floats = [0_f32; 16];
                gl_call!(self, "glGetFloati_v"(name => u32, index => u32, floats.as_mut_ptr() => *mut f32));
                let bits = floats.iter().map(|f| u64::from(f.to_bits())).collect();
                state.insert(format!("float 0x{name:04X}[{index}]"), bits);
            }
            for (name, index) in [(glow::BLEND, 8), (glow::SCISSOR_TEST, 4)]
                .into_iter()
                .flat_map(|(name, indices)| (0..indices).map(move |index| (name, index)))
            {
                let on = gl_call!(self, "glIsEnabledi"(name => u32, index => u32) -> u8);
                state.insert(
                    format!("enabled 0x{name:04X}[{index}]"),
                    vec![u64::from(on)],
                );
            }
            let active = self.gl.get_parameter_i32(glow::ACTIVE_TEXTURE) as u32;
            for unit in 0..UNITS {
                self.gl.active_texture(glow::TEXTURE0 + unit);
                for name in TEXTURES
                    .map(|(_, binding)| binding)
                    .into_iter()
                    .chain([glow::SAMPLER_BINDING])
                {
                    state.insert(format!("0x{name:04X} of unit {unit}"), self.integers(name));
                }
            }
            self.gl.active_texture(active);
            state
        };
        // SAFETY: as above.
        assert_eq!(unsafe { self.gl.get_error() }, glow::NO_ERROR);
        state
    }

    unsafe fn integers(&self, name: u32) -> Vec<u64> {
        let mut numbers = [0_i32; 16];
        // SAFETY: the caller knows that the context is current; no state has more numbers.
        unsafe { gl_call!(self, "glGetIntegerv"(name => u32, numbers.as_mut_ptr() => *mut i32)) };
        numbers.iter().map(|number| *number as u64).collect()
    }
}

/// A program that transform feedback can take positions from.
fn program(gl: &glow::Context) -> glow::Program {
    let sources = [
        (
            glow::VERTEX_SHADER,
            "#version 430 core\nvoid main() { gl_Position = vec4(0.5); }",
        ),
        (
            glow::FRAGMENT_SHADER,
            "#version 430 core\nout vec4 color;\nvoid main() { color = vec4(0.25); }",
        ),
    ];
    // SAFETY: the context is current, and every object is made here.
    unsafe {
        let program = gl.create_program().unwrap();
        for (kind, source) in sources {
            let shader = gl.create_shader(kind).unwrap();
            gl.shader_source(shader, source);
            gl.compile_shader(shader);
            gl.attach_shader(program, shader);
            gl.delete_shader(shader);
        }
        gl.transform_feedback_varyings(program, &["gl_Position"], glow::INTERLEAVED_ATTRIBS);
        gl.link_program(program);
        assert!(gl.get_program_link_status(program));
        program
    }
}

/// Targets that the host has a texture of, and their bindings.
const TEXTURES: [(u32, u32); 9] = [
    (glow::TEXTURE_2D, glow::TEXTURE_BINDING_2D),
    (glow::TEXTURE_3D, glow::TEXTURE_BINDING_3D),
    (glow::TEXTURE_BUFFER, glow::TEXTURE_BINDING_BUFFER),
    (glow::TEXTURE_RECTANGLE, glow::TEXTURE_BINDING_RECTANGLE),
    (glow::TEXTURE_1D, glow::TEXTURE_BINDING_1D),
    (glow::TEXTURE_2D_ARRAY, glow::TEXTURE_BINDING_2D_ARRAY),
    (glow::TEXTURE_CUBE_MAP, glow::TEXTURE_BINDING_CUBE_MAP),
    (
        glow::TEXTURE_2D_MULTISAMPLE,
        glow::TEXTURE_BINDING_2D_MULTISAMPLE,
    ),
    (glow::TEXTURE_1D_ARRAY, glow::TEXTURE_BINDING_1D_ARRAY),
];

const CAPABILITIES: &[u32] = &[
    glow::BLEND,
    glow::COLOR_LOGIC_OP,
    glow::CULL_FACE,
    glow::DEBUG_OUTPUT,
    glow::DEBUG_OUTPUT_SYNCHRONOUS,
    glow::DEPTH_CLAMP,
    glow::DEPTH_TEST,
    glow::DITHER,
    glow::FRAMEBUFFER_SRGB,
    glow::LINE_SMOOTH,
    glow::MULTISAMPLE,
    glow::POLYGON_OFFSET_FILL,
    glow::POLYGON_OFFSET_LINE,
    glow::POLYGON_OFFSET_POINT,
    glow::POLYGON_SMOOTH,
    glow::PRIMITIVE_RESTART,
    glow::PRIMITIVE_RESTART_FIXED_INDEX,
    glow::PROGRAM_POINT_SIZE,
    glow::RASTERIZER_DISCARD,
    glow::SAMPLE_ALPHA_TO_COVERAGE,
    glow::SAMPLE_ALPHA_TO_ONE,
    glow::SAMPLE_COVERAGE,
    glow::SAMPLE_MASK,
    glow::SAMPLE_SHADING,
    glow::SCISSOR_TEST,
    glow::STENCIL_TEST,
    glow::TEXTURE_CUBE_MAP_SEAMLESS,
    glow::CLIP_DISTANCE0,
    glow::CLIP_DISTANCE1,
    glow::CLIP_DISTANCE2,
    glow::CLIP_DISTANCE3,
    glow::CLIP_DISTANCE4,
    glow::CLIP_DISTANCE5,
    glow::CLIP_DISTANCE6,
    glow::CLIP_DISTANCE7,
];

const PROVOKING_VERTEX: u32 = 0x8E4F;
const PROGRAM_PIPELINE_BINDING: u32 = 0x825A;
const PATCH_VERTICES: u32 = 0x8E72;
const CLAMP_READ_COLOR: u32 = 0x891C;
const POINT_FADE_THRESHOLD_SIZE: u32 = 0x8128;
const POINT_SPRITE_COORD_ORIGIN: u32 = 0x8CA0;
const DRAW_INDIRECT_BUFFER_BINDING: u32 = 0x8F43;
const DISPATCH_INDIRECT_BUFFER_BINDING: u32 = 0x90EF;
const ATOMIC_COUNTER_BUFFER_BINDING: u32 = 0x92C1;
const TRANSFORM_FEEDBACK_BINDING: u32 = 0x8E25;

const NUMBERS: &[u32] = &[
    glow::ACTIVE_TEXTURE,
    glow::ARRAY_BUFFER_BINDING,
    glow::ELEMENT_ARRAY_BUFFER_BINDING,
    glow::BLEND_DST_ALPHA,
    glow::BLEND_DST_RGB,
    glow::BLEND_EQUATION_ALPHA,
    glow::BLEND_EQUATION_RGB,
    glow::BLEND_SRC_ALPHA,
    glow::BLEND_SRC_RGB,
    glow::COLOR_WRITEMASK,
    glow::COPY_READ_BUFFER_BINDING,
    glow::COPY_WRITE_BUFFER_BINDING,
    glow::CULL_FACE_MODE,
    glow::CURRENT_PROGRAM,
    glow::DEPTH_FUNC,
    glow::DEPTH_WRITEMASK,
    DISPATCH_INDIRECT_BUFFER_BINDING,
    DRAW_INDIRECT_BUFFER_BINDING,
    glow::DRAW_BUFFER0,
    glow::DRAW_FRAMEBUFFER_BINDING,
    glow::READ_FRAMEBUFFER_BINDING,
    glow::READ_BUFFER,
    glow::RENDERBUFFER_BINDING,
    glow::FRAGMENT_SHADER_DERIVATIVE_HINT,
    glow::LINE_SMOOTH_HINT,
    glow::POLYGON_SMOOTH_HINT,
    glow::TEXTURE_COMPRESSION_HINT,
    glow::FRONT_FACE,
    glow::LOGIC_OP_MODE,
    PATCH_VERTICES,
    glow::POLYGON_MODE,
    glow::PRIMITIVE_RESTART_INDEX,
    PROGRAM_PIPELINE_BINDING,
    PROVOKING_VERTEX,
    glow::SAMPLE_COVERAGE_INVERT,
    glow::SCISSOR_BOX,
    glow::STENCIL_BACK_FAIL,
    glow::STENCIL_BACK_FUNC,
    glow::STENCIL_BACK_PASS_DEPTH_FAIL,
    glow::STENCIL_BACK_PASS_DEPTH_PASS,
    glow::STENCIL_BACK_REF,
    glow::STENCIL_BACK_VALUE_MASK,
    glow::STENCIL_BACK_WRITEMASK,
    glow::STENCIL_FAIL,
    glow::STENCIL_FUNC,
    glow::STENCIL_PASS_DEPTH_FAIL,
    glow::STENCIL_PASS_DEPTH_PASS,
    glow::STENCIL_REF,
    glow::STENCIL_VALUE_MASK,
    glow::STENCIL_WRITEMASK,
    glow::STENCIL_CLEAR_VALUE,
    glow::SHADER_STORAGE_BUFFER_BINDING,
    glow::UNIFORM_BUFFER_BINDING,
    ATOMIC_COUNTER_BUFFER_BINDING,
    glow::TRANSFORM_FEEDBACK_BUFFER_BINDING,
    TRANSFORM_FEEDBACK_BINDING,
    glow::TRANSFORM_FEEDBACK_ACTIVE,
    glow::TRANSFORM_FEEDBACK_PAUSED,
    glow::VERTEX_ARRAY_BINDING,
    glow::PIXEL_PACK_BUFFER_BINDING,
    glow::PIXEL_UNPACK_BUFFER_BINDING,
    glow::QUERY_BUFFER_BINDING,
    CLAMP_READ_COLOR,
    glow::CLIP_ORIGIN,
    glow::CLIP_DEPTH_MODE,
    POINT_SPRITE_COORD_ORIGIN,
    glow::DEBUG_GROUP_STACK_DEPTH,
    glow::PACK_ALIGNMENT,
    glow::PACK_IMAGE_HEIGHT,
    glow::PACK_LSB_FIRST,
    glow::PACK_ROW_LENGTH,
    glow::PACK_SKIP_IMAGES,
    glow::PACK_SKIP_PIXELS,
    glow::PACK_SKIP_ROWS,
    glow::PACK_SWAP_BYTES,
    glow::UNPACK_ALIGNMENT,
    glow::UNPACK_IMAGE_HEIGHT,
    glow::UNPACK_LSB_FIRST,
    glow::UNPACK_ROW_LENGTH,
    glow::UNPACK_SKIP_IMAGES,
    glow::UNPACK_SKIP_PIXELS,
    glow::UNPACK_SKIP_ROWS,
    glow::UNPACK_SWAP_BYTES,
];

const FLOATS: &[u32] = &[
    glow::BLEND_COLOR,
    glow::COLOR_CLEAR_VALUE,
    glow::DEPTH_CLEAR_VALUE,
    glow::LINE_WIDTH,
    glow::MIN_SAMPLE_SHADING_VALUE,
    POINT_FADE_THRESHOLD_SIZE,
    glow::POINT_SIZE,
    glow::POLYGON_OFFSET_FACTOR,
    glow::POLYGON_OFFSET_UNITS,
    glow::SAMPLE_COVERAGE_VALUE,
];

/// Names, and how many indices are asked.
const INDEXED: &[(&[u32], u32)] = &[
    (
        &[
            glow::BLEND_SRC_RGB,
            glow::BLEND_DST_RGB,
            glow::BLEND_SRC_ALPHA,
            glow::BLEND_DST_ALPHA,
            glow::BLEND_EQUATION_RGB,
            glow::BLEND_EQUATION_ALPHA,
            glow::COLOR_WRITEMASK,
            glow::SHADER_STORAGE_BUFFER_BINDING,
            glow::SHADER_STORAGE_BUFFER_START,
            glow::SHADER_STORAGE_BUFFER_SIZE,
            glow::UNIFORM_BUFFER_BINDING,
            glow::UNIFORM_BUFFER_START,
            glow::UNIFORM_BUFFER_SIZE,
            glow::IMAGE_BINDING_NAME,
            glow::IMAGE_BINDING_LEVEL,
            glow::IMAGE_BINDING_LAYERED,
            glow::IMAGE_BINDING_LAYER,
            glow::IMAGE_BINDING_ACCESS,
            glow::IMAGE_BINDING_FORMAT,
        ],
        8,
    ),
    (&[glow::SCISSOR_BOX], 4),
    (&[glow::SAMPLE_MASK_VALUE, ATOMIC_COUNTER_BUFFER_BINDING], 1),
];
