//! The methods of one scene, measured in rounds.

use std::cell::{Cell, RefCell};

use onionskin::{Context, Error, Method, Renderer, Result, Scene};

use super::methods::Asked;
use super::rounds::{self, Plan, Runner};
use super::row::{By, Counts, Row};
use super::statistics::Times;
use super::vtk::{MODES, Vtk};
use crate::cli::progress::Progress;
use crate::cli::setup::Rendering;

const WARM_UP: u32 = 2;
/// In milliseconds.
const BUDGET: f64 = 5000.0;

/// What is measured, and how.
pub(super) struct Task<'t> {
    pub(super) rendering: &'t Rendering,
    pub(super) context: &'t Context,
    pub(super) asked: &'t Asked,
    pub(super) frames: u32,
}

/// A row for each method, and for each mode of VTK if it takes part. One that does not run on this scene or driver has a row that says why.
pub(super) fn measure(task: &Task<'_>, scene: &Scene, vtk: Option<Vtk>) -> Result<Vec<Row>> {
    let &Task {
        rendering,
        context,
        asked,
        frames,
    } = task;
    let methods = asked.methods(scene);
    rendering.check_methods(scene, methods.len())?;
    let plan = Plan {
        warm_up: WARM_UP,
        rounds: frames,
        budget: BUDGET,
    };
    let frames_of_one = u64::from(WARM_UP + frames);
    let parts = methods.len() as u64 * (1 + frames_of_one);
    let of_vtk = vtk
        .as_ref()
        .map_or(0, |_| MODES.len() as u64 * frames_of_one);
    let progress = Progress::new(parts + of_vtk, &scene.name);
    let vtk = vtk.map(RefCell::new);
    let passes: [Cell<u64>; MODES.len()] = Default::default();
    // Each method has a renderer of its own, so that none gives back in a round what it needs in the next.
    let mut renderers = Vec::new();
    for _ in &methods {
        renderers.push(rendering.silent_renderer(context, scene)?.without_costs());
    }
    let mut rows = Vec::new();
    let mut runners: Vec<Runner<'_>> = Vec::new();
    let mut running = Vec::new();
    for (method, renderer) in methods.iter().zip(&mut renderers) {
        progress.next(&format!("{}: {method}", scene.name));
        let mut row = Row::begun(By::Onionskin, method.name());
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
    if let Some(vtk) = &vtk {
        for (mode, passes) in MODES.into_iter().zip(&passes) {
            running.push(rows.len());
            rows.push(Row::begun(By::Vtk, mode));
            runners.push(Box::new(move |camera| {
                let frame = vtk.borrow_mut().frame(mode, &camera, None)?;
                passes.set(frame.passes);
                Ok(frame.ms)
            }));
        }
    }
    progress.next(&scene.name);
    let times = rounds::run(&mut runners, &scene.camera, plan, || progress.part_done());
    for (number, times) in running.into_iter().zip(times) {
        rows[number].times = match times {
            Ok(times) => Times::of(times).ok_or_else(|| "no frame was timed".into()),
            Err(error) => Err(why(&error)),
        };
    }
    let of_vtk = rows.iter_mut().filter(|row| row.by == By::Vtk);
    for (row, passes) in of_vtk.zip(&passes) {
        row.counts.geometry_passes = Some(passes.get()).filter(|_| row.times.is_ok());
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
pub(super) fn why(error: &Error) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().to_owned()
}
