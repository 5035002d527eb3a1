//! Blending in the order of submission, whose errors depth peeling corrects (Everitt 2001, figure 1b).

use super::algorithm::{Algorithm, Drawn, Setup};
use super::entry::{Entry, Memory, Ties, Volumes};
use super::technique::{Published, Technique};
use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::stage::OPAQUE_FIRST;
use crate::scene::Scene;
use crate::steps;
use crate::steps::{Dialect, Listing, Variables, gl::*, run};

/// Blends each fragment over those before it.
pub(super) const BLEND_IN_ORDER: Listing = Listing {
    title: "Transparent geometry over whatever came before it",
    source: "Everitt 2001, Introduction",
    dialect: Dialect::Calls,
    steps: steps! {
        run OPAQUE_FIRST;
        glDepthMask(false);
        glEnable(BLEND);
        glBlendFuncSeparate(SRC_ALPHA, ONE_MINUS_SRC_ALPHA, ONE, ONE_MINUS_SRC_ALPHA);
        drawTransparentObjects();
        glDisable(BLEND);
        glDepthMask(true);
    },
};

/// Blending in the order of submission, which has no options.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blend;

impl Algorithm for Blend {
    fn prepare(&mut self, _: &mut GlMachine<'_>, _: &Scene) -> Result<()> {
        Ok(())
    }

    fn draw(&mut self, machine: &mut GlMachine<'_>, _: &Scene) -> Result<Drawn> {
        run(&BLEND_IN_ORDER, &[], Variables::new(), machine)?;
        Ok(Drawn {
            iterations: 1,
            ..Drawn::default()
        })
    }
}

const ENTRY: Entry = Entry {
    name: "blend",
    source: "Everitt 2001, figure 1b",
    exact: false,
    exactness: "no",
    ties: Ties::OverEarlier,
    memory: Memory::Pixels,
    volumes: Volumes::Refused,
    keeps: None,
    needs: &[],
};

impl Technique for Blend {
    fn entry(&self) -> &'static Entry {
        &ENTRY
    }

    fn algorithm(&self, _: &Setup) -> Box<dyn Algorithm> {
        Box::new(Self)
    }
}

impl Published for Blend {}
