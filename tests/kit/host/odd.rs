//! States of a host's that are odd: each by a name, with the calls that set it.

#![allow(unsafe_code)]
// a host calls GL
// SAFETY, the same for all: `Host::set`, which calls them, knows that the context is current and the host's objects alive.
#![allow(clippy::undocumented_unsafe_blocks)]

use glow::HasContext;

use super::super::loader;
use super::{
    CLAMP_READ_COLOR, Odd, PATCH_VERTICES, POINT_FADE_THRESHOLD_SIZE, POINT_SPRITE_COORD_ORIGIN,
    UNITS, gl_call,
};

/// Mesa clamps the sides in place, in memory that it was given to read: a constant would make it crash.
fn odd(viewport: [f32; 4]) -> [f32; 4] {
    std::hint::black_box(viewport)
}

/// Every state that is set, alone or with all others. An odd value is one that no fresh context has.
pub const ODD: &[Odd] = &[
    ("rasterizer discard", |h| unsafe {
        h.gl.enable(glow::RASTERIZER_DISCARD)
    }),
    ("logic op", |h| unsafe {
        h.gl.enable(glow::COLOR_LOGIC_OP);
        gl_call!(h, "glLogicOp"(0x150A => u32)); // GL_INVERT
    }),
    ("polygon mode", |h| unsafe {
        h.gl.polygon_mode(glow::FRONT_AND_BACK, glow::LINE)
    }),
    ("polygon offset", |h| unsafe {
        for cap in [
            glow::POLYGON_OFFSET_FILL,
            glow::POLYGON_OFFSET_LINE,
            glow::POLYGON_OFFSET_POINT,
        ] {
            h.gl.enable(cap);
        }
        h.gl.polygon_offset(-3.0, -1e6);
    }),
    ("primitive restart", |h| unsafe {
        h.gl.enable(glow::PRIMITIVE_RESTART);
        gl_call!(h, "glPrimitiveRestartIndex"(1 => u32));
    }),
    ("primitive restart, fixed index", |h| unsafe {
        h.gl.enable(glow::PRIMITIVE_RESTART_FIXED_INDEX)
    }),
    ("clip control", |h| unsafe {
        gl_call!(h, "glClipControl"(glow::UPPER_LEFT => u32, glow::ZERO_TO_ONE => u32));
    }),
    ("front face", |h| unsafe { h.gl.front_face(glow::CW) }),
    ("culling", |h| unsafe {
        h.gl.enable(glow::CULL_FACE);
        h.gl.cull_face(glow::FRONT_AND_BACK);
    }),
    ("clip distances", |h| unsafe {
        (0..8).for_each(|i| h.gl.enable(glow::CLIP_DISTANCE0 + i))
    }),
    ("depth clamp", |h| unsafe { h.gl.enable(glow::DEPTH_CLAMP) }),
    ("depth test", |h| unsafe {
        h.gl.enable(glow::DEPTH_TEST);
        h.gl.depth_func(glow::NEVER);
        h.gl.depth_mask(false);
    }),
    ("depth range", |h| unsafe {
        h.gl.depth_range_f64(0.75, 0.25)
    }),
    ("depth range of viewport 2", |h| unsafe {
        h.gl.depth_range_f64_slice(2, 1, &[[0.125, 0.5]])
    }),
    ("stencil", |h| unsafe {
        h.gl.enable(glow::STENCIL_TEST);
        for (face, n) in [(glow::FRONT, 3), (glow::BACK, 5)] {
            h.gl.stencil_func_separate(face, glow::NOTEQUAL, n, 0x0F + n as u32);
            h.gl.stencil_mask_separate(face, 0x30 + n as u32);
            h.gl.stencil_op_separate(face, glow::INVERT, glow::INCR, glow::DECR_WRAP);
        }
    }),
    ("blending", |h| unsafe {
        h.gl.enable(glow::BLEND);
        h.gl.blend_color(0.1, 0.2, 0.3, 0.4);
        h.gl.blend_func_separate(
            glow::DST_COLOR,
            glow::SRC_COLOR,
            glow::CONSTANT_ALPHA,
            glow::DST_ALPHA,
        );
        h.gl.blend_equation_separate(glow::FUNC_SUBTRACT, glow::MAX);
    }),
    ("blending of buffer 1", |h| unsafe {
        h.gl.disable_draw_buffer(glow::BLEND, 1);
        h.gl.blend_func_draw_buffer(1, glow::ZERO, glow::ZERO);
        h.gl.blend_equation_draw_buffer(1, glow::MIN);
    }),
    ("color mask", |h| unsafe {
        h.gl.color_mask(true, false, true, false)
    }),
    ("color mask of buffer 3", |h| unsafe {
        h.gl.color_mask_draw_buffer(3, false, true, false, true)
    }),
    ("clear values", |h| unsafe {
        h.gl.clear_color(0.1, 0.2, 0.3, 0.4);
        h.gl.clear_depth_f64(0.3);
        h.gl.clear_stencil(0x55);
    }),
    ("scissor", |h| unsafe {
        h.gl.enable(glow::SCISSOR_TEST);
        h.gl.scissor(1, 2, 3, 4);
    }),
    ("scissor of viewport 2", |h| unsafe {
        h.gl.disable_draw_buffer(glow::SCISSOR_TEST, 2);
        h.gl.scissor_slice(2, 1, &[[5, 6, 7, 8]]);
    }),
    ("viewport", |h| unsafe {
        h.gl.viewport_f32_slice(0, 1, &[odd([1.5, 2.5, 3.5, 4.5])])
    }),
    ("viewport 3", |h| unsafe {
        h.gl.viewport_f32_slice(3, 1, &[odd([0.5, 0.5, 2.5, 2.5])])
    }),
    ("dither and sRGB", |h| unsafe {
        h.gl.disable(glow::DITHER);
        h.gl.enable(glow::FRAMEBUFFER_SRGB);
    }),
    ("multisampling", |h| unsafe {
        h.gl.disable(glow::MULTISAMPLE);
        for cap in [
            glow::SAMPLE_ALPHA_TO_COVERAGE,
            glow::SAMPLE_ALPHA_TO_ONE,
            glow::SAMPLE_COVERAGE,
            glow::SAMPLE_MASK,
            glow::SAMPLE_SHADING,
        ] {
            h.gl.enable(cap);
        }
        h.gl.sample_coverage(0.25, true);
        gl_call!(h, "glSampleMaski"(0 => u32, 0 => u32));
        gl_call!(h, "glMinSampleShading"(0.5 => f32));
    }),
    ("smoothing", |h| unsafe {
        h.gl.enable(glow::POLYGON_SMOOTH);
        h.gl.enable(glow::LINE_SMOOTH);
    }),
    ("points and lines", |h| unsafe {
        h.gl.enable(glow::PROGRAM_POINT_SIZE);
        gl_call!(h, "glPointSize"(3.0 => f32));
        gl_call!(h, "glPointParameterf"(POINT_FADE_THRESHOLD_SIZE => u32, 2.0 => f32));
        gl_call!(h, "glPointParameteri"(POINT_SPRITE_COORD_ORIGIN => u32, glow::LOWER_LEFT as i32 => i32));
    }),
    ("provoking vertex", |h| unsafe {
        gl_call!(h, "glProvokingVertex"(0x8E4D => u32)); // GL_FIRST_VERTEX_CONVENTION
    }),
    ("patches", |h| unsafe {
        h.gl.patch_parameter_i32(PATCH_VERTICES, 5)
    }),
    ("seamless cube maps", |h| unsafe {
        h.gl.enable(glow::TEXTURE_CUBE_MAP_SEAMLESS)
    }),
    ("hints", |h| unsafe {
        for hint in [
            glow::FRAGMENT_SHADER_DERIVATIVE_HINT,
            glow::LINE_SMOOTH_HINT,
            glow::POLYGON_SMOOTH_HINT,
            glow::TEXTURE_COMPRESSION_HINT,
        ] {
            gl_call!(h, "glHint"(hint => u32, glow::FASTEST => u32));
        }
    }),
    ("clamping of what is read", |h| unsafe {
        gl_call!(h, "glClampColor"(CLAMP_READ_COLOR => u32, 1 => u32));
    }),
    ("textures and samplers of every unit", |h| unsafe {
        for unit in 0..UNITS {
            h.gl.active_texture(glow::TEXTURE0 + unit);
            for (target, texture) in &h.objects.textures {
                h.gl.bind_texture(*target, Some(*texture));
            }
            h.gl.bind_sampler(unit, Some(h.objects.sampler));
        }
        h.gl.sampler_parameter_i32(
            h.objects.sampler,
            glow::TEXTURE_MIN_FILTER,
            glow::LINEAR as i32,
        );
        h.gl.active_texture(glow::TEXTURE0 + 11);
    }),
    ("images", |h| unsafe {
        for unit in 0..8 {
            h.gl.bind_image_texture(
                unit,
                Some(h.objects.textures[0].1),
                0,
                true,
                0,
                glow::WRITE_ONLY,
                glow::RGBA32F,
            );
        }
    }),
    ("buffers", |h| unsafe {
        let b = &h.objects.buffers;
        for index in 0..8 {
            h.gl.bind_buffer_range(glow::SHADER_STORAGE_BUFFER, index, Some(b[0]), 256, 1024);
            h.gl.bind_buffer_base(glow::UNIFORM_BUFFER, index, Some(b[1]));
        }
        h.gl.bind_buffer_base(glow::ATOMIC_COUNTER_BUFFER, 0, Some(b[2]));
        for (number, target) in [
            glow::ARRAY_BUFFER,
            glow::SHADER_STORAGE_BUFFER,
            glow::UNIFORM_BUFFER,
            glow::COPY_READ_BUFFER,
            glow::COPY_WRITE_BUFFER,
            glow::DRAW_INDIRECT_BUFFER,
            glow::DISPATCH_INDIRECT_BUFFER,
        ]
        .into_iter()
        .enumerate()
        {
            h.gl.bind_buffer(target, Some(b[(number + 3) % b.len()]));
        }
    }),
    ("query buffer", |h| unsafe {
        h.gl.bind_buffer(glow::QUERY_BUFFER, Some(h.objects.buffers[6]))
    }),
    ("pixel buffers", |h| unsafe {
        h.gl.bind_buffer(glow::PIXEL_PACK_BUFFER, Some(h.objects.buffers[4]));
        h.gl.bind_buffer(glow::PIXEL_UNPACK_BUFFER, Some(h.objects.buffers[5]));
    }),
    ("pixel store", |h| unsafe {
        for (name, value) in [
            (glow::PACK_SWAP_BYTES, 1),
            (glow::PACK_ROW_LENGTH, 33),
            (glow::PACK_SKIP_ROWS, 2),
            (glow::PACK_SKIP_PIXELS, 3),
            (glow::PACK_ALIGNMENT, 8),
            (glow::PACK_LSB_FIRST, 1),
            (glow::PACK_IMAGE_HEIGHT, 17),
            (glow::PACK_SKIP_IMAGES, 1),
            (glow::UNPACK_SWAP_BYTES, 1),
            (glow::UNPACK_ROW_LENGTH, 33),
            (glow::UNPACK_SKIP_ROWS, 2),
            (glow::UNPACK_SKIP_PIXELS, 3),
            (glow::UNPACK_ALIGNMENT, 8),
            (glow::UNPACK_LSB_FIRST, 1),
            (glow::UNPACK_IMAGE_HEIGHT, 17),
            (glow::UNPACK_SKIP_IMAGES, 1),
        ] {
            h.gl.pixel_store_i32(name, value);
        }
    }),
    ("framebuffers", |h| unsafe {
        h.gl.bind_framebuffer(glow::DRAW_FRAMEBUFFER, Some(h.objects.framebuffers[0]));
        h.gl.bind_framebuffer(glow::READ_FRAMEBUFFER, Some(h.objects.framebuffers[1]));
        h.gl.draw_buffers(&[glow::NONE]);
        h.gl.read_buffer(glow::NONE);
        h.gl.bind_renderbuffer(glow::RENDERBUFFER, Some(h.objects.renderbuffer));
    }),
    ("vertex array", |h| unsafe {
        h.gl.bind_vertex_array(Some(h.objects.array));
        h.gl.bind_buffer(glow::ELEMENT_ARRAY_BUFFER, Some(h.objects.buffers[3]));
    }),
    ("program and pipeline", |h| unsafe {
        gl_call!(h, "glBindProgramPipeline"(h.objects.pipeline => u32));
        h.gl.use_program(Some(h.objects.program));
    }),
    ("transform feedback", |h| unsafe {
        h.gl.bind_transform_feedback(glow::TRANSFORM_FEEDBACK, Some(h.objects.feedback));
    }),
    ("debug output and groups", |h| unsafe {
        h.gl.enable(glow::DEBUG_OUTPUT);
        h.gl.enable(glow::DEBUG_OUTPUT_SYNCHRONOUS);
        h.gl.push_debug_group(glow::DEBUG_SOURCE_APPLICATION, 0, "the host's");
    }),
];
