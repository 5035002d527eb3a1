//! `onionskin inspect`: what a method does to each fragment of a pixel.

mod text;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::{ArgGroup, Args};
use onionskin::inspect::{self, History, Where};
use onionskin::low_level::edition;
use onionskin::low_level::image::check_writable;
use onionskin::low_level::words::Words;
use onionskin::report::save_text;
use onionskin::{Error, Method, Renderer, Result, Scene};

use super::method_options::MethodOptions;
use super::output::{print_json, say};
use super::progress::Progress;
use super::setup::Setup;
use super::words::one_of;

/// Show what a method does to each fragment of a pixel
///
/// Lists every fragment of the pixel, then every pass of the method: which fragments it drew, at which test each of them
/// ended, and what the pixel held afterwards. The method runs on OpenGL, and call by call on an emulated pixel, too. After
/// every pass the values of both are compared. At the end stands the method's image of the pixel beside the exact one, and
/// the first fragment at which they part.
#[derive(Args)]
#[command(after_help = EXAMPLES, group = ArgGroup::new("which").required(true))]
pub(super) struct Inspect {
    #[command(flatten)]
    setup: Setup,
    #[command(flatten)]
    method: MethodOptions,
    /// The pixel's column from the left and row from the top; the first ones are 0
    #[arg(long, value_name = "X,Y", value_parser = pixel, allow_hyphen_values = true, group = "which")]
    pixel: Option<[u32; 2]>,
    /// Take the pixel that is farthest from the exact image. Pixels whose colour hangs on a difference of depth that the
    /// depth buffer cannot hold are taken last
    #[arg(long, group = "which")]
    worst: bool,
    /// Take the pixel with the most layers
    #[arg(long, group = "which")]
    deepest: bool,
    /// Take a pixel at which something happens
    #[arg(long = "where", value_name = "WHAT", group = "which", value_parser = one_of(Where::VALUES))]
    place: Option<Where>,
    /// Count the pixel's row from the bottom, as OpenGL does
    #[arg(long, requires = "pixel")]
    bottom_up: bool,
    /// Print the lines of the listings, too. A letter says where each comes from: see `onionskin listing --help`
    #[arg(long)]
    lines: bool,
    /// Write a page that steps through the passes: one file, .html, which needs no network
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Print one JSON object and nothing else
    ///
    /// It has `scene`, `method`, `chosen`, `size`, `pixel`, `by_distance`, `of_slices`, `fragments` (in the order of submission,
    /// each with its `fate`), `passes` (each with its `lines`, its `events`, and what the pixel `held`), `ray`, `exact`,
    /// `composited`, `parts_at`, `image`, `error`, `list`, `marked`, `stopped`, `agree` and `not_followed`. What they hold, the
    /// documentation of the library says: onionskin::low_level::edition::history_json.
    #[arg(long, conflicts_with = "lines")]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin inspect scene.toml --pixel 320,200 -m depth-peeling
  onionskin inspect scene.toml --worst -m painter           where the painter's algorithm is most wrong, and why
  onionskin inspect scene.toml --where tied -m depth-peeling
  onionskin inspect scene.toml --deepest -m dfb+ppao+ppdp --html pixel.html
  onionskin inspect scene.toml --pixel 0,0 --json | jq '.fragments[].fate'";

impl Inspect {
    pub(super) fn run(self) -> Result<ExitCode> {
        let method = self.method.method()?;
        if let Some(path) = &self.html {
            check_page(path)?;
        }
        let scene = self.setup.scene()?;
        self.method.slices.check_scene(&scene)?;
        let method = self.method.or_automatic(method);
        let context = self.setup.gl.context()?;
        let renderer = self.setup.renderer(&context, &scene)?;
        let mut renderer = self.method.slices.apply_to(renderer)?;
        let progress = Progress::new(1, &format!("inspecting {} by {method}", scene.name));
        let pixel = self.which(&mut renderer, &scene, &method)?;
        let history = inspect::history(&mut renderer, &scene, &method, pixel)?;
        drop(progress);
        self.show(&history)?;
        Ok(ExitCode::SUCCESS)
    }

    fn which(
        &self,
        renderer: &mut Renderer<'_>,
        scene: &Scene,
        method: &Method,
    ) -> Result<[u32; 2]> {
        if let Some([x, y]) = self.pixel {
            let [width, height] = scene.size;
            if self.bottom_up && y >= height {
                return Err(Error::usage(
                    format!("there is no pixel {x},{y} in an image of {width} x {height} pixels"),
                    format!("rows are 0 to {} from the bottom", height - 1),
                ));
            }
            return Ok([x, if self.bottom_up { height - 1 - y } else { y }]);
        }
        let (found, what) = if self.worst {
            let found = inspect::worst(renderer, scene, method)?;
            (found, format!("{method}'s image is exact at every pixel"))
        } else if self.deepest {
            let found = inspect::deepest(renderer, scene)?;
            (found, "no pixel has a transparent fragment".into())
        } else {
            let place = self.place.expect("one of the group is required");
            let found = inspect::find(renderer, scene, method, place)?;
            (
                found,
                format!("no such pixel was found: {}", place.meaning()),
            )
        };
        found.ok_or_else(|| Error::usage(what, "choose a pixel with --pixel X,Y"))
    }

    fn show(&self, history: &History) -> Result<()> {
        if let Some(path) = &self.html {
            save_text(path, &edition::history_page(history)?)?;
        }
        if self.json {
            print_json(&edition::history_json::object(history))
        } else {
            say(text::text(history, self.lines))
        }
    }
}

fn check_page(path: &PathBuf) -> Result<()> {
    if path.extension().is_none_or(|ending| ending != "html") {
        return Err(Error::FileName {
            path: path.to_owned(),
            kind: "page",
            remedy: "name it .html",
        });
    }
    check_writable(path)
}

fn pixel(text: &str) -> Result<[u32; 2], Error> {
    let wrong = || {
        Error::usage(
            format!("'{text}' is not a pixel"),
            "write its column from the left and its row from the top, such as 320,200",
        )
    };
    let (x, y) = text.split_once(',').ok_or_else(wrong)?;
    let number = |text: &str| text.trim().parse().map_err(|_| wrong());
    Ok([number(x)?, number(y)?])
}
