//! The history of a pixel: what a method does to each of its fragments, pass by pass.
//!
//! [`history`] renders a frame, and has it watched. Each call that the method performs on OpenGL is performed on an
//! [emulated pixel](crate::emulator), too, which has the fragments that OpenGL has there. After every draw the values that
//! both hold are compared. So a history says what happened to each fragment, and whether OpenGL has done what it should.
//!
//! ```
//! use onionskin::{Context, Method, Renderer, Scene, generate, inspect};
//!
//! let context = Context::headless()?;
//! let quads = generate::quads(&generate::Quads { count: 3, ..Default::default() })?;
//! let scene = Scene::of("quads", vec![quads]);
//! let mut renderer = Renderer::new(&context, 64, 48)?;
//! let peeling = Method::DepthPeeling(Default::default());
//! let history = inspect::history(&mut renderer, &scene, &peeling, [32, 24])?;
//! assert_eq!(history.fragments.len(), 3);
//! assert!(history.differences().next().is_none());
//! # Ok::<(), onionskin::Error>(())
//! ```

mod compare;
mod composite;
mod drawn_order;
mod exact;
mod fates;
mod find;
mod follower;
mod fragments;
mod history;
mod nodes;
mod recording;
mod seen;
mod trace;
mod watched;

pub use composite::{Composite, Layer};
pub use fates::Fate;
pub use find::{Where, deepest, find, worst};
pub use history::{Event, FragmentHistory, History, Line, ListCosts, Loss, Pass, RaySegment, name};

use crate::error::{Error, Result};
use crate::methods::{Exact, Renderer, Technique};
use crate::scene::Scene;

/// The history of a pixel, in column `x` from the left and row `y` from the top.
///
/// # Errors
/// If there is no such pixel, or the method or the driver fails.
pub fn history(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
    pixel: [u32; 2],
) -> Result<History> {
    let histories = histories(renderer, scene, method, &[pixel])?;
    Ok(histories
        .into_iter()
        .next()
        .expect("one pixel has one history"))
}

/// The histories of several pixels, all of one frame.
///
/// # Errors
/// As [`history`].
pub fn histories(
    renderer: &mut Renderer<'_>,
    scene: &Scene,
    method: &dyn Technique,
    pixels: &[[u32; 2]],
) -> Result<Vec<History>> {
    let size = renderer.size();
    if let Some(outside) = pixels.iter().find(|[x, y]| *x >= size[0] || *y >= size[1]) {
        return Err(outside_of(*outside, size));
    }
    if method.entry().name == Exact.entry().name {
        return Err(Error::usage(
            "exact has no passes: the oracle sorts the fragments and composites them in f64",
            "inspect another method; every history has the exact composite beside it",
        ));
    }
    let from_below: Vec<_> = pixels.iter().map(|&[x, y]| [x, size[1] - 1 - y]).collect();
    let watched = watched::Watched::new(method, from_below);
    let frame = renderer.render(scene, &watched)?;
    Ok(watched.histories(&frame))
}

fn outside_of([x, y]: [u32; 2], [width, height]: [u32; 2]) -> Error {
    Error::usage(
        format!("there is no pixel {x},{y} in an image of {width} x {height} pixels"),
        format!(
            "columns are 0 to {}, rows are 0 to {} from the top",
            width - 1,
            height - 1
        ),
    )
}
