//! Horizontal bands: the image is rendered in parts, so that the fragment lists fit into the memory.
//!
//! "Nothing lost" begins here: list memory is sized from an exact count of every pixel's fragments.

use super::options::{ABufferOptions, Fill, Manager};
use crate::error::{Error, Result};
use crate::gl::GlMachine;

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
pub struct Room {
    /// The bytes of all lists of a band together with `beside`. An image with a single row that needs more is refused.
    pub bytes: u64,
    /// The bytes that do not depend on the band: the base offsets of the whole image's pixels, or the pool's counter.
    pub beside: u64,
    /// The most records of a band, which are all in one buffer. As for `bytes`, more are refused.
    pub records: u64,
    /// The most bytes of a band with more than one row.
    pub quick: u64,
}

impl Room {
    /// The bytes beside the lists of an image of so many pixels. An automatic fill counts as an ordered one.
    pub fn beside(options: &ABufferOptions, pixels: u64) -> u64 {
        match (options.manager, options.fill) {
            (Manager::Ffb, _) => 0,
            (Manager::Ppll, Fill::Atomics) => 16,
            (Manager::Dfb | Manager::Ppll, _) => GlMachine::scan_bytes(pixels),
        }
    }

    /// The bytes of bands that a rasteriser on the CPU renders quickly.
    ///
    /// Llvmpipe bins all triangles of a band, then draws tile by tile; with lists of 8 MiB, the part that a tile needs
    /// stays in a core's cache. On 64 quads that took three quarters of the time that 128 MiB took. But every band
    /// processes the whole geometry again. With 128 fragments per triangle that is well worth it, and with fewer
    /// fragments the bands are larger.
    pub fn quick(renderer: &str, triangles: u64, record_bytes: u64) -> u64 {
        const CACHED: u64 = 8 << 20;
        const FRAGMENTS_PER_TRIANGLE: u64 = 128;
        match renderer.contains("llvmpipe") {
            true => CACHED.max(FRAGMENTS_PER_TRIANGLE * triangles * record_bytes),
            false => u64::MAX,
        }
    }
}

/// Cuts an image into as few bands as possible. `counts` are the pixels' complexities, row by row from the bottom.
///
/// # Errors
/// If a single row does not fit.
pub fn bands(
    counts: &[u32],
    width: u32,
    options: &ABufferOptions,
    room: Room,
) -> Result<Vec<Band>> {
    // Without a fragment, nothing is allocated.
    let fits = |band: &Band| {
        band.fragments == 0
            || band.bytes(options, width).saturating_add(room.beside) <= room.bytes
                && band.records(options.manager, width) <= room.records
    };
    let is_quick = |band: &Band| band.bytes(options, width) <= room.quick;
    let mut bands: Vec<Band> = Vec::new();
    for (row, counts) in counts.chunks_exact(width as usize).enumerate() {
        let row = Band {
            first_row: row as u32,
            rows: 1,
            layers: deepest(counts),
            fragments: counts.iter().copied().map(u64::from).sum(),
        };
        if !fits(&row) {
            return Err(too_large(&row, width, options, room));
        }
        match bands.last_mut() {
            Some(band) if fits(&band.with(row)) && is_quick(&band.with(row)) => {
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

fn too_large(row: &Band, width: u32, options: &ABufferOptions, room: Room) -> Error {
    let what = format!(
        "the fragment lists of one row of {width} pixels need {} records of {} bytes, {} bytes in all ({} fragments, {} \
         in the deepest pixel), and {} bytes beside them for the whole image; there is room for {} records and {} \
         bytes",
        row.records(options.manager, width),
        options.record_bytes(),
        row.bytes(options, width),
        row.fragments,
        row.layers,
        room.beside,
        room.records,
        room.bytes,
    );
    let remedy = match options.manager {
        Manager::Dfb | Manager::Ppll if room.beside > room.bytes / 2 => {
            "give it a larger budget, or use ffb, which needs nothing beside the lists"
        }
        Manager::Ffb => {
            "give it a larger budget, or use dfb, which needs room only for what is there"
        }
        Manager::Dfb | Manager::Ppll => "give it a larger budget, or render a smaller image",
    };
    Error::usage(what, remedy)
}

#[cfg(test)]
mod tests {
    use super::*;

    const NO_LIMIT: Room = Room {
        bytes: u64::MAX,
        beside: 0,
        records: u64::MAX,
        quick: u64::MAX,
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
        let mut state = 1_u32;
        let mut random = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            state >> 16
        };
        for manager in [Manager::Ffb, Manager::Dfb, Manager::Ppll] {
            let options = options(manager);
            for _ in 0..200 {
                let (width, rows) = (1 + random() % 7, 1 + random() % 9);
                let counts: Vec<u32> = (0..width * rows).map(|_| random() % 5).collect();
                let room = Room {
                    bytes: 700 + u64::from(random() % 2000),
                    beside: u64::from(random() % 500),
                    ..NO_LIMIT
                };
                let Ok(bands) = bands(&counts, width, &options, room) else {
                    let row = 4 * u64::from(width) * options.record_bytes() + room.beside;
                    assert!(row > room.bytes, "{manager:?} {width} {room:?}: refused");
                    continue;
                };
                let mut next = 0;
                for band in &bands {
                    assert_eq!(band.first_row, next);
                    assert!(
                        band.fragments == 0
                            || band.bytes(&options, width) + room.beside <= room.bytes
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
                    assert!(longer.bytes(&options, width) + room.beside > room.bytes);
                }
            }
        }
    }

    #[test]
    fn a_row_is_not_refused_for_being_slow() {
        let room = Room {
            quick: 300,
            ..NO_LIMIT
        };
        let counts = [0, 9, 9, 9, 0, 1, 1, 1];
        let bands = bands(&counts, 2, &options(Manager::Ffb), room).unwrap();
        let rows: Vec<_> = bands.iter().map(|band| band.rows).collect();
        assert_eq!(rows, [1, 1, 2]);
    }

    #[test]
    fn few_triangles_come_in_many_bands_and_many_in_few() {
        assert_eq!(Room::quick("llvmpipe (LLVM 15)", 128, 16), 8 << 20);
        assert_eq!(Room::quick("llvmpipe (LLVM 15)", 100_000, 16), 204_800_000);
        assert_eq!(Room::quick("a GPU", 128, 16), u64::MAX);
    }

    #[test]
    fn a_row_that_does_not_fit_is_refused_with_the_numbers() {
        let room = Room {
            bytes: 100,
            ..NO_LIMIT
        };
        let refused = bands(&[0, 9], 2, &options(Manager::Ffb), room).unwrap_err();
        let text = refused.to_string();
        for part in ["288 bytes", "9 in the deepest pixel", "100 bytes", "dfb"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }

    #[test]
    fn an_image_without_fragments_fits_everywhere() {
        let nowhere = Room {
            bytes: 1,
            beside: 4080,
            records: 0,
            quick: 1,
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
        let room = Room {
            bytes: 3000,
            beside: Room::beside(&dynamic, 1000),
            ..NO_LIMIT
        };
        let text = bands(&[0, 9], 2, &dynamic, room).unwrap_err().to_string();
        // 1000 offsets, 16 sums of 64, and the sum of all in what a buffer has at least.
        for part in ["4080 bytes beside", "3000 bytes", "ffb"] {
            assert!(text.contains(part), "{part}: {text}");
        }
    }
}
