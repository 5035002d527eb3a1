//! `generate = "isosurface"`: its volume and its value.

use super::keys::Keys;
use super::limits::ANY;
use super::volume::NamedVolume;
use crate::error::{Result, nearest};
use crate::scene::generate::Isosurface;

/// The keys of an isosurface.
pub(super) const PARAMETERS: [&str; 4] = ["volume", "value", "color", "opacity"];

/// The isosurface of the volume that `volume` names.
pub(super) fn read<'v>(keys: &Keys, volumes: &'v [NamedVolume]) -> Result<Isosurface<'v>> {
    let names: Vec<&str> = volumes.iter().filter_map(NamedVolume::name).collect();
    let Some(wanted) = keys.text("volume")? else {
        return Err(keys.wrong(
            "volume",
            "this isosurface has no volume",
            "Give a [[volume]] of this file a `name`, and write that name here: volume = \"NAME\".",
        ));
    };
    let Some(found) = volumes.iter().find(|volume| volume.name() == Some(wanted)) else {
        let remedy = match nearest(wanted, &names) {
            Some(meant) => format!("Did you mean \"{meant}\"?"),
            None if names.is_empty() => "No [[volume]] of this file has a `name`.".to_owned(),
            None => format!("Known are: {}.", names.join(", ")),
        };
        let what = format!("no volume is named \"{wanted}\"");
        return Err(keys.wrong("volume", what, remedy));
    };
    let missing = || keys.wrong("value", "`value` is missing", "Write value = 0.5.");
    Ok(Isosurface {
        volume: &found.volume,
        value: keys.number32("value", &ANY)?.ok_or_else(missing)?,
    })
}
