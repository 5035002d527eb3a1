//! Pixels go to the driver and come back whole, whatever pixel-store state the host of the context has left.

#![allow(unsafe_code)] // setting a host's state is calling GL

use crate::kit::loader;
use crate::kit::small_scenes;
use glow::HasContext;
use onionskin::low_level::gl::{GlMachine, Profile};
use onionskin::low_level::steps::{Call, Machine, Map, Target};
use onionskin::{Context, ContextOptions, Format, Method, Renderer, Scene};
use proptest::prelude::*;

const SIZE: [u32; 2] = [7, 5];
const COLOR: Map = Map::named("color");
const DEPTH: Map = Map::named("depth");
const NUMBERS: Map = Map::named("numbers");

/// A pixel-store value and the largest odd value that is tried.
const VALUES: [(u32, i32); 16] = [
    (glow::PACK_SWAP_BYTES, 1),
    (glow::PACK_LSB_FIRST, 1),
    (glow::PACK_ROW_LENGTH, 64),
    (glow::PACK_IMAGE_HEIGHT, 64),
    (glow::PACK_SKIP_ROWS, 9),
    (glow::PACK_SKIP_PIXELS, 9),
    (glow::PACK_SKIP_IMAGES, 3),
    (glow::PACK_ALIGNMENT, 8),
    (glow::UNPACK_SWAP_BYTES, 1),
    (glow::UNPACK_LSB_FIRST, 1),
    (glow::UNPACK_ROW_LENGTH, 64),
    (glow::UNPACK_IMAGE_HEIGHT, 64),
    (glow::UNPACK_SKIP_ROWS, 9),
    (glow::UNPACK_SKIP_PIXELS, 9),
    (glow::UNPACK_SKIP_IMAGES, 3),
    (glow::UNPACK_ALIGNMENT, 8),
];

/// What a host has left: a value for each of [`VALUES`], and whether pixel buffers are bound.
#[derive(Clone, Debug)]
struct Left {
    values: Vec<i32>,
    buffers: [bool; 2],
}

fn left() -> impl Strategy<Value = Left> {
    let values: Vec<_> = VALUES
        .iter()
        .map(|&(name, most)| match name {
            glow::PACK_ALIGNMENT | glow::UNPACK_ALIGNMENT => {
                prop_oneof![Just(1), Just(2), Just(4), Just(8)].boxed()
            }
            _ => (0..=most).boxed(),
        })
        .collect();
    (values, any::<[bool; 2]>()).prop_map(|(values, buffers)| Left { values, buffers })
}

/// Everything at once, each value odd.
fn worst() -> Left {
    Left {
        values: VALUES.iter().map(|(_, most)| *most).collect(),
        buffers: [true; 2],
    }
}

/// A host's two pixel buffers, large enough for any of the transfers.
struct Host<'c> {
    gl: &'c glow::Context,
    buffers: [glow::Buffer; 2],
}

const TARGETS: [u32; 2] = [glow::PIXEL_PACK_BUFFER, glow::PIXEL_UNPACK_BUFFER];
const BINDINGS: [u32; 2] = [
    glow::PIXEL_PACK_BUFFER_BINDING,
    glow::PIXEL_UNPACK_BUFFER_BINDING,
];

impl<'c> Host<'c> {
    fn new(context: &'c Context) -> Self {
        let gl = context.glow();
        // SAFETY: the context is current.
        let buffers = TARGETS.map(|target| unsafe {
            let buffer = gl.create_buffer().unwrap();
            gl.bind_buffer(target, Some(buffer));
            gl.buffer_data_size(target, 1 << 20, glow::STREAM_COPY);
            gl.bind_buffer(target, None);
            buffer
        });
        Self { gl, buffers }
    }

    fn leave(&self, left: &Left) {
        // SAFETY: the context is current, and the values are within their ranges.
        unsafe {
            for ((name, _), value) in VALUES.iter().zip(&left.values) {
                self.gl.pixel_store_i32(*name, *value);
            }
            for ((target, bound), buffer) in TARGETS.iter().zip(left.buffers).zip(self.buffers) {
                self.gl.bind_buffer(*target, bound.then_some(buffer));
            }
        }
    }

    fn state(&self) -> Left {
        // SAFETY: the context is current.
        unsafe {
            Left {
                values: VALUES
                    .iter()
                    .map(|(name, _)| self.gl.get_parameter_i32(*name))
                    .collect(),
                buffers: BINDINGS.map(|binding| self.gl.get_parameter_buffer(binding).is_some()),
            }
        }
    }

    fn expect(&self, left: &Left) {
        let found = self.state();
        assert_eq!(found.values, left.values);
        assert_eq!(found.buffers, left.buffers);
    }
}

#[test]
fn what_is_read_back_does_not_hang_on_the_host_s_pixel_store() {
    let context = Context::headless().unwrap();
    let machine = painted(&context);
    let host = Host::new(&context);
    let clean = read(&machine);
    assert_eq!(clean.0.len(), (SIZE[0] * SIZE[1]) as usize);
    assert!(clean.0.iter().all(|texel| *texel == [0.25, 0.5, 0.75, 1.0]));
    assert_eq!(
        (clean.1[0], clean.2[0], clean.3[0]),
        (0.375, 77, [0x0102_0304; 4])
    );
    proptest!(|(left in left())| {
        host.leave(&left);
        prop_assert_eq!(&read(&machine), &clean);
        host.expect(&left);
    });
}

#[test]
fn the_worst_pixel_store_is_seen_by_gl_itself() {
    // The control: unguarded, the same read gives other bytes. The slice has room for whatever is skipped.
    let context = Context::headless().unwrap();
    let machine = painted(&context);
    let host = Host::new(&context);
    let mut left = worst();
    left.buffers = [false; 2];
    host.leave(&left);
    let mut bytes = vec![0_u8; 1 << 16];
    let first = machine.read_counts(NUMBERS).unwrap()[0].to_ne_bytes();
    // SAFETY: the framebuffer that was painted is bound; 64 x 64 texels of 16 bytes fit.
    unsafe {
        host.gl.read_buffer(glow::COLOR_ATTACHMENT1);
        let into = glow::PixelPackData::Slice(Some(&mut bytes));
        let (width, height) = (SIZE[0] as i32, SIZE[1] as i32);
        host.gl.read_pixels(
            0,
            0,
            width,
            height,
            glow::RED_INTEGER,
            glow::UNSIGNED_INT,
            into,
        );
        assert_eq!(host.gl.get_error(), glow::NO_ERROR);
    }
    assert_ne!(bytes[..4], first, "nothing was skipped");
    let at = bytes.iter().position(|byte| *byte != 0).unwrap();
    let mut swapped = first;
    swapped.reverse();
    assert_eq!(bytes[at..at + 4], swapped, "the bytes were not swapped");
}

#[test]
fn what_is_uploaded_does_not_hang_on_the_host_s_pixel_store() {
    let context = Context::headless().unwrap();
    let host = Host::new(&context);
    let scene = fog();
    let frame = |context| {
        let mut renderer = Renderer::new(context, 24, 16).unwrap();
        let method: Method = "dfb".parse().unwrap();
        renderer.render(&scene, &method).unwrap().image
    };
    let clean = frame(&context);
    proptest!(ProptestConfig::with_cases(24), |(left in left())| {
        host.leave(&left);
        prop_assert!(frame(&context) == clean);
        host.expect(&left);
    });
    host.leave(&worst());
    assert!(frame(&context) == clean);
    host.expect(&worst());
}

#[test]
fn what_is_read_back_does_not_hang_on_pixel_transfers_of_a_compatibility_profile() {
    const RED_SCALE: u32 = 0x0D14;
    const DEPTH_BIAS: u32 = 0x0D1F;
    const INDEX_OFFSET: u32 = 0x0D13;
    type PixelTransfer = unsafe extern "system" fn(u32, f32);
    let options = ContextOptions {
        profile: Profile::Compatibility,
        ..Default::default()
    };
    let context = Context::new(options).unwrap();
    let machine = painted(&context);
    let clean = read(&machine);
    // SAFETY: a null-checked function of this name has this signature.
    let transfer: PixelTransfer = unsafe {
        let function = loader::function(context.backend().unwrap(), "glPixelTransferf");
        assert!(!function.is_null());
        std::mem::transmute(function)
    };
    let odd = [(RED_SCALE, 0.5), (DEPTH_BIAS, 0.25), (INDEX_OFFSET, 3.0)];
    for (name, value) in odd {
        // SAFETY: the context is current and of the compatibility profile.
        unsafe { transfer(name, value) };
    }
    assert_eq!(read(&machine), clean);
    for (name, value) in odd {
        // SAFETY: as above.
        assert_eq!(unsafe { context.glow().get_parameter_f32(name) }, value);
    }
}

type Read = (Vec<[f32; 4]>, Vec<f32>, Vec<u8>, Vec<[u32; 4]>, Vec<u32>);

fn read(machine: &GlMachine<'_>) -> Read {
    (
        machine.read_colors(COLOR).unwrap(),
        machine.read_depths(DEPTH).unwrap(),
        machine.read_stencils(DEPTH).unwrap(),
        machine.read_integers(NUMBERS).unwrap(),
        machine.read_counts(NUMBERS).unwrap(),
    )
}

/// A machine with maps whose texels are known, and their framebuffer bound.
fn painted(context: &Context) -> GlMachine<'_> {
    let mut machine = GlMachine::new(context, SIZE).unwrap();
    machine.begin_frame();
    machine.allocate(COLOR, Format::Rgba32F).unwrap();
    machine.allocate(NUMBERS, Format::Rgba32Ui).unwrap();
    machine.allocate(DEPTH, Format::Depth32FStencil8).unwrap();
    machine
        .framebuffer_with(Target("painted"), &[COLOR, NUMBERS], Some(DEPTH))
        .unwrap();
    let gl = context.glow();
    // SAFETY: the context is current, and the framebuffer's attachments have these types.
    unsafe {
        gl.clear_buffer_f32_slice(glow::COLOR, 0, &[0.25, 0.5, 0.75, 1.0]);
        gl.clear_buffer_u32_slice(glow::COLOR, 1, &[0x0102_0304; 4]);
        gl.clear_buffer_depth_stencil(glow::DEPTH_STENCIL, 0, 0.375, 77);
    }
    machine
        .perform(&Call::DepthMask { flag: true })
        .expect("no error of GL's");
    machine
}

fn fog() -> Scene {
    let mut scene = small_scenes::fog();
    scene.size = [24, 16];
    scene
}
