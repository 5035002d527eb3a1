//! Depth peeling that draws only the triangles that may have something left to peel, and composites its layers only where
//! they may have pixels.

use super::super::culling::Extents;
use super::super::sorting::TriangleSort;
use crate::error::Result;
use crate::gl::GlMachine;
use crate::papers::stage::{ACCUMULATION, OPAQUE_DEPTH};
use crate::papers::vtk::DEPTH_BUFFERS;
use crate::scene::Scene;
use crate::steps::{Call, CallLine, Machine, Objects, Query};

/// A machine that has its transparent objects drawn without the triangles that lie before the last layer wherever they are
/// seen, or where nothing is left. The listing does not know of it.
pub(super) struct Culled<'m, 'c> {
    machine: &'m mut GlMachine<'c>,
    scene: &'m Scene,
    extents: Extents,
    /// Row by row from the bottom, once there is a layer.
    opaque: Vec<f32>,
    peels: usize,
    /// The pixels of the last layer lie in it, so those of the next one do: x, y, width and height. `None` means anywhere.
    alive: Option<[u32; 4]>,
}

impl<'m, 'c> Culled<'m, 'c> {
    /// Nothing is peeled yet. The scene was uploaded in the order of submission.
    pub(super) fn new(machine: &'m mut GlMachine<'c>, scene: &'m Scene) -> Self {
        let extents = Extents::new(
            scene,
            machine.size(),
            &TriangleSort::Submission.order(scene),
        );
        Self {
            machine,
            scene,
            extents,
            opaque: Vec::new(),
            peels: 0,
            alive: None,
        }
    }

    /// Has every triangle drawn again, and draws over the screen go anywhere.
    pub(super) fn finish(self) -> Result<()> {
        self.machine.set_screen(None);
        self.machine.reorder(self.scene, &[self.extents.all()])
    }

    /// Depth buffer A, which the peel looks up, has the last layer's depth at the layer's pixels and the opaque depth at
    /// others, or 0 at those that are not alive ([`ALIVE`](crate::papers::vtk::ALIVE)). No layer but the first lies at 0.
    fn cull(&mut self) -> Result<()> {
        let mut bound = self.machine.read_depths(DEPTH_BUFFERS[self.peels % 2])?;
        if self.peels == 1 {
            self.opaque = self.machine.read_depths(OPAQUE_DEPTH)?;
        } else {
            let dead = bound.iter_mut().filter(|depth| **depth == 0.0);
            dead.for_each(|depth| *depth = 1.0);
        }
        let width = self.machine.size()[0];
        self.alive = Some(rectangle(&bound, &self.opaque, width as usize));
        let left = self.extents.unfinished(&bound, &self.opaque, width);
        self.machine.reorder(self.scene, &[left])
    }
}

impl Machine for Culled<'_, '_> {
    fn perform(&mut self, call: &Call) -> Result<()> {
        match *call {
            Call::Draw {
                objects: Objects::Transparent,
            } => {
                if self.peels > 0 {
                    self.cull()?;
                }
                self.peels += 1;
            }
            // There a layer goes under those before it.
            Call::BindFramebuffer { framebuffer } => {
                let alive = self.alive.filter(|_| framebuffer == ACCUMULATION);
                self.machine.set_screen(alive);
            }
            _ => {}
        }
        self.machine.perform(call)
    }

    fn samples(&mut self, query: Query) -> Result<u64> {
        self.machine.samples(query)
    }

    fn follow(&mut self, line: &CallLine) {
        self.machine.follow(line);
    }
}

/// The rectangle around the pixels whose bound lies before the opaque depth.
fn rectangle(bound: &[f32], opaque: &[f32], width: usize) -> [u32; 4] {
    let [mut left, mut right, mut low, mut high] = [width, 0, usize::MAX, 0];
    let rows = bound.chunks_exact(width).zip(opaque.chunks_exact(width));
    for (y, (bound, opaque)) in rows.enumerate() {
        let is_open = |x: &usize| bound[*x] < opaque[*x];
        let Some(first) = (0..width).find(is_open) else {
            continue;
        };
        let last = (first..width).rfind(is_open).unwrap_or(first);
        (left, right) = (left.min(first), right.max(last + 1));
        (low, high) = (low.min(y), y + 1);
    }
    if high == 0 {
        return [0; 4];
    }
    [left, low, right - left, high - low].map(|side| side as u32)
}

#[cfg(test)]
mod tests {
    use super::rectangle;

    #[test]
    fn the_rectangle_has_every_pixel_that_is_open_and_no_row_or_column_more() {
        let opaque = [1.0; 12];
        let open = |pixels: &[usize]| {
            let mut bound = [1.0; 12];
            pixels.iter().for_each(|&pixel| bound[pixel] = 0.5);
            rectangle(&bound, &opaque, 4)
        };
        assert_eq!(open(&[]), [0, 0, 0, 0]);
        assert_eq!(open(&[0]), [0, 0, 1, 1]);
        assert_eq!(open(&[11]), [3, 2, 1, 1]);
        assert_eq!(open(&[6, 9]), [1, 1, 2, 2]);
        assert_eq!(open(&[1, 3, 8]), [0, 0, 4, 3]);
        // What lies behind the opaque surface, or on it, is not open.
        assert_eq!(rectangle(&[0.5, 0.5], &[0.25, 0.5], 2), [0; 4]);
    }
}
