//! `[path]`: where the camera goes, and what is shown when.

use super::keys::Keys;
use super::limits::{ANY, POSITIVE};
use super::nearest::nearest;
use super::sources::Source;
use crate::error::Result;
use crate::scene::animation::Show;
use crate::scene::path::CameraPath;

/// The longest path: at a second a frame it takes eleven days.
const MOST_FRAMES: u64 = 1_000_000;

/// What a file says about its animation.
#[derive(Default)]
pub(super) struct Loaded {
    pub(super) path: Option<CameraPath>,
    pub(super) shows: Vec<Show>,
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
    // A path that dollies need not turn.
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

fn shows(keys: &Keys, sources: &[Source]) -> Result<Vec<Show>> {
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
        let names = keys.texts("sources")?.ok_or_else(|| missing("sources"))?;
        let mut show = Show {
            from,
            meshes: Vec::new(),
            volumes: Vec::new(),
        };
        for source in named(&keys, &names, sources)? {
            show.meshes.push(source.meshes.clone());
            show.volumes.push(source.volumes.clone());
        }
        shows.push(show);
    }
    Ok(shows)
}

/// The sources of these names, in the file's order; several may share a name.
fn named<'s>(keys: &Keys, names: &[&str], sources: &'s [Source]) -> Result<Vec<&'s Source>> {
    let known: Vec<&str> = sources.iter().filter_map(|s| s.name.as_deref()).collect();
    for name in names {
        if !known.contains(name) {
            let remedy = match nearest(name, &known) {
                Some(meant) => format!("Did you mean \"{meant}\"?"),
                None => "Give a [[mesh]] or [[volume]] this `name`.".to_owned(),
            };
            let what = format!("there is no mesh and no volume named \"{name}\"");
            return Err(keys.wrong("sources", what, remedy));
        }
    }
    let shown = |source: &&Source| source.name.as_deref().is_some_and(|n| names.contains(&n));
    Ok(sources.iter().filter(shown).collect())
}
