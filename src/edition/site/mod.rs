//! The edition as a site: pages that need neither a server nor a network.
//!
//! A folder gets one file for each page, the style sheet, the scripts, and the folder `figures`. Figures are made one after
//! the other, and each is written whole: its pictures first, and last its record, `figures/KEY.json`, from which the pages are
//! made. So a run that was killed goes on with the next figure, and ends with the same bytes as one that was not. Pages are
//! made again by every run.
//!
//! # Chapters
//!
//! A chapter is a row of `CHAPTERS` in `pages.rs` and a template, `web/chapters/NAME.html`, which extends `page.html` and
//! fills the block `main`. These functions are there:
//!
//! | in a template | makes |
//! | --- | --- |
//! | `{{ listing("everitt/listing-1") }}` | a listing's lines with their origins, in all readings |
//! | `{{ figure("everitt-3") }}` | a figure: pictures, drawings, plots, tables, caption |
//! | `{{ claims("everitt", "Listing 1", "E05") }}` | the claims of these places or keys, with verdicts, figures and tests |
//! | `{{ errata("everitt", "Listing 2") }}` | the errata of these places or keys |
//! | `{{ player("everitt/depth-peeling", scene="three-panes", exercises=["everitt-tie"]) }}` | a program that one steps through and changes, on a pixel and with exercises of `web/exercises.json` |
//! | `{{ term("depth complexity") }}`, `{{ term("peel", "peels") }}` | a word with a link to the glossary |
//! | `{{ method("depth-peeling") }}` | a method's name with a link to its page |
//!
//! A place is the beginning of [`Claim::place`](crate::low_level::papers::Claim::place) up to a comma or a semicolon. A name that leads
//! nowhere is an error, so that a misspelt one cannot go unseen. Every claim and every erratum of a paper stands in its chapter
//! exactly once: [`Site::write`] refuses a chapter that leaves one out.

mod advice;
mod environment;
mod folder;
mod functions;
mod glossary;
mod machine;
mod methods;
mod pages;
mod players;
mod record;

use std::path::Path;
use std::sync::Arc;

use self::environment::Pages;
use self::folder::Folder;
use self::record::Records;
use super::figures::{self, Figure, Studio};
use super::script;
use crate::error::Result;
use crate::gl::Context;

/// A folder that gets the edition.
pub struct Site<'c> {
    context: &'c Context,
    quick: bool,
    folder: Folder,
    figures: Vec<&'static Figure>,
}

/// What was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Built {
    /// The number of pages.
    pub pages: usize,
    /// The number of figures that were made.
    pub made: usize,
    /// The number of figures that an earlier run had made.
    pub kept: usize,
}

impl<'c> Site<'c> {
    /// Makes the folder, or takes one that is empty or has a part of the same edition. A `quick` edition has small
    /// pictures.
    ///
    /// # Errors
    /// If the folder cannot be written to, has files that are not the edition's, or has another edition. Nothing was
    /// written then.
    pub fn open(path: &Path, context: &'c Context, quick: bool) -> Result<Self> {
        let figures: Vec<_> = figures::every().collect();
        let names = pages::files();
        let keys: Vec<_> = figures.iter().map(|figure| figure.key).collect();
        let folder = Folder::open(path, &identity(context, quick), &names, &keys)?;
        Ok(Self {
            context,
            quick,
            folder,
            figures,
        })
    }

    /// The number of parts that [`write`](Self::write) makes one after the other.
    pub fn parts(&self) -> usize {
        self.figures.len() + 1
    }

    /// Makes what is missing. `begin` is told of each part before it is made.
    ///
    /// # Errors
    /// If a figure cannot be made, or a file cannot be written.
    pub fn write(&self, begin: &mut dyn FnMut(&str)) -> Result<Built> {
        let studio = Studio::new(self.context, self.quick)?;
        let (mut made, mut records) = (0, Records::new());
        for figure in &self.figures {
            begin(figure.source);
            let record = match record::kept(&self.folder, figure) {
                Some(record) => record,
                None => {
                    made += 1;
                    record::make(&self.folder, figure, &studio)?
                }
            };
            records.insert(figure.key, record);
        }
        begin("pages");
        let pages = self.pages(records)?;
        self.folder.tidy();
        Ok(Built {
            pages,
            made,
            kept: self.figures.len() - made,
        })
    }

    fn pages(&self, records: Records) -> Result<usize> {
        for (name, text) in pages::ASSETS {
            match name.ends_with(".js") {
                true => self.folder.write(name, script::compact(text).as_bytes())?,
                false => self.folder.write(name, text.as_bytes())?,
            }
        }
        let all = pages::all(self.context, &records)?;
        let pages = Pages::new(Arc::new(records), self.quick)?;
        for page in &all {
            let text = pages.render(page)?;
            self.folder.write(&page.file, text.as_bytes())?;
        }
        Ok(all.len())
    }
}

/// What all files of an edition have in common, line by line.
fn identity(context: &Context, quick: bool) -> String {
    let driver = context.driver();
    let size = if quick { "quick" } else { "whole" };
    format!(
        "onionskin {}\nedition: {size}\nOpenGL: {}, {}\n",
        env!("CARGO_PKG_VERSION"),
        driver.renderer,
        driver.version_text,
    )
}
