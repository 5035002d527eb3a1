//! Figure 2 of Carr et al. (2008), value by value on OpenGL and on the emulated pixel at the same time (C07 to C10).

use crate::kit::lockstep;
use crate::kit::peels;
use crate::kit::stack;
use onionskin::low_level::emulator::Emulator;
use onionskin::low_level::emulator::FragmentOutcome::*;
use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::papers::carr_2008::coherent::{self, LOOP_A};
use onionskin::low_level::papers::carr_2008::{
    BOUND, D_SC, D_SN, DEPTH_BUFFER, Z_MIN_POST, Z_MIN_PREV,
};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{Call, Dialect, Listing, Machine, Variables, gl::*, run};
use onionskin::{Context, Format, steps};

const D_SC_AT_S4: Listing = Listing {
    title: "Everything up to s4 has been peeled",
    source: "Carr et al. 2008, figure 2",
    dialect: Dialect::Calls,
    steps: steps! {
        glBindFramebuffer(BOUND);
        glClear(DEPTH_BUFFER_BIT);
    },
};

#[test]
pub(crate) fn c07_to_c10_figure_2_on_opengl() {
    let context = Context::headless().unwrap();
    // s0 < s4 < s3 < s5 < s6 < s10 < s9 < s7 < s2 < s1 < s8
    let order = [0, 4, 3, 5, 6, 10, 9, 7, 2, 1, 8];
    let place = |s| order.iter().position(|&other| other == s).unwrap() as u16;
    let pieces = (0..11).map(|s| stack::Piece {
        level: place(s) * 50,
        color: [0.5; 4],
    });
    let scene = stack::Stack {
        width: 1,
        pixels: vec![pieces.collect()],
        opaque: None,
    }
    .scene();
    let mut gl = GlMachine::new(&context, scene.size).unwrap();
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    peels::Loop::A.allocate_maps(&mut gl, color, depth);
    gl.set_geometry(Geometry::upload(&context, &scene, scene.size).unwrap());
    gl.begin_frame();
    let mut pixels = lockstep::surfaces(&mut gl, &scene, peels::IMAGE);
    // Two triangles make a surface: its number is half of theirs.
    for surface in &mut pixels[0] {
        surface.fragment.order /= 2;
    }
    let s4 = pixels[0][4].fragment.depth;
    let mut emulator = Emulator::new(pixels.clone()).watching(0);
    peels::Loop::A.allocate_maps(&mut emulator, color, depth);
    gl.begin_frame();
    let maps = [DEPTH_BUFFER, D_SC, D_SN, Z_MIN_PREV, Z_MIN_POST];
    let mut both = lockstep::LockStep::new(
        &mut gl,
        &mut emulator,
        maps.map(|map| lockstep::Watched { map, format: depth })
            .to_vec(),
        vec![0],
        0.0,
    );
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut both).unwrap();
    let amendments: Vec<_> = coherent::AMENDMENTS
        .into_iter()
        .filter(|amendment| amendment.key != "CX09" && amendment.key != "CX11")
        .collect();
    let clear_depth = Call::ClearDepth { depth: s4.into() };
    both.perform(&clear_depth).unwrap();
    run(&D_SC_AT_S4, &[], Variables::new(), &mut both).unwrap();
    let variables = Variables::new().with("iteration_limit", 1.0);
    run(&LOOP_A, &amendments, variables, &mut both).unwrap();
    // Bit for bit the same on both after every pass; so the record tells of both.
    assert!(both.compared > 20);
    let depth_of = |s: usize| pixels[0][s].fragment.depth;
    let draws = &emulator.record().draws[1..];
    assert_eq!(draws[0].with(Pass), [1, 2, 3]);
    assert_eq!(draws[0].left, (3, depth_of(3)));
    assert_eq!(draws[1].left, (1, depth_of(2)));
    assert_eq!(draws[2].left, (251, depth_of(7)));
    assert_eq!(draws[3].left, (255, depth_of(10)));
    assert_eq!(gl.read_depths(Z_MIN_POST).unwrap(), [depth_of(10)]);
    assert_eq!(gl.read_stencils(Z_MIN_POST).unwrap(), [255]);
}
