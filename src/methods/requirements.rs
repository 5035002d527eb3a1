//! Checking the requirements of peeling methods, with messages that name what is missing.

use crate::error::{Error, Result};
use crate::gl::{Driver, Format};
use crate::papers::vtk::{ALPHA_BITS, missing_extensions};

/// Checks that this driver can peel, in colours of this format.
pub(super) fn check(driver: &Driver, color: Format) -> Result<()> {
    let missing = missing_extensions(driver.version, |name| driver.has(name));
    if !missing.is_empty() {
        return Err(Error::Driver {
            what: format!(
                "depth peeling needs OpenGL extensions that this driver lacks: {}",
                missing.join(", ")
            ),
            remedy: "`onionskin doctor` shows the driver; Mesa has them all".into(),
        });
    }
    let bits = color.alpha_bits();
    if bits < ALPHA_BITS {
        return Err(Error::option(
            "color",
            format!(
                "depth peeling needs at least {ALPHA_BITS} alpha bits, and the colour format {color} has {bits}"
            ),
            "choose rgba8, rgba16f or rgba32f",
        ));
    }
    Ok(())
}
