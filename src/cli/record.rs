//! The JSON object of a frame, for `render --json` and `compare --json`.

use onionskin::low_level::methods::{ABufferCounts, VerifiedCounts};
use onionskin::{Comparison, Frame, Result, Stats};
use serde::Serialize;

/// How many frames a time is the median of.
pub(super) const FRAMES: usize = 5;

/// One result. The names are part of the command line's interface.
#[derive(Serialize)]
pub(super) struct Record<'a> {
    scene: &'a str,
    method: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    chosen: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reading: Option<&'a str>,
    iterations: u32,
    geometry_passes: u64,
    triangles: u64,
    layers: Option<u32>,
    fragments: u64,
    lost: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    merged: Option<u64>,
    stopped: String,
    depth_peeling: String,
    bytes: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    slices: Option<u32>,
    #[serde(flatten)]
    a_buffer: Option<Lists>,
    #[serde(flatten)]
    verified: Option<Unproved>,
    ms: f64,
    max_error: f64,
    rms_error: f64,
    hanging_pixels: usize,
    hanging_max_error: f64,
}

/// The difference of a method's image from the exact one. Pixels that depend on a difference of depth that the depth
/// buffer cannot hold are kept apart from real errors.
pub(super) struct Errors {
    pub(super) real: Comparison,
    pub(super) hanging: Comparison,
    pub(super) hanging_pixels: usize,
}

impl Errors {
    pub(super) fn new(frame: &Frame, exact: &Frame) -> Result<Self> {
        let hangs = |pixel: usize| {
            let hanging = exact.hanging.as_ref();
            hanging.is_some_and(|hanging| hanging.drawn[pixel])
        };
        let pixels = exact.image.pixels.len();
        Ok(Self {
            real: Comparison::among(&frame.image, &exact.image, 0.0, |pixel| !hangs(pixel))?,
            hanging: Comparison::among(&frame.image, &exact.image, 0.0, hangs)?,
            hanging_pixels: (0..pixels).filter(|&pixel| hangs(pixel)).count(),
        })
    }
}

/// The values that only an A-buffer has.
#[derive(Serialize)]
struct Lists {
    bands: u32,
    counting_passes: u32,
    list_bytes: u64,
    records_read: u64,
    subpasses: u64,
    most_subpasses: u32,
    array_slots_reserved: u64,
    array_slots_used: u64,
    truncated_pixels: u64,
}

impl Lists {
    fn new(counts: &ABufferCounts) -> Self {
        Self {
            bands: counts.bands,
            counting_passes: counts.counting_passes,
            list_bytes: counts.list_bytes,
            records_read: counts.records_read,
            subpasses: counts.subpasses,
            most_subpasses: counts.most_subpasses,
            array_slots_reserved: counts.slots_reserved,
            array_slots_used: counts.slots_used,
            truncated_pixels: counts.truncated_pixels,
        }
    }
}

/// What only the verified painter has.
#[derive(Serialize)]
struct Unproved {
    marked_pixels: u64,
    list_fragments: u64,
    list_triangles: u64,
    list_bytes: u64,
}

impl Unproved {
    fn new(counts: &VerifiedCounts) -> Self {
        Self {
            marked_pixels: counts.marked_pixels,
            list_fragments: counts.list_fragments,
            list_triangles: counts.list_triangles,
            list_bytes: counts.list_bytes,
        }
    }
}

impl<'a> Record<'a> {
    pub(super) fn new(scene: &'a str, stats: &'a Stats, error: &Errors) -> Self {
        Self {
            scene,
            method: &stats.method,
            chosen: stats.chosen.map(|chosen| chosen.method),
            reading: None,
            iterations: stats.iterations,
            geometry_passes: stats.geometry_passes,
            triangles: stats.triangles,
            layers: stats.layers,
            fragments: stats.fragments,
            lost: stats.lost,
            merged: stats.merged,
            stopped: stats.stopped_text(),
            depth_peeling: stats.peeling.to_string(),
            bytes: stats.bytes,
            slices: stats.slices,
            a_buffer: stats.a_buffer.as_ref().map(Lists::new),
            verified: stats.verified.as_ref().map(Unproved::new),
            ms: stats.ms,
            max_error: error.real.max,
            rms_error: error.real.rms,
            hanging_pixels: error.hanging_pixels,
            hanging_max_error: error.hanging.max,
        }
    }

    /// And how the method's text was read.
    pub(super) fn read(self, reading: Option<&'a str>) -> Self {
        Self { reading, ..self }
    }
}
