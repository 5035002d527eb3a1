//! Unpacking no more than is needed.

use std::io::Read;

use flate2::read::{MultiGzDecoder, ZlibDecoder};

/// Deflate packs at most 1032 bytes into one; what claims to hold more cannot.
const BEST_RATIO: u64 = 1032;

/// Whether so few packed bytes can hold so many.
pub(super) fn can_hold(packed: usize, wanted: u64) -> bool {
    wanted <= (packed as u64).saturating_mul(BEST_RATIO)
}

/// Unpacks gzip's `wanted` first bytes, or all there are if they are fewer. What does not unpack is said.
pub(super) fn unpack(packed: &[u8], wanted: usize) -> Result<Vec<u8>, String> {
    read(MultiGzDecoder::new(packed), wanted)
}

/// The same for zlib.
pub(super) fn unpack_zlib(packed: &[u8], wanted: usize) -> Result<Vec<u8>, String> {
    read(ZlibDecoder::new(packed), wanted)
}

/// Grows with what is really there: a header's word is not taken for it.
fn read(unpacker: impl Read, wanted: usize) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    let read = unpacker.take(wanted as u64).read_to_end(&mut bytes);
    match read {
        Ok(_) => Ok(bytes),
        Err(error) => Err(error.to_string()),
    }
}
