//! `a_buffer/scan_reduce.comp`: the sum of each `chunk` numbers of one level is one number of the next.

/// All invocations. Sums are modulo 2^32.
pub(in crate::low_level::emulator) fn main(lower: &[u32], chunk: usize) -> Vec<u32> {
    let sum = |numbers: &[u32]| numbers.iter().copied().fold(0, u32::wrapping_add);
    lower.chunks(chunk).map(sum).collect()
}
