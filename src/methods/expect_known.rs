//! Whether a listing, as a method is about to run it, names only what there is. A user's amendments may not.

use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::stage;
use crate::steps::{Amendment, Known, Listing, Resources, check};

/// Checks a listing that finds these resources, those of the stage, and every shader of the machine.
///
/// # Errors
/// The first name that is not known, and the one that was probably meant.
pub(super) fn expect_known(
    machine: &GlMachine<'_>,
    listing: &Listing,
    amendments: &[Amendment],
    resources: &[&'static Resources],
) -> Result<()> {
    let known = Known::shaders(machine.shaders()).with(&[&stage::RESOURCES]);
    check(listing, amendments, &known.with(resources))
}
