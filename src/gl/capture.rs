//! Reading back every fragment, for the oracle to sort.
//!
//! The list is made with one atomic counter, in the order in which fragments come. This order does not matter, because
//! each record has its pixel and its triangle's place in the order of submission. The memory is sized from an exact
//! count. If a piece of the image has more fragments than one buffer may hold, the piece is halved.

use bytemuck::{Pod, Zeroable};
use glow::HasContext;

use super::bindings;
use super::context::Context;
use super::machine::GlMachine;
use super::making::{Making, allocate};
use crate::error::{Error, Result};
use crate::fragment::Rgba;
use crate::steps::{Call, Capability, Compare, Machine, Map, Objects, Query, Shader, Target};

/// A fragment and its pixel.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct CapturedFragment {
    /// Column, from the left.
    pub x: u32,
    /// Row, from the bottom.
    pub y: u32,
    /// Window-space depth.
    pub depth: f32,
    /// Place of its triangle in the order of submission, over all meshes. Of a face of the box around a volume it is the id
    /// ([`Source::id`](crate::fragment::Source::id)).
    pub order: u32,
    /// The colour, with straight alpha. A box has none, and has the number of its triangle in red.
    pub color: Rgba,
}

/// Captures every fragment of the transparent objects that lies before `opaque_depth`, in no particular order. At most
/// `limit` fragments are held in GL's memory at a time.
///
/// # Errors
/// If the driver has too little memory, or a single pixel has more fragments than the limit.
pub fn capture(
    machine: &mut GlMachine<'_>,
    opaque_depth: Map,
    limit: u32,
) -> Result<Vec<CapturedFragment>> {
    let mut fragments = Vec::new();
    let what = Captured {
        objects: Objects::Transparent,
        depth: opaque_depth,
        passes: Compare::Less,
    };
    capture_in_pieces(machine, &what, limit, |_, piece| {
        fragments.extend_from_slice(piece);
        Ok(())
    })?;
    Ok(fragments)
}

/// The fragments to be captured.
pub struct Captured {
    /// The objects that are drawn. Boxes around volumes have depths that are clamped to 0..1.
    pub objects: Objects,
    /// The depths against which they are tested, unchanged.
    pub depth: Map,
    /// The test.
    pub passes: Compare,
}

/// Captures fragments in pieces of the image, and gives each piece with its fragments to `take`. Each pixel is in one
/// piece. A piece has at most `limit` fragments.
///
/// # Errors
/// If the driver has too little memory, if a single pixel has more fragments than the limit, or if `take` returns an
/// error.
pub fn capture_in_pieces(
    machine: &mut GlMachine<'_>,
    what: &Captured,
    limit: u32,
    take: impl FnMut(Piece, &[CapturedFragment]) -> Result<()>,
) -> Result<()> {
    let [width, height] = machine.size();
    let all = Piece {
        x: 0,
        y: 0,
        width,
        height,
    };
    capture_pieces(machine, what, vec![all], limit, take)
}

fn capture_pieces(
    machine: &mut GlMachine<'_>,
    what: &Captured,
    mut pieces: Vec<Piece>,
    limit: u32,
    mut take: impl FnMut(Piece, &[CapturedFragment]) -> Result<()>,
) -> Result<()> {
    let context = machine.context();
    let room = room(
        context.driver().limit("GL_MAX_SHADER_STORAGE_BLOCK_SIZE"),
        limit,
    );
    // A depth attachment also keeps clear of the trap that `Trap` describes.
    machine.framebuffer(TARGET, None, Some(what.depth))?;
    for call in before(what.passes) {
        machine.perform(&call)?;
    }
    let objects = what.objects;
    if objects == Objects::Proxies {
        machine.perform(&Call::Enable { cap: CLAMPED })?;
    }
    let mut fragments = Vec::new();
    while let Some(piece) = pieces.pop() {
        piece.scissor(context.glow());
        match count(machine, objects)? {
            0 => take(piece, &[])?,
            count if count <= u64::from(room) => {
                let list = List::new(context, count as u32)?;
                machine.perform(&Call::UseProgram { program: CAPTURE })?;
                machine.perform(&Call::Draw { objects })?;
                list.read(&mut fragments)?;
                take(piece, &fragments)?;
            }
            count => pieces.extend(piece.halves().ok_or_else(|| Error::Driver {
                what: format!("the pixel {}, {} has {count} fragments", piece.x, piece.y),
                remedy: format!("at most {room} fit into one buffer here; render a simpler scene"),
            })?),
        }
    }
    // SAFETY: the context is current.
    unsafe { context.glow().disable_draw_buffer(glow::SCISSOR_TEST, 0) };
    if objects == Objects::Proxies {
        machine.perform(&Call::Disable { cap: CLAMPED })?;
    }
    machine.perform(&Call::DepthMask { flag: true })?;
    Ok(())
}

/// Captures the fragments of one pixel, in the order in which they are drawn. The pixel is in column `x` from the left and
/// row `y` from the bottom.
///
/// # Errors
/// As [`capture_in_pieces`].
pub(crate) fn capture_at(
    machine: &mut GlMachine<'_>,
    what: &Captured,
    [x, y]: [u32; 2],
) -> Result<Vec<CapturedFragment>> {
    let pixel = Piece {
        x,
        y,
        width: 1,
        height: 1,
    };
    let mut fragments = Vec::new();
    capture_pieces(machine, what, vec![pixel], u32::MAX, |_, captured| {
        fragments.extend_from_slice(captured);
        Ok(())
    })?;
    fragments.sort_by_key(|fragment| fragment.order);
    Ok(fragments)
}

const CAPTURE: Shader = Shader("capture");
const SURFACE: Shader = Shader("surface");
const CAPTURED: Query = Query("captured");
const TARGET: Target = Target("capture");
/// What lies before the near plane or behind the far one is drawn, too.
const CLAMPED: Capability = Capability::DepthClamp;

fn before(passes: Compare) -> [Call; 3] {
    [
        Call::Enable {
            cap: Capability::DepthTest,
        },
        Call::DepthFunc { func: passes },
        Call::DepthMask { flag: false },
    ]
}

/// The number of fragments that one buffer holds.
fn room(largest_buffer: i64, limit: u32) -> u32 {
    // glow addresses the inside of a buffer with 31 bits.
    let bytes = largest_buffer.clamp(0, i64::from(i32::MAX)) as usize;
    u32::try_from(bytes / size_of::<CapturedFragment>())
        .unwrap_or(u32::MAX)
        .min(limit)
        .max(1)
}

/// The number of fragments of the current piece.
fn count(machine: &mut GlMachine<'_>, objects: Objects) -> Result<u64> {
    machine.perform(&Call::UseProgram { program: SURFACE })?;
    machine.perform(&Call::BeginQuery { query: CAPTURED })?;
    machine.perform(&Call::Draw { objects })?;
    machine.perform(&Call::EndQuery { query: CAPTURED })?;
    machine.samples(CAPTURED)
}

/// A rectangle of the image, in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Piece {
    /// The first column, from the left.
    pub x: u32,
    /// The first row, from the bottom.
    pub y: u32,
    /// The number of columns.
    pub width: u32,
    /// The number of rows.
    pub height: u32,
}

impl Piece {
    fn scissor(self, gl: &glow::Context) {
        // SAFETY: the context is current.
        unsafe {
            gl.enable_draw_buffer(glow::SCISSOR_TEST, 0);
            let corner_and_size = [self.x, self.y, self.width, self.height];
            gl.scissor_slice(0, 1, &[corner_and_size.map(|number| number as i32)]);
        }
    }

    /// Two pieces, cut across the longer side. `None` for a single pixel.
    fn halves(self) -> Option<[Self; 2]> {
        let Self {
            x,
            y,
            width,
            height,
        } = self;
        if height >= width && height > 1 {
            let lower = height / 2;
            Some([
                Self {
                    height: lower,
                    ..self
                },
                Self {
                    y: y + lower,
                    height: height - lower,
                    ..self
                },
            ])
        } else if width > 1 {
            let left = width / 2;
            Some([
                Self {
                    width: left,
                    ..self
                },
                Self {
                    x: x + left,
                    width: width - left,
                    ..self
                },
            ])
        } else {
            None
        }
    }
}

/// The counter and the list of `capture.frag`, bound.
struct List<'c> {
    context: &'c Context,
    counter: glow::Buffer,
    list: glow::Buffer,
    expected: u32,
}

impl<'c> List<'c> {
    fn new(context: &'c Context, expected: u32) -> Result<Self> {
        let gl = context.glow();
        let bytes = expected as i32 * size_of::<CapturedFragment>() as i32;
        let mut making = Making::new(gl);
        // SAFETY: the context is current; both buffers get their storage before they are used, and the list's size is
        // within `room`.
        unsafe {
            let counter = making.buffer()?;
            gl.bind_buffer_base(
                glow::SHADER_STORAGE_BUFFER,
                bindings::COUNTER,
                Some(counter),
            );
            allocate(gl, "the counter of fragments", 4, || {
                gl.buffer_data_u8_slice(glow::SHADER_STORAGE_BUFFER, &[0; 4], glow::DYNAMIC_READ);
            })?;
            let list = making.buffer()?;
            gl.bind_buffer_base(glow::SHADER_STORAGE_BUFFER, bindings::CAPTURED, Some(list));
            let what = format!("a list of {expected} fragments");
            allocate(gl, &what, bytes as u64, || {
                gl.buffer_data_size(glow::SHADER_STORAGE_BUFFER, bytes, glow::DYNAMIC_READ);
            })?;
            making.finish();
            Ok(Self {
                context,
                counter,
                list,
                expected,
            })
        }
    }

    /// Waits for the list and reads it.
    fn read(&self, fragments: &mut Vec<CapturedFragment>) -> Result<()> {
        let gl = self.context.glow();
        let mut counted = 0_u32;
        fragments.clear();
        fragments.resize(self.expected as usize, CapturedFragment::zeroed());
        // SAFETY: the shader's writes are waited for, and both reads stay within their buffers.
        unsafe {
            gl.memory_barrier(glow::BUFFER_UPDATE_BARRIER_BIT);
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(self.counter));
            gl.get_buffer_sub_data(
                glow::SHADER_STORAGE_BUFFER,
                0,
                bytemuck::bytes_of_mut(&mut counted),
            );
            gl.bind_buffer(glow::SHADER_STORAGE_BUFFER, Some(self.list));
            let list = bytemuck::cast_slice_mut(fragments);
            gl.get_buffer_sub_data(glow::SHADER_STORAGE_BUFFER, 0, list);
        }
        if counted == self.expected {
            return Ok(());
        }
        Err(Error::Driver {
            what: format!(
                "the driver drew {} fragments, but its atomic counter says {counted}",
                self.expected
            ),
            remedy: "`onionskin doctor` says whether this driver loses atomics".into(),
        })
    }
}

impl Drop for List<'_> {
    fn drop(&mut self) {
        let gl = self.context.glow();
        // SAFETY: the buffers are its own.
        unsafe {
            gl.delete_buffer(self.counter);
            gl.delete_buffer(self.list);
        }
    }
}
