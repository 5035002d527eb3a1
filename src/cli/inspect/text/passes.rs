//! The passes of a method at a pixel: what each did to the fragments, and what the pixel held afterwards.

use std::fmt::Write;

use onionskin::inspect::{Event, Pass, name};
use onionskin::low_level::emulator::{InList, RayEvent, RayHappening, RayRun, Resolve};
use onionskin::low_level::fragment::Source;
use onionskin::low_level::steps::{Held, Origin, Texel};

pub(super) fn pass_text(number: usize, pass: &Pass, with_lines: bool) -> String {
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
