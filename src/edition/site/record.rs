//! A figure in the folder: its pictures, and the record that says what the page shows of it.
//!
//! | name | value |
//! | --- | --- |
//! | `key`, `source`, `title`, `caption` | texts |
//! | `pictures` | each with `file`, `width`, `height`, `label`, `alt`, `flips` |
//! | `drawings` | each with `svg`, `alt` |
//! | `charts` | each as its template draws it |
//! | `tables` | each with `caption`, `columns`, `rows` |

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::folder::{FIGURES, Folder};
use crate::error::{Error, Result};
use crate::low_level::edition::figures::{Drawn, Figure, Picture, Studio};

/// The records of all figures, by their keys.
pub(super) type Records = BTreeMap<&'static str, Value>;

/// The record of a figure that is whole.
pub(super) fn kept(folder: &Folder, figure: &Figure) -> Option<Value> {
    let record: Value = serde_json::from_str(&folder.read(&file(figure))?).ok()?;
    let pictures = record["pictures"].as_array()?;
    let whole = pictures
        .iter()
        .all(|picture| picture["file"].as_str().is_some_and(|it| folder.has(it)));
    whole.then_some(record)
}

/// Makes a figure, and writes it: the record last.
pub(super) fn make(folder: &Folder, figure: &Figure, studio: &Studio) -> Result<Value> {
    let drawn = (figure.make)(studio)?;
    let mut pictures = Vec::new();
    for picture in &drawn.pictures {
        pictures.push(write_picture(folder, figure, picture)?);
    }
    let record = record(figure, &drawn, pictures);
    let mut text = record.to_string();
    text.push('\n');
    folder.write(&file(figure), text.as_bytes())?;
    Ok(record)
}

fn file(figure: &Figure) -> String {
    format!("{FIGURES}/{}.json", figure.key)
}

fn write_picture(folder: &Folder, figure: &Figure, picture: &Picture) -> Result<Value> {
    let file = format!("{FIGURES}/{}-{}.png", figure.key, picture.name);
    let png = picture.image.to_png().map_err(|answer| Error::Plot {
        what: "a picture of a figure",
        answer,
    })?;
    folder.write(&file, &png)?;
    Ok(json!({
        "file": file,
        "width": picture.image.width,
        "height": picture.image.height,
        "label": picture.label,
        "alt": picture.alt,
        "flips": picture.flips,
    }))
}

fn record(figure: &Figure, drawn: &Drawn, pictures: Vec<Value>) -> Value {
    let drawings = drawn.drawings.iter();
    let tables = drawn.tables.iter();
    json!({
        "key": figure.key,
        "source": figure.source,
        "title": figure.title,
        "caption": drawn.caption,
        "pictures": pictures,
        "drawings": drawings
            .map(|(svg, alt)| json!({ "svg": svg, "alt": alt }))
            .collect::<Vec<_>>(),
        "charts": drawn.charts.iter().map(|chart| chart.laid_out()).collect::<Vec<_>>(),
        "tables": tables
            .map(|it| json!({ "caption": it.caption, "columns": it.columns, "rows": it.rows }))
            .collect::<Vec<_>>(),
    })
}
