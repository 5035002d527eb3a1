//! The arguments for a method and its options.

use clap::Args;
use onionskin::{Method, Result};

use super::chosen::Chosen;
use super::slices::Slices;

/// The method that options belong to if none is named.
const WITH_OPTIONS: &str = "depth-peeling";

#[derive(Args)]
pub(super) struct MethodOptions {
    /// The method, such as exact, painter or ffb; `onionskin methods` describes all of them [default: auto, a quick
    /// exact one for the scene; depth-peeling if one of its options is given]
    #[arg(short, long)]
    method: Option<String>,
    #[command(flatten)]
    pub(super) chosen: Chosen,
    #[command(flatten)]
    pub(super) slices: Slices,
}

impl MethodOptions {
    /// The method with its options. If none is named, it is depth peeling.
    ///
    /// # Errors
    /// If the method does not exist, or does not have an option.
    pub(super) fn method(&self) -> Result<Method> {
        let method = self.method.as_deref().unwrap_or(WITH_OPTIONS).parse()?;
        let method = self.chosen.apply_to(method)?;
        self.slices.check(&method)?;
        Ok(method)
    }

    /// `method`, or a quick exact one if neither a method nor an option was given.
    pub(super) fn or_automatic(&self, method: Method) -> Method {
        let asked = self.method.is_some() || self.slices.is_given() || self.chosen.is_any();
        match asked {
            true => method,
            false => Method::Automatic,
        }
    }
}
