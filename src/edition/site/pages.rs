//! Which pages and files the site has.

use serde_json::{Value, json};

use super::folder::IDENTITY;
use super::record::Records;
use super::{glossary, machine, methods};
use crate::error::Result;
use crate::gl::Context;
use crate::methods::registry;

/// A page.
pub(super) struct Page {
    /// Its file.
    pub(super) file: String,
    /// Its title.
    pub(super) title: String,
    pub(super) template: &'static str,
    /// The paper whose claims and errata all stand in it.
    pub(super) paper: Option<&'static str>,
    /// What its template is given besides what all are given.
    pub(super) data: Value,
}

/// A chapter on one paper.
pub(super) struct Chapter {
    /// The paper's key.
    pub(super) paper: &'static str,
    pub(super) file: &'static str,
    /// The name in the site's navigation.
    pub(super) short: &'static str,
    pub(super) title: &'static str,
    pub(super) template: &'static str,
    pub(super) text: &'static str,
}

/// The chapters, in the order of their publications.
pub(super) const CHAPTERS: &[Chapter] = &[
    Chapter {
        paper: "everitt",
        file: "everitt.html",
        short: "Everitt 2001",
        title: "Everitt 2001: Interactive Order-Independent Transparency",
        template: "chapters/everitt.html",
        text: include_str!("../web/chapters/everitt.html"),
    },
    Chapter {
        paper: "vtk",
        file: "vtk.html",
        short: "VTK 2006",
        title: "VTK 2006: Depth Peeling",
        template: "chapters/vtk.html",
        text: include_str!("../web/chapters/vtk.html"),
    },
    Chapter {
        paper: "carr",
        file: "carr.html",
        short: "Carr et al. 2008",
        title: "Carr, Měch and Miller 2008: Coherent Layer Peeling for Transparent High-Depth-Complexity Scenes",
        template: "chapters/carr.html",
        text: include_str!("../web/chapters/carr.html"),
    },
    Chapter {
        paper: "lindholm",
        file: "lindholm.html",
        short: "Lindholm et al. 2015",
        title: "Lindholm et al. 2015: Hybrid Data Visualization Based on Depth Complexity Histogram Analysis",
        template: "chapters/lindholm.html",
        text: include_str!("../web/chapters/lindholm.html"),
    },
];

/// The templates besides the chapters.
pub(super) const TEMPLATES: &[(&str, &str)] = &[
    ("page.html", include_str!("../web/site/page.html")),
    ("parts.html", include_str!("../web/site/parts.html")),
    ("index.html", include_str!("../web/site/index.html")),
    ("methods.html", include_str!("../web/site/methods.html")),
    ("method.html", include_str!("../web/site/method.html")),
    ("glossary.html", include_str!("../web/site/glossary.html")),
    ("machine.html", include_str!("../web/site/machine.html")),
];

/// The files that stand beside the pages as they are.
pub(super) const ASSETS: &[(&str, &str)] = &[
    ("style.css", include_str!("../web/site/style.css")),
    ("site.js", include_str!("../web/site/site.js")),
    ("machine.js", include_str!("../web/machine.js")),
    ("exercises.js", include_str!("../web/exercises.js")),
    ("player.js", include_str!("../web/player.js")),
];

/// The names in the navigation: file and text.
pub(super) fn navigation() -> Vec<Value> {
    let chapters = CHAPTERS.iter().map(|it| (it.file, it.short));
    let before = [
        ("index.html", "Why is it wrong?"),
        ("methods.html", "Methods"),
    ];
    let after = [("glossary.html", "Glossary"), ("machine.html", "Machine")];
    before
        .into_iter()
        .chain(chapters)
        .chain(after)
        .map(|(file, text)| json!({ "file": file, "text": text }))
        .collect()
}

fn chapters() -> Value {
    let chapters = CHAPTERS.iter();
    chapters
        .map(|it| json!({ "file": it.file, "title": it.title }))
        .collect()
}

/// Every page, with its data.
///
/// # Errors
/// If the driver cannot be asked.
pub(super) fn all(context: &Context, records: &Records) -> Result<Vec<Page>> {
    let page = |file: &str, title: &str, template, data| Page {
        file: file.into(),
        title: title.into(),
        template,
        paper: None,
        data,
    };
    let mut all = vec![
        page(
            "index.html",
            "Why does my transparency look wrong?",
            "index.html",
            chapters(),
        ),
        page("methods.html", "Methods", "methods.html", methods::table()),
        page(
            "glossary.html",
            "Glossary",
            "glossary.html",
            glossary::data(),
        ),
        page(
            "machine.html",
            "Machine, driver and versions",
            "machine.html",
            machine::data(context)?,
        ),
    ];
    all.extend(CHAPTERS.iter().map(|chapter| Page {
        paper: Some(chapter.paper),
        ..page(chapter.file, chapter.title, chapter.template, Value::Null)
    }));
    all.extend(registry().iter().map(|row| {
        page(
            &methods::file(row.name),
            row.name,
            "method.html",
            methods::data(row, records),
        )
    }));
    Ok(all)
}

/// The names of all files of the site but the figures'.
pub(super) fn files() -> Vec<String> {
    let fixed = [
        "index.html",
        "methods.html",
        "glossary.html",
        "machine.html",
        IDENTITY,
    ];
    let fixed = fixed.into_iter().map(str::to_owned);
    fixed
        .chain(CHAPTERS.iter().map(|it| it.file.to_owned()))
        .chain(ASSETS.iter().map(|(name, _)| (*name).to_owned()))
        .chain(registry().iter().map(|row| methods::file(row.name)))
        .collect()
}
