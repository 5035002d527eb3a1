//! The statistics of a frame.

use std::fmt;

use crate::steps::Reason;

/// The statistics of a frame. Everything but `ms` is a count, and is the same in every run.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Stats {
    /// The method's name.
    pub method: String,
    /// The method that drew the frame, and why, or `None` if it was not chosen automatically.
    pub chosen: Option<Chosen>,
    /// The rounds of the method's loop, including the last one even if it found nothing. It is 1 without a loop.
    pub iterations: u32,
    /// How often the transparent geometry was drawn.
    pub geometry_passes: u64,
    /// The triangles of all these passes together: the work of the method on geometry.
    pub triangles: u64,
    /// The layers in the image, or `None` if the method does not make layers.
    pub layers: Option<u32>,
    /// The transparent fragments before the opaque depth, which belong in the image.
    pub fragments: u64,
    /// The number of them that are not in the image (dropped ties, peels not made), or `None` if the method cannot
    /// tell.
    pub lost: Option<u64>,
    /// The number of fragments that are in the image, but were merged with others, so that what lies between them may be in
    /// the wrong order. `None` if the method merges none, or does not count them.
    pub merged: Option<u64>,
    /// The reason for which the loop ended, or `None` if the method has no loop.
    pub stopped: Option<Reason>,
    /// Whether depth peeling was used, and if not, why.
    pub peeling: Peeling,
    /// The bytes of the maps that the method has allocated.
    pub bytes: u64,
    /// How many slices the scene's volumes were drawn as, or `None` if they were not drawn as slices.
    pub slices: Option<u32>,
    /// The costs of the fragment lists, or `None` if the method has none.
    pub a_buffer: Option<ABufferCounts>,
    /// The proof of the verified painter, or `None` with other methods.
    pub verified: Option<VerifiedCounts>,
    /// The time of the frame in milliseconds, without readback and files.
    ///
    /// After [`measure`](super::Renderer::measure) it is the median of several frames. After
    /// [`render`](super::Renderer::render) it is that of the single frame, including the compilation of its shaders.
    pub ms: f64,
}

/// The method that was chosen for a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Chosen {
    /// The method's name.
    pub method: &'static str,
    /// Why it is this one, as the end of a sentence.
    pub why: &'static str,
}

/// The costs of an A-buffer. They do not depend on the machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct ABufferCounts {
    /// The number of bands in which the image was rendered.
    pub bands: u32,
    /// Geometry passes that only counted, before the lists were made. Every band is one more, which fills them.
    pub counting_passes: u32,
    /// Bytes of the lists: records, links, base offsets, for the largest band.
    pub list_bytes: u64,
    /// Records read from the lists.
    pub records_read: u64,
    /// Subpasses of all pixels, which is how often a list was walked.
    pub subpasses: u64,
    /// The most subpasses of a pixel.
    pub most_subpasses: u32,
    /// Elements of Local Arrays that were reserved, of all pixels (figure 5).
    pub slots_reserved: u64,
    /// Elements that held a fragment at some time. The others are figure 5's grey areas.
    pub slots_used: u64,
    /// Pixels that lost fragments.
    pub truncated_pixels: u64,
    /// The number of times that ppAO's segments have resolved a pixel, or 0 without ppAO.
    pub resolved: u64,
}

/// What the verified painter could not prove, and so put into lists.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct VerifiedCounts {
    /// The pixels whose fragments were not drawn in strictly increasing depths.
    pub marked_pixels: u64,
    /// The fragments of these pixels.
    pub list_fragments: u64,
    /// The triangles that were drawn into the lists.
    pub list_triangles: u64,
    /// The bytes of the lists, which have room for somewhat more than these fragments.
    pub list_bytes: u64,
}

/// The answer to VTK's question "was depth peeling actually used", with its reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Peeling {
    /// It was.
    Used,
    /// There was nothing to peel.
    NothingTransparent,
    /// It is switched off, as it is in VTK at first.
    SwitchedOff,
    /// The window was made without alpha bit planes, as VTK makes it at first.
    NoAlphaBits,
    /// The method is another one.
    #[default]
    OtherMethod,
}

impl fmt::Display for Peeling {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Used => "used",
            Self::NothingTransparent => "not used: nothing is transparent",
            Self::SwitchedOff => "not used: it is switched off",
            Self::NoAlphaBits => "not used: the window has no alpha bit planes",
            Self::OtherMethod => "not used: another method",
        })
    }
}

impl Stats {
    /// Why the loop ended, for people and for JSON.
    pub fn stopped_text(&self) -> String {
        self.stopped
            .map_or_else(|| "done".into(), |reason| reason.to_string())
    }
}

impl fmt::Display for Stats {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut line = |name: &str, value: &dyn fmt::Display| writeln!(f, "{name:<16} {value}");
        line("method", &self.method)?;
        if let Some(Chosen { method, why }) = self.chosen {
            line("chosen", &format_args!("{method}: {why}"))?;
        }
        line("iterations", &self.iterations)?;
        line("geometry passes", &self.geometry_passes)?;
        line("triangles", &self.triangles)?;
        if let Some(layers) = self.layers {
            line("layers", &layers)?;
        }
        line("stopped", &self.stopped_text())?;
        line("depth peeling", &self.peeling)?;
        line("fragments", &self.fragments)?;
        match self.lost {
            Some(lost) => line("lost", &lost)?,
            None => line("lost", &"not counted")?,
        }
        if let Some(merged) = self.merged {
            line("merged", &merged)?;
        }
        line(
            "memory",
            &format_args!("{:.1} MiB", self.bytes as f64 / f64::from(1 << 20)),
        )?;
        if let Some(slices) = self.slices {
            line("slices", &slices)?;
        }
        if let Some(counts) = &self.a_buffer {
            line("bands", &counts.bands)?;
            line("counting passes", &counts.counting_passes)?;
            line(
                "lists",
                &format_args!("{:.1} MiB", counts.list_bytes as f64 / f64::from(1 << 20)),
            )?;
            line("records read", &counts.records_read)?;
            line(
                "subpasses",
                &format_args!(
                    "{}, at most {} for a pixel",
                    counts.subpasses, counts.most_subpasses
                ),
            )?;
            line(
                "array slots",
                &format_args!(
                    "{} reserved, {} used",
                    counts.slots_reserved, counts.slots_used
                ),
            )?;
        }
        if let Some(counts) = &self.verified {
            line(
                "not in order",
                &format_args!("{} pixels", counts.marked_pixels),
            )?;
            line(
                "lists",
                &format_args!(
                    "{} fragments of {} triangles, {:.1} MiB",
                    counts.list_fragments,
                    counts.list_triangles,
                    counts.list_bytes as f64 / f64::from(1 << 20)
                ),
            )?;
        }
        write!(f, "{:<16} {:.1} ms", "time", self.ms)
    }
}
