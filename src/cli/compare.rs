//! `onionskin compare`: several methods on one scene.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use comfy_table::{CellAlignment, Table, presets};
use onionskin::low_level::image::check_writable;
use onionskin::options::Reading;
use onionskin::report::{Panels, PlotKind};
use onionskin::{Context, CountBy, Method, Renderer, Result, Scene, Stats, registry};

use super::loss::loss;
use super::output::{self, print_json, say};
use super::progress::Progress;
use super::record::{Errors, FRAMES, Record};
use super::setup::Setup;
use super::slices::Slices;

/// Compare methods on one scene: passes, time, and error against the exact image
///
/// Iterations are the rounds of the method's loop. Passes are how often the transparent geometry was drawn. Lost
/// fragments belong in the image and are not in it. Memory is what the method allocates on the GPU besides the
/// geometry. Times are milliseconds per frame: the median of several frames after a warm-up, without readback. They can
/// be compared only within one run. Errors are differences of a channel from the exact image, 0 to 1. They leave out
/// pixels that depend on a difference of depth that the depth buffer cannot hold; these pixels are counted below the
/// table.
///
/// For methods with fragment lists there is a second table. It has the bytes of the lists in the largest band, the
/// number of records read from the lists, the number of walks of all pixels' lists and of the list that was walked most
/// often, and how many elements of local arrays were reserved and how many of them held a fragment at some time.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Compare {
    #[command(flatten)]
    setup: Setup,
    #[command(flatten)]
    slices: Slices,
    /// Methods, separated by commas, or all; `onionskin methods` describes them
    #[arg(short, long, value_name = "METHODS", default_value = "all")]
    method: String,
    /// Run each method in every reading of its paper that it has: literally, with what fills the paper's silence, and
    /// amended. What a reading loses is lost to the paper's silence or to its errors
    #[arg(long)]
    readings: bool,
    /// A sheet of all images, each with its method's name and its largest error, .png or .svg
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Print one JSON object per method and nothing else
    #[arg(long)]
    json: bool,
}

/// The panels in a row of the sheet.
const COLUMNS: usize = 4;

const EXAMPLES: &str = "\
Examples:
  onionskin compare scene.toml
  onionskin compare scene.toml -m blend,weighted-blended,depth-peeling -o sheet.png
  onionskin compare scene.toml -m coherent-layer-peeling-a --readings
  onionskin compare model.obj -m blend,depth-peeling --size 640x480
  onionskin compare scene.toml --json | jq 'select(.max_error > 0.01) | .method'";

impl Compare {
    pub(super) fn run(self) -> Result<ExitCode> {
        // Wrong names of methods are reported before anything long begins.
        let mut methods = self.methods()?;
        if let Some(path) = &self.output {
            PlotKind::of(path)?;
            check_writable(path)?;
        }
        let scene = self.setup.scene()?;
        self.slices.check_scene(&scene)?;
        if self.method == "all" && !scene.volumes.is_empty() {
            let sliced = self.slices.is_given();
            methods.retain(|method| {
                let volumes = method.entry().volumes;
                volumes.are_rendered() || sliced && volumes.take_slices()
            });
        }
        let context = self.setup.gl.context()?;
        if self.method == "all" {
            methods.retain(|method| runs_here(method, &context));
        }
        let mut renderer = self
            .slices
            .apply_to(self.setup.renderer(&context, &scene)?)?;
        let most = match self.readings {
            true => Reading::ALL.len() as u64,
            false => 1,
        };
        let progress = Progress::new(methods.len() as u64 * most + 1, "exact");
        let exact = self.setup.exact(&mut renderer, &scene)?;
        progress.part_done();
        let mut results = Vec::new();
        let mut sheet = Panels::new(&format!("{}, by several methods", scene.name))
            .columns(COLUMNS)
            .picture(&exact.image, "exact");
        for method in methods {
            for reading in self.readings_of(&method) {
                progress.next(&method.to_string());
                let method = read(method, reading, &mut renderer, &scene)?;
                let frame = renderer.measure(&scene, &method, FRAMES)?;
                let error = Errors::new(&frame, &exact)?;
                progress.part_done();
                // Without a sheet no method's image is kept, because many of them may be large.
                if self.output.is_some() {
                    sheet = sheet.picture(&frame.image, &caption(&frame.stats, reading, &error));
                }
                results.push(Row {
                    stats: frame.stats,
                    error,
                    reading: reading.map(Reading::name),
                });
            }
        }
        drop(progress);
        if let Some(path) = &self.output {
            sheet.save(path)?;
        }
        if self.json {
            for row in &results {
                let record = Record::new(&scene.name, &row.stats, &row.error);
                print_json(&record.read(row.reading))?;
            }
        } else {
            say(table(&results, self.readings))?;
            say(format_args!(
                "{} fragments in {} x {} pixels",
                exact.stats.fragments, scene.size[0], scene.size[1]
            ))?;
            if let Some(hanging) = hanging(&results) {
                say(hanging)?;
            }
            if let Some(lists) = table_of_lists(&results, self.readings) {
                say(format_args!("\n{lists}"))?;
            }
        }
        for row in &results {
            if let Some(note) = loss(&row.stats) {
                output::note(note);
            }
        }
        Ok(ExitCode::SUCCESS)
    }

    /// The readings in which a method runs: `None` if it has none, or none is asked for.
    fn readings_of(&self, method: &Method) -> Vec<Option<Reading>> {
        let has_readings = method
            .choices()
            .iter()
            .any(|choice| choice.name == "as-printed");
        match self.readings && has_readings {
            true => Reading::ALL.map(Some).to_vec(),
            false => vec![None],
        }
    }

    fn methods(&self) -> Result<Vec<Method>> {
        match self.method.as_str() {
            "all" => Ok(registry().iter().map(|entry| entry.method).collect()),
            names => names.split(',').map(|name| name.trim().parse()).collect(),
        }
    }
}

/// A method that reads its paper like this. Everitt's text is told how many passes it makes: as many as the deepest pixel
/// has transparent layers, and one for the opaque one.
fn read(
    mut method: Method,
    reading: Option<Reading>,
    renderer: &mut Renderer<'_>,
    scene: &Scene,
) -> Result<Method> {
    if let Some(reading @ (Reading::Literal | Reading::AsPrinted)) = reading {
        method.choose(reading.name(), "")?;
        if let Method::DepthPeeling(options) = &mut method {
            options.maximum_number_of_peels =
                renderer.complexity(scene, CountBy::Blending)?.max() + 1;
        }
    }
    Ok(method)
}

/// What a panel of the sheet shows.
fn caption(stats: &Stats, reading: Option<Reading>, error: &Errors) -> String {
    let reading = reading.map_or(String::new(), |reading| format!(", {}", reading.name()));
    let error = match error.real.max {
        error if error < 0.01 => format!("{error:.1e}"),
        error => format!("{error:.2}"),
    };
    format!("{}{reading}: largest error {error}", stats.method)
}

/// What came of a method.
struct Row {
    stats: Stats,
    error: Errors,
    reading: Option<&'static str>,
}

/// Whether a method runs here. A note says which one does not.
fn runs_here(method: &Method, context: &Context) -> bool {
    let entry = method.entry();
    let runs = entry.runs_on(context.driver());
    if !runs {
        let needs = entry.needs.join(" or ");
        output::note(format_args!("{method} left out: it needs {needs}"));
    }
    runs
}

/// Notes about the pixels that the errors leave out: their number, and how wrong they are.
fn hanging(results: &[Row]) -> Option<String> {
    let pixels = results.first()?.error.hanging_pixels;
    let worst = results
        .iter()
        .map(|row| row.error.hanging.max)
        .fold(0.0, f64::max);
    (pixels > 0).then(|| {
        format!(
            "{pixels} pixels hang on a difference of depth that the depth buffer cannot hold: left out of the errors, off by \
             {worst:.2e} at most"
        )
    })
}

fn table(results: &[Row], readings: bool) -> Table {
    let header = [
        "method",
        "reading",
        "iterations",
        "passes",
        "lost",
        "memory MiB",
        "ms",
        "max error",
        "rms error",
        "stopped",
    ];
    // Which reading, and why it stopped, where it may not have ended by itself.
    let shown = |column: &usize| readings || ![1, header.len() - 1].contains(column);
    let rows = results.iter().map(|row| {
        let Row {
            stats,
            error,
            reading,
        } = row;
        [
            stats.method.clone(),
            reading.unwrap_or_default().into(),
            stats.iterations.to_string(),
            stats.geometry_passes.to_string(),
            stats
                .lost
                .map_or_else(|| "not counted".into(), |lost| lost.to_string()),
            mebibytes(stats.bytes),
            format!("{:.1}", stats.ms),
            format!("{:.2e}", error.real.max),
            format!("{:.2e}", error.real.rms),
            stats.stopped_text(),
        ]
    });
    table_of(&header, shown, rows)
}

/// The costs of fragment lists, for the methods that have them.
fn table_of_lists(results: &[Row], readings: bool) -> Option<Table> {
    let header = [
        "fragment lists",
        "reading",
        "bands",
        "list MiB",
        "records read",
        "subpasses",
        "most",
        "slots reserved",
        "used",
    ];
    let shown = |column: &usize| readings || *column != 1;
    let rows = results.iter().filter_map(|row| {
        let counts = row.stats.a_buffer.as_ref()?;
        Some([
            row.stats.method.clone(),
            row.reading.unwrap_or_default().into(),
            counts.bands.to_string(),
            mebibytes(counts.list_bytes),
            counts.records_read.to_string(),
            counts.subpasses.to_string(),
            counts.most_subpasses.to_string(),
            counts.slots_reserved.to_string(),
            counts.slots_used.to_string(),
        ])
    });
    let table = table_of(&header, shown, rows);
    (table.row_count() > 0).then_some(table)
}

/// A table of the columns that are shown.
fn table_of<const COLUMNS: usize>(
    header: &[&str; COLUMNS],
    shown: impl Fn(&usize) -> bool,
    rows: impl Iterator<Item = [String; COLUMNS]>,
) -> Table {
    let shown: Vec<usize> = (0..COLUMNS).filter(shown).collect();
    let mut table = Table::new();
    table
        .load_style(presets::NOTHING)
        .set_header(shown.iter().map(|&column| header[column]));
    for cells in rows {
        table.add_row(shown.iter().map(|&column| &cells[column]));
    }
    numbers_to_the_right(table)
}

/// The cells after the method's name.
fn numbers_to_the_right(mut table: Table) -> Table {
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

fn mebibytes(bytes: u64) -> String {
    format!("{:.1}", bytes as f64 / f64::from(1 << 20))
}
