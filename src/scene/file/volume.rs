//! `[[volume]]`.

use std::path::Path;

use super::keys::{Keys, NumberOrWord};
use super::limits::{ANY, DENSITY, FRACTION, STEP};
use super::{transform, volume_generator};
use crate::error::{Error, Result};
use crate::scene::volume::{self, Missing, Transfer, TransferPoint, Volume, Wish};

/// All volumes of a file, in its order.
#[derive(Default)]
pub(super) struct Loaded {
    pub(super) volumes: Vec<NamedVolume>,
    pub(super) notices: Vec<String>,
}

/// A volume, with its name and its part in the scene.
pub(super) struct NamedVolume {
    pub(super) volume: Volume,
    /// The name in the file.
    pub(super) given: Option<String>,
    /// Whether the volume is used for isosurfaces only.
    pub(super) hidden: bool,
}

impl NamedVolume {
    /// The name in the file.
    pub(super) fn name(&self) -> Option<&str> {
        self.given.as_deref()
    }
}

/// The keys of every volume, from a file or from a generator.
const COMMON: [&str; 5] = ["name", "hidden", "step", "transfer", "transform"];
/// The keys of a volume from a file.
const OF_FILES: [&str; 3] = ["file", "array", "nan"];
/// The most samples that one scene file generates: 2 GiB of them.
const MOST_GENERATED: u64 = volume::MAX_SAMPLES;

pub(super) fn load_all(top: &Keys) -> Result<Loaded> {
    let mut loaded = Loaded::default();
    let mut generated = 0;
    for keys in top.tables("volume", "[[volume]]")? {
        // Faults of the look are reported before a large file is read.
        let volume = match (keys.text("file")?, keys.text("generate")?) {
            (Some(_), Some(_)) => {
                let what = "a volume is either read from a file or generated";
                let remedy = "Take out `file` or `generate`, or make two [[volume]] of it.";
                return Err(keys.wrong("generate", what, remedy));
            }
            (None, None) => return Err(without_samples(&keys)),
            (Some(file), None) => {
                keys.expect_only(&[&OF_FILES[..], &COMMON].concat())?;
                let look = Look::read(&keys)?;
                let wish = wish(&keys)?;
                let folder = keys.document.path.parent().unwrap_or(Path::new(""));
                let read = volume::load(&folder.join(file), &wish)?;
                loaded.notices.extend(read.notices);
                look.give(&keys, read.volume)?
            }
            (None, Some(_)) => {
                let volume = volume_generator::read(&keys, &COMMON)?;
                generated += volume.samples().len() as u64;
                if generated > MOST_GENERATED {
                    let what = format!(
                        "this and the volumes before it make {generated} samples, at most {MOST_GENERATED} are generated"
                    );
                    return Err(keys.wrong("samples", what, "Ask for fewer."));
                }
                Look::read(&keys)?.give(&keys, volume)?
            }
        };
        loaded.volumes.push(NamedVolume {
            volume,
            given: keys.text("name")?.map(str::to_owned),
            hidden: keys.flag("hidden")?.unwrap_or(false),
        });
    }
    Ok(loaded)
}

fn without_samples(keys: &Keys) -> Error {
    // A misspelt key is the more likely mistake.
    let known = [&OF_FILES[..], &["generate"], &COMMON].concat();
    keys.expect_only(&known).err().unwrap_or_else(|| {
        let names = volume_generator::names();
        keys.wrong(
            "file",
            "a volume without samples",
            format!("Give `file = \"volume.nhdr\"`, or `generate` with one of: {names}."),
        )
    })
}

/// The reader's options.
fn wish<'a>(keys: &Keys<'a>) -> Result<Wish<'a>> {
    Ok(Wish {
        array: keys.text("array")?,
        missing: match keys.number_or_word("nan", &ANY, "empty")? {
            Some(NumberOrWord::Number(value)) => Missing::Value(value as f32),
            Some(NumberOrWord::Word) | None => Missing::Empty,
        },
        memory: keys.document.memory,
    })
}

/// The look and the place of a volume.
struct Look {
    step: f64,
    transfer: Transfer,
}

impl Look {
    fn read(keys: &Keys) -> Result<Self> {
        Ok(Self {
            step: keys.number("step", &STEP)?.unwrap_or(Volume::DEFAULT_STEP),
            transfer: if keys.flag("hidden")? == Some(true) && !keys.is_list("transfer") {
                Transfer::default()
            } else {
                transfer(keys)?
            },
        })
    }

    fn give(self, keys: &Keys, volume: Volume) -> Result<Volume> {
        let transform = transform::read(keys)?;
        let mut volume = volume
            .transformed(&transform)
            .map_err(|error| match error {
                Error::Scene { what, remedy, .. } => keys.wrong("transform", what, remedy),
                other => other,
            })?;
        volume.step = self.step;
        volume.transfer = self.transfer;
        Ok(volume)
    }
}

fn transfer(keys: &Keys) -> Result<Transfer> {
    const MISSING: &str = "Write transfer = [{ value = 0, color = [1, 1, 1], density = 0 }, ...], in the order of the values.";
    let points: Vec<TransferPoint> = keys
        .tables("transfer", "a point of a transfer function")?
        .iter()
        .map(|point| {
            point.expect_only(&["value", "color", "density"])?;
            let missing = |key: &str| point.wrong(key, format!("`{key}` is missing"), MISSING);
            let value = point.number32("value", &ANY)?;
            let color = point.vector32("color", &FRACTION)?;
            let density = point.number32("density", &DENSITY)?;
            Ok(TransferPoint {
                value: value.ok_or_else(|| missing("value"))?,
                color: color.ok_or_else(|| missing("color"))?,
                density: density.ok_or_else(|| missing("density"))?,
            })
        })
        .collect::<Result<_>>()?;
    match volume::fault(&points) {
        Some((_, what, _)) if points.is_empty() => {
            Err(keys.wrong("transfer", format!("the transfer function {what}"), MISSING))
        }
        Some((number, what, remedy)) => {
            let what = format!("the transfer function's point {number} {what}");
            Err(keys.wrong("transfer", what, remedy))
        }
        None => Transfer::new(points),
    }
}
