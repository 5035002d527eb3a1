//! The argument for the encoding of colours in pictures.

use clap::Args;
use onionskin::Encoding;

#[derive(Args)]
pub(super) struct EncodingOption {
    /// Encode PNGs for display (sRGB) instead of storing linear values
    #[arg(long)]
    srgb: bool,
}

impl EncodingOption {
    pub(super) fn encoding(&self) -> Encoding {
        if self.srgb {
            Encoding::Srgb
        } else {
            Encoding::Linear
        }
    }
}
