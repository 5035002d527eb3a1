//! Figure 2 of Carr et al. (2008), pass by pass: eleven surfaces at one pixel, submitted as s0 to s10. Everything up to
//! s4 has been peeled.
//!
//! The emulated pixel says what happens to each surface. OpenGL runs the same steps beside it. The stencil value and
//! the depth that both leave are printed under each table. One sentence of the paper's trace is wrong: see pass 3.
//!
//! Writes one picture, as PNG and as SVG, with a row per pass and a column per surface.
//!
//! `cargo run --example 05_figure_2_pass_by_pass [FOLDER]`

use onionskin::generate::{Quads, quads};
use onionskin::low_level::emulator::{Draw, Emulator, Group, Surface};
use onionskin::low_level::gl::{Geometry, GlMachine, capture};
use onionskin::low_level::methods::{allocate_maps, begin_batch};
use onionskin::low_level::papers::carr_2008::coherent::{
    self, PASS_5, PASS_6, RANGE_1, RANGE_3, RANGE_5,
};
use onionskin::low_level::papers::carr_2008::passes::{PASS_1, PASS_2, PASS_3, PASS_4};
use onionskin::low_level::papers::carr_2008::{D_SN, DEPTH_BUFFER, Z_MIN_POST, Z_MIN_PREV};
use onionskin::low_level::papers::stage;
use onionskin::low_level::steps::{self, Dialect, Listing, Variables, Workspace, gl::*, run};
use onionskin::report::fates;
use onionskin::{Context, Format, Fragment, Result, Scene, steps};

#[path = "common/example.rs"]
mod example;

/// One of 18 orders of depth that fit everything the paper says about its figure.
const FRONT_TO_BACK: [usize; 11] = [0, 4, 3, 5, 6, 10, 9, 7, 2, 1, 8];

const PASSES: [(&str, Listing); 6] = [
    (
        "Pass 1: count the surfaces that lower the depth",
        listing(steps! {
            glBindFramebuffer(stage::PEEL);
            glColorMask(false, false, false, false);
            run RANGE_1;
            run PASS_1;
            glCopyImageSubData(DEPTH_BUFFER, D_SN);
        }),
    ),
    (
        "Pass 2: count back to 1; the depth becomes z_min_prev",
        listing(steps! {
            run PASS_2;
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_PREV);
        }),
    ),
    (
        "Pass 3: count the run from s_n on (the paper: s9 'sets the depth'; it does not)",
        listing(steps! {
            run RANGE_3 amended by &[coherent::HALF_OPEN];
            run PASS_3;
        }),
    ),
    (
        "Pass 4: skip the run; the depth becomes z_min_post",
        listing(steps! {
            run PASS_4;
            glCopyImageSubData(DEPTH_BUFFER, Z_MIN_POST);
        }),
    ),
    (
        "Pass 5: composite the run",
        listing(steps! {
            glDisable(STENCIL_TEST);
            glDisable(DEPTH_TEST);
            glColorMask(true, true, true, true);
            run RANGE_5 amended by &[coherent::HALF_OPEN];
            run PASS_5;
        }),
    ),
    (
        "Pass 6: composite what ends it",
        listing(steps! {
            run PASS_6 amended by &[coherent::BEFORE_OPAQUE];
        }),
    ),
];

const fn listing(steps: &'static [steps::Step]) -> Listing {
    Listing {
        title: "a pass",
        source: "Carr et al. 2008, figure 2",
        dialect: Dialect::Calls,
        steps,
    }
}

fn main() -> Result<()> {
    let scene = scene()?;
    let context = Context::headless()?;
    let mut gl = GlMachine::new(&context, scene.size)?;
    gl.set_geometry(Geometry::upload(&context, &scene, scene.size)?);
    maps(&mut gl)?;
    gl.begin_frame();
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut gl)?;
    let surfaces = surfaces(&mut gl)?;
    let s4 = surfaces[4].fragment.depth;
    let mut emulator = Emulator::new(vec![surfaces]).watching(0);
    maps(&mut emulator)?;
    gl.begin_frame();

    begin(&mut gl, s4)?;
    begin(&mut emulator, s4)?;
    let before = emulator.record().draws.len();
    for (title, pass) in PASSES {
        run(&pass, &[], Variables::new(), &mut gl)?;
        run(&pass, &[], Variables::new(), &mut emulator)?;
        println!("{title}");
        print!(
            "{}",
            emulator.record().draws[emulator.record().draws.len() - 1]
        );
        println!(
            "  OpenGL has: stencil {}, depth {}\n",
            gl.read_stencils(DEPTH_BUFFER)?[0],
            gl.read_depths(DEPTH_BUFFER)?[0]
        );
    }

    let path = example::output("05_figure_2_pass_by_pass.png")?;
    let titles = PASSES.iter().map(|(title, _)| *title);
    let draws: Vec<(&str, &Draw)> = titles.zip(&emulator.record().draws[before..]).collect();
    let title = "Figure 2 of Carr et al. 2008: eleven surfaces at one pixel, pass by pass";
    let figure = fates(title, &draws);
    figure.save(&path)?;
    figure.save(path.with_extension("svg"))?;
    println!("{}", path.display());
    Ok(())
}

/// Quads parallel to the screen, submitted as s0 to s10, in one pixel.
fn scene() -> Result<Scene> {
    let quad = |s| {
        let place = FRONT_TO_BACK
            .iter()
            .position(|&other| other == s)
            .unwrap_or(0);
        quads(&Quads {
            count: 1,
            depths: vec![place as f32 * 0.2],
            ..Quads::default()
        })
    };
    let mut scene = Scene::of("figure 2", (0..11).map(quad).collect::<Result<_>>()?);
    scene.size = [1, 1];
    Ok(scene)
}

/// The same maps for both machines.
fn maps(workspace: &mut impl Workspace) -> Result<()> {
    let (color, depth) = (Format::Rgba32F, Format::Depth32FStencil8);
    allocate_maps(workspace, &[&stage::RESOURCES], color, depth)?;
    allocate_maps(workspace, &coherent::RESOURCES_A, color, depth)
}

/// There is nothing opaque, and everything up to s4 is peeled.
fn begin(machine: &mut impl Workspace, s4: f32) -> Result<()> {
    run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
    begin_batch(machine, s4, 1.0)
}

/// The fragments that OpenGL makes, in the order of submission.
fn surfaces(gl: &mut GlMachine<'_>) -> Result<Vec<Surface>> {
    let mut captured = capture(gl, stage::OPAQUE_DEPTH, 1000)?;
    captured.sort_by_key(|fragment| fragment.order);
    let surface = |fragment: &onionskin::low_level::gl::CapturedFragment| Surface {
        fragment: Fragment {
            depth: fragment.depth,
            color: fragment.color,
            // A quad is two triangles. One of them covers the pixel's centre.
            order: fragment.order / 2,
        },
        group: Group::Unsorted,
    };
    Ok(captured.iter().map(surface).collect())
}
