//! `onionskin complexity`: how many layers each pixel has.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use onionskin::low_level::image::{FileKind, check_writable};
use onionskin::low_level::words::Words;
use onionskin::report::{self, Measure, Panels, PlotKind};
use onionskin::{Complexity, CountBy, Error, Result};
use serde::Serialize;

use super::output::{print_json, say};
use super::setup::Setup;
use super::words::one_of;

/// Count how many layers each pixel has, and print their histogram
///
/// Depth complexity is the number of transparent fragments of a pixel that no opaque surface hides. It determines the
/// cost of a method: peeling takes a pass for each layer of the deepest pixel, and fragment lists take memory for every
/// fragment. The picture is inverted as in Lindholm et al.: a white pixel has no fragment, a black one the most.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Complexities {
    #[command(flatten)]
    setup: Setup,
    /// The file of the picture of all pixels' complexities: .png with a scale, .exr with the values alone, 1 less the part
    /// of the most layers
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The file of the histogram's plot, .svg or .png. Its axis of pixels is logarithmic
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
    /// The file of the histogram's numbers, .csv
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// The number of complexities in a bin of the histogram
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    bin: u32,
    /// How fragments are counted. The result is the same, except that stencil ends at 255
    #[arg(long, value_name = "BY", value_parser = one_of(CountBy::VALUES), default_value_t = CountBy::Blending)]
    by: CountBy,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin complexity scene.toml
  onionskin complexity model.obj -o layers.png --plot histogram.svg --csv histogram.csv
  onionskin complexity scene.toml --bin 8 --json | jq .percentile_99";

#[derive(Serialize)]
struct Record<'a> {
    scene: &'a str,
    pixels: usize,
    covered: u64,
    coverage: f64,
    fragments: u64,
    max: u32,
    percentile_50: u32,
    percentile_90: u32,
    percentile_99: u32,
    histogram: Vec<[u64; 3]>,
}

impl Complexities {
    pub(super) fn run(self) -> Result<ExitCode> {
        self.check_paths()?;
        let scene = self.setup.scene()?;
        let context = self.setup.gl.context()?;
        let mut renderer = self.setup.renderer(&context, &scene)?;
        let complexity = renderer.complexity(&scene, self.by)?;
        self.write(&scene.name, &complexity)?;
        if self.json {
            print_json(&self.record(&scene.name, &complexity))?;
        } else {
            say(self.text(&complexity))?;
        }
        Ok(ExitCode::SUCCESS)
    }

    /// All faults of the arguments are reported before anything long begins.
    fn check_paths(&self) -> Result<()> {
        if let Some(path) = &self.output {
            FileKind::of(path)?;
        }
        if let Some(path) = &self.plot {
            PlotKind::of(path)?;
        }
        if let Some(path) = &self.csv
            && path.extension().is_none_or(|ending| ending != "csv")
        {
            return Err(Error::FileName {
                path: path.to_owned(),
                kind: "table",
                remedy: "name it .csv",
            });
        }
        let paths = [&self.output, &self.plot, &self.csv];
        paths
            .into_iter()
            .flatten()
            .try_for_each(|path| check_writable(path))
    }

    fn write(&self, name: &str, complexity: &Complexity) -> Result<()> {
        if let Some(path) = &self.output {
            match FileKind::of(path)? {
                FileKind::Exr => report::picture(complexity).save(path)?,
                _ => panel(name, complexity).save(path)?,
            }
        }
        if let Some(path) = &self.plot {
            report::plot(name, complexity, self.bin, PlotKind::of(path)?)?.save(path)?;
        }
        if let Some(path) = &self.csv {
            report::save_text(path, &report::csv(complexity, self.bin))?;
        }
        Ok(())
    }

    fn record<'a>(&self, scene: &'a str, complexity: &Complexity) -> Record<'a> {
        let bins = complexity.histogram(self.bin).into_iter();
        Record {
            scene,
            pixels: complexity.counts.len(),
            covered: complexity.covered(),
            coverage: complexity.coverage(),
            fragments: complexity.fragments(),
            max: complexity.max(),
            percentile_50: complexity.percentile(0.5),
            percentile_90: complexity.percentile(0.9),
            percentile_99: complexity.percentile(0.99),
            histogram: bins
                .map(|bin| [u64::from(bin.from), u64::from(bin.to), bin.pixels])
                .collect(),
        }
    }

    fn text(&self, complexity: &Complexity) -> String {
        let mut text = format!(
            "{:<16} {} of {} ({:.1}%)\n",
            "covered pixels",
            complexity.covered(),
            complexity.counts.len(),
            complexity.coverage() * 100.0
        );
        text += &format!("{:<16} {}\n", "fragments", complexity.fragments());
        text += &format!(
            "{:<16} {} at most; {} or less in 50%, {} in 90%, {} in 99% of the covered pixels\n",
            "layers",
            complexity.max(),
            complexity.percentile(0.5),
            complexity.percentile(0.9),
            complexity.percentile(0.99)
        );
        text += "\nlayers      pixels\n";
        let bins = complexity.histogram(self.bin);
        let most = bins.iter().map(|bin| bin.pixels).max().unwrap_or(0);
        for bin in bins.iter().filter(|bin| bin.pixels > 0) {
            let range = if bin.from == bin.to {
                bin.from.to_string()
            } else {
                format!("{}-{}", bin.from, bin.to)
            };
            let bar = bar(bin.pixels, most);
            text += format!("{range:<9} {:>8} {bar}", bin.pixels).trim_end();
            text.push('\n');
        }
        text.truncate(text.trim_end().len());
        text
    }
}

/// The picture for people, with a scale.
fn panel(name: &str, complexity: &Complexity) -> Panels {
    let (width, height) = (complexity.width, complexity.height);
    let layers = Measure::of_counts(width, height, &complexity.counts).inverted();
    Panels::new(&format!("Depth complexity: {name}")).measure(layers, "layers at each pixel")
}

/// A bar on a logarithmic scale. The longest one has 40 characters.
fn bar(pixels: u64, most: u64) -> String {
    let length = ((pixels + 1) as f64).ln() / ((most + 1) as f64).ln() * 40.0;
    "#".repeat(length.round() as usize)
}
