//! Figure 2: eleven surfaces at one pixel, submitted as s0 to s10, pass by pass. Everything up to s4 has been peeled.

use crate::emulator::{Draw, Emulator, Group, Surface};
use crate::error::Result;
use crate::fragment::Fragment;
use crate::gl::{CapturedFragment, Context, Geometry, GlMachine, capture};
use crate::low_level::edition::figures::plots::svg_of;
use crate::low_level::edition::figures::{Drawn, Figure, Studio};
use crate::low_level::report::fates;
use crate::methods::{allocate_maps, begin_batch};
use crate::papers::carr_2008::coherent::{self, PASS_5, PASS_6, RANGE_1, RANGE_3, RANGE_5};
use crate::papers::carr_2008::passes::{PASS_1, PASS_2, PASS_3, PASS_4};
use crate::papers::carr_2008::{D_SN, DEPTH_BUFFER, Z_MIN_POST, Z_MIN_PREV};
use crate::papers::stage;
use crate::scene::Scene;
use crate::scene::generate::{Quads, quads};
use crate::steps;
use crate::steps::{Dialect, Format, Listing, Variables, Workspace, gl::*, run};

pub(super) const FIGURE: Figure = Figure {
    key: "carr-2",
    source: "Carr et al. 2008, figure 2",
    title: "What each pass does to each of the eleven surfaces",
    make,
};

/// One of 18 orders of depth that fit everything the paper says about its figure.
pub const FRONT_TO_BACK: [usize; 11] = [0, 4, 3, 5, 6, 10, 9, 7, 2, 1, 8];

/// The six passes with their titles. Each leaves its depths where the later ones look for them.
pub const PASSES: [(&str, Listing); 6] = [
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

/// What a pass has done.
#[derive(Clone, Debug)]
pub struct PassRun {
    /// The pass's title.
    pub title: &'static str,
    /// What became of each surface on the emulated pixel, and what the pixel's depth buffer holds at the end.
    pub draw: Draw,
    /// The stencil value and the depth that OpenGL has at the end.
    pub on_gl: (u8, f32),
}

/// Runs the six passes on OpenGL and on the emulated pixel.
///
/// # Errors
/// If the driver fails.
pub fn run_passes(context: &Context) -> Result<Vec<PassRun>> {
    let scene = scene()?;
    let mut gl = GlMachine::new(context, scene.size)?;
    gl.set_geometry(Geometry::upload(context, &scene, scene.size)?);
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
    let mut runs = Vec::new();
    for (title, pass) in PASSES {
        run(&pass, &[], Variables::new(), &mut gl)?;
        run(&pass, &[], Variables::new(), &mut emulator)?;
        let draws = &emulator.record().draws;
        runs.push(PassRun {
            title,
            draw: draws[draws.len() - 1].clone(),
            on_gl: (
                gl.read_stencils(DEPTH_BUFFER)?[0],
                gl.read_depths(DEPTH_BUFFER)?[0],
            ),
        });
    }
    Ok(runs)
}

/// Quads parallel to the screen, submitted as s0 to s10, in one pixel.
fn scene() -> Result<Scene> {
    let quad = |s| {
        let place = FRONT_TO_BACK.iter().position(|&other| other == s);
        quads(&Quads {
            count: 1,
            depths: vec![place.unwrap_or(0) as f32 * 0.2],
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
    let surface = |fragment: &CapturedFragment| Surface {
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

/// What the paper says of the stencil and the depth after passes 1 to 4. It says nothing of them after passes 5 and 6.
const PAPER: [(&str, &str); 4] = [
    ("3", "D(s3)"),
    ("1", "D(s2)"),
    ("251", "D(s9)"),
    ("255", "D(s10)"),
];

fn make(studio: &Studio) -> Result<Drawn> {
    let runs = run_passes(studio.context)?;
    let draws: Vec<(&str, &Draw)> = runs.iter().map(|run| (run.title, &run.draw)).collect();
    let strips = fates("", &draws);
    let rows = runs.iter().enumerate().map(|(number, run)| {
        let (stencil, depth) = PAPER.get(number).copied().unwrap_or(("", ""));
        vec![
            (number + 1).to_string(),
            stencil.into(),
            run.on_gl.0.to_string(),
            depth.into(),
            surface_at(&run.draw, run.on_gl.1),
        ]
    });
    let drawn = Drawn::new(
        "A row for each pass, and a box for each surface in the order in which it is drawn. Follow s9: pass 3 inverts the \
         stencil value at it, from 4 to 251, and pass 4 is the first to let it through. The paper's trace fits but for one \
         sentence: s9 cannot set the depth in pass 3, because it fails the depth test (CX01).",
    )
    .drawing(
        svg_of(strips.draw()?),
        "six rows of eleven boxes, which say of each surface whether it passes, fails a test or is clipped",
    );
    Ok(drawn.table(
        "What the depth and stencil buffer hold after each pass, on OpenGL and on the emulated pixel alike",
        &["pass", "stencil, the paper", "stencil", "depth, the paper", "depth"],
        rows.collect(),
    ))
}

/// The surface of this depth.
fn surface_at(draw: &Draw, depth: f32) -> String {
    match draw.fates.iter().find(|fate| fate.depth == depth) {
        Some(fate) => format!("D(s{})", fate.order),
        None => format!("{depth}"),
    }
}
