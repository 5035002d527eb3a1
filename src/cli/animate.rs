//! `onionskin animate`: a camera path as numbered pictures and a table.

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;
use onionskin::{Animation, Error, Method, Renderer, Result};
use serde::Serialize;

use super::encoding::EncodingOption;
use super::frame_folder::FrameFolder;
use super::frame_row::FrameRow;
use super::method_options::MethodOptions;
use super::output::{note, print_json, say};
use super::progress::Progress;
use super::setup::Setup;

/// Render a scene's camera path to numbered pictures and a table
///
/// The folder gets frame-00000.png and so on. Beside each picture, frame-00000.csv has the frame's time, complexity and
/// counters. frames.csv joins these rows. A frame that is whole is kept, so an interrupted command continues when it is
/// repeated. Several commands may fill one folder at once, each with frames of its own. The folder refuses frames of
/// another scene, method or size. Without [path] in the scene file, the camera turns once in 36 frames.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Animate {
    #[command(flatten)]
    setup: Setup,
    #[command(flatten)]
    method: MethodOptions,
    /// The folder of the pictures. It is made if it is missing
    #[arg(short, long, value_name = "FOLDER")]
    output: PathBuf,
    /// Only the frames from A to B, counted from 0; B itself is left out
    #[arg(long, value_name = "A..B", value_parser = frames)]
    frames: Option<Range<u32>>,
    #[command(flatten)]
    encoding: EncodingOption,
    /// Print one JSON object and nothing else
    #[arg(long)]
    json: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin animate scene.toml -o frames -m exact
  onionskin animate scene.toml -o frames -m ppll+ppao --size 512x384
  onionskin animate scene.toml -o frames --frames 100..200   the second of a job array's parts";

/// The JSON object of an animation.
#[derive(Serialize)]
struct Done<'a> {
    scene: &'a str,
    method: &'a str,
    frames: u32,
    rendered: u32,
    kept: u32,
    in_table: u32,
    table: &'a Path,
}

impl Animate {
    pub(super) fn run(self) -> Result<ExitCode> {
        let method = self.method.method()?;
        if self.method.chosen.has("layers") {
            return Err(Error::usage(
                "an animation has no place for layers",
                "Leave out --layers, or render one frame's with `onionskin render`.",
            ));
        }
        let animation = self.setup.animation()?;
        if !animation.has_path {
            let scene = self.setup.scene.display();
            let frames = animation.path.frames;
            note(format_args!(
                "{scene} has no [path]: the camera turns once, in {frames} frames"
            ));
        }
        self.method.slices.check_scene(&animation.scene)?;
        let method = self.method.or_automatic(method);
        let range = self.range(animation.path.frames)?;
        let context = self.setup.gl.context()?;
        let renderer = self.setup.renderer(&context, &animation.scene)?;
        let mut renderer = self.method.slices.apply_to(renderer)?;
        let folder = FrameFolder::open(&self.output, &self.identity(&animation, &method))?;
        let rendered = self.fill(&folder, &animation, &method, &mut renderer, range.clone())?;
        let (table, in_table) = folder.join(animation.path.frames)?;
        let kept = range.len() as u32 - rendered;
        if self.json {
            print_json(&Done {
                scene: &animation.scene.name,
                method: &method.to_string(),
                frames: animation.path.frames,
                rendered,
                kept,
                in_table,
                table: &table,
            })?;
        } else {
            let all = animation.path.frames;
            let table = table.display();
            say(format_args!(
                "{rendered} frames rendered, {kept} kept; {in_table} of {all} are in {table}"
            ))?;
        }
        Ok(ExitCode::SUCCESS)
    }

    fn range(&self, all: u32) -> Result<Range<u32>> {
        let range = self.frames.clone().unwrap_or(0..all);
        if range.end > all {
            return Err(Error::usage(
                format!(
                    "frames {}..{} are asked for, of {all}",
                    range.start, range.end
                ),
                format!("Ask for frames within 0..{all}, or set `frames` in the scene's [path]."),
            ));
        }
        Ok(range)
    }

    /// Everything that the pictures depend on. The folder keeps it as its first file.
    fn identity(&self, animation: &Animation, method: &Method) -> Vec<(&'static str, String)> {
        let [width, height] = animation.scene.size;
        vec![
            ("scene", format!("{:08x}", animation.fingerprint())),
            ("frames", animation.path.frames.to_string()),
            ("size", format!("{width}x{height}")),
            ("method", format!("{method:?}")),
            ("slices", self.method.slices.to_string()),
            ("formats", self.setup.formats()),
            ("encoding", format!("{:?}", self.encoding.encoding())),
        ]
    }

    /// Renders the frames that are missing, and returns their number.
    fn fill(
        &self,
        folder: &FrameFolder,
        animation: &Animation,
        method: &Method,
        renderer: &mut Renderer,
        range: Range<u32>,
    ) -> Result<u32> {
        let name = &animation.scene.name;
        let progress = Progress::new(range.len() as u64, &format!("{name} by {method}"));
        let encoding = self.encoding.encoding();
        let mut rendered = 0;
        for span in animation.spans(range) {
            let mut film = renderer.film(animation.frame(span.start)?, method);
            for number in span {
                if !folder.has(number) {
                    let camera = animation.camera(number)?;
                    if rendered == 0 {
                        // The first frame compiles the shaders, which does not count as its time.
                        film.frame(camera)?;
                    }
                    let (frame, complexity) = film.frame_and_count(camera, Default::default())?;
                    let row = FrameRow::new(number, &frame.stats, &complexity);
                    folder.add(number, &frame.image, encoding, &row.csv())?;
                    rendered += 1;
                }
                progress.part_done();
            }
        }
        Ok(rendered)
    }
}

fn frames(text: &str) -> Result<Range<u32>, Error> {
    let wrong = || {
        Error::usage(
            format!("'{text}' is not a range of frames"),
            "write A..B, such as 0..100; A is the first frame, B the first one that is left out",
        )
    };
    let (start, end) = text.split_once("..").ok_or_else(wrong)?;
    let number = |text: &str| text.parse::<u32>().map_err(|_| wrong());
    let range = number(start)?..number(end)?;
    if range.is_empty() {
        return Err(wrong());
    }
    Ok(range)
}
