//! The arguments for a method and its options.

use clap::Args;
use onionskin::{Method, Result, Scene};

use super::chosen::Chosen;
use super::slices::Slices;

/// The default method.
const OF_SURFACES: &str = "depth-peeling";
/// The default method for a scene with volumes, unless an option is given that only the other default has.
const OF_VOLUMES: &str = "dfb+ppdp";

#[derive(Args)]
pub(super) struct MethodOptions {
    /// The method, such as exact, painter or ffb; `onionskin methods` describes all of them [default: depth-peeling,
    /// and dfb+ppdp for scenes with volumes]
    #[arg(short, long)]
    method: Option<String>,
    #[command(flatten)]
    pub(super) chosen: Chosen,
    #[command(flatten)]
    pub(super) slices: Slices,
}

impl MethodOptions {
    /// The method with its options, or depth peeling if none is named.
    ///
    /// # Errors
    /// If the method does not exist, or does not have an option.
    pub(super) fn method(&self) -> Result<Method> {
        let method = self.method.as_deref().unwrap_or(OF_SURFACES).parse()?;
        let method = self.chosen.apply_to(method)?;
        self.slices.check(&method)?;
        Ok(method)
    }

    /// `method`, or the default for the scene's volumes if no method was named and no option that only depth peeling
    /// has was given.
    ///
    /// # Errors
    /// None, because the method is in the registry.
    pub(super) fn for_scene(&self, method: Method, scene: &Scene) -> Result<Method> {
        let asked = self.method.is_some() || self.slices.is_given() || self.chosen.is_any();
        if asked || scene.volumes.is_empty() {
            return Ok(method);
        }
        OF_VOLUMES.parse()
    }
}
