//! `a_buffer/scan_spread.comp`: each number becomes the sum of those before it.

/// All invocations. The level above holds the sum before each `chunk` numbers; the uppermost level has none above it.
pub(in crate::low_level::emulator) fn main(lower: &mut [u32], upper: Option<&[u32]>, chunk: usize) {
    for (invocation, numbers) in lower.chunks_mut(chunk).enumerate() {
        let mut before = upper.map_or(0, |upper| upper[invocation]);
        for number in numbers {
            let here = *number;
            *number = before;
            before = before.wrapping_add(here);
        }
    }
}
