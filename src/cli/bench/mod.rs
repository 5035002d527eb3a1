//! `onionskin bench`: what methods cost, in rounds.

mod files;
mod measure;
mod methods;
mod rounds;
mod row;
mod statistics;
mod steps;
mod sweep;
mod table;
mod vtk;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use onionskin::{Result, Scene};
use serde::Serialize;

use super::output::{self, print_json, say};
use super::setup::Rendering;
use files::CostPlot;
use measure::{Task, measure, why};
use methods::Asked;
use row::{Fields, Rows};
use steps::Steps;
use sweep::Sweep;
use vtk::{PATIENCE, Vtk};

/// Measure what methods cost, relative to plain blending
///
/// All methods are measured in one process, in rounds: in each round every method draws one frame. So a machine that is
/// busy for a while is busy for all of them. Rounds in which drivers compile shaders do not count. From round to round the
/// eye moves on a little, and a frame's time has everything that a changed view takes: sorting triangles, uploading their
/// order, drawing. Reading the image and writing files are not in it. Times are milliseconds: the median, the smallest and
/// the largest. The ratios are those of medians. They say more than the times, and only within one run.
///
/// Where Python has VTK, three of its modes take part in the rounds, in a process of their own: `alpha` blends in the order
/// of submission, `peel` and `dual` peel without a limit. VTK's image has 8 bits per channel, and its surfaces are not lit.
///
/// Counts are those of the first frame: how often the transparent geometry was drawn, how many fragments lie in lists, and
/// the memory of the method on the GPU besides the geometry. For the verified painter only the fragments of marked pixels
/// lie in lists, whose order it could not prove.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Bench {
    /// Scene files (.toml), or models (.obj), to which a camera is fitted
    #[arg(value_name = "SCENE|MODEL", required_unless_present = "sweep")]
    scenes: Vec<PathBuf>,
    #[command(flatten)]
    rendering: Rendering,
    /// Methods, separated by commas, or all. Plain blending is always among them [default: those that do not draw the
    /// scene again for each layer, and dual-depth-peeling; hybrid-layer-peeling if there are slices or volumes]
    #[arg(short, long, value_name = "METHODS")]
    method: Vec<String>,
    /// The number of rounds. A method whose frames have taken five seconds takes no part in further ones
    #[arg(long, value_name = "N", default_value_t = 9, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    frames: u32,
    /// Show how long the steps of each method take, in further frames in which each step is waited for
    #[arg(long)]
    steps: bool,
    /// The Python whose VTK takes part
    #[arg(long, value_name = "PROGRAM", conflicts_with = "no_vtk")]
    python: Option<PathBuf>,
    /// Leave VTK out
    #[arg(long)]
    no_vtk: bool,
    /// The file of all counts and times, .csv
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// The file of a plot of what methods cost, relative to plain blending, and of the scenes' depth complexities,
    /// .svg or .png. Both axes are logarithmic
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Measure generated scenes, of which each has more of something than the one before. The folder gets the numbers as
    /// a table, and a plot of them
    #[arg(
        long,
        value_name = "WHAT",
        conflicts_with = "scenes",
        requires = "output"
    )]
    sweep: Option<Sweep>,
    /// The folder of a sweep's files: .csv, .svg and .png. It is made if it is missing
    #[arg(short, long, value_name = "FOLDER", requires = "sweep")]
    output: Option<PathBuf>,
    /// Print one JSON object per method and nothing else
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin bench scene.toml
  onionskin bench a.toml b.toml -m verified-painter,dfb+ppdp --frames 41
  onionskin bench scene.toml -m all --csv costs.csv
  onionskin bench --sweep depth -o out/depth
  onionskin bench scene.toml --json | jq 'select(.of_blend < 2) | .method'";

/// The JSON object of a row.
#[derive(Serialize)]
struct Record<'r> {
    #[serde(flatten)]
    fields: Fields,
    #[serde(skip_serializing_if = "Option::is_none", flatten)]
    steps: Option<&'r Steps>,
}

impl Bench {
    pub(super) fn run(self) -> Result<ExitCode> {
        // Faults of the arguments and of the scenes are reported before anything long begins.
        let asked = Asked::of(&self.method)?;
        let scenes = self.scenes()?;
        if let (Some(sweep), Some(first)) = (self.sweep, scenes.first()) {
            sweep.check(&asked.methods(first))?;
        }
        self.check_paths()?;
        let device = self.rendering.gl.context()?.driver().renderer.clone();
        let task = Task {
            rendering: &self.rendering,
            asked: &asked,
            frames: self.frames,
            steps: self.steps,
        };
        let mut measured = Vec::new();
        for scene in &scenes {
            let vtk = self.vtk(scene)?;
            let rows = Rows {
                scene,
                device: &device,
                rows: measure(&task, scene, vtk)?,
            };
            self.print(&rows)?;
            measured.push(rows);
        }
        self.save(&measured)?;
        Ok(ExitCode::SUCCESS)
    }

    /// The scenes that are named, or those of a sweep.
    fn scenes(&self) -> Result<Vec<Scene>> {
        match self.sweep {
            Some(sweep) => sweep.scenes(self.rendering.size()),
            None => {
                let scenes = self.scenes.iter().map(|path| self.rendering.load(path));
                scenes.map(|animation| Ok(animation?.scene)).collect()
            }
        }
    }

    fn save(&self, scenes: &[Rows<'_>]) -> Result<()> {
        if let Some(path) = &self.csv {
            files::save_csv(path, scenes)?;
        }
        let Some(first) = scenes.first() else {
            return Ok(());
        };
        let device = first.device;
        if let Some(path) = &self.plot {
            let plot = CostPlot {
                caption: format!("Cost of a frame on {device}, a mark for each scene"),
                across: "mean depth complexity, fragments per pixel",
                up: "times plain blending",
                joined: false,
            };
            let cost = |rows: &Rows<'_>, ms| rows.base().map(|base| ms / base);
            plot.save(&[path], scenes, |rows| Sweep::Depth.place(rows), cost)?;
        }
        if let (Some(sweep), Some(folder)) = (self.sweep, &self.output) {
            let [csv, svg, png] = files::of_sweep(folder, sweep.name())?;
            files::save_csv(&csv, scenes)?;
            let plot = CostPlot {
                caption: sweep.caption(device, first.scene.size),
                across: sweep.across(),
                up: "milliseconds, median",
                joined: true,
            };
            plot.save(
                &[&svg, &png],
                scenes,
                |rows| sweep.place(rows),
                |_, ms| Some(ms),
            )?;
        }
        Ok(())
    }

    /// VTK with the scene, if it can take part. A note says why it does not, unless nobody expects it to.
    fn vtk(&self, scene: &Scene) -> Result<Option<Vtk>> {
        if self.no_vtk {
            return Ok(None);
        }
        if !scene.volumes.is_empty() {
            output::note(format_args!(
                "VTK takes no part in {}: it has volumes",
                scene.name
            ));
            return Ok(None);
        }
        let python = self.python.as_deref().unwrap_or(Path::new("python3"));
        match Vtk::start(python, scene, PATIENCE) {
            Ok(vtk) => Ok(Some(vtk)),
            Err(error) if self.python.is_some() => Err(error),
            Err(error) => {
                let why = why(&error);
                output::note(format_args!(
                    "{why}, so it takes no part (--python names another)"
                ));
                Ok(None)
            }
        }
    }

    fn check_paths(&self) -> Result<()> {
        if let Some(path) = &self.csv {
            files::check_csv(path)?;
        }
        if let Some(path) = &self.plot {
            files::check_plot(path)?;
        }
        if let (Some(sweep), Some(folder)) = (self.sweep, &self.output) {
            files::of_sweep(folder, sweep.name())?;
        }
        Ok(())
    }

    fn print(&self, rows: &Rows<'_>) -> Result<()> {
        if self.json {
            let mut records = rows.rows.iter().map(|row| Record {
                fields: rows.fields(row),
                steps: row.steps.as_ref(),
            });
            return records.try_for_each(|record| print_json(&record));
        }
        let scene = rows.scene;
        let [width, height] = scene.size;
        let fragments = rows.rows.iter().find_map(|row| row.counts.fragments);
        let fragments = fragments.map_or_else(String::new, |count| format!(", {count} fragments"));
        say(format_args!(
            "{}: {width} x {height}, {} triangles{fragments}, on {}\n{}\n",
            scene.name,
            scene.triangle_count(),
            rows.device,
            table::table(rows)
        ))?;
        for row in &rows.rows {
            if let (Some(steps), Ok(times)) = (&row.steps, &row.times) {
                say(steps.table(&row.method, times.median()) + "\n")?;
            }
        }
        table::left_out(rows).iter().for_each(output::note);
        Ok(())
    }
}
