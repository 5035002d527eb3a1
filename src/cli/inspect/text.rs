//! A pixel's history as text, 80 columns wide.

mod composites;
mod fragments;
mod passes;
mod shortened;

use std::fmt::Write;

use onionskin::inspect::{Fate, History};

use composites::{composites, ray};
use fragments::fragments;
use passes::pass_text;

/// The history; with the lines of the listings if they are asked for.
pub(super) fn text(history: &History, with_lines: bool) -> String {
    let mut text = summary(history);
    if history.fragments.is_empty() && history.ray.is_empty() {
        return wrapped(text.trim_end());
    }
    if !history.fragments.is_empty() {
        text += &fragments(history);
    }
    for (number, pass) in (1..).zip(&history.passes) {
        text += &pass_text(number, pass, with_lines);
    }
    text += &ray(&history.ray);
    text += &composites(history);
    wrapped(text.trim_end())
}

/// As wide as the narrowest terminals are.
const COLUMNS: usize = 80;

/// The text with lines that are too long broken between words, and after the commas of calls.
fn wrapped(text: &str) -> String {
    let mut done = String::new();
    for line in text.lines() {
        let mut width = 0;
        for word in line.split_inclusive([' ', ',']) {
            let length = word.trim_end().chars().count();
            if width > 0 && width + length > COLUMNS {
                done.truncate(done.trim_end_matches(' ').len());
                done += "\n      ";
                width = 6;
            }
            done += word;
            width += word.chars().count();
        }
        done.push('\n');
    }
    done.truncate(done.trim_end().len());
    done
}

fn summary(history: &History) -> String {
    let mut text = String::new();
    let mut row = |name: &str, value: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{name:<11} {value}");
    };
    let ([x, y], [width, height]) = (history.pixel, history.size);
    row("scene", history.scene.clone());
    row(
        "pixel",
        format!("{x}, {y} of {width} x {height}, from the top left"),
    );
    row(
        "method",
        match &history.chosen {
            Some(chosen) => format!("{} ({chosen})", history.method),
            None => history.method.clone(),
        },
    );
    row("fragments", count(history));
    let [r, g, b, _] = history.image;
    row("image", format!("{r:.6} {g:.6} {b:.6} on OpenGL"));
    let [r, g, b, _] = history.exact.color;
    let error = history.error;
    let of = if history.of_slices {
        " of the slices"
    } else {
        ""
    };
    row(
        "exact",
        format!("{r:.6} {g:.6} {b:.6}{of}, at most {error:.1e} from it"),
    );
    if let Some(list) = history.list {
        let [reserved, used] = list.slots;
        row(
            "list",
            format!(
                "{} read in {}; {used} of {reserved} array slots used",
                counted(list.records_read as usize, "record"),
                counted(list.subpasses as usize, "subpass"),
            ),
        );
    }
    if let Some(marked) = history.marked {
        let proof = match marked {
            true => "failed: the pixel is marked and has a list",
            false if history.exact.layers.is_empty() => "nothing to prove",
            false => "in order, so one pass is exact",
        };
        row("proof", proof.into());
    }
    if let Some(reason) = history.stopped {
        row("stopped", reason.to_string());
    }
    row("machines", machines(history));
    text
}

type IsFate = fn(&Fate) -> bool;

fn count(history: &History) -> String {
    let all = history.fragments.len();
    if all == 0 {
        return match history.ray.is_empty() {
            true => "none: the pixel shows the background".into(),
            false => "none: there are only volumes".into(),
        };
    }
    let of = |is: IsFate| {
        let fates = history.fragments.iter().map(|fragment| &fragment.fate);
        fates.filter(|fate| is(fate)).count()
    };
    let kinds: [(&str, IsFate); 7] = [
        ("composited", |fate| matches!(fate, Fate::Composited(_))),
        ("mixed", |fate| *fate == Fate::Mixed),
        ("opaque", |fate| *fate == Fate::Opaque),
        ("hidden", |fate| *fate == Fate::Hidden),
        ("lost", |fate| matches!(fate, Fate::Lost | Fate::Tied(_))),
        ("in the image wrongly", |fate| {
            matches!(fate, Fate::Wrong(_))
        }),
        ("not followed", |fate| *fate == Fate::Unknown),
    ];
    let counted = kinds.into_iter().map(|(word, is)| (of(is), word));
    let counted: Vec<_> = counted
        .filter(|(count, _)| *count > 0)
        .map(|(count, word)| format!("{count} {word}"))
        .collect();
    format!("{all}: {}", counted.join(", "))
}

/// Whether OpenGL and the emulated pixel agree.
fn machines(history: &History) -> String {
    if let Some((pass, _)) = history.differences().next() {
        let passes = history.passes.iter();
        let wrong = passes.filter(|pass| !pass.differences.is_empty()).count();
        let first = &history.passes[pass];
        let line = first.lines.last().map_or("", |line| line.text.trim());
        return format!(
            "DIFFER after {wrong} of {} passes, first after pass {}\n{:<11} {}: {line}",
            history.passes.len(),
            pass + 1,
            "",
            first.program,
        );
    }
    let followed = history.passes.iter().filter(|pass| pass.emulated.is_some());
    let [followed, all] = [followed.count(), history.passes.len()];
    let all = counted(all, "pass");
    let mut text = match followed {
        0 => "not compared: the emulated pixel could follow no pass".to_owned(),
        _ => format!("OpenGL and the emulated pixel agree after {followed} of {all}"),
    };
    if let Some(why) = history.not_followed.first() {
        let why = why.lines().next().unwrap_or_default();
        let _ = write!(text, "\n{:<11} {why}", "");
    }
    text
}

/// A number of things.
fn counted(count: usize, one: &str) -> String {
    let ending = match (count, one.ends_with('s')) {
        (1, _) => "",
        (_, true) => "es",
        (_, false) => "s",
    };
    format!("{count} {one}{ending}")
}
