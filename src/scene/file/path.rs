//! `[path]`: the camera's path, and which meshes and volumes are shown in which frames.

use std::collections::BTreeMap;

use super::keys::Keys;
use super::limits::{ANY, POSITIVE};
use super::sources::Source;
use crate::error::{Error, Result, nearest};
use crate::scene::animation::{Named, Show, Shows};
use crate::scene::path::CameraPath;

/// The largest number of frames. At a second per frame, they take eleven days.
const MOST_FRAMES: u64 = 1_000_000;

/// The animation of a file.
#[derive(Default)]
pub(super) struct Loaded {
    pub(super) path: Option<CameraPath>,
    pub(super) shows: Shows,
}

pub(super) fn read(top: &Keys, sources: &[Source]) -> Result<Loaded> {
    let Some(keys) = top.table("path", "[path]")? else {
        return Ok(Loaded::default());
    };
    keys.expect_only(&["frames", "rotate", "dolly", "dolly_frames", "show"])?;
    let default = CameraPath::default();
    let frames = keys.integer("frames", &(1..=MOST_FRAMES))?;
    let frames = frames.map_or(default.frames, |frames| frames as u32);
    let dolly = keys.number("dolly", &POSITIVE)?;
    let dolly_frames = keys.integer("dolly_frames", &(2..=MOST_FRAMES))?;
    // A path with a dolly need not turn.
    let still = if dolly.is_some() { 0.0 } else { default.rotate };
    let path = CameraPath {
        frames,
        rotate: keys.number("rotate", &ANY)?.unwrap_or(still),
        dolly: dolly.unwrap_or(default.dolly),
        dolly_frames: dolly_frames.map_or(frames.max(2), |frames| frames as u32),
    };
    Ok(Loaded {
        shows: shows(&keys, sources)?,
        path: Some(path),
    })
}

fn shows(keys: &Keys, sources: &[Source]) -> Result<Shows> {
    let (names, named) = by_name(sources);
    let mut shows: Vec<Show> = Vec::new();
    for keys in keys.tables("show", "[[path.show]]")? {
        keys.expect_only(&["from", "sources"])?;
        let missing = |key: &str| {
            let what = format!("`{key}` is missing");
            keys.wrong(key, what, "Write from = 100 and sources = [\"NAME\"].")
        };
        let from = keys.integer("from", &(0..=MOST_FRAMES))?;
        let from = from.ok_or_else(|| missing("from"))? as u32;
        if shows.last().is_some_and(|last| last.from >= from) {
            let what = "this does not start after the [[path.show]] before it";
            return Err(keys.wrong("from", what, "Put them into the order of their frames."));
        }
        let wanted = keys.texts("sources")?.ok_or_else(|| missing("sources"))?;
        let places = wanted.iter().map(|name| {
            let place = names.get(name).copied();
            place.ok_or_else(|| unknown(&keys, name, &names))
        });
        let mut places = places.collect::<Result<Vec<_>>>()?;
        places.sort_unstable();
        places.dedup();
        shows.push(Show {
            from,
            names: places,
        });
    }
    Ok(Shows { named, shows })
}

/// The place of each name, and at each place the sources that have the name. Several sources may share one.
fn by_name(sources: &[Source]) -> (BTreeMap<&str, usize>, Vec<Named>) {
    let mut names = BTreeMap::new();
    let mut named: Vec<Named> = Vec::new();
    for source in sources {
        let Some(name) = source.name.as_deref() else {
            continue;
        };
        let place = *names.entry(name).or_insert(named.len());
        if place == named.len() {
            named.push(Named::default());
        }
        named[place].meshes.push(source.meshes.clone());
        named[place].volumes.push(source.volumes.clone());
    }
    (names, named)
}

fn unknown(keys: &Keys, name: &str, names: &BTreeMap<&str, usize>) -> Error {
    let known: Vec<&str> = names.keys().copied().collect();
    let remedy = match nearest(name, &known) {
        Some(meant) => format!("Did you mean \"{meant}\"?"),
        None => "Give a [[mesh]] or [[volume]] this `name`.".to_owned(),
    };
    let what = format!("no mesh and no volume is named \"{name}\"");
    keys.wrong("sources", what, remedy)
}
