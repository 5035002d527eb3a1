//! The machine, the driver and the versions that made the edition.

use serde_json::{Value, json};

use crate::error::Result;
use crate::gl::{Context, Driver, GlMachine, WANTED_EXTENSIONS};
use crate::methods::registry;

pub(super) fn data(context: &Context) -> Result<Value> {
    let driver = context.driver();
    let traps = GlMachine::new(context, [256, 256])?.traps()?;
    let traps = traps.iter();
    let limits = driver.limits.iter();
    Ok(json!({
        "renderer": driver.renderer,
        "version": driver.version_text,
        "extensions": extensions(driver),
        "limits": limits.map(|(name, value)| json!([name, value])).collect::<Vec<_>>(),
        "traps": traps.map(|it| json!([it.what, it.avoided])).collect::<Vec<_>>(),
        "missing": missing(driver),
        "system": std::env::consts::OS,
        "architecture": std::env::consts::ARCH,
    }))
}

/// The extensions that some method uses: the name, the purpose, and whether the driver has it.
fn extensions(driver: &Driver) -> Vec<Value> {
    let wanted = WANTED_EXTENSIONS.iter();
    wanted
        .map(|(name, purpose)| json!([name, purpose, driver.has(name)]))
        .collect()
}

/// The methods that the driver does not run, whose pages have no pictures therefore.
fn missing(driver: &Driver) -> Vec<&'static str> {
    let rows = registry().iter().filter(|row| !row.runs_on(driver));
    rows.map(|row| row.name).collect()
}
