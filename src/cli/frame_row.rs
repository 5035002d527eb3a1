//! The row that `animate` writes for a frame, besides its picture.

use onionskin::{Complexity, Stats};

/// A row of the table. Everything but `ms` is a count, and is the same in every run.
pub(super) struct FrameRow(Vec<(&'static str, String)>);

impl FrameRow {
    /// The columns in order. A value that the method does not count is left empty.
    pub(super) fn new(frame: u32, stats: &Stats, complexity: &Complexity) -> Self {
        let lists = stats.a_buffer.as_ref();
        let optional = |value: Option<u64>| value.map_or_else(String::new, |v| v.to_string());
        Self(vec![
            ("frame", frame.to_string()),
            ("ms", format!("{:.3}", stats.ms)),
            ("covered", complexity.covered().to_string()),
            ("fragments", complexity.fragments().to_string()),
            ("max", complexity.max().to_string()),
            ("percentile_50", complexity.percentile(0.5).to_string()),
            ("percentile_90", complexity.percentile(0.9).to_string()),
            ("percentile_99", complexity.percentile(0.99).to_string()),
            ("iterations", stats.iterations.to_string()),
            ("geometry_passes", stats.geometry_passes.to_string()),
            ("lost", optional(stats.lost)),
            ("bytes", stats.bytes.to_string()),
            ("bands", optional(lists.map(|l| l.bands.into()))),
            ("list_bytes", optional(lists.map(|l| l.list_bytes))),
            ("records_read", optional(lists.map(|l| l.records_read))),
            ("subpasses", optional(lists.map(|l| l.subpasses))),
            (
                "array_slots_reserved",
                optional(lists.map(|l| l.slots_reserved)),
            ),
            ("array_slots_used", optional(lists.map(|l| l.slots_used))),
        ])
    }

    /// A line of names and a line of values.
    pub(super) fn csv(&self) -> String {
        let names: Vec<&str> = self.0.iter().map(|(name, _)| *name).collect();
        let values: Vec<&str> = self.0.iter().map(|(_, value)| value.as_str()).collect();
        format!("{}\n{}\n", names.join(","), values.join(","))
    }
}
