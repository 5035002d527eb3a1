//! The JSON object of a pixel's history, for `inspect --json` and for its page. Its names are part of the command line's
//! interface.
//!
//! | name | value |
//! | --- | --- |
//! | `scene`, `method`, `chosen` | names; `chosen` is the method that `auto` chose, or null |
//! | `size`, `pixel` | the image's width and height; column from the left and row from the top |
//! | `by_distance` | whether depths are distances from the eye along the view direction (`--inverse-w`), null where infinite |
//! | `of_slices` | whether volumes are drawn as slices, and `exact` is the exact image of these |
//! | `fragments` | every fragment in the order of submission |
//! | `passes` | every draw of the method |
//! | `exact`, `composited` | the layers, nearest first, in the exact image and in the method's; `composited` may be null |
//! | `ray` | the parts of the ray inside of volumes: `distances` from the eye, `volumes`, `light`, and the part of all light that is `stopped` |
//! | `parts_at` | the first layer at which they differ, counted from 0, or null |
//! | `image`, `error` | the colour on OpenGL; its largest difference from the exact one |
//! | `list` | what resolving the pixel's list took, or null: `records_read`, `composited`, `subpasses`, `slots_reserved`, `slots_used` |
//! | `marked` | whether the verified painter could not prove the pixel's order; null by other methods |
//! | `stopped` | why the method's loop ended, or null |
//! | `agree` | whether OpenGL and the emulated pixel hold the same after every pass that was compared; null if none was |
//! | `not_followed` | steps that the emulated pixel could not follow |
//!
//! A fragment has `mesh`, `triangle`, `opaque`, `depth` (in f64), `stored_depth` (OpenGL's), `color` (straight alpha), `pass`
//! (the last one, counted from 0, in which it passed every test, or null), `exact_weight` and `weight` (the
//! part of its colour that is in the exact image, and in the method's, or null), and `fate`: an object with `is` (composited, wrong, tied, lost, mixed, hidden, opaque or unknown), and `layer` or `with` as far as it
//! has them. A lost one has a `loss`: no_room (its list was full), dropped (the Local Array was), ended (the loop ended before it
//! was peeled, see `stopped`), never_drawn, or replaced (drawn, but others took its place). Layers are counted from 0. A pass has `program`, `over_screen`, `lines`, `events`, `resolve` (null, or the `size` of the Local
//! Array and the `subpasses` through the pixel's list, each with the fragments that it `skipped` and `dropped`, those that its
//! `array` held, and those that it `composited`; with volumes the `ray`, else null), `held` and `emulated` (`depth`,
//! `stencil`, `colors`, each null where there is none), and `differences` in words. A line has `title`, `source`, `text`, `call`
//! and the name of its `origin`. A fragment is named by its number, and a face of the box around volume 0 is "v0 in" or "v0 out".
//! The ray's events have `distance`, `is` and `what` (begins; cast, and the number of samples; box, and the volume's number;
//! surface, and the fragment), and after it the volumes around the ray as a bitmask, `occupancy`, and `transparency`. An event has `fragment`, `outcome`, `stencil` and `depth`
//! before and after, `record` (its place in the pixel's list, or null), `no_room` (whether the list had none for it), and by multi-layer alpha blending the
//! `nodes` after it, each as the fragments that were merged into it. A composite has
//! `color` and `layers`, each with `fragment` and `so_far` (premultiplied, and the part of the light that is stopped).

use crate::emulator::{InList, RayEvent, RayHappening, Resolve};
use crate::fragment::Source;
use crate::inspect::{
    Composite, Event, Fate, FragmentHistory, History, Line, Loss, Pass, RaySegment, name,
};
use crate::steps::{Held, Origin, Texel};
use serde_json::{Value, json};

/// A 32-bit float with no more digits than tell it from others; null if it is not finite.
fn number(value: f32) -> Value {
    json!(value.to_string().parse::<f64>().ok())
}

fn numbers(values: &[f32]) -> Value {
    values.iter().copied().map(number).collect()
}

/// The object of a history.
pub fn object(history: &History) -> Value {
    let fragments: Vec<_> = history.fragments.iter().map(fragment).collect();
    let passes: Vec<_> = history.passes.iter().map(pass).collect();
    json!({
        "scene": history.scene,
        "method": history.method,
        "chosen": history.chosen,
        "size": history.size,
        "pixel": history.pixel,
        "by_distance": history.by_distance,
        "of_slices": history.of_slices,
        "fragments": fragments,
        "passes": passes,
        "ray": history.ray.iter().map(segment).collect::<Vec<_>>(),
        "exact": composite(&history.exact),
        "composited": history.composited.as_ref().map(composite),
        "parts_at": history.parts_at,
        "image": numbers(&history.image),
        "error": history.error,
        "list": history.list.map(|it| json!({
            "records_read": it.records_read,
            "composited": it.composited,
            "subpasses": it.subpasses,
            "slots_reserved": it.slots[0],
            "slots_used": it.slots[1],
        })),
        "marked": history.marked,
        "stopped": history.stopped.map(|reason| reason.to_string()),
        "agree": history.is_compared().then(|| history.differences().next().is_none()),
        "not_followed": history.not_followed,
    })
}

fn fragment(fragment: &FragmentHistory) -> Value {
    json!({
        "mesh": fragment.mesh,
        "triangle": fragment.triangle,
        "opaque": fragment.opaque,
        "depth": fragment.depth,
        "stored_depth": number(fragment.stored_depth),
        "color": numbers(&fragment.color.to_array()),
        "pass": fragment.pass,
        "exact_weight": fragment.exact_weight,
        "weight": fragment.weight,
        "fate": fate(&fragment.fate),
        "loss": fragment.loss.map(Loss::name),
    })
}

fn fate(fate: &Fate) -> Value {
    match fate {
        Fate::Composited(layer) => json!({ "is": "composited", "layer": layer }),
        Fate::Wrong(layer) => json!({ "is": "wrong", "layer": layer }),
        Fate::Tied(with) => json!({ "is": "tied", "with": with }),
        Fate::Lost => json!({ "is": "lost" }),
        Fate::Mixed => json!({ "is": "mixed" }),
        Fate::Hidden => json!({ "is": "hidden" }),
        Fate::Opaque => json!({ "is": "opaque" }),
        _ => json!({ "is": "unknown" }),
    }
}

fn pass(pass: &Pass) -> Value {
    let lines: Vec<_> = pass.lines.iter().map(line).collect();
    let events: Vec<_> = pass.events.iter().map(event).collect();
    json!({
        "program": pass.program,
        "over_screen": pass.over_screen,
        "lines": lines,
        "events": events,
        "resolve": pass.resolve.as_ref().map(resolve),
        "held": held(&pass.held),
        "emulated": pass.emulated.as_ref().map(held),
        "differences": pass.differences,
    })
}

fn line(line: &Line) -> Value {
    json!({
        "title": line.title,
        "source": line.source,
        "text": line.text,
        "call": line.call,
        "origin": line.origin.map(Origin::name),
    })
}

fn event(event: &Event) -> Value {
    let record = match event.list {
        Some(InList::Stored(record)) => Some(record),
        _ => None,
    };
    json!({
        "fragment": named(event.fragment),
        "outcome": event.outcome.to_string(),
        "stencil": event.stencil,
        "depth": numbers(&event.depth),
        "record": record,
        "no_room": event.list == Some(InList::NoRoom),
        "nodes": event.nodes,
    })
}

fn resolve(resolve: &Resolve) -> Value {
    let subpasses = resolve.resolved.passes.iter();
    let subpasses: Vec<_> = subpasses
        .map(|it| {
            json!({
                "skipped": all_named(&it.skipped),
                "dropped": all_named(&it.dropped),
                "array": all_named(&it.array),
                "composited": all_named(&it.composited),
            })
        })
        .collect();
    let events = resolve.ray.as_ref().map(|ray| &ray.events);
    let ray: Option<Vec<_>> = events.map(|events| events.iter().map(happening).collect());
    json!({ "size": resolve.size, "subpasses": subpasses, "ray": ray })
}

/// A surface by its number, a face of a box by its name.
fn named(fragment: u32) -> Value {
    match Source::of(fragment) {
        Source::Surface(number) => json!(number),
        Source::Proxy { .. } => json!(name(fragment)),
    }
}

fn all_named(fragments: &[u32]) -> Vec<Value> {
    fragments.iter().copied().map(named).collect()
}

fn happening(event: &RayEvent) -> Value {
    let (is, what) = match event.what {
        RayHappening::Begins => ("begins", Value::Null),
        RayHappening::IsCast(samples) => ("cast", json!(samples)),
        RayHappening::Toggles(volume) => ("box", json!(volume)),
        RayHappening::Blends(surface) => ("surface", json!(surface)),
    };
    json!({
        "is": is,
        "what": what,
        "distance": event.distance,
        "occupancy": event.occupancy,
        "transparency": event.transparency,
    })
}

fn held(held: &Held) -> Value {
    let texel = |texel: &Texel| match texel {
        Texel::Color(channels) => numbers(channels),
        Texel::Integers(channels) => json!(channels),
    };
    let colors: Vec<_> = held.colors.iter().map(texel).collect();
    json!({ "depth": held.depth.map(number), "stencil": held.stencil, "colors": colors })
}

fn segment(segment: &RaySegment) -> Value {
    json!({
        "distances": segment.distances,
        "volumes": segment.volumes,
        "light": segment.light,
        "stopped": segment.stopped,
    })
}

fn composite(composite: &Composite) -> Value {
    let layers = composite.layers.iter();
    let layers: Vec<_> = layers
        .map(|layer| json!({ "fragment": layer.fragment, "so_far": layer.so_far }))
        .collect();
    json!({ "color": composite.color, "layers": layers })
}
