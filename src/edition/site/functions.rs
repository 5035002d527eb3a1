//! The functions of the templates. Each makes HTML by a macro of `parts.html`.

use std::sync::{Arc, Mutex};

use minijinja::value::{Kwargs, Rest, Serde, Value};
use minijinja::{Environment, Error, ErrorKind, State, context};
use serde_json::json;

use super::record::Records;
use super::{glossary, methods, players};
use crate::methods::registry;
use crate::papers::{Claim, Erratum, Paper, papers, texts};
use crate::steps::{Origin, Reading, Text, TextLine};

type Made = std::result::Result<Value, Error>;

/// The keys of the claims and errata that a page has shown.
pub(super) type Shown = Arc<Mutex<Vec<&'static str>>>;

pub(super) fn add(environment: &mut Environment<'static>, records: Arc<Records>, shown: Shown) {
    environment.add_function("listing", listing);
    environment.add_function("term", term);
    environment.add_function("method", method);
    environment.add_function("player", player);
    environment.add_function("figure", move |state: &State, key: &str| -> Made {
        let record = records.get(key).ok_or_else(|| nothing("figure", key))?;
        part(state, "figure", Value::from(Serde(record)))
    });
    environment.add_function("part", |state: &State, name: &str, value: Value| {
        part(state, name, value)
    });
    let of_errata = Arc::clone(&shown);
    environment.add_function(
        "claims",
        move |state: &State, paper: &str, places: Rest<String>| -> Made {
            let paper = known(paper)?;
            let all = paper.claims.iter().map(|it| (it.key, it.place, it));
            let found = chosen(all.collect(), &places, &shown)?;
            let rows: Vec<_> = found.into_iter().map(claim).collect();
            part(state, "claims", Value::from(Serde(rows)))
        },
    );
    environment.add_function(
        "errata",
        move |state: &State, paper: &str, places: Rest<String>| -> Made {
            let paper = known(paper)?;
            let all = paper.errata.iter().map(|it| (it.key, it.place, it));
            let found = chosen(all.collect(), &places, &of_errata)?;
            let rows: Vec<_> = found.into_iter().map(erratum).collect();
            part(state, "errata", Value::from(Serde(rows)))
        },
    );
}

/// What a macro of `parts.html` makes of a value.
fn part(state: &State, name: &str, value: Value) -> Made {
    let parts = state.env().get_template("parts.html")?;
    let mut macros = parts.render_captured(context! {})?;
    let made = macros.with_state_mut(|macros| macros.call_macro(name, &[value]))?;
    Ok(Value::from_safe_string(made))
}

fn nothing(kind: &str, name: &str) -> Error {
    Error::new(
        ErrorKind::InvalidOperation,
        format!("there is no {kind} '{name}'"),
    )
}

fn known(key: &str) -> Result<&'static Paper, Error> {
    let found = papers().iter().find(|paper| paper.key == key);
    found.ok_or_else(|| nothing("paper", key))
}

/// Those of these keys or places, in their paper's order.
fn chosen<T: Copy>(
    all: Vec<(&'static str, &'static str, T)>,
    wanted: &[String],
    shown: &Shown,
) -> Result<Vec<T>, Error> {
    let is = |wanted: &str, key: &str, place: &str| {
        wanted == key || wanted == place || Some(wanted) == place.split([',', ';']).next()
    };
    for name in wanted {
        if !all.iter().any(|(key, place, _)| is(name, key, place)) {
            return Err(nothing("key or place", name));
        }
    }
    let mut found = Vec::new();
    let mut keys = shown
        .lock()
        .unwrap_or_else(|poisoned| poisoned.into_inner());
    for (key, place, it) in all {
        if wanted.iter().any(|name| is(name, key, place)) {
            keys.push(key);
            found.push(it);
        }
    }
    Ok(found)
}

fn claim(claim: &Claim) -> serde_json::Value {
    let figures = claim.figures.iter();
    json!({
        "key": claim.key,
        "place": claim.place,
        "claim": claim.claim,
        "verdict": claim.verdict.to_string(),
        "evidence": claim.evidence,
        "figures": figures
            .map(|it| json!({ "of": it.of, "paper": it.paper, "here": it.here }))
            .collect::<Vec<_>>(),
        "tests": claim.tests,
    })
}

fn erratum(erratum: &Erratum) -> serde_json::Value {
    json!({
        "key": erratum.key,
        "place": erratum.place,
        "kind": erratum.kind.to_string(),
        "printed": erratum.printed,
        "executed": erratum.executed,
        "change": erratum.change,
        "tests": erratum.tests,
    })
}

/// A listing in all readings that differ, the amended one first.
fn listing(state: &State, name: &str) -> Made {
    let found = texts(name).ok().filter(|found| found.len() == 1);
    let (_, text) = found
        .and_then(|mut it| it.pop())
        .ok_or_else(|| nothing("listing", name))?;
    part(state, "listing", Value::from(Serde(readings(name, text))))
}

/// What is shown of a listing.
pub(super) fn readings(name: &str, text: &Text) -> serde_json::Value {
    let mut readings: Vec<(Vec<&str>, Vec<TextLine>)> = Vec::new();
    for reading in Reading::ALL.into_iter().rev() {
        let lines = text.lines(reading);
        match readings.iter_mut().find(|(_, others)| *others == lines) {
            Some((names, _)) => names.push(reading.name()),
            None => readings.push((vec![reading.name()], lines)),
        }
    }
    let readings: Vec<_> = readings
        .iter()
        .map(|(names, lines)| {
            let lines: Vec<_> = lines.iter().map(line).collect();
            json!({ "names": names, "lines": lines })
        })
        .collect();
    json!({
        "key": name,
        "id": format!("listing-{}", name.replace('/', "-")),
        "title": text.title(),
        "source": text.source(),
        "readings": readings,
    })
}

fn line(line: &TextLine) -> serde_json::Value {
    json!({
        "text": line.text,
        "note": line.note,
        "number": line.number,
        "letter": line.origin.map(|it| it.letter().to_string()),
        "origin": line.origin.map(Origin::name),
    })
}

fn term(state: &State, word: &str, text: Option<&str>) -> Made {
    let term = glossary::find(word).ok_or_else(|| nothing("term", word))?;
    let link = json!({
        "file": "glossary.html",
        "anchor": glossary::anchor(term.word),
        "code": false,
        "text": text.unwrap_or(word),
    });
    part(state, "link", Value::from(Serde(link)))
}

fn method(state: &State, name: &str, text: Option<&str>) -> Made {
    let row = registry().iter().find(|row| row.name == name);
    let row = row.ok_or_else(|| nothing("method", name))?;
    let link = json!({ "file": methods::file(row.name), "anchor": null, "code": text.is_none(), "text": text.unwrap_or(name) });
    part(state, "link", Value::from(Serde(link)))
}

/// A player. The script finds it by its class.
fn player(state: &State, program: &str, options: Kwargs) -> Made {
    let scene: String = options.get("scene")?;
    let exercises: Option<Vec<String>> = options.get("exercises")?;
    options.assert_all_used()?;
    let data = players::data(program, &scene, &exercises.unwrap_or_default());
    let data = data.map_err(|name| nothing("program, scene or exercise", &name))?;
    part(state, "player", Value::from(Serde(data)))
}
