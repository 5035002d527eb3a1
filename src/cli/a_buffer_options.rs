//! Arguments that choose what can be chosen about an A-buffer.

use clap::{Args, ValueEnum};
use onionskin::methods::{ABufferOptions, Fill, Keep, RecordColor, Sort};
use onionskin::{Method, Result};

const A_BUFFERS: &str = "Options of ffb, dfb and ppll";

/// What can be chosen about an A-buffer.
#[derive(Args)]
pub(super) struct ABufferArguments {
    /// How many fragments the local array has room for: 8, 16, 32 ... 256; what a static one has no room for is lost, and
    /// counted [default: 64]
    #[arg(long, value_name = "N", help_heading = A_BUFFERS)]
    array: Option<u32>,
    /// Which fragments a local array keeps that has no room for all, where nothing peels the rest [default: first, as the
    /// paper leaves it]
    #[arg(long, value_enum, help_heading = A_BUFFERS)]
    keep: Option<KeepArgument>,
    /// How many fragments ppDP peels at a time, 1 to 64 [default: 8]
    #[arg(long, value_name = "N", help_heading = A_BUFFERS)]
    peel: Option<u32>,
    /// End a ray when less light than this comes through; the paper has 0.02 [default: 0, which is exact]
    #[arg(long, value_name = "0..1", help_heading = A_BUFFERS)]
    termination: Option<f32>,
    /// The most MiB that fragment lists may take; what does not fit is rendered in horizontal bands. Without it, as many
    /// as are quick: on llvmpipe 8, more for many triangles
    #[arg(long, value_name = "MIB", help_heading = A_BUFFERS)]
    budget: Option<u64>,
    /// How lists are filled [default: ordered where the driver has it]
    #[arg(long, value_enum, help_heading = A_BUFFERS)]
    fill: Option<FillArgument>,
    /// How local arrays are sorted; the result is the same [default: what is quicker for the scene]
    #[arg(long, value_enum, help_heading = A_BUFFERS)]
    array_sort: Option<SortArgument>,
    /// How fragment records keep colours [default: half]
    #[arg(long, value_enum, help_heading = A_BUFFERS)]
    record_color: Option<RecordColorArgument>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum KeepArgument {
    /// The first of the list: with ffb and dfb those submitted first, with ppll those submitted last
    First,
    /// The nearest; the image is then that of the nearest N
    Nearest,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum FillArgument {
    /// Image atomics, as the paper has it
    Atomics,
    /// Framebuffer fetch: a pixel's fragments take their turns
    Ordered,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum SortArgument {
    /// Insertion sort, as the paper has it
    Insertion,
    /// A network of comparators
    Network,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum RecordColorArgument {
    /// Four 16-bit floats, as the paper has it
    Half,
    /// Four 32-bit floats
    Float,
}

impl ABufferArguments {
    /// Whether any is.
    pub(super) fn are_given(&self) -> bool {
        self.array.is_some()
            || self.keep.is_some()
            || self.peel.is_some()
            || self.termination.is_some()
            || self.budget.is_some()
            || self.fill.is_some()
            || self.array_sort.is_some()
            || self.record_color.is_some()
    }

    /// The method with its options.
    ///
    /// # Errors
    /// If a number is out of its range.
    pub(super) fn method(&self, defaults: ABufferOptions, as_printed: bool) -> Result<Method> {
        let options = ABufferOptions {
            array: self.array.unwrap_or(defaults.array),
            keep: match self.keep {
                None => defaults.keep,
                Some(KeepArgument::First) => Keep::First,
                Some(KeepArgument::Nearest) => Keep::Nearest,
            },
            peel: self.peel.unwrap_or(defaults.peel),
            termination: self.termination.unwrap_or(defaults.termination),
            budget: self.budget.map(|mib| mib.saturating_mul(1 << 20)),
            fill: match self.fill {
                None => defaults.fill,
                Some(FillArgument::Atomics) => Fill::Atomics,
                Some(FillArgument::Ordered) => Fill::Ordered,
            },
            sort: match self.array_sort {
                None => defaults.sort,
                Some(SortArgument::Insertion) => Sort::Insertion,
                Some(SortArgument::Network) => Sort::Network,
            },
            color: match self.record_color {
                None => defaults.color,
                Some(RecordColorArgument::Half) => RecordColor::Half,
                Some(RecordColorArgument::Float) => RecordColor::Float,
            },
            as_printed,
            ..defaults
        };
        options.check()?;
        Ok(Method::ABuffer(options))
    }
}
