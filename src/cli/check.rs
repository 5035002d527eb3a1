//! `onionskin check`: someone else's image against the exact one.

use std::fmt;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use onionskin::low_level::image::{FileKind, check_writable, resemblance};
use onionskin::report::{Measure, Panels};
use onionskin::{Comparison, Error, Frame, Image, Result, Scene, difference_picture};
use serde::Serialize;

use super::output::{note, print_json, say};
use super::progress::Progress;
use super::setup::Setup;

/// Check an image against the exact one
///
/// Renders the scene exactly, compares, and writes a difference picture of three panels: the image, the exact image,
/// and their difference made visible. Exits with 1 if a channel of a pixel differs by more than the bound. If the
/// difference looks like one of the usual mistakes (sRGB, alpha, flips, shifts, channels, background), it says which.
///
/// Pixels whose colour hangs on a difference of depth that a depth buffer cannot hold are counted apart, and pass. As the
/// image may be a GPU's, corners of triangles are allowed to be off by half of 1/256 of a pixel.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Check {
    #[command(flatten)]
    setup: Setup,
    /// The image, .png or .exr, of the scene's size. 8-bit values are taken as linear, so the image must not be encoded
    /// as sRGB
    image: PathBuf,
    /// The largest difference of a channel that passes, 0 to 1. The default is one step of 8 bits, 1/255: half a step
    /// for rounding to 8 bits, and half a step for a renderer that truncates
    #[arg(long, value_name = "DIFFERENCE", default_value_t = 1.0 / 255.0, hide_default_value = true)]
    bound: f64,
    /// The file of the difference picture: .png with captions and a scale, .exr with the three panels' values alone
    /// [default: difference.png, if it can be written]
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The factor by which differences are multiplied in the picture, to make them visible. The scale ends at 1/FACTOR
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
    looks_like: Option<String>,
}

/// The difference picture's default file.
const DIFFERENCE: &str = "difference.png";

impl Check {
    pub(super) fn run(self) -> Result<ExitCode> {
        self.check_arguments()?;
        // Only the header is read first: a small file may hold an enormous picture, or say that it does.
        let size = Image::size_of_file(&self.image)?;
        let scene = self.setup.scene()?;
        self.check_size(size, scene.size)?;
        let image = Image::load_within(&self.image, &self.setup.memory())?;
        let context = self.setup.gl.context()?;
        let progress = Progress::new(1, "rendering the exact image");
        let mut renderer = self.setup.renderer(&context, &scene)?;
        let exact = self.setup.exact(&mut renderer, &scene)?;
        drop(progress);
        let comparison = Comparison::new(&image, &exact.image, self.bound)?;
        let verdict = self.verdict(&scene, &image, &exact, &comparison)?;
        let picture = self.write(&scene.name, &image, &exact.image)?;
        if self.json {
            print_json(&verdict)?;
        } else {
            say(&verdict)?;
            if let Some(path) = picture {
                say(format_args!("{:<16} {}", "difference", path.display()))?;
            }
        }
        Ok(ExitCode::from(u8::from(!verdict.passed)))
    }

    fn verdict<'a>(
        &self,
        scene: &'a Scene,
        image: &Image,
        exact: &Frame,
        comparison: &Comparison,
    ) -> Result<Verdict<'a>> {
        let passed = comparison.over == 0;
        let hangs = |pixel: usize| {
            let hanging = exact.hanging.as_ref();
            hanging.is_some_and(|hanging| hanging.given[pixel])
        };
        let hanging = Comparison::among(image, &exact.image, self.bound, hangs)?;
        let looks_like = if passed {
            None
        } else {
            resemblance(image, &exact.image, self.bound, scene.background)
        };
        Ok(Verdict {
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
            looks_like: looks_like.map(|it| it.to_string()),
        })
    }

    /// Writes the difference picture to --output, or to its default file if that is possible. The verdict does not
    /// depend on it.
    fn write(&self, scene: &str, image: &Image, exact: &Image) -> Result<Option<&Path>> {
        if let Some(path) = &self.output {
            match FileKind::of(path)? {
                FileKind::Exr => difference_picture(image, exact, self.gain)?.save(path)?,
                _ => self.panels(scene, image, exact)?.save(path)?,
            }
            return Ok(Some(path));
        }
        match self.panels(scene, image, exact)?.save(DIFFERENCE) {
            Ok(()) => Ok(Some(Path::new(DIFFERENCE))),
            Err(Error::Output { what, .. }) => {
                note(format_args!(
                    "no difference picture, {DIFFERENCE} cannot be written here: {what} (-o says where it goes)"
                ));
                Ok(None)
            }
            Err(other) => Err(other),
        }
    }

    /// The picture for people, with captions, and a scale that ends where a difference times the gain is 1.
    fn panels(&self, scene: &str, image: &Image, exact: &Image) -> Result<Panels> {
        let difference = Measure::difference(image, exact)?.up_to(1.0 / f64::from(self.gain));
        let title = format!("{}, checked against {scene}", self.image.display());
        Ok(Panels::new(&title)
            .picture(image, "the image")
            .picture(exact, "exact")
            .measure(difference, "largest difference of a channel"))
    }

    fn check_size(&self, [width, height]: [u32; 2], of_scene: [u32; 2]) -> Result<()> {
        if [width, height] == of_scene {
            return Ok(());
        }
        let (image, [w, h]) = (self.image.display(), of_scene);
        Err(Error::usage(
            format!("{image} is {width} x {height} pixels, but the scene is {w} x {h}"),
            format!("add --size {width}x{height}"),
        ))
    }

    /// All faults of the arguments are reported before anything long begins.
    fn check_arguments(&self) -> Result<()> {
        if !(0.0..=1.0).contains(&self.bound) {
            return Err(Error::usage(
                format!("--bound is {}, and differences are from 0 to 1", self.bound),
                "a bound of 0.004 is one step of 8 bits",
            ));
        }
        if !(self.gain > 0.0 && self.gain.is_finite()) {
            return Err(Error::usage(
                format!("--gain is {}, and must be more than 0", self.gain),
                "a gain of 8 shows a difference of an eighth as white",
            ));
        }
        let output = self.output.as_deref();
        if let Some(path) = output {
            FileKind::of(path)?;
            check_writable(path)?;
        }
        let same = |a: &Path, b: &Path| Some(a.canonicalize().ok()? == b.canonicalize().ok()?);
        if same(&self.image, output.unwrap_or(Path::new(DIFFERENCE))) == Some(true) {
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
        if *hanging_pixels > 0 {
            write!(
                f,
                "\n{:<16} {hanging_pixels_over} of them: {hanging_pixels} pixels hang on a difference of depth that a depth \
                 buffer between the scene's near and far plane cannot hold",
                "hang on depth"
            )?;
        }
        if let Some(sentence) = &self.looks_like {
            write!(f, "\n{:<16} {sentence}", "looks like")?;
        }
        Ok(())
    }
}
