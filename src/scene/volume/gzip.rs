//! Compressed bytes.

use std::io::Read;

use flate2::read::{MultiGzDecoder, ZlibDecoder};

/// Deflate packs at most 1032 bytes into one, so no data can hold more.
const BEST_RATIO: u64 = 1032;

/// Whether so many bytes can be packed into so few.
pub(super) fn can_hold(packed: u64, wanted: u64) -> bool {
    wanted <= packed.saturating_mul(BEST_RATIO)
}

/// Whether these bytes begin as gzip does.
pub(super) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// Unpacks gzip while it is read.
pub(super) fn unpack(packed: &[u8]) -> impl Read + '_ {
    MultiGzDecoder::new(packed)
}

/// Unpacks zlib while it is read.
pub(super) fn unpack_zlib(packed: &[u8]) -> impl Read + '_ {
    ZlibDecoder::new(packed)
}
