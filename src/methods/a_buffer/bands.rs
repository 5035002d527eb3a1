//! Horizontal bands: the image is rendered in parts, so that the fragment lists fit into the memory.
//!
//! "Nothing lost" begins here: list memory is sized from an exact count of every pixel's fragments.

use super::options::{ABufferOptions, Fill, Manager};
use crate::error::{Error, Result};
use crate::gl::{GlMachine, Quirks};

/// A band: rows that are rendered together, and the memory of their lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Band {
    /// The first row, from the bottom.
    pub first_row: u32,
    /// The number of rows.
    pub rows: u32,
    /// The complexity of the deepest pixel.
    pub layers: u32,
    /// The number of all fragments.
    pub fragments: u64,
}

impl Band {
    /// The number of records for which the lists have room.
    pub fn records(&self, manager: Manager, width: u32) -> u64 {
        match manager {
            Manager::Ffb => u64::from(self.layers) * u64::from(width) * u64::from(self.rows),
            Manager::Dfb | Manager::Ppll => self.fragments,
        }
    }

    /// Bytes of the records and links.
    pub fn bytes(&self, options: &ABufferOptions, width: u32) -> u64 {
        self.records(options.manager, width) * options.record_bytes()
    }

    fn with(self, next: Self) -> Self {
        Self {
            first_row: self.first_row,
            rows: self.rows + next.rows,
            layers: self.layers.max(next.layers),
            fragments: self.fragments + next.fragments,
        }
    }
}

/// The memory that the lists may take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// The most bytes, of a band's lists and of what is `fixed` together. An image with a single row that needs more is
    /// refused.
    pub bytes: u64,
    /// The bytes that no choice of bands changes: the base offsets of the whole image's pixels, or the pool's counter.
    pub fixed: u64,
    /// The most records of a band, which are all in one buffer. As for `bytes`, more are refused.
    pub records: u64,
    /// The bytes that the lists of a band with more than one row do not exceed, because larger bands are slower.
    pub preferred_band: u64,
}

/// The [`fixed`](Budget::fixed) bytes for an image of so many pixels. An automatic fill counts as an ordered one.
pub(super) fn fixed(options: &ABufferOptions, pixels: u64) -> u64 {
    match (options.manager, options.fill) {
        (Manager::Ffb, _) => 0,
        (Manager::Ppll, Fill::Atomics) => 16,
        (Manager::Dfb | Manager::Ppll, _) => GlMachine::scan_bytes(pixels),
    }
}

/// The bytes of a [`preferred_band`](Budget::preferred_band): as many as stay in the driver's cache, if it has one for
/// lists. But every band processes the whole geometry again. With 128 fragments per triangle that is well worth it, and
/// with fewer fragments the bands are larger.
pub(super) fn preferred(quirks: Quirks, triangles: u64, record_bytes: u64) -> u64 {
    const FRAGMENTS_PER_TRIANGLE: u64 = 128;
    let worth_it = FRAGMENTS_PER_TRIANGLE * triangles * record_bytes;
    let cached = quirks.cached_bytes;
    cached.map_or(u64::MAX, |cached| cached.max(worth_it))
}

/// Cuts an image into as few bands as possible. `counts` are the pixels' complexities, row by row from the bottom.
///
/// # Errors
/// If a single row does not fit.
pub fn bands(
    counts: &[u32],
    width: u32,
    options: &ABufferOptions,
    budget: Budget,
) -> Result<Vec<Band>> {
    // Without a fragment, nothing is allocated.
    let fits = |band: &Band| {
        band.fragments == 0
            || band.bytes(options, width).saturating_add(budget.fixed) <= budget.bytes
                && band.records(options.manager, width) <= budget.records
    };
    let is_preferred = |band: &Band| band.bytes(options, width) <= budget.preferred_band;
    let mut bands: Vec<Band> = Vec::new();
    for (row, counts) in counts.chunks_exact(width as usize).enumerate() {
        let row = Band {
            first_row: row as u32,
            rows: 1,
            layers: deepest(counts),
            fragments: counts.iter().copied().map(u64::from).sum(),
        };
        if !fits(&row) {
            return Err(too_large(&row, width, options, budget));
        }
        match bands.last_mut() {
            Some(band) if fits(&band.with(row)) && is_preferred(&band.with(row)) => {
                *band = band.with(row);
            }
            _ => bands.push(row),
        }
    }
    Ok(bands)
}

/// The largest of some complexities.
pub(super) fn deepest(counts: &[u32]) -> u32 {
    // Unlike `max` of an iterator, this compares many at a time.
    counts.iter().copied().fold(0, u32::max)
}

fn too_large(row: &Band, width: u32, options: &ABufferOptions, budget: Budget) -> Error {
    let what = format!(
        "the fragment lists of one row of {width} pixels need {} records of {} bytes, {} bytes in all ({} fragments, {} \
         in the deepest pixel), and {} bytes beside them for the whole image; there is room for {} records and {} \
         bytes",
        row.records(options.manager, width),
        options.record_bytes(),
        row.bytes(options, width),
        row.fragments,
        row.layers,
        budget.fixed,
        budget.records,
        budget.bytes,
    );
    let remedy = match options.manager {
        Manager::Dfb | Manager::Ppll if budget.fixed > budget.bytes / 2 => {
            "give it a larger budget, or use ffb, which needs nothing beside the lists"
        }
        Manager::Ffb => {
            "give it a larger budget, or use dfb, which needs room only for what is there"
        }
        Manager::Dfb | Manager::Ppll => "give it a larger budget, or render a smaller image",
    };
    Error::option("budget", what, remedy)
}

#[cfg(test)]
mod tests {
    use rand::Rng;
    use rand_pcg::Pcg32;

    use super::*;

    const NO_LIMIT: Budget = Budget {
        bytes: u64::MAX,
        fixed: 0,
        records: u64::MAX,
        preferred_band: u64::MAX,
    };

    fn options(manager: Manager) -> ABufferOptions {
        ABufferOptions {
            manager,
            ..ABufferOptions::DEFAULT
        }
    }

    #[test]
    fn without_a_limit_there_is_one_band() {
        let counts = [1, 2, 3, 4, 5, 6];
        let bands = bands(&counts, 2, &options(Manager::Ppll), NO_LIMIT).unwrap();
        let whole = Band {
            first_row: 0,
            rows: 3,
            layers: 6,
            fragments: 21,
        };
        assert_eq!(bands, [whole]);
    }

    #[test]
    fn l08_a_fixed_buffer_takes_records_for_the_deepest_pixel_everywhere() {
        let band = bands(&[0, 0, 0, 7], 2, &options(Manager::Ffb), NO_LIMIT).unwrap()[0];
        assert_eq!(band.bytes(&options(Manager::Ffb), 2), 7 * 4 * 16);
        assert_eq!(band.records(Manager::Dfb, 2), 7);
    }

    /// For every cut of many random images, no row is missing or occurs twice, every band fits, and no band could take
    /// the next row.
    #[test]
    fn bands_fit_and_are_as_few_as_can_be() {
        let mut chance = Pcg32::new(1, 54);
        let mut random = move || chance.next_u32();
        for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
            let options = options(manager);
            for _ in 0..200 {
                let (width, rows) = (1 + random() % 7, 1 + random() % 9);
                let counts: Vec<u32> = (0..width * rows).map(|_| random() % 5).collect();
                let budget = Budget {
                    bytes: 700 + u64::from(random() % 2000),
                    fixed: u64::from(random() % 500),
                    ..NO_LIMIT
                };
                let Ok(bands) = bands(&counts, width, &options, budget) else {
                    let row = 4 * u64::from(width) * options.record_bytes() + budget.fixed;
                    assert!(
                        row > budget.bytes,
                        "{manager:?} {width} {budget:?}: refused"
                    );
                    continue;
                };
                let mut next = 0;
                for band in &bands {
                    assert_eq!(band.first_row, next);
                    assert!(
                        band.fragments == 0
                            || band.bytes(&options, width) + budget.fixed <= budget.bytes
                    );
                    next += band.rows;
                }
                assert_eq!(next, rows);
                let first_row_of = |band: &Band| {
                    let first = (band.first_row * width) as usize;
                    super::bands(
                        &counts[first..first + width as usize],
                        width,
                        &options,
                        NO_LIMIT,
                    )
                    .unwrap()[0]
                };
                for pair in bands.windows(2) {
                    let longer = pair[0].with(first_row_of(&pair[1]));
                    assert!(longer.bytes(&options, width) + budget.fixed > budget.bytes);
                }
            }
        }
    }

    #[test]
    fn a_row_is_not_refused_for_being_slow() {
        let budget = Budget {
            preferred_band: 300,
            ..NO_LIMIT
        };
        let counts = [0, 9, 9, 9, 0, 1, 1, 1];
        let bands = bands(&counts, 2, &options(Manager::Ffb), budget).unwrap();
        let rows: Vec<_> = bands.iter().map(|band| band.rows).collect();
        assert_eq!(rows, [1, 1, 2]);
    }

    #[test]
    fn few_triangles_come_in_many_bands_and_many_in_few() {
        let on_tiles = Quirks {
            cached_bytes: Some(8 << 20),
            ..Quirks::default()
        };
        assert_eq!(preferred(on_tiles, 128, 16), 8 << 20);
        assert_eq!(preferred(on_tiles, 100_000, 16), 204_800_000);
        assert_eq!(preferred(Quirks::default(), 128, 16), u64::MAX);
    }

    #[test]
    fn a_row_that_does_not_fit_is_refused_with_the_numbers() {
        let budget = Budget {
            bytes: 100,
            ..NO_LIMIT
        };
        let refused = bands(&[0, 9], 2, &options(Manager::Ffb), budget).unwrap_err();
        let text = refused.to_string();
        for part in ["288 bytes", "9 in the deepest pixel", "100 bytes", "dfb"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn an_image_without_fragments_fits_everywhere() {
        let nowhere = Budget {
            bytes: 1,
            fixed: 4080,
            records: 0,
            preferred_band: 1,
        };
        for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
            assert_eq!(
                bands(&[0; 6], 2, &options(manager), nowhere).unwrap().len(),
                1
            );
        }
    }

    #[test]
    fn base_offsets_that_take_the_budget_are_named() {
        let dynamic = options(Manager::Dfb);
        let budget = Budget {
            bytes: 3000,
            fixed: fixed(&dynamic, 1000),
            ..NO_LIMIT
        };
        let text = bands(&[0, 9], 2, &dynamic, budget).unwrap_err().to_string();
        // 1000 offsets, 16 sums of 64, and the sum of all in what a buffer has at least.
        for part in ["4080 bytes beside", "3000 bytes", "ffb"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}
