//! Putting the pieces of an image together.

use super::block::Block;
use crate::scene::volume::check::Fault;

/// An image that some pieces have filled.
pub(super) struct Assembly {
    whole: Block,
    samples: Vec<f32>,
    known: Known,
    /// The number of samples that may still come.
    left: usize,
}

/// The samples that have come so far.
enum Known {
    Nothing,
    /// These samples.
    Part(Vec<bool>),
    All,
}

/// How often the pieces may hold the whole extent. Where each cell is a piece of its own, every point is in eight
/// pieces.
const OVERLAP: usize = 8;

impl Assembly {
    pub(super) fn of(whole: Block) -> Self {
        Self {
            whole,
            samples: Vec::new(),
            known: Known::Nothing,
            left: whole.count().saturating_mul(OVERLAP),
        }
    }

    /// Checks that a piece of this size may come. It is called before the piece is read, so that pieces that lie over
    /// one another do not take for ever.
    pub(super) fn expect(&mut self, block: &Block) -> Result<(), Fault> {
        match self.left.checked_sub(block.count()) {
            Some(left) => {
                self.left = left;
                Ok(())
            }
            None => Err((
                format!("the pieces hold the whole extent more than {OVERLAP} times over"),
                "Give each part of the image once.",
            )),
        }
    }

    /// Puts a piece in its place. Where pieces overlap, as pieces of points do at their borders, the later one counts.
    /// Samples outside of the whole extent are left out.
    pub(super) fn add(&mut self, block: Block, samples: Vec<f32>) {
        if block == self.whole {
            self.samples = samples;
            self.known = Known::All;
            return;
        }
        let count = self.whole.count();
        if let Known::Nothing = self.known {
            // Zeros cost no memory until they are overwritten, so only what the pieces really have takes memory.
            self.samples = vec![0.0; count];
            self.known = Known::Part(vec![false; count]);
        }
        self.whole.for_each_common_row(&block, |to, from, length| {
            self.samples[to..to + length].copy_from_slice(&samples[from..from + length]);
            if let Known::Part(known) = &mut self.known {
                known[to..to + length].fill(true);
            }
        });
    }

    /// The whole image.
    ///
    /// # Errors
    /// The number of samples that no piece has.
    pub(super) fn finish(self) -> Result<Vec<f32>, usize> {
        let missing = match &self.known {
            Known::Nothing => self.whole.count(),
            Known::Part(known) => known.iter().filter(|known| !**known).count(),
            Known::All => 0,
        };
        if missing == 0 {
            Ok(self.samples)
        } else {
            Err(missing)
        }
    }
}
