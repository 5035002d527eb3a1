//! Depth complexity: the number of fragments of each pixel, and its histogram (Lindholm et al. 2015, section 3.1).

use super::a_buffer::expect_stencil;
use super::algorithm::DrawOrder;
use super::frame::Frame;
use super::proxies::proxies;
use super::renderer::Renderer;
use super::technique::Technique;
use crate::error::Result;
use crate::gl::Format;
use crate::papers::lindholm_2015 as paper;
use crate::papers::stage;
use crate::scene::Scene;
use crate::steps::{Variables, run};
use crate::words::words;

/// The way to count fragments. On llvmpipe the fixed function is over ten times as fast as atomics.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum CountBy {
    /// Additive blending into a 32-bit float: exact up to 2^24.
    #[default]
    Blending,
    /// One atomic counter per pixel, as the paper has it.
    Atomics,
    /// The stencil buffer: 255 means 255 or more.
    Stencil,
    /// One atomic counter per pixel for all geometry, as the paper counts: opaque surfaces, too, and what they hide.
    AllGeometry,
}

words! { CountBy, "way to count",
    Blending "blending" "Additive blending into a 32-bit float",
    Atomics "atomics" "One atomic counter per pixel, as the paper has it",
    Stencil "stencil" "The stencil buffer: 255 means 255 or more",
}

/// The depth complexity image. It has for each pixel the number of transparent fragments before the opaque surfaces,
/// plus the number of fragments of volumes' boxes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Complexity {
    /// Pixels per row.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// The complexities, row by row from the top.
    pub counts: Vec<u32>,
}

/// A bin of a histogram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bin {
    /// The lowest complexity in the bin.
    pub from: u32,
    /// The highest complexity in the bin.
    pub to: u32,
    /// The number of pixels whose complexity falls into the bin.
    pub pixels: u64,
}

impl Complexity {
    /// The highest complexity of all pixels.
    pub fn max(&self) -> u32 {
        self.counts.iter().copied().max().unwrap_or(0)
    }

    /// The number of all fragments.
    pub fn fragments(&self) -> u64 {
        self.counts.iter().map(|&count| u64::from(count)).sum()
    }

    /// The number of pixels with any fragment.
    pub fn covered(&self) -> u64 {
        self.counts.iter().filter(|&&count| count > 0).count() as u64
    }

    /// The part of the image that has any fragment, 0 to 1.
    pub fn coverage(&self) -> f64 {
        self.covered() as f64 / (self.counts.len().max(1)) as f64
    }

    /// The smallest complexity that `part` of the covered pixels do not exceed (nearest rank). `part` is from 0 to 1.
    /// The result is 0 if no pixel is covered.
    pub fn percentile(&self, part: f64) -> u32 {
        let mut covered: Vec<u32> = self.counts.iter().copied().filter(|&c| c > 0).collect();
        covered.sort_unstable();
        let rank = (part.clamp(0.0, 1.0) * covered.len() as f64).ceil() as usize;
        covered.get(rank.max(1) - 1).copied().unwrap_or(0)
    }

    /// The part of the covered pixels with a complexity of at most `limit`, 0 to 1. It is 1 if no pixel is covered.
    pub fn part_up_to(&self, limit: u32) -> f64 {
        let within = self.counts.iter().filter(|&&c| c > 0 && c <= limit).count() as f64;
        match self.covered() {
            0 => 1.0,
            covered => within / covered as f64,
        }
    }

    /// The part of the image with a complexity of at most `limit`, 0 to 1: the paper's "majority of all pixels", which
    /// counts empty pixels, too.
    pub fn part_of_image_up_to(&self, limit: u32) -> f64 {
        let within = self.counts.iter().filter(|&&count| count <= limit).count();
        within as f64 / self.counts.len().max(1) as f64
    }

    /// The depth complexity histogram. Bin `k` holds the complexities from `k * bin` to `(k + 1) * bin - 1`, and the
    /// last bin holds the maximum. If `bin` is 1, there is a bin for every complexity. 0 is taken as 1.
    pub fn histogram(&self, bin: u32) -> Vec<Bin> {
        let bin = bin.max(1);
        let mut bins: Vec<Bin> = (0..=self.max() / bin)
            .map(|k| Bin {
                from: k * bin,
                to: k * bin + (bin - 1),
                pixels: 0,
            })
            .collect();
        for count in &self.counts {
            bins[(count / bin) as usize].pixels += 1;
        }
        bins
    }
}

impl Renderer<'_> {
    /// Counts every pixel's transparent fragments.
    ///
    /// # Errors
    /// If the driver fails.
    pub fn complexity(&mut self, scene: &Scene, by: CountBy) -> Result<Complexity> {
        let _visit = self.machine.context().visit()?;
        self.set_up(scene, &DrawOrder::Submission)?;
        self.count(scene, by)
    }

    /// Renders a frame, and counts every pixel's transparent fragments: what [`render`](Self::render) and
    /// [`complexity`](Self::complexity) answer, but the scene is uploaded only once.
    ///
    /// # Errors
    /// What the method or the driver cannot do.
    pub fn render_and_count(
        &mut self,
        scene: &Scene,
        method: &dyn Technique,
        by: CountBy,
    ) -> Result<(Frame, Complexity)> {
        let frame = self.render(scene, method)?;
        let complexity = self.count_after(&frame, scene, by)?;
        Ok((frame, complexity))
    }

    /// Counts after a frame of the scene.
    pub(super) fn count_after(
        &mut self,
        frame: &Frame,
        scene: &Scene,
        by: CountBy,
    ) -> Result<Complexity> {
        // What was drawn as slices is counted as volumes.
        if frame.stats.slices.is_some() {
            return self.complexity(scene, by);
        }
        let _visit = self.machine.context().visit()?;
        // The frame's planes may be others than the camera's own.
        self.machine.look(scene);
        self.allocate_stage()?;
        self.count(scene, by)
    }

    /// The scene is uploaded.
    fn count(&mut self, scene: &Scene, by: CountBy) -> Result<Complexity> {
        self.begin(scene)?;
        let machine = &mut self.machine;
        run(&stage::OPAQUE_FIRST, &[], Variables::new(), machine)?;
        if by == CountBy::Stencil {
            expect_stencil(machine)?;
        }
        let (format, listing) = match by {
            CountBy::Blending => (Format::R32F, stage::COUNT_AT_EACH_PIXEL),
            CountBy::Atomics => (Format::R32Ui, paper::COMPLEXITY_IMAGE),
            CountBy::AllGeometry => (Format::R32Ui, paper::COMPLEXITY_OF_ALL),
            CountBy::Stencil => (Format::R32F, paper::COUNT_BY_STENCIL),
        };
        machine.allocate(stage::COMPLEXITY, format)?;
        machine.framebuffer_with(
            stage::COUNTED,
            &[stage::COMPLEXITY],
            Some(stage::OPAQUE_DEPTH),
        )?;
        run(&listing, proxies(scene), Variables::new(), machine)?;
        let map = match by {
            CountBy::Stencil => stage::OPAQUE_DEPTH,
            CountBy::Blending | CountBy::Atomics | CountBy::AllGeometry => stage::COMPLEXITY,
        };
        let [width, height] = machine.size();
        let bottom_up = machine.read_counts(map)?;
        machine.expect_no_error("while layers were counted")?;
        let rows = bottom_up.chunks_exact(width as usize).rev();
        Ok(Complexity {
            width,
            height,
            counts: rows.flatten().copied().collect(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn complexity(counts: &[u32]) -> Complexity {
        Complexity {
            width: counts.len() as u32,
            height: 1,
            counts: counts.to_vec(),
        }
    }

    #[test]
    fn l01_a_histogram_counts_every_pixel_once() {
        let complexity = complexity(&[0, 1, 1, 2, 7, 8, 9]);
        let pixels = |bin| -> Vec<u64> {
            complexity
                .histogram(bin)
                .iter()
                .map(|bin| bin.pixels)
                .collect()
        };
        assert_eq!(pixels(1), [1, 2, 1, 0, 0, 0, 0, 1, 1, 1]);
        assert_eq!(pixels(4), [4, 1, 2]);
        assert_eq!(pixels(100), [7]);
        let last = complexity.histogram(4)[2];
        assert_eq!((last.from, last.to), (8, 11));
    }

    #[test]
    fn percentiles_are_exact_and_of_covered_pixels() {
        let counts: Vec<u32> = (0..=100).collect();
        let complexity = complexity(&counts);
        let at = |part| complexity.percentile(part);
        assert_eq!(
            [at(0.0), at(0.01), at(0.5), at(0.995), at(1.0)],
            [1, 1, 50, 100, 100]
        );
        assert_eq!(complexity.part_up_to(25), 0.25);
        assert_eq!((complexity.covered(), complexity.max()), (100, 100));
    }

    #[test]
    fn an_empty_image_has_a_histogram_too() {
        let complexity = complexity(&[0, 0]);
        assert_eq!(complexity.percentile(0.5), 0);
        assert_eq!(complexity.part_up_to(8), 1.0);
        assert_eq!(complexity.histogram(1)[0].pixels, 2);
    }
}
