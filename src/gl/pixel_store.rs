//! The layout of pixels in memory on their way to the driver and back.
//!
//! In GL this layout is state. With someone else's row length, skips or pixel buffer, reading a texture would write
//! past the slice. So every transfer owns this state as long as it lasts.

use std::ffi::{c_float, c_uint, c_void};

use glow::HasContext;

use super::context::Context;

/// Every `glPixelStore` value, and what a transfer of tightly packed rows needs it to be.
const VALUES: [(u32, i32); 24] = [
    (glow::PACK_SWAP_BYTES, 0),
    (glow::PACK_LSB_FIRST, 0),
    (glow::PACK_ROW_LENGTH, 0),
    (glow::PACK_IMAGE_HEIGHT, 0),
    (glow::PACK_SKIP_ROWS, 0),
    (glow::PACK_SKIP_PIXELS, 0),
    (glow::PACK_SKIP_IMAGES, 0),
    (glow::PACK_ALIGNMENT, 1),
    (glow::PACK_COMPRESSED_BLOCK_WIDTH, 0),
    (glow::PACK_COMPRESSED_BLOCK_HEIGHT, 0),
    (glow::PACK_COMPRESSED_BLOCK_DEPTH, 0),
    (glow::PACK_COMPRESSED_BLOCK_SIZE, 0),
    (glow::UNPACK_SWAP_BYTES, 0),
    (glow::UNPACK_LSB_FIRST, 0),
    (glow::UNPACK_ROW_LENGTH, 0),
    (glow::UNPACK_IMAGE_HEIGHT, 0),
    (glow::UNPACK_SKIP_ROWS, 0),
    (glow::UNPACK_SKIP_PIXELS, 0),
    (glow::UNPACK_SKIP_IMAGES, 0),
    (glow::UNPACK_ALIGNMENT, 1),
    (glow::UNPACK_COMPRESSED_BLOCK_WIDTH, 0),
    (glow::UNPACK_COMPRESSED_BLOCK_HEIGHT, 0),
    (glow::UNPACK_COMPRESSED_BLOCK_DEPTH, 0),
    (glow::UNPACK_COMPRESSED_BLOCK_SIZE, 0),
];

/// Targets and bindings of the buffers that replace a pointer.
const BUFFERS: [(u32, u32); 2] = [
    (glow::PIXEL_PACK_BUFFER, glow::PIXEL_PACK_BUFFER_BINDING),
    (glow::PIXEL_UNPACK_BUFFER, glow::PIXEL_UNPACK_BUFFER_BINDING),
];

const CLAMP_READ_COLOR: u32 = 0x891C;
const FIXED_ONLY: i32 = 0x891D;

/// What `glPixelTransfer` sets in a compatibility profile, and what leaves pixels as they are: scales and biases, maps,
/// index shift and offset.
const TRANSFERS: [(u32, f32); 14] = [
    (0x0D10, 0.0), // GL_MAP_COLOR
    (0x0D11, 0.0), // GL_MAP_STENCIL
    (0x0D12, 0.0), // GL_INDEX_SHIFT
    (0x0D13, 0.0), // GL_INDEX_OFFSET
    (0x0D14, 1.0), // GL_RED_SCALE
    (0x0D15, 0.0), // GL_RED_BIAS
    (0x0D18, 1.0), // GL_GREEN_SCALE
    (0x0D19, 0.0), // GL_GREEN_BIAS
    (0x0D1A, 1.0), // GL_BLUE_SCALE
    (0x0D1B, 0.0), // GL_BLUE_BIAS
    (0x0D1C, 1.0), // GL_ALPHA_SCALE
    (0x0D1D, 0.0), // GL_ALPHA_BIAS
    (0x0D1E, 1.0), // GL_DEPTH_SCALE
    (0x0D1F, 0.0), // GL_DEPTH_BIAS
];

/// Owns the state of pixel transfers: rows are tightly packed, and pointers are pointers. The state is restored when
/// this is dropped.
pub(super) struct PixelStore<'c> {
    context: &'c Context,
    before: State,
}

struct State {
    values: [i32; VALUES.len()],
    buffers: [Option<glow::Buffer>; BUFFERS.len()],
    clamp: i32,
    /// Of a compatibility profile only.
    transfers: [f32; TRANSFERS.len()],
}

fn tight() -> State {
    State {
        values: VALUES.map(|(_, value)| value),
        buffers: [None; BUFFERS.len()],
        clamp: FIXED_ONLY,
        transfers: TRANSFERS.map(|(_, value)| value),
    }
}

impl<'c> PixelStore<'c> {
    /// The context is current.
    pub(super) fn own(context: &'c Context) -> Self {
        let before = State::read(context);
        before.change_to(&tight(), context);
        Self { context, before }
    }
}

impl Drop for PixelStore<'_> {
    fn drop(&mut self) {
        tight().change_to(&self.before, self.context);
    }
}

impl State {
    fn read(context: &Context) -> Self {
        let gl = context.glow();
        let has_transfers = context.driver().has_fixed_functions;
        // SAFETY: the context is current, and each name is a single number in OpenGL 4.3; the transfers' in its
        // compatibility profile.
        unsafe {
            Self {
                values: VALUES.map(|(name, _)| gl.get_parameter_i32(name)),
                buffers: BUFFERS.map(|(_, binding)| gl.get_parameter_buffer(binding)),
                clamp: gl.get_parameter_i32(CLAMP_READ_COLOR),
                transfers: TRANSFERS.map(|(name, neutral)| {
                    if has_transfers {
                        gl.get_parameter_f32(name)
                    } else {
                        neutral
                    }
                }),
            }
        }
    }

    /// Sets what differs.
    fn change_to(&self, to: &Self, context: &Context) {
        let gl = context.glow();
        for ((name, _), (from, to)) in VALUES.iter().zip(self.values.iter().zip(&to.values)) {
            if from != to {
                // SAFETY: the context is current, and the value is GL's default or what GL has answered.
                unsafe { gl.pixel_store_i32(*name, *to) };
            }
        }
        for ((target, _), (from, to)) in BUFFERS.iter().zip(self.buffers.iter().zip(&to.buffers)) {
            if from != to {
                // SAFETY: as above.
                unsafe { gl.bind_buffer(*target, *to) };
            }
        }
        if self.clamp != to.clamp {
            clamp_reads(context, to.clamp);
        }
        for ((name, _), (from, to)) in TRANSFERS
            .iter()
            .zip(self.transfers.iter().zip(&to.transfers))
        {
            if from != to {
                transfer(context, *name, *to);
            }
        }
    }
}

fn clamp_reads(context: &Context, value: i32) {
    type ClampColor = unsafe extern "system" fn(c_uint, c_uint);
    let function = context.function("glClampColor");
    if !function.is_null() {
        // SAFETY: the OpenGL specification gives the function of that name this signature; the context is current.
        unsafe {
            let clamp = std::mem::transmute::<*const c_void, ClampColor>(function);
            clamp(CLAMP_READ_COLOR, value as c_uint);
        }
    }
}

fn transfer(context: &Context, name: u32, value: f32) {
    type PixelTransfer = unsafe extern "system" fn(c_uint, c_float);
    let function = context.function("glPixelTransferf");
    if !function.is_null() {
        // SAFETY: as above; the context is of the compatibility profile, or the value would not differ.
        unsafe {
            let transfer = std::mem::transmute::<*const c_void, PixelTransfer>(function);
            transfer(name, value);
        }
    }
}
