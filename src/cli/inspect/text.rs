//! A pixel's history as text, 80 columns wide.

use std::fmt::Write;

use onionskin::inspect::{
    Composite, Event, Fate, FragmentHistory, History, Loss, Pass, RaySegment, name,
};
use onionskin::low_level::emulator::{InList, RayEvent, RayHappening, RayRun, Resolve};
use onionskin::low_level::fragment::Source;
use onionskin::low_level::steps::{Held, Origin, Texel};

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

fn fragments(history: &History) -> String {
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

/// A number of things.
fn counted(count: usize, one: &str) -> String {
    let ending = match (count, one.ends_with('s')) {
        (1, _) => "",
        (_, true) => "es",
        (_, false) => "s",
    };
    format!("{count} {one}{ending}")
}

/// A channel in three characters, if it is from 0 to 1.
fn hundredths(channel: f32) -> String {
    let text = format!("{channel:.2}");
    match text.strip_prefix('0') {
        Some(rest) => rest.to_owned(),
        None => format!("{channel:.1}"),
    }
}

fn shortened(name: &str, columns: usize) -> String {
    let length = name.chars().count();
    if length <= columns {
        return name.to_owned();
    }
    let end: String = name.chars().skip(length - columns + 1).collect();
    format!("~{end}")
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

fn pass_text(number: usize, pass: &Pass, with_lines: bool) -> String {
    let last = pass.lines.last();
    let place = last.map_or_else(String::new, |line| match line.title {
        "" => line.source.to_owned(),
        title => format!("{title} ({})", line.source),
    });
    let mut text = format!("\npass {number}  {}: {place}\n", pass.program);
    if with_lines {
        for line in &pass.lines {
            let letter = line.origin.map_or(' ', Origin::letter);
            let _ = writeln!(text, "  {letter} {}", line.text);
        }
    }
    for it in &pass.events {
        text += &event(it);
    }
    if let Some(it) = &pass.resolve {
        text += &resolve(it);
    }
    let agree = pass.differences.is_empty();
    let who = match (&pass.emulated, agree) {
        (Some(_), true) => "both hold",
        _ => "OpenGL",
    };
    let _ = writeln!(text, "  {who:<10} {}", held(&pass.held));
    if let (Some(emulated), false) = (&pass.emulated, agree) {
        let _ = writeln!(text, "  {:<10} {}", "emulated", held(emulated));
        for difference in &pass.differences {
            let _ = writeln!(text, "  DIFFERENT  {difference}");
        }
    }
    text
}

/// The subpasses through a list, a line for what each did.
fn resolve(resolve: &Resolve) -> String {
    let mut text = format!("  a Local Array of {}\n", resolve.size);
    for (number, subpass) in (1..).zip(&resolve.resolved.passes) {
        let kinds = [
            ("skipped", &subpass.skipped),
            ("dropped", &subpass.dropped),
            ("composited", &subpass.composited),
        ];
        for (word, fragments) in kinds.iter().filter(|(_, all)| !all.is_empty()) {
            let names: Vec<_> = fragments.iter().map(|&it| name(it)).collect();
            for (row, names) in names.chunks(12).enumerate() {
                let lead = match row {
                    0 => format!("subpass {number} {word}"),
                    _ => String::new(),
                };
                let _ = writeln!(text, "  {lead:<22}{}", names.join(" "));
            }
        }
    }
    if let Some(ray) = &resolve.ray {
        text += &cast_ray(ray);
    }
    text
}

/// The emulated pixel's ray, a line for each event.
fn cast_ray(ray: &RayRun) -> String {
    let mut text = format!("  {:<12}{:<22}{}\n", "distance", "the ray", "comes through");
    for event in &ray.events {
        let _ = writeln!(
            text,
            "  {:<12}{:<22}{:.4}",
            format!("{:.4}", event.distance),
            happening(event),
            event.transparency
        );
    }
    text
}

fn happening(event: &RayEvent) -> String {
    match event.what {
        RayHappening::Begins => "begins".into(),
        RayHappening::IsCast(1) => "after 1 sample".into(),
        RayHappening::IsCast(samples) => format!("after {samples} samples"),
        RayHappening::Toggles(volume) => {
            let leaves = event.occupancy >> volume & 1 == 0;
            name(Source::Proxy { volume, leaves }.id())
        }
        RayHappening::Blends(surface) => name(surface),
    }
}

fn event(event: &Event) -> String {
    let change = |before: String, after: String| match before == after {
        true => before,
        false => format!("{before} -> {after}"),
    };
    let [stencil_before, stencil] = event.stencil;
    let [depth_before, depth] = event.depth;
    let list = match event.list {
        Some(InList::Stored(record)) => format!(", record {record}"),
        Some(InList::NoRoom) => ", NO ROOM in the list".into(),
        None => String::new(),
    };
    let mut text = format!(
        "  {:<8}{:<14}stencil {:<13}depth {}{list}\n",
        name(event.fragment),
        event.outcome,
        change(stencil_before.to_string(), stencil.to_string()),
        change(depth_before.to_string(), depth.to_string()),
    );
    if !event.nodes.is_empty() {
        let node = |fragments: &Vec<u32>| {
            let names = fragments.iter().map(|&it| name(it));
            names.collect::<Vec<_>>().join(" + ")
        };
        let nodes: Vec<_> = event.nodes.iter().map(node).collect();
        let _ = writeln!(text, "          nodes {}", nodes.join(", "));
    }
    text
}

fn held(held: &Held) -> String {
    let mut values = Vec::new();
    if let Some(depth) = held.depth {
        values.push(format!("depth {depth}"));
    }
    if let Some(stencil) = held.stencil {
        values.push(format!("stencil {stencil}"));
    }
    let is_one = held.colors.len() == 1;
    for (number, texel) in held.colors.iter().enumerate() {
        let texel = match texel {
            Texel::Color([r, g, b, a]) => format!("{r:.4} {g:.4} {b:.4} {a:.4}"),
            Texel::Integers([r, g, b, a]) => format!("{r} {g} {b} {a}"),
        };
        values.push(match is_one {
            true => format!("color {texel}"),
            false => format!("color {number}: {texel}"),
        });
    }
    match values.is_empty() {
        true => "nothing".into(),
        false => values.join(", "),
    }
}

/// The exact ray through the volumes.
fn ray(segments: &[RaySegment]) -> String {
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
fn composites(history: &History) -> String {
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
