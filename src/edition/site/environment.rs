//! The templates, and what all of them are given.

use std::sync::{Arc, Mutex};

use minijinja::syntax::SyntaxConfig;
use minijinja::value::Serde;
use minijinja::{AutoEscape, Environment, UndefinedBehavior, context};

use super::functions::{self, Shown};
use super::pages::{CHAPTERS, Page, TEMPLATES, navigation};
use super::record::Records;
use crate::error::{Error, Result};
use crate::papers::papers;
use crate::steps::Origin;

pub(super) struct Pages {
    environment: Environment<'static>,
    /// The claims and errata of the page that is being made.
    shown: Shown,
    quick: bool,
}

impl Pages {
    pub(super) fn new(records: Arc<Records>, quick: bool) -> Result<Self> {
        let shown = Arc::new(Mutex::new(Vec::new()));
        // A line that has nothing but a statement leaves no line.
        let mut syntax = SyntaxConfig::builder();
        syntax.trim_blocks(true).lstrip_blocks(true);
        let syntax = syntax.build().map_err(fault)?;
        let mut environment = Environment::new();
        environment.set_undefined_behavior(UndefinedBehavior::Strict);
        environment.set_auto_escape_callback(|_| AutoEscape::Html);
        environment.set_syntax(syntax);
        functions::add(&mut environment, records, Arc::clone(&shown));
        let chapters = CHAPTERS.iter().map(|it| (it.template, it.text));
        for (name, text) in TEMPLATES.iter().copied().chain(chapters) {
            environment.add_template(name, text).map_err(fault)?;
        }
        Ok(Self {
            environment,
            shown,
            quick,
        })
    }

    /// The text of a page.
    pub(super) fn render(&self, page: &Page) -> Result<String> {
        let mut shown = self
            .shown
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        shown.clear();
        drop(shown);
        let template = self
            .environment
            .get_template(page.template)
            .map_err(fault)?;
        let whole = context! {
            file => &page.file,
            title => &page.title,
            navigation => Serde(navigation()),
            legend => Origin::LEGEND.map(|(letter, meaning)| (letter.to_string(), meaning)).to_vec(),
            version => env!("CARGO_PKG_VERSION"),
            quick => self.quick,
            data => Serde(&page.data),
        };
        let text = template.render(whole).map_err(fault)?;
        self.expect_whole(page)?;
        Ok(text)
    }

    /// Refuses a chapter that does not have every claim and every erratum of its paper once.
    fn expect_whole(&self, page: &Page) -> Result<()> {
        let Some(paper) = papers().iter().find(|it| Some(it.key) == page.paper) else {
            return Ok(());
        };
        let mut shown = self
            .shown
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner())
            .clone();
        shown.sort_unstable();
        let claims = paper.claims.iter().map(|it| it.key);
        let mut all: Vec<_> = claims.chain(paper.errata.iter().map(|it| it.key)).collect();
        all.sort_unstable();
        if shown == all {
            return Ok(());
        }
        let missing = all.iter().filter(|key| !shown.contains(key)).copied();
        let twice = shown.windows(2).filter(|pair| pair[0] == pair[1]);
        let (missing, twice): (Vec<_>, Vec<_>) =
            (missing.collect(), twice.map(|it| it[0]).collect());
        Err(Error::usage(
            format!("{}: missing {missing:?}, twice {twice:?}", page.file),
            "this is a fault of onionskin: a chapter has each claim and each erratum of its paper once",
        ))
    }
}

fn fault(error: minijinja::Error) -> Error {
    let mut what = format!("a page cannot be made: {error:#}");
    let mut source = std::error::Error::source(&error);
    while let Some(cause) = source {
        what += &format!("; {cause}");
        source = cause.source();
    }
    Error::usage(what, "this is a fault of onionskin")
}
