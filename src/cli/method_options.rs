//! Arguments that choose a method and what can be chosen about it.

use clap::Args;
use onionskin::{Method, Result, Scene};

use super::chosen::Chosen;
use super::slices::Slices;

/// The method if none is named.
const OF_SURFACES: &str = "depth-peeling";
/// The method if none is named, nor anything that the other one has, and there are volumes.
const OF_VOLUMES: &str = "dfb+ppdp";

#[derive(Args)]
pub(super) struct MethodOptions {
    /// The method: exact, painter, ffb ...; `onionskin methods` describes them all [default: depth-peeling; dfb+ppdp
    /// where volumes are to be rendered]
    #[arg(short, long)]
    method: Option<String>,
    #[command(flatten)]
    pub(super) chosen: Chosen,
    #[command(flatten)]
    pub(super) slices: Slices,
}

impl MethodOptions {
    /// The method with its options; depth peeling if none is named.
    ///
    /// # Errors
    /// If there is no such method, or it has no such option.
    pub(super) fn method(&self) -> Result<Method> {
        let method = self.method.as_deref().unwrap_or(OF_SURFACES).parse()?;
        let method = self.chosen.apply_to(method)?;
        self.slices.check(&method)?;
        Ok(method)
    }

    /// `method`, or if none was named, and nothing chosen that only depth peeling has, one that renders the scene's volumes.
    ///
    /// # Errors
    /// None, for the method is in the registry.
    pub(super) fn for_scene(&self, method: Method, scene: &Scene) -> Result<Method> {
        let asked = self.method.is_some() || self.slices.is_given() || self.chosen.is_any();
        if asked || scene.volumes.is_empty() {
            return Ok(method);
        }
        OF_VOLUMES.parse()
    }
}
