//! The exact ray and the exact composite of a pixel, with the method's composite beside it.

use std::fmt::Write;

use onionskin::inspect::{Composite, History, RaySegment};

use super::shortened::shortened;

/// The exact ray through the volumes.
pub(super) fn ray(segments: &[RaySegment]) -> String {
    if segments.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "\n{:<22}{:<10}{:<22}{:<10}{}\n",
        "exact ray, from - to", "length", "light", "stopped", "volumes"
    );
    for segment in segments {
        let ([from, to], [r, g, b]) = (segment.distances, segment.light);
        let _ = writeln!(
            text,
            "{:<22}{:<10}{:<22}{:<10}{}",
            format!("{from:.4} - {to:.4}"),
            format!("{:.4}", to - from),
            format!("{r:.4} {g:.4} {b:.4}"),
            format!("{:.4}", segment.stopped),
            shortened(&segment.volumes.join(", "), 16)
        );
    }
    text
}

/// The exact composite, and the method's beside it.
pub(super) fn composites(history: &History) -> String {
    let mut text = format!("\n{:<8}{:<34}", "layer", "exact, so far");
    text += match history.composited {
        Some(_) => "method, so far\n",
        None => "\n",
    };
    let ours = history.composited.as_ref();
    let most = ours.map_or(0, |it| it.layers.len());
    let rows = history.exact.layers.len().max(most);
    for row in 0..rows {
        let layer = |composite: &Composite| {
            composite.layers.get(row).map_or_else(String::new, |layer| {
                let [r, g, b, a] = layer.so_far;
                format!("s{:<4}{r:.4} {g:.4} {b:.4} {a:.4}", layer.fragment)
            })
        };
        let parts = match history.parts_at == Some(row) {
            true => " <- part",
            false => "",
        };
        let method = ours.map(layer).unwrap_or_default();
        let line = format!("{:<8}{:<34}{method}{parts}", row + 1, layer(&history.exact));
        text += line.trim_end();
        text.push('\n');
    }
    text
}
