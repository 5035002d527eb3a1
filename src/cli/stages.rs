//! Where the time of a whole command goes, from its start to its result.

use std::fmt;
use std::time::{Duration, Instant};

use onionskin::Frame;

/// The stages that are done, in milliseconds.
pub(super) struct Stages {
    /// When the last stage was done.
    last: Instant,
    done: Vec<(&'static str, f64)>,
}

impl Stages {
    /// No stage yet. The first one begins.
    pub(super) fn begin() -> Self {
        Self {
            last: Instant::now(),
            done: Vec::new(),
        }
    }

    /// The stage that began with the end of the one before is done.
    pub(super) fn done(&mut self, stage: &'static str) {
        let now = Instant::now();
        self.done.push((stage, milliseconds(now - self.last)));
        self.last = now;
    }

    /// The stages of a frame are done, whose shaders took so long to compile. What was rendered besides is in no stage.
    pub(super) fn frame_done(&mut self, frame: &Frame, compiling: f64) {
        self.done.extend([
            ("sorting, upload, maps", frame.times.set_up),
            ("compiling shaders", compiling),
            ("drawing", frame.stats.ms - compiling),
            ("counting, reading back", frame.times.read_back),
        ]);
        self.last = Instant::now();
    }
}

fn milliseconds(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

impl fmt::Display for Stages {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (stage, ms) in &self.done {
            writeln!(f, "{stage:<24} {ms:>9.1} ms")?;
        }
        let whole: f64 = self.done.iter().map(|(_, ms)| ms).sum();
        write!(f, "{:<24} {whole:>9.1} ms", "together")
    }
}
