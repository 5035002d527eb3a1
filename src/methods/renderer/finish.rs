//! After the drawing: reading the image back, and counting the fragments that belong in it.

use std::time::Instant;

use super::super::algorithm::{Algorithm, Composited, Drawn};
use super::super::frame::{Frame, Layer, Times};
use super::super::proxies::proxies;
use super::super::stats::Stats;
use super::super::technique::Technique;
use super::{Renderer, Shown, milliseconds};
use crate::error::Result;
use crate::gl::Context;
use crate::image::Image;
use crate::papers::stage;
use crate::scene::Scene;
use crate::steps::{Machine, Map, Variables, run};

impl Renderer<'_> {
    /// The frame of what was drawn last. `times` are the milliseconds of setting up and of drawing.
    pub(super) fn finish(
        &mut self,
        shown: &Shown<'_>,
        method: &dyn Technique,
        algorithm: &mut dyn Algorithm,
        mut drawn: Drawn,
        [set_up, ms]: [f64; 2],
    ) -> Result<Frame> {
        let begun = Instant::now();
        self.machine
            .save_and_restore(|machine| algorithm.account(machine, &mut drawn))?;
        let counts = self.machine.counts();
        let image = match drawn.image {
            Some(image) => image,
            None => self.image(stage::IMAGE_COLOR)?,
        };
        let layers = match drawn.keeps_layers {
            true => self.layers(drawn.layers.unwrap_or(0))?,
            false => Vec::new(),
        };
        let fragments = self.count_fragments(&shown.scene)?;
        let lost = match drawn.composited {
            Composited::All => Some(0),
            Composited::Some(composited) => Some(fragments.saturating_sub(composited)),
            Composited::Lost(left) => Some(left),
            Composited::Unknown => None,
        };
        // Without this check, parts for which a driver had too little memory would only be missing in the image.
        let method = method.entry().name;
        self.machine
            .expect_no_error(&format!("while {method} rendered the frame"))?;
        let stats = Stats {
            method: method.into(),
            chosen: drawn.chosen,
            iterations: drawn.iterations,
            geometry_passes: counts.geometry_passes,
            triangles: counts.triangles,
            layers: drawn.layers,
            fragments,
            lost,
            merged: drawn
                .unmerged
                .map(|unmerged| fragments.saturating_sub(unmerged)),
            stopped: drawn.stopped,
            peeling: drawn.peeling,
            bytes: counts.bytes,
            slices: shown.slices,
            a_buffer: drawn.a_buffer,
            verified: drawn.verified,
            ms,
        };
        Ok(Frame {
            image,
            layers,
            hanging: drawn.hanging,
            stats,
            times: Times {
                set_up,
                read_back: milliseconds(begun),
            },
            notices: notices(self.machine.context()),
        })
    }

    fn image(&self, map: Map) -> Result<Image> {
        let [width, height] = self.machine.size();
        Ok(Image::from_bottom_up(
            width,
            height,
            &self.machine.read_colors(map)?,
        ))
    }

    fn layers(&self, count: u32) -> Result<Vec<Layer>> {
        let width = self.machine.size()[0] as usize;
        let layer = |number| {
            let color = self.image(Map::numbered("layer", number))?;
            // As printed, the listing saves colours only.
            let depth = self
                .machine
                .read_depths(Map::numbered("layer depth", number))
                .unwrap_or_default();
            Ok(Layer {
                color,
                depth: depth.chunks_exact(width).rev().flatten().copied().collect(),
            })
        };
        (0..count).map(layer).collect()
    }

    /// The number of fragments that belong in the image, for any method: see [`stage::COUNT`]. Leaves the image as it
    /// is.
    fn count_fragments(&mut self, scene: &Scene) -> Result<u64> {
        self.begin(scene)?;
        run(
            &stage::COUNT,
            proxies(scene),
            Variables::new(),
            &mut self.machine,
        )?;
        self.machine.samples(stage::FRAGMENTS)
    }
}

/// Notes about errors of someone else.
fn notices(context: &Context) -> Vec<String> {
    let errors = context.foreign_errors();
    let notice = |error| {
        format!(
            "OpenGL had {error} pending before the frame: it is of a call that was made before, and is taken note of here"
        )
    };
    errors.into_iter().map(notice).collect()
}
