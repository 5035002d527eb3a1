//! Scene files.
//!
//! ```toml
//! size = [1024, 768]               # pixels, 1 to 65535 each
//! background = [1.0, 1.0, 1.0]     # linear RGB; black if left out
//!
//! [camera]                         # keys that are left out are fitted, see PartialCamera
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
//! file = "potential.nhdr"          # .nrrd, .nhdr, .nii, .nii.gz, .vti, .pvti; or: generate = "ball" and its parameters
//! array = "phi"                    # one of several arrays (.vti, .pvti); if left out: the active scalars, or the first
//! nan = "empty"                    # for samples that are not numbers: "empty" (no density around them), or a number
//! step = 0.5                       # sampling distance in voxels
//! transfer = [                     # see Transfer; in the order of the values
//!   { value = 0.0, color = [1.0, 1.0, 1.0], density = 0.0 },
//!   { value = 5.0, color = [0.1, 0.2, 0.9], density = 0.4 },
//! ]
//! transform = { translate = [0, 1, 0] }
//! hidden = false                   # true: used for isosurfaces only, and needs no transfer function
//! name = "potential"               # for isosurfaces and [[path.show]]; a mesh may have a name, too
//!
//! [[mesh]]
//! generate = "isosurface"
//! volume = "potential"             # a volume's name
//! value = 2.5
//!
//! [path]                           # for animations, see CameraPath; without it, the camera turns once in 36 frames
//! frames = 400
//! rotate = 90.0                    # degrees over all frames
//! dolly = 0.4                      # the eye comes as near as this part of its distance, and goes back ...
//! dolly_frames = 200               # ... in so many frames
//!
//! [[path.show]]                    # everything is shown before the first of these
//! from = 100                       # from this frame on ...
//! sources = ["potential"]          # ... only meshes and volumes with one of these names are shown
//! ```
//!
//! Volumes of patients stand in right-anterior-superior axes (RAS). NIfTI files always have these axes. NRRD files
//! whose `space` is anatomical are turned into them if they have others. All other files, and all meshes, stay in their
//! own axes.
//!
//! A transform first scales (by one factor or by three), then rotates about the origin, then moves.

mod camera;
mod flow_generator;
mod generator;
mod isosurface;
mod keys;
mod limits;
mod mesh;
mod path;
mod place;
mod seed;
mod sources;
mod transform;
mod value;
mod volume;
mod volume_generator;

use std::path::Path;

use toml::de::DeTable;

use super::animation::Animation;
use super::contents::{Scene, joined};
use super::options::LoadOptions;
use super::source::{self, stem};
use super::volume::Volume;
use crate::error::{Error, Place, Result};
use crate::memory::MemoryLimit;
use keys::Keys;
use limits::FRACTION;
use mesh::Loaded;
use place::{Document, Lines};
use sources::Source;
use volume::NamedVolume;

/// The largest scene file that is read. Scene files are written by hand; the limit leaves room for one that a program
/// wrote.
const MAX_BYTES: usize = 16 << 20;

/// The memory of the parser's tree per byte of a list of one-digit numbers, the densest text that there is. Measured.
const BYTES_PER_BYTE: u64 = 80;

/// Reads a scene file and all files that it names.
pub(super) fn load(path: &Path, options: &LoadOptions) -> Result<Animation> {
    let memory = &options.memory;
    let text = read(path, memory)?;
    let lines = &Lines::of(&text);
    let document = Document {
        path,
        text: &text,
        lines,
        memory,
    };
    let table = DeTable::parse(&text).map_err(|error| unparsed(&document, &error))?;
    let keys = Keys::top(document, &table);
    keys.expect_only(&["size", "background", "camera", "path", "mesh", "volume"])?;
    let of_file = keys.integers("size", &(1..=65535))?;
    let of_file = of_file.map(|size| size.map(|pixels| pixels as u32));
    let size = options.size.or(of_file).unwrap_or(Scene::DEFAULT_SIZE);
    let background = keys.vector32("background", &FRACTION)?.unwrap_or_default();
    let camera = camera::CameraKeys::read(&keys)?;
    let of_volumes = volume::load_all(&keys)?;
    let mut of_meshes = mesh::load_all(&keys, &of_volumes.volumes)?;
    of_meshes.notices.extend(of_volumes.notices);
    let volumes = shown(of_volumes.volumes, &mut of_meshes.sources);
    let Loaded {
        meshes,
        notices,
        sources,
    } = of_meshes;
    let wished = path::read(&keys, &sources)?;
    let scene = Scene {
        name: stem(path),
        size,
        background,
        camera: camera.fit(joined(&meshes, &volumes), size)?,
        meshes,
        volumes,
        notices,
    };
    Ok(Animation {
        scene,
        has_path: wished.path.is_some(),
        path: wished.path.unwrap_or_default(),
        wish: camera.partial(),
        shows: wished.shows,
    })
}

/// The volumes that are not hidden. Each entry of the file becomes a source.
fn shown(all: Vec<NamedVolume>, sources: &mut Vec<Source>) -> Vec<Volume> {
    let mut volumes = Vec::new();
    for entry in all {
        let first = volumes.len();
        volumes.extend((!entry.hidden).then_some(entry.volume));
        sources.push(Source {
            name: entry.given,
            meshes: 0..0,
            volumes: first..volumes.len(),
        });
    }
    volumes
}

fn read(path: &Path, memory: &MemoryLimit) -> Result<String> {
    let bytes = source::read(path, memory)?;
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
    let bytes_of_tree = bytes.len() as u64 * BYTES_PER_BYTE;
    memory
        .check(bytes_of_tree)
        .map_err(|shortage| shortage.at(Place::file(path), "the scene file's values"))?;
    let text = String::from_utf8(bytes).map_err(|error| {
        let (valid, rest) = error.as_bytes().split_at(error.utf8_error().valid_up_to());
        let line = 1 + valid.iter().filter(|&&byte| byte == b'\n').count();
        let byte = rest.first().copied().unwrap_or_default();
        let mut what = format!("this is not UTF-8 text: it has the byte {byte:#04x}");
        if byte >= 0xa0 {
            // The first 256 characters of Unicode are Latin-1's.
            what += &format!(", which is '{}' in Latin-1", char::from(byte));
        }
        Error::input(
            Place::line(path, line),
            what,
            "Save the file as UTF-8, in an editor or by `iconv -f latin1 -t utf-8`.",
        )
    })?;
    // The byte order mark that some editors put before UTF-8.
    Ok(match text.strip_prefix('\u{feff}') {
        Some(text) => text.to_owned(),
        None => text,
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
