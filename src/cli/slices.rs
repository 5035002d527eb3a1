//! The argument for the number of slices as which volumes are drawn.

use std::fmt;

use clap::Args;
use onionskin::low_level::methods::{MOST_SLICES, Volumes};
use onionskin::{Error, Method, Renderer, Result, Scene};

#[derive(Args)]
pub(super) struct Slices {
    /// Draw volumes as N slices across the view, for methods that know only surfaces; hybrid-layer-peeling does so by
    /// default, with 256
    #[arg(long, value_name = "N", value_parser = count, help_heading = "Options of methods for surfaces")]
    slices: Option<u32>,
}

impl Slices {
    pub(super) fn is_given(&self) -> bool {
        self.slices.is_some()
    }

    /// Checks that there is a volume to be sliced.
    ///
    /// # Errors
    /// If the argument is given, and there are no volumes.
    pub(super) fn check_scene(&self, scene: &Scene) -> Result<()> {
        if self.is_given() && scene.volumes.is_empty() {
            return Err(Error::usage(
                format!("--slices is given, and {} has no volumes", scene.name),
                "leave it out, or give a scene with a [[volume]]",
            ));
        }
        Ok(())
    }

    /// The renderer, set to draw volumes as so many slices.
    pub(super) fn apply_to<'c>(&self, renderer: Renderer<'c>) -> Result<Renderer<'c>> {
        match self.slices {
            Some(count) => renderer.with_slices(count),
            None => Ok(renderer),
        }
    }

    /// Checks that the method draws slices.
    ///
    /// # Errors
    /// If the argument is given, and the method draws no slices.
    pub(super) fn check(&self, method: &Method) -> Result<()> {
        if !self.is_given() || method.entry().volumes.take_slices() {
            return Ok(());
        }
        Err(if method.entry().volumes == Volumes::Rays {
            Error::usage(
                format!("{method} casts rays through volumes, and draws no slices"),
                "leave out --slices, or choose hybrid-layer-peeling",
            )
        } else {
            Error::usage(
                format!("{method} would draw slices in the order of submission, over one another"),
                "leave out --slices, or choose hybrid-layer-peeling",
            )
        })
    }
}

impl fmt::Display for Slices {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.slices {
            Some(count) => write!(f, "{count}"),
            None => f.write_str("as the method has them"),
        }
    }
}

fn count(text: &str) -> Result<u32, Error> {
    let number = text.parse().ok();
    let among = number.filter(|count| (1..=MOST_SLICES).contains(count));
    among.ok_or_else(|| {
        Error::usage(
            format!("'{text}' is no number of slices"),
            format!("write a whole number from 1 to {MOST_SLICES}"),
        )
    })
}
