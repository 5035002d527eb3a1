//! The table of a pixel's fragments, and why some are lost.

use std::fmt::Write;

use onionskin::inspect::{Fate, FragmentHistory, History, Loss};

use super::shortened::shortened;

pub(super) fn fragments(history: &History) -> String {
    let depth = if history.by_distance {
        "distance"
    } else {
        "depth"
    };
    let mut text = format!(
        "\n{:<5}{:<9}{:>8}  {depth:<12}{:<12}{:<16}{:<5}{}\n",
        "", "mesh", "triangle", "stored", "colour, alpha", "pass", "fate"
    );
    for (number, it) in history.fragments.iter().enumerate() {
        let [r, g, b, a] = it.color.to_array().map(hundredths);
        let pass = it.pass.map(|pass| (pass + 1).to_string());
        let _ = writeln!(
            text,
            "{:<5}{:<9}{:>8}  {:<12}{:<12}{:<16}{:<5}{}",
            format!("s{number}"),
            shortened(&it.mesh, 8),
            it.triangle,
            nine_digits(it.depth),
            it.stored_depth,
            format!("{r} {g} {b} {a}"),
            pass.as_deref().unwrap_or("-"),
            fate(it)
        );
    }
    text + &losses(&history.fragments)
}

/// The reasons for which fragments are lost, a line for each reason.
fn losses(fragments: &[FragmentHistory]) -> String {
    let mut reasons: Vec<(Loss, Vec<String>)> = Vec::new();
    for (number, fragment) in fragments.iter().enumerate() {
        let Some(loss) = fragment.loss else {
            continue;
        };
        let name = format!("s{number}");
        match reasons.iter_mut().find(|(other, _)| *other == loss) {
            Some((_, names)) => names.push(name),
            None => reasons.push((loss, vec![name])),
        }
    }
    let lines = reasons
        .iter()
        .map(|(loss, names)| format!("lost {}: {loss}\n", names.join(" ")));
    lines.collect()
}

/// A depth or distance with so many digits, as a 32-bit float may need.
fn nine_digits(value: f64) -> String {
    let before = value.abs().max(1.0).log10() as usize;
    format!("{value:.*}", 9_usize.saturating_sub(before))
}

/// A channel in three characters, if it is from 0 to 1.
fn hundredths(channel: f32) -> String {
    let text = format!("{channel:.2}");
    match text.strip_prefix('0') {
        Some(rest) => rest.to_owned(),
        None => format!("{channel:.1}"),
    }
}

fn fate(fragment: &FragmentHistory) -> String {
    match &fragment.fate {
        Fate::Composited(layer) => format!("layer {}", layer + 1),
        Fate::Wrong(layer) => format!("WRONG layer {}", layer + 1),
        Fate::Tied(other) => format!("LOST to s{other}"),
        Fate::Lost => "LOST".into(),
        Fate::Mixed => match fragment.weight {
            Some(weight) => format!("mixed {weight:.3}"),
            None => "mixed".into(),
        },
        Fate::Hidden => "hidden".into(),
        Fate::Opaque => "opaque".into(),
        _ => "?".into(),
    }
}
