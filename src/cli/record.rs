//! What `render --json` and `compare --json` say of a frame.

use onionskin::image::Comparison;
use onionskin::methods::Stats;
use serde::Serialize;

/// One result. The names are part of the command line's face.
#[derive(Serialize)]
pub(super) struct Record<'a> {
    scene: &'a str,
    method: &'a str,
    iterations: u32,
    geometry_passes: u64,
    layers: Option<u32>,
    fragments: u64,
    lost: Option<u64>,
    stopped: String,
    depth_peeling: String,
    bytes: u64,
    ms: f64,
    max_error: f64,
    rms_error: f64,
}

impl<'a> Record<'a> {
    pub(super) fn new(scene: &'a str, stats: &'a Stats, error: &Comparison) -> Self {
        Self {
            scene,
            method: &stats.method,
            iterations: stats.iterations,
            geometry_passes: stats.geometry_passes,
            layers: stats.layers,
            fragments: stats.fragments,
            lost: stats.lost,
            stopped: stats.stopped_text(),
            depth_peeling: stats.peeling.to_string(),
            bytes: stats.bytes,
            ms: stats.ms,
            max_error: error.max,
            rms_error: error.rms,
        }
    }
}
