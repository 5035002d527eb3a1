//! What a figure consists of.

use super::chart::Chart;
use crate::error::Result;
use crate::image::{Image, differences_alone};

/// What a figure's function has drawn: pictures, then drawings, then charts, then tables, and under all of them the caption.
#[derive(Clone, Debug, Default)]
pub struct Drawn {
    /// Pictures.
    pub pictures: Vec<Picture>,
    /// Drawings as SVG, each with a text for those who do not see it.
    pub drawings: Vec<(String, String)>,
    /// Plots.
    pub charts: Vec<Chart>,
    /// Tables.
    pub tables: Vec<Table>,
    /// What is to be seen, in a few sentences.
    pub caption: String,
}

/// A picture of a figure.
#[derive(Clone, Debug)]
pub struct Picture {
    /// Its name among the figure's pictures, of small letters, digits and hyphens: a part of its file's name.
    pub name: String,
    /// The pixels.
    pub image: Image,
    /// The few words that stand under it, or on its button.
    pub label: String,
    /// What it shows, for those who do not see it.
    pub alt: String,
    /// Whether it shares one place with the figure's other pictures of this kind, which readers flip through. All of them
    /// have the same size.
    pub flips: bool,
}

/// A table of a figure.
#[derive(Clone, Debug)]
pub struct Table {
    /// What its numbers are.
    pub caption: String,
    /// The heads of its columns.
    pub columns: Vec<String>,
    /// Its rows, each with as many cells as there are columns. The first cell is the row's head.
    pub rows: Vec<Vec<String>>,
}

impl Drawn {
    /// Nothing yet but the caption.
    pub fn new(caption: impl Into<String>) -> Self {
        Self {
            caption: caption.into(),
            ..Self::default()
        }
    }

    /// One more picture, which stands beside the others.
    #[must_use]
    pub fn picture(self, name: &str, image: &Image, label: &str, alt: &str) -> Self {
        self.one_more(name, image, [label, alt], false)
    }

    /// One more picture of those that readers flip through.
    #[must_use]
    pub fn flipped(self, name: &str, image: &Image, label: &str, alt: &str) -> Self {
        self.one_more(name, image, [label, alt], true)
    }

    /// One more picture of those that readers flip through: how much two pictures differ, times `gain`. Black is no
    /// difference.
    ///
    /// # Errors
    /// If the pictures' sizes differ.
    pub fn difference(self, name: &str, pair: [&Image; 2], gain: f32, label: &str) -> Result<Self> {
        let picture = differences_alone(pair[0], pair[1], gain)?;
        let alt = format!("{label}: black where both pictures are the same");
        Ok(self.flipped(name, &picture, label, &alt))
    }

    /// One more drawing, as SVG.
    #[must_use]
    pub fn drawing(mut self, svg: String, alt: &str) -> Self {
        self.drawings.push((svg, alt.into()));
        self
    }

    /// One more plot.
    #[must_use]
    pub fn chart(mut self, chart: Chart) -> Self {
        self.charts.push(chart);
        self
    }

    /// One more table.
    #[must_use]
    pub fn table(mut self, caption: &str, columns: &[&str], rows: Vec<Vec<String>>) -> Self {
        self.tables.push(Table {
            caption: caption.into(),
            columns: columns.iter().map(|&it| it.into()).collect(),
            rows,
        });
        self
    }

    fn one_more(mut self, name: &str, image: &Image, [label, alt]: [&str; 2], flips: bool) -> Self {
        self.pictures.push(Picture {
            name: name.into(),
            image: image.clone(),
            label: label.into(),
            alt: alt.into(),
            flips,
        });
        self
    }
}
