//! The methods of one scene, measured in rounds.

use onionskin::{Context, Error, Method, Renderer, Result, Scene};

use super::methods::Asked;
use super::rounds::{self, Plan, Runner};
use super::row::{By, Counts, Row};
use super::statistics::Times;
use crate::cli::progress::Progress;
use crate::cli::setup::Rendering;

const WARM_UP: u32 = 2;
/// In milliseconds.
const BUDGET: f64 = 5000.0;

/// A row for each method. One that does not run on this scene or driver has a row that says why.
pub(super) fn measure(
    rendering: &Rendering,
    context: &Context,
    scene: &Scene,
    asked: &Asked,
    frames: u32,
) -> Result<Vec<Row>> {
    let methods = asked.methods(scene);
    rendering.check_methods(scene, methods.len())?;
    let plan = Plan {
        warm_up: WARM_UP,
        rounds: frames,
        budget: BUDGET,
    };
    let progress = Progress::new(
        methods.len() as u64 * u64::from(1 + WARM_UP + frames),
        &scene.name,
    );
    // Each method has a renderer of its own, so that none gives back in a round what it needs in the next.
    let mut renderers = Vec::new();
    for _ in &methods {
        renderers.push(rendering.silent_renderer(context, scene)?.without_costs());
    }
    let mut rows = Vec::new();
    let mut runners = Vec::new();
    let mut running = Vec::new();
    for (method, renderer) in methods.iter().zip(&mut renderers) {
        progress.next(&format!("{}: {method}", scene.name));
        let mut row = Row {
            by: By::Onionskin,
            method: method.to_string(),
            counts: Counts::default(),
            times: Err("not measured".into()),
        };
        match begin(renderer, scene, method) {
            Ok((counts, runner)) => {
                row.counts = counts;
                running.push(rows.len());
                runners.push(runner);
            }
            Err(error) => row.times = Err(why(&error)),
        }
        rows.push(row);
        progress.part_done();
    }
    progress.next(&scene.name);
    let times = rounds::run(&mut runners, &scene.camera, plan, || progress.part_done());
    for (number, times) in running.into_iter().zip(times) {
        rows[number].times = match times {
            Ok(times) => Times::of(times).ok_or_else(|| "no frame was timed".into()),
            Err(error) => Err(why(&error)),
        };
    }
    Ok(rows)
}

/// The first frame, which compiles the shaders and is counted, and the runner for the frames that are timed.
fn begin<'r>(
    renderer: &'r mut Renderer<'_>,
    scene: &Scene,
    method: &'r Method,
) -> Result<(Counts, Runner<'r>)> {
    let mut film = renderer.film(scene.clone(), method);
    let counts = Counts::of(method, &film.frame(scene.camera)?.stats);
    Ok((counts, Box::new(move |camera| film.time(camera))))
}

/// What is wrong, without what to do about it: a row has one line.
fn why(error: &Error) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().to_owned()
}
