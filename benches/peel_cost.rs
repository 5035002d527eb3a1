//! The cost of a peel and of its parts: ratios of medians, all from one run.
//!
//! `cargo bench --bench peel_cost [SCENE.toml]`; the bundled molecule if no scene is named.

use std::time::Instant;

use onionskin::low_level::gl::{Geometry, GlMachine};
use onionskin::low_level::papers::{stage, vtk};
use onionskin::low_level::steps::{self, Dialect, Listing, Map, Variables, gl::*, run};
use onionskin::options::{Compositing, DepthPeelingOptions};
use onionskin::{Context, Format, Method, Renderer, Result, Scene, steps};

const ROUNDS: usize = 9;
const IMAGE: Map = Map::named("image");
const DEPTH_0: Map = Map::numbered("depth buffer", 0);
const DEPTH_1: Map = Map::numbered("depth buffer", 1);

fn main() -> Result<()> {
    // `cargo bench` adds `--bench` to what the user gives.
    let named = std::env::args()
        .skip(1)
        .find(|argument| !argument.starts_with('-'));
    let path = named.unwrap_or_else(|| {
        concat!(env!("CARGO_MANIFEST_DIR"), "/examples/scenes/molecule.toml").into()
    });
    let scene = Scene::load(&path)?;
    let context = Context::headless()?;
    println!("{path} on {}", context.driver().renderer);

    let mut parts = Parts::new(&context, &scene)?;
    let names = [
        "opaque pass",
        "first peel",
        "second peel",
        "clear",
        "copy depth",
        "under",
    ];
    let mut times = vec![Vec::new(); names.len()];
    for round in 0..=ROUNDS {
        for (part, times) in times.iter_mut().enumerate() {
            let ms = parts.time(part)?;
            // The first round compiles the shaders.
            if round > 0 {
                times.push(ms);
            }
        }
    }
    let medians: Vec<f64> = times.into_iter().map(median).collect();
    for (name, ms) in names.iter().zip(&medians) {
        println!(
            "{name:<14} {ms:8.2} ms {:6.2} of an opaque pass",
            ms / medians[0]
        );
    }
    let screen: f64 = medians[3..].iter().sum();
    let (peel, allowed) = (
        medians[1].max(medians[2]) + screen,
        1.6 * medians[0] + screen,
    );
    println!(
        "a peel: {peel:.2} ms, {:.2} of (1.6 opaque passes + the full-screen work)",
        peel / allowed
    );

    drop(parts);
    let mut renderer = Renderer::new(&context, scene.size[0], scene.size[1])?;
    for compositing in [Compositing::OnTheFly, Compositing::KeepLayers] {
        let method = Method::DepthPeeling(DepthPeelingOptions {
            compositing,
            ..Default::default()
        });
        let stats = renderer.measure(&scene, &method, ROUNDS)?.stats;
        let per_peel = stats.ms / f64::from(stats.iterations);
        println!(
            "{compositing:?}: {:.1} ms for {} peels, {per_peel:.2} ms each, {:.2} opaque passes",
            stats.ms,
            stats.iterations,
            per_peel / medians[0]
        );
    }
    Ok(())
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_unstable_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The parts of a peel, one by one.
struct Parts<'c> {
    machine: GlMachine<'c>,
}

impl<'c> Parts<'c> {
    fn new(context: &'c Context, scene: &Scene) -> Result<Self> {
        let mut machine = GlMachine::new(context, scene.size)?;
        machine.allocate(IMAGE, Format::Rgba32F)?;
        machine.allocate(vtk::COLOR_BUFFER, Format::Rgba32F)?;
        machine.allocate(stage::ACCUMULATED, Format::Rgba32F)?;
        for depth in [stage::OPAQUE_DEPTH, DEPTH_0, DEPTH_1] {
            machine.allocate(depth, Format::Depth32FStencil8)?;
        }
        machine.framebuffer(stage::IMAGE, Some(IMAGE), Some(stage::OPAQUE_DEPTH))?;
        machine.framebuffer(stage::PEEL, Some(vtk::COLOR_BUFFER), Some(DEPTH_1))?;
        machine.framebuffer(stage::ACCUMULATION, Some(stage::ACCUMULATED), None)?;
        machine.set_geometry(Geometry::upload(context, scene, scene.size)?);
        machine.begin_frame();
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), &mut machine)?;
        Ok(Self { machine })
    }

    fn time(&mut self, part: usize) -> Result<f64> {
        let (before, timed): (&Listing, &Listing) = match part {
            0 => (&BEFORE_PEEL, &OPAQUE_PASS),
            1 => (&BEFORE_PEEL, &FIRST_PEEL),
            2 => (&BEFORE_SECOND, &SECOND_PEEL),
            3 => (&BEFORE_PEEL, &CLEAR),
            4 => (&BEFORE_PEEL, &COPY),
            _ => (&BEFORE_UNDER, &UNDER),
        };
        run(before, &[], Variables::new(), &mut self.machine)?;
        self.machine.finish();
        let start = Instant::now();
        run(timed, &[], Variables::new(), &mut self.machine)?;
        self.machine.finish();
        Ok(start.elapsed().as_secs_f64() * 1e3)
    }
}

const BEFORE_PEEL: Listing = listing(steps! {
    glBindFramebuffer(stage::PEEL);
    glFramebufferDepth(DEPTH_1);
    glCopyImageSubData(stage::OPAQUE_DEPTH, DEPTH_1);
    glEnable(DEPTH_TEST);
    glDepthFunc(LESS);
    glActiveTexture(0);
    glBindTexture(DEPTH_0);
    glClear(COLOR_BUFFER_BIT);
});
const OPAQUE_PASS: Listing =
    listing(steps! { glUseProgram(stage::SURFACE); drawTransparentObjects(); });
const FIRST_PEEL: Listing = listing(steps! {
    glSamplerCompareFunc(ALWAYS);
    glUseProgram(stage::PEEL_SURFACE);
    drawTransparentObjects();
});
const BEFORE_SECOND: Listing = listing(steps! {
    run BEFORE_PEEL;
    glFramebufferDepth(DEPTH_0);
    glCopyImageSubData(stage::OPAQUE_DEPTH, DEPTH_0);
    run OPAQUE_PASS;
    run BEFORE_PEEL;
});
const SECOND_PEEL: Listing = listing(steps! {
    glSamplerCompareFunc(GREATER);
    glUseProgram(stage::PEEL_SURFACE);
    drawTransparentObjects();
});
const CLEAR: Listing = listing(steps! { glClear(COLOR_BUFFER_BIT); });
const COPY: Listing = listing(steps! { glCopyImageSubData(stage::OPAQUE_DEPTH, DEPTH_1); });
const BEFORE_UNDER: Listing = listing(steps! {
    run BEFORE_SECOND;
    run SECOND_PEEL;
    glBindFramebuffer(stage::ACCUMULATION);
    glClear(COLOR_BUFFER_BIT);
    glDisable(DEPTH_TEST);
    glEnable(BLEND);
    glBlendFuncSeparate(ONE_MINUS_DST_ALPHA, ONE, ONE_MINUS_DST_ALPHA, ONE);
    glUseProgram(vtk::UNDER_LAYER);
    glActiveTexture(1);
    glBindTexture(stage::OPAQUE_DEPTH);
    glActiveTexture(3);
    glBindTexture(DEPTH_1);
    glActiveTexture(2);
    glBindTexture(vtk::COLOR_BUFFER);
});
const UNDER: Listing = listing(steps! { drawScreen(); glDisable(BLEND); });

const fn listing(steps: &'static [steps::Step]) -> Listing {
    Listing {
        title: "a part of a peel",
        source: "the bench",
        dialect: Dialect::Calls,
        steps,
    }
}
