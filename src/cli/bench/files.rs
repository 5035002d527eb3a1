//! The files that a bench writes: a table of numbers, a plot.

use std::path::{Path, PathBuf};

use onionskin::low_level::image::check_writable;
use onionskin::report::{CostLine, PlotKind, costs, save_text};
use onionskin::{Error, Result};

use super::row::Rows;

/// Checks, before a long computation, that a table could be written there.
pub(super) fn check_csv(path: &Path) -> Result<()> {
    if path.extension().is_none_or(|ending| ending != "csv") {
        return Err(Error::FileName {
            path: path.to_owned(),
            kind: "table",
            remedy: "name it .csv",
        });
    }
    check_writable(path)
}

/// Checks, before a long computation, that a plot could be written there.
pub(super) fn check_plot(path: &Path) -> Result<()> {
    PlotKind::of(path)?;
    check_writable(path)
}

/// The files of a sweep, in a folder that is made if it is missing.
pub(super) fn of_sweep(folder: &Path, name: &str) -> Result<[PathBuf; 3]> {
    if !folder.is_dir() {
        std::fs::create_dir(folder).map_err(|error| Error::Output {
            path: folder.to_owned(),
            what: error.to_string(),
            remedy: "name a folder. The folder that it is in has to exist".into(),
            source: Some(error),
        })?;
    }
    let files = ["csv", "svg", "png"].map(|ending| folder.join(name).with_extension(ending));
    files.iter().try_for_each(|file| check_writable(file))?;
    Ok(files)
}

/// The numbers of all scenes, under one line of names.
pub(super) fn save_csv(path: &Path, scenes: &[Rows<'_>]) -> Result<()> {
    let tables = scenes.iter().enumerate();
    let text: String = tables.map(|(number, rows)| rows.csv(number == 0)).collect();
    save_text(path, &text)
}

/// A plot of what each method takes, in milliseconds or times plain blending.
pub(super) struct CostPlot<'p> {
    pub(super) caption: String,
    pub(super) across: &'p str,
    pub(super) up: &'p str,
    pub(super) joined: bool,
}

impl CostPlot<'_> {
    /// Writes the plot. `place` is a scene's place along the horizontal axis, and `cost` what is shown of a median of
    /// milliseconds. Scenes without a place are left out.
    pub(super) fn save(
        &self,
        paths: &[&Path],
        scenes: &[Rows<'_>],
        place: impl Fn(&Rows<'_>) -> Option<f64>,
        cost: impl Fn(&Rows<'_>, f64) -> Option<f64>,
    ) -> Result<()> {
        let mut lines: Vec<CostLine> = Vec::new();
        for rows in scenes {
            let Some(x) = place(rows).filter(|&x| x > 0.0) else {
                continue;
            };
            for row in &rows.rows {
                let Some(y) = row
                    .times
                    .as_ref()
                    .ok()
                    .and_then(|times| cost(rows, times.median()))
                else {
                    continue;
                };
                let name = row.name();
                match lines.iter_mut().find(|line| line.name == name) {
                    Some(line) => line.points.push([x, y]),
                    None => lines.push(CostLine {
                        name,
                        points: vec![[x, y]],
                        joined: self.joined,
                    }),
                }
            }
        }
        let [svg, png] = costs(&self.caption, self.across, self.up, &lines)?;
        for path in paths {
            match PlotKind::of(path)? {
                PlotKind::Svg => svg.save(path)?,
                _ => png.save(path)?,
            }
        }
        Ok(())
    }
}
