//! Scene files.
//!
//! ```toml
//! size = [1024, 768]               # pixels, 1 to 65535 each
//! background = [1.0, 1.0, 1.0]     # linear RGB; black if left out
//!
//! [camera]                         # what is left out is fitted, see PartialCamera
//! eye = [0.0, 0.0, 3.0]
//! target = [0.0, 0.0, 0.0]
//! up = [0.0, 1.0, 0.0]
//! fov = 30.0
//! near = 0.1
//! far = 10.0
//!
//! [[mesh]]
//! file = "model.obj"               # or: generate = "teapot" and its parameters
//! color = [0.8, 0.55, 0.3]
//! opacity = 0.4
//! shading = "two-sided"            # none, flat, lit, two-sided
//! inside = [0.0, 0.6, 0.0]         # two-sided shading only; `color` if left out
//! sorted = false
//! transform = { scale = 2.0, rotate = { axis = [0, 1, 0], degrees = 30 }, translate = [0, 1, 0] }
//!
//! [[volume]]
//! file = "potential.nhdr"          # .nrrd, .nhdr, .nii, .nii.gz, .vti; or: generate = "ball" and its parameters
//! step = 0.5                       # sampling distance in voxels
//! transfer = [                     # see Transfer; in the order of the values
//!   { value = 0.0, color = [1.0, 1.0, 1.0], density = 0.0 },
//!   { value = 5.0, color = [0.1, 0.2, 0.9], density = 0.4 },
//! ]
//! transform = { translate = [0, 1, 0] }
//! ```
//!
//! A transform scales first (by one factor or by three), then rotates about the origin, then moves.

mod camera;
mod generator;
mod keys;
mod limits;
mod mesh;
mod nearest;
mod place;
mod transform;
mod value;
mod volume;
mod volume_generator;

use std::path::Path;

use toml::de::DeTable;

use super::{Scene, joined, source, stem};
use crate::error::{Error, Place, Result};
use keys::Keys;
use limits::FRACTION;
use mesh::Loaded;
use place::Document;

/// The largest scene file that is read. It is written by hand; this leaves room for one written by a program.
const MAX_BYTES: usize = 16 << 20;

/// Reads a scene file and all that it names. A given size replaces the file's.
pub(super) fn load(path: &Path, size: Option<[u32; 2]>) -> Result<Scene> {
    let text = read(path)?;
    let document = Document { path, text: &text };
    let table = DeTable::parse(&text).map_err(|error| unparsed(&document, &error))?;
    let keys = Keys::top(document, &table);
    keys.expect_only(&["size", "background", "camera", "mesh", "volume"])?;
    let of_file = keys.integers("size", &(1..=65535))?;
    let of_file = of_file.map(|size| size.map(|pixels| pixels as u32));
    let size = size.or(of_file).unwrap_or(Scene::DEFAULT_SIZE);
    let background = keys.vector32("background", &FRACTION)?.unwrap_or_default();
    let camera = camera::Wish::read(&keys)?;
    let Loaded {
        meshes,
        mut notices,
    } = mesh::load_all(&keys)?;
    let of_volumes = volume::load_all(&keys)?;
    notices.extend(of_volumes.notices);
    let volumes = of_volumes.volumes;
    Ok(Scene {
        name: stem(path),
        size,
        background,
        camera: camera.fit(joined(&meshes, &volumes), size)?,
        meshes,
        volumes,
        notices,
    })
}

fn read(path: &Path) -> Result<String> {
    let bytes = source::read(path)?;
    if bytes.len() > MAX_BYTES {
        return Err(Error::input(
            Place::file(path),
            format!(
                "{} bytes; a scene file has at most {MAX_BYTES}",
                bytes.len()
            ),
            "Put the geometry into model files, which the scene file names.",
        ));
    }
    String::from_utf8(bytes).map_err(|error| {
        let valid = &error.as_bytes()[..error.utf8_error().valid_up_to()];
        let line = 1 + valid.iter().filter(|&&byte| byte == b'\n').count();
        Error::input(
            Place::line(path, line),
            "this is not UTF-8 text",
            "Save the file as UTF-8.",
        )
    })
}

fn unparsed(document: &Document, error: &toml::de::Error) -> Error {
    let place = match error.span() {
        Some(span) => document.place(span),
        None => Place::file(document.path),
    };
    Error::input(
        place,
        format!("this is not TOML: {}", error.message().replace('\n', ", ")),
        "Correct the line; toml.io shows the format. Text goes in quotes, lists in square brackets.",
    )
}
