//! Fragments that are not in an image.

use onionskin::{Stats, registry};

/// The note about an image that is not whole, or `None` if it is.
pub(super) fn loss(stats: &Stats) -> Option<String> {
    let lost = stats.lost.filter(|&lost| lost > 0)?;
    if let Some(counts) = &stats.a_buffer {
        return Some(format!(
            "{lost} of {} fragments, of {} pixels, are not in the image of {} (stopped: {}; --array takes more at a time, \
             ppDP takes all)",
            stats.fragments,
            counts.truncated_pixels,
            stats.method,
            stats.stopped_text()
        ));
    }
    let entry = registry().iter().find(|entry| entry.name == stats.method)?;
    Some(format!(
        "{lost} of {} fragments are not in the image of {} (stopped: {}; of equal depths: {})",
        stats.fragments,
        stats.method,
        stats.stopped_text(),
        entry.ties
    ))
}
