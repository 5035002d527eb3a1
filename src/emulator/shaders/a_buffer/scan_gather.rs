//! `a_buffer/scan_gather.comp`: the counts of an image's pixels, one after the other.

/// A texel of the complexity map holds a whole number. What is not one is cut off, as by `uint()`.
pub(in crate::low_level::emulator) fn main(complexity: &[f32]) -> Vec<u32> {
    complexity.iter().map(|&count| count as u32).collect()
}
