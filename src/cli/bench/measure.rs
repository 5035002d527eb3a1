//! The methods of one scene, measured in rounds.

use std::cell::{Cell, RefCell};

use onionskin::low_level::methods::Film;
use onionskin::{Error, Result, Scene};

use super::methods::Asked;
use super::rounds::{self, Plan, Runner};
use super::row::{By, Counts, Row};
use super::statistics::Times;
use super::steps::{self, Steps, Timed};
use super::vtk::{MODES, Vtk};
use crate::cli::progress::Progress;
use crate::cli::setup::Rendering;

const WARM_UP: u32 = 2;
/// In milliseconds.
const WARM_AFTER: f64 = 1000.0;
/// In milliseconds.
const BUDGET: f64 = 5000.0;

/// What is measured, and how.
pub(super) struct Task<'t> {
    pub(super) rendering: &'t Rendering,
    pub(super) asked: &'t Asked,
    pub(super) frames: u32,
    /// Whether to time their steps, too.
    pub(super) steps: bool,
}

/// A row for each method, and for each mode of VTK if it takes part. One that does not run on this scene or driver has a row
/// that says why.
pub(super) fn measure(task: &Task<'_>, scene: &Scene, vtk: Option<Vtk>) -> Result<Vec<Row>> {
    let &Task {
        rendering,
        asked,
        frames,
        ..
    } = task;
    let methods = asked.methods(scene);
    rendering.check_methods(scene, methods.len())?;
    let plan = Plan {
        warm_up: WARM_UP,
        warm_after: WARM_AFTER,
        rounds: frames,
        budget: BUDGET,
    };
    let frames_of_one = u64::from(WARM_UP + frames);
    let parts = methods.len() as u64 * (1 + frames_of_one);
    let of_vtk = vtk
        .as_ref()
        .map_or(0, |_| MODES.len() as u64 * frames_of_one);
    let progress = Progress::new(parts + of_vtk, &scene.name);
    // Each method has a context of its own, so that none gives back in a round what it needs in the next. Some drivers keep
    // only so many compiled shaders for a context: on llvmpipe, lists' networks of all methods together are more, and each
    // would be compiled again in each round.
    let mut contexts = Vec::new();
    for _ in &methods {
        contexts.push(rendering.gl.context()?);
    }
    let mut renderers = Vec::new();
    for context in &contexts {
        renderers.push(rendering.silent_renderer(context, scene)?.without_costs());
    }
    let mut rows = Vec::new();
    let mut films = Vec::new();
    let mut warmed = Vec::new();
    for (method, renderer) in methods.iter().zip(&mut renderers) {
        progress.next(&format!("{}: {method}", scene.name));
        let mut row = Row::begun(By::Onionskin, method.name());
        let mut film = renderer.film(scene.clone(), method);
        // The first frame compiles the shaders, and is counted.
        match film.frame(scene.camera) {
            Ok(frame) => {
                row.counts = Counts::of(method, &frame.stats);
                warmed.push(frame.stats.ms);
                films.push((rows.len(), RefCell::new(film)));
            }
            Err(error) => row.times = Err(why(&error)),
        }
        rows.push(row);
        progress.part_done();
    }
    progress.next(&scene.name);
    let vtk = vtk.map(RefCell::new);
    let passes: [Cell<u64>; MODES.len()] = Default::default();
    let mut runners: Vec<Runner<'_>> = Vec::new();
    let mut running = Vec::new();
    for (number, film) in &films {
        running.push(*number);
        runners.push(Box::new(|camera| film.borrow_mut().time(camera)));
    }
    if let Some(vtk) = &vtk {
        for (mode, passes) in MODES.into_iter().zip(&passes) {
            running.push(rows.len());
            warmed.push(0.0);
            rows.push(Row::begun(By::Vtk, mode));
            runners.push(Box::new(move |camera| {
                let frame = vtk.borrow_mut().frame(mode, &camera, None)?;
                passes.set(frame.passes);
                Ok(frame.ms)
            }));
        }
    }
    let times = rounds::run(&mut runners, &scene.camera, plan, &warmed, || {
        progress.part_done()
    });
    drop(runners);
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
    if task.steps {
        for (number, film) in films {
            let row: &mut Row = &mut rows[number];
            progress.next(&format!("{}: steps of {}", scene.name, row.method));
            if row.times.is_ok() {
                row.steps = Steps::of(&frames_by_steps(&mut film.into_inner(), scene, plan)?);
            }
        }
    }
    Ok(rows)
}

/// Frames in which each step is waited for.
fn frames_by_steps(
    film: &mut Film<'_, '_>,
    scene: &Scene,
    plan: Plan,
) -> Result<Vec<steps::Frame>> {
    let mut frames = Vec::new();
    let mut runner: [Runner<'_>; 1] = [Box::new(|camera| {
        let (ms, steps) = film.time_steps(camera)?;
        frames.push((ms, steps.into_iter().map(Timed::from).collect()));
        Ok(ms)
    })];
    let plan = Plan { warm_up: 0, ..plan };
    let answer = rounds::run(&mut runner, &scene.camera, plan, &[0.0], || {}).pop();
    drop(runner);
    answer.transpose()?;
    Ok(frames)
}

/// What is wrong, without what to do about it: a row has one line.
pub(super) fn why(error: &Error) -> String {
    let text = error.to_string();
    text.lines().next().unwrap_or_default().to_owned()
}
