//! `onionskin check`: someone else's image against the exact one.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use onionskin::image::{Comparison, FileKind, Image, check_writable, difference_picture};
use onionskin::{Error, Method, Result};
use serde::Serialize;

use super::output::{print_json, say};
use super::progress::Progress;
use super::setup::Setup;

/// Check an image against the exact one
///
/// Renders the scene exactly, compares, and writes a difference picture of three panels: the image, the exact one, and
/// their difference made visible. Exits with 1 if a channel of a pixel differs by more than the bound.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Check {
    #[command(flatten)]
    setup: Setup,
    /// The image, .png or .exr, of the scene's size. 8-bit values are taken as linear: give no image encoded as sRGB
    image: PathBuf,
    /// The largest difference of a channel that passes, 0 to 1. The default is one step of 8 bits, 1/255: half a step
    /// for rounding to 8 bits, as much again for a renderer that truncates
    #[arg(long, value_name = "DIFFERENCE", default_value_t = 1.0 / 255.0, hide_default_value = true)]
    bound: f64,
    /// Where the difference picture goes, .png or .exr
    #[arg(short, long, value_name = "FILE", default_value = "difference.png")]
    output: PathBuf,
    /// What differences are multiplied by in the picture, to be seen
    #[arg(long, value_name = "FACTOR", default_value_t = 8.0)]
    gain: f32,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin check scene.toml mine.png                       exit code 0: right, at 8 bits
  onionskin check scene.toml mine.exr --bound 1e-5          a float image can be held to more
  onionskin check model.obj mine.png -o out/difference.png --gain 32";

#[derive(Serialize)]
struct Verdict<'a> {
    scene: &'a str,
    image: String,
    passed: bool,
    bound: f64,
    max_error: f64,
    mean_error: f64,
    rms_error: f64,
    percentile_99: f64,
    pixels_over: usize,
    pixels: usize,
    worst_pixel: Option<[u32; 2]>,
    hanging_pixels: usize,
    hanging_pixels_over: usize,
}

impl Check {
    pub(super) fn run(self) -> Result<ExitCode> {
        self.check_arguments()?;
        let image = Image::load(&self.image)?;
        let scene = self.setup.scene()?;
        if [image.width, image.height] != scene.size {
            return Err(Error::usage(
                format!(
                    "{} is {} x {} pixels, but the scene is {} x {}",
                    self.image.display(),
                    image.width,
                    image.height,
                    scene.size[0],
                    scene.size[1]
                ),
                format!("add --size {}x{}", image.width, image.height),
            ));
        }
        let context = self.setup.gl.context()?;
        let progress = Progress::new(1, "rendering the exact image");
        let exact = self
            .setup
            .renderer(&context, &scene)?
            .render(&scene, &Method::Exact)?;
        drop(progress);
        let comparison = Comparison::new(&image, &exact.image, self.bound)?;
        difference_picture(&image, &exact.image, self.gain)?.save(&self.output)?;
        let passed = comparison.over == 0;
        let hangs = |pixel: usize| {
            let hanging = exact.hanging.as_ref();
            hanging.is_some_and(|hanging| hanging.given[pixel])
        };
        let hanging = Comparison::among(&image, &exact.image, self.bound, hangs)?;
        let verdict = Verdict {
            scene: &scene.name,
            image: self.image.display().to_string(),
            passed,
            bound: comparison.bound,
            max_error: comparison.max,
            mean_error: comparison.mean,
            rms_error: comparison.rms,
            percentile_99: comparison.percentile_99,
            pixels_over: comparison.over,
            pixels: image.pixels.len(),
            worst_pixel: comparison.worst,
            hanging_pixels: (0..image.pixels.len())
                .filter(|&pixel| hangs(pixel))
                .count(),
            hanging_pixels_over: hanging.over,
        };
        if self.json {
            print_json(&verdict)?;
        } else {
            say(&verdict)?;
            say(format_args!(
                "{:<16} {}",
                "difference",
                self.output.display()
            ))?;
        }
        Ok(ExitCode::from(u8::from(!passed)))
    }

    /// Whatever can be wrong with the arguments is said before anything long begins.
    fn check_arguments(&self) -> Result<()> {
        if !(self.bound >= 0.0 && self.gain > 0.0 && self.gain.is_finite()) {
            return Err(Error::usage(
                "--bound must not be negative, and --gain must be more than 0",
                "a bound of 0.004 is one step of 8 bits",
            ));
        }
        FileKind::of(&self.output)?;
        check_writable(&self.output)?;
        let same = |a: &Path, b: &Path| Some(a.canonicalize().ok()? == b.canonicalize().ok()?);
        if same(&self.image, &self.output) == Some(true) {
            return Err(Error::usage(
                format!(
                    "the difference picture would replace the image {}",
                    self.image.display()
                ),
                "say where it goes with --output",
            ));
        }
        Ok(())
    }
}

impl fmt::Display for Verdict<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut line = |name: &str, value: &dyn fmt::Display| writeln!(f, "{name:<16} {value}");
        let verdict = if self.passed {
            "exact within the bound"
        } else {
            "differs"
        };
        line("verdict", &verdict)?;
        line("bound", &format_args!("{:.6}", self.bound))?;
        line("maximum", &format_args!("{:.6}", self.max_error))?;
        line(
            "99th percentile",
            &format_args!("{:.6}", self.percentile_99),
        )?;
        line("mean", &format_args!("{:.6}", self.mean_error))?;
        line("rms", &format_args!("{:.6}", self.rms_error))?;
        if let Some([x, y]) = self.worst_pixel {
            line("worst pixel", &format_args!("{x}, {y} (from the top left)"))?;
        }
        let Self {
            pixels_over,
            pixels,
            hanging_pixels,
            hanging_pixels_over,
            ..
        } = self;
        write!(f, "{:<16} {pixels_over} of {pixels}", "pixels over it")?;
        if *hanging_pixels == 0 {
            return Ok(());
        }
        write!(
            f,
            "\n{:<16} {hanging_pixels_over} of them: {hanging_pixels} pixels hang on a difference of depth that a depth \
             buffer between the scene's near and far plane cannot hold",
            "hang on depth"
        )
    }
}
