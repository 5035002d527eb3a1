//! The pages of the methods, from the registry.

use serde_json::{Value, json};

use super::advice::{self, COMPONENTS};
use super::record::Records;
use crate::low_level::edition::figures;
use crate::methods::{Listed, Memory, Ties, registry};

/// The page of a method.
pub(super) fn file(name: &str) -> String {
    format!("method-{}.html", figures::method_file(name))
}

/// A row for every method.
pub(super) fn table() -> Value {
    registry().iter().map(facts).collect()
}

/// What the page of a method shows.
pub(super) fn data(row: &Listed, records: &Records) -> Value {
    let mut data = facts(row);
    let advice = advice::of(row.name);
    let parts: Vec<&str> = row.name.split('+').skip(1).collect();
    let added = || COMPONENTS.iter().filter(|it| parts.contains(&it.0));
    let listings = advice.map_or(&[][..], |it| it.listings).iter();
    data["does"] = advice.map(|it| it.does).into();
    data["take"] = advice.map(|it| it.take).into();
    data["leave"] = advice.map(|it| it.leave).into();
    data["adds"] = added().map(|it| it.1).collect();
    data["listings"] = listings
        .chain(added().flat_map(|it| it.2))
        .copied()
        .collect();
    data["ties_meaning"] = meaning_of_ties(row.ties).into();
    data["memory_meaning"] = meaning_of_memory(row.memory).into();
    let options = row.method.choices();
    let options = options.iter();
    data["options"] = options
        .map(|it| json!({ "name": it.name, "help": it.help }))
        .collect();
    data["figure"] = records
        .get("methods")
        .map_or(Value::Null, |record| figure(row, record));
    data
}

fn facts(row: &Listed) -> Value {
    json!({
        "name": row.name,
        "file": file(row.name),
        "source": row.source,
        "exact": row.exact,
        "exactness": row.exactness,
        "ties": row.ties.to_string(),
        "memory": row.memory.to_string(),
        "keeps": row.keeps,
        "needs": row.needs,
    })
}

/// The method's part of the figure of all methods.
fn figure(row: &Listed, record: &Value) -> Value {
    let mut figure = record.clone();
    let own = figures::method_file(row.name);
    let names = ["exact".to_owned(), own.clone(), format!("{own}-difference")];
    let files = names.map(|name| format!("figures/methods-{name}.png"));
    if let Some(pictures) = figure["pictures"].as_array_mut() {
        pictures.retain(|it| files.iter().any(|file| it["file"] == file.as_str()));
        // The method's own picture first.
        pictures.sort_by_key(|it| it["file"] != files[1].as_str());
    }
    if let Some(rows) = figure["tables"][0]["rows"].as_array_mut() {
        rows.retain(|cells| cells[0] == row.name);
    }
    figure["title"] = format!("Three knots by {} and exact", row.name).into();
    figure
}

fn meaning_of_ties(ties: Ties) -> &'static str {
    match ties {
        Ties::InOrder => {
            "Where surfaces coincide, the one that was submitted first lies in front, and all are in the image."
        }
        Ties::OverEarlier => "Where surfaces coincide, the one that was drawn last lies in front.",
        Ties::InOrderAfterSorting => {
            "Where surfaces coincide, the one that comes first after the sort lies in front. Without a sort that is the one submitted first."
        }
        Ties::UnsortedFirst => "Where surfaces coincide, those of unsorted meshes lie in front.",
        Ties::FirstKept => {
            "Where surfaces coincide, one is in the image. The others are missing, and are counted."
        }
        Ties::Unordered => "The order does not matter, here or elsewhere.",
    }
}

fn meaning_of_memory(memory: Memory) -> &'static str {
    match memory {
        Memory::Pixels => "Known beforehand: it does not depend on the scene.",
        Memory::PixelsAndTriangles => {
            "Known beforehand: besides the pixels, it keeps the order of the triangles."
        }
        Memory::PixelsOrLayers => "Known beforehand, unless layers are kept.",
        Memory::PixelsTimesLayers => "As much for every pixel as the deepest one needs.",
        Memory::PixelsAndFragments => {
            "As much as there are fragments, which depends on the scene and on the view."
        }
        Memory::Fragments => "As much as there are fragments, in main memory.",
    }
}
