//! The state of fixed functions that the whole context shares.

use glow::HasContext;

use super::super::context::Context;
use super::bindings::has_query_buffer;
use super::per_buffer::PerBuffer;

/// Capabilities that are disabled when a frame begins. Listings enable those that they need.
const CAPABILITIES: [u32; 25] = [
    glow::DEPTH_TEST,
    glow::STENCIL_TEST,
    glow::CULL_FACE,
    glow::DITHER,
    glow::DEPTH_CLAMP,
    glow::RASTERIZER_DISCARD,
    glow::COLOR_LOGIC_OP,
    glow::POLYGON_OFFSET_FILL,
    glow::POLYGON_SMOOTH,
    glow::PRIMITIVE_RESTART,
    glow::PRIMITIVE_RESTART_FIXED_INDEX,
    glow::SAMPLE_ALPHA_TO_COVERAGE,
    glow::SAMPLE_ALPHA_TO_ONE,
    glow::SAMPLE_COVERAGE,
    glow::SAMPLE_SHADING,
    glow::SAMPLE_MASK,
    glow::FRAMEBUFFER_SRGB,
    glow::CLIP_DISTANCE0,
    glow::CLIP_DISTANCE1,
    glow::CLIP_DISTANCE2,
    glow::CLIP_DISTANCE3,
    glow::CLIP_DISTANCE4,
    glow::CLIP_DISTANCE5,
    glow::CLIP_DISTANCE6,
    glow::CLIP_DISTANCE7,
];

/// The same for compatibility profiles: the alpha test and the polygon stipple.
const OF_OLD: [u32; 2] = [0x0BC0, 0x0B42];

/// The same for extensions.
const OF_EXTENSIONS: [(&str, u32); 9] = [
    ("GL_EXT_depth_bounds_test", 0x8890),
    ("GL_EXT_stencil_two_side", 0x8910),
    ("GL_EXT_raster_multisample", 0x9327),
    ("GL_NV_conservative_raster", 0x9346),
    ("GL_INTEL_conservative_rasterization", 0x83FE),
    ("GL_NV_fragment_coverage_to_color", 0x92DD),
    ("GL_NV_shading_rate_image", 0x9563),
    ("GL_NV_scissor_exclusive", 0x9555),
    ("GL_NV_representative_fragment_test", 0x937F),
];

const INITIAL_CLIP_CONTROL: [u32; 2] = [glow::LOWER_LEFT, glow::NEGATIVE_ONE_TO_ONE];
/// Nothing is shaded flat by it here; but rasterisers begin with that vertex, and round otherwise.
const PROVOKING_VERTEX: u32 = 0x8E4F;
const LAST_VERTEX: u32 = 0x8E4E;
const CLAMP_FRAGMENT_COLOR: u32 = 0x891B;
const FIXED_ONLY: u32 = 0x891D;

/// All of this state, either the current one or the one that a frame needs.
#[derive(Debug)]
pub(super) struct Fixed {
    enabled: Vec<(u32, bool)>,
    depth_func: u32,
    depth_mask: bool,
    depth_range: [f64; 2],
    stencil: [Stencil; 2],
    clear_color: [f32; 4],
    clear_depth: f64,
    clear_stencil: i32,
    viewport: [f32; 4],
    scissor: [i32; 4],
    /// Of the first viewport.
    scissored: bool,
    /// Front and back, which a core profile keeps the same.
    polygon_mode: [i32; 2],
    front_face: u32,
    provoking_vertex: u32,
    /// Origin and depth mode, where there are others.
    clip_control: Option<[u32; 2]>,
    /// Of a compatibility profile.
    clamp_fragments: Option<u32>,
}

/// The stencil state of a face.
#[derive(Clone, Copy, Debug)]
struct Stencil {
    func: u32,
    reference: i32,
    value_mask: u32,
    mask: u32,
    op: [u32; 3],
}

const FACES: [u32; 2] = [glow::FRONT, glow::BACK];
/// The names of a face's values: function, reference, its mask, what is written, the three operations.
const STENCIL_NAMES: [[u32; 7]; 2] = [
    [
        glow::STENCIL_FUNC,
        glow::STENCIL_REF,
        glow::STENCIL_VALUE_MASK,
        glow::STENCIL_WRITEMASK,
        glow::STENCIL_FAIL,
        glow::STENCIL_PASS_DEPTH_FAIL,
        glow::STENCIL_PASS_DEPTH_PASS,
    ],
    [
        glow::STENCIL_BACK_FUNC,
        glow::STENCIL_BACK_REF,
        glow::STENCIL_BACK_VALUE_MASK,
        glow::STENCIL_BACK_WRITEMASK,
        glow::STENCIL_BACK_FAIL,
        glow::STENCIL_BACK_PASS_DEPTH_FAIL,
        glow::STENCIL_BACK_PASS_DEPTH_PASS,
    ],
];

/// GL's initial state, as a fresh context has it, with a viewport of `size`. The context is current.
pub(in crate::low_level::gl) fn known_state(context: &Context, size: [u32; 2]) {
    let [width, height] = size;
    let stencil = Stencil {
        func: glow::ALWAYS,
        reference: 0,
        value_mask: 0xFF,
        mask: 0xFF,
        op: [glow::KEEP; 3],
    };
    let known = Fixed {
        enabled: capabilities(context).map(|name| (name, false)).collect(),
        depth_func: glow::LESS,
        depth_mask: true,
        depth_range: [0.0, 1.0],
        stencil: [stencil; 2],
        clear_color: [0.0; 4],
        clear_depth: 1.0,
        clear_stencil: 0,
        viewport: [0.0, 0.0, width as f32, height as f32],
        scissor: [0, 0, width as i32, height as i32],
        scissored: false,
        polygon_mode: [glow::FILL as i32; 2],
        front_face: glow::CCW,
        provoking_vertex: LAST_VERTEX,
        clip_control: clip_control(context).map(|_| INITIAL_CLIP_CONTROL),
        clamp_fragments: clamp_fragments(context).map(|_| FIXED_ONLY),
    };
    known.set(context);
    PerBuffer::initial().set(context);
    if has_query_buffer(context) {
        // With a buffer bound there, a query's answer goes into it, and not to where it is asked for.
        // SAFETY: the context is current.
        unsafe { context.glow().bind_buffer(glow::QUERY_BUFFER, None) };
    }
}

/// The call that the host has to make before a frame, because it cannot be made from here: of state that is not OpenGL's
/// initial one, and whose function glow does not have and nobody else, either.
pub(super) fn out_of_reach(context: &Context) -> Option<&'static str> {
    let more = context.more();
    if clip_control(context).is_some_and(|there| there != INITIAL_CLIP_CONTROL)
        && !more.has_clip_control()
    {
        return Some("glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE)");
    }
    (provoking_vertex(context) != LAST_VERTEX && !more.has_provoking_vertex())
        .then_some("glProvokingVertex(GL_LAST_VERTEX_CONVENTION)")
}

fn provoking_vertex(context: &Context) -> u32 {
    // SAFETY: the context is current, and it is a single number.
    unsafe { context.glow().get_parameter_i32(PROVOKING_VERTEX) as u32 }
}

fn capabilities(context: &Context) -> impl Iterator<Item = u32> {
    let driver = context.driver();
    let of_old = driver.has_fixed_functions.then_some(OF_OLD);
    let of_extensions = OF_EXTENSIONS
        .iter()
        .filter(|(extension, _)| driver.has(extension))
        .map(|(_, capability)| *capability);
    CAPABILITIES
        .into_iter()
        .chain(of_old.into_iter().flatten())
        .chain(of_extensions)
}

/// Origin and depth mode.
fn clip_control(context: &Context) -> Option<[u32; 2]> {
    let driver = context.driver();
    let there = driver.version >= (4, 5) || driver.has("GL_ARB_clip_control");
    // SAFETY: both are single numbers where there is a clip control.
    there.then(|| unsafe {
        [glow::CLIP_ORIGIN, glow::CLIP_DEPTH_MODE]
            .map(|name| context.glow().get_parameter_i32(name) as u32)
    })
}

fn clamp_fragments(context: &Context) -> Option<u32> {
    // SAFETY: a single number in every compatibility profile.
    context
        .driver()
        .has_fixed_functions
        .then(|| unsafe { context.glow().get_parameter_i32(CLAMP_FRAGMENT_COLOR) as u32 })
}

impl Fixed {
    pub(super) fn read(context: &Context) -> Self {
        let gl = context.glow();
        let mut viewport = [0.0; 4];
        let mut scissor = [0; 4];
        let mut range = [0.0; 2];
        let mut clear_color = [0.0; 4];
        // Drivers of core profiles answer with one number or with two.
        let mut polygon_mode = [0; 2];
        // SAFETY: every slice is as long as its state has numbers.
        unsafe {
            gl.get_parameter_f32_slice(glow::VIEWPORT, &mut viewport);
            gl.get_parameter_i32_slice(glow::SCISSOR_BOX, &mut scissor);
            gl.get_parameter_f32_slice(glow::DEPTH_RANGE, &mut range);
            gl.get_parameter_f32_slice(glow::COLOR_CLEAR_VALUE, &mut clear_color);
            gl.get_parameter_i32_slice(glow::POLYGON_MODE, &mut polygon_mode);
        }
        if !context.driver().has_fixed_functions {
            polygon_mode[1] = polygon_mode[0];
        }
        let number = |name| {
            // SAFETY: each is a single number.
            unsafe { gl.get_parameter_i32(name) }
        };
        let more = context.more();
        Self {
            enabled: capabilities(context)
                // SAFETY: each is a capability of this context.
                .map(|name| (name, unsafe { gl.is_enabled(name) }))
                .collect(),
            depth_func: number(glow::DEPTH_FUNC) as u32,
            depth_mask: number(glow::DEPTH_WRITEMASK) != 0,
            depth_range: more
                .doubles(glow::DEPTH_RANGE)
                .unwrap_or(range.map(f64::from)),
            stencil: STENCIL_NAMES.map(|names| {
                let [func, reference, value_mask, mask, fail, depth_fail, pass] = names.map(number);
                Stencil {
                    func: func as u32,
                    reference,
                    value_mask: value_mask as u32,
                    mask: mask as u32,
                    op: [fail, depth_fail, pass].map(|op| op as u32),
                }
            }),
            clear_color,
            clear_depth: more.doubles(glow::DEPTH_CLEAR_VALUE).map_or_else(
                // SAFETY: a single number.
                || f64::from(unsafe { gl.get_parameter_f32(glow::DEPTH_CLEAR_VALUE) }),
                |[depth]| depth,
            ),
            clear_stencil: number(glow::STENCIL_CLEAR_VALUE),
            viewport,
            scissor,
            // SAFETY: a capability of every context; of the first viewport.
            scissored: unsafe { gl.is_enabled(glow::SCISSOR_TEST) },
            polygon_mode,
            front_face: number(glow::FRONT_FACE) as u32,
            provoking_vertex: number(PROVOKING_VERTEX) as u32,
            clip_control: clip_control(context),
            clamp_fragments: clamp_fragments(context),
        }
    }

    pub(super) fn set(&self, context: &Context) {
        let gl = context.glow();
        // SAFETY: the context is current; the values are OpenGL's own or what it has answered.
        unsafe {
            for &(name, on) in &self.enabled {
                if on {
                    gl.enable(name)
                } else {
                    gl.disable(name)
                }
            }
            gl.depth_func(self.depth_func);
            gl.depth_mask(self.depth_mask);
            gl.depth_range_f64_slice(0, 1, &[self.depth_range]);
            for (face, stencil) in FACES.into_iter().zip(self.stencil) {
                let [fail, depth_fail, pass] = stencil.op;
                gl.stencil_func_separate(face, stencil.func, stencil.reference, stencil.value_mask);
                gl.stencil_mask_separate(face, stencil.mask);
                gl.stencil_op_separate(face, fail, depth_fail, pass);
            }
            let [red, green, blue, alpha] = self.clear_color;
            gl.clear_color(red, green, blue, alpha);
            gl.clear_depth_f64(self.clear_depth);
            gl.clear_stencil(self.clear_stencil);
            // Mesa clamps the sides in place, though it is given the array to read: it must not be a constant.
            let viewport = std::hint::black_box([self.viewport]);
            gl.viewport_f32_slice(0, 1, &viewport);
            gl.scissor_slice(0, 1, &[self.scissor]);
            if self.scissored {
                gl.enable_draw_buffer(glow::SCISSOR_TEST, 0);
            } else {
                gl.disable_draw_buffer(glow::SCISSOR_TEST, 0);
            }
            let [front, back] = self.polygon_mode.map(|mode| mode as u32);
            if front == back {
                gl.polygon_mode(glow::FRONT_AND_BACK, front);
            } else {
                gl.polygon_mode(glow::FRONT, front);
                gl.polygon_mode(glow::BACK, back);
            }
            gl.front_face(self.front_face);
        }
        if self.provoking_vertex != provoking_vertex(context) {
            context.more().provoking_vertex(self.provoking_vertex);
        }
        if let Some(wanted) = self.clamp_fragments
            && Some(wanted) != clamp_fragments(context)
        {
            context.more().clamp_color(CLAMP_FRAGMENT_COLOR, wanted);
        }
        if let Some(wanted) = self.clip_control
            && Some(wanted) != clip_control(context)
        {
            context.more().clip_control(wanted);
        }
    }
}
