//! `onionskin render`: one image.

use std::panic::resume_unwind;
use std::path::PathBuf;
use std::process::ExitCode;
use std::thread;

use clap::Args;
use onionskin::low_level::image::{FileKind, check_writable};
use onionskin::{Frame, Method, Result};

use super::encoding::EncodingOption;
use super::loss::loss;
use super::method_options::MethodOptions;
use super::output::{self, print_json, say};
use super::progress::Progress;
use super::record::{Errors, FRAMES, Record};
use super::setup::{SCENE_FILES, Setup};
use super::stages::Stages;

/// Render a scene by one method
///
/// Writes the image and prints what the method did: how many passes it made, why it stopped, and how many fragments
/// that belong in the image are not in it.
#[derive(Args)]
#[command(after_help = EXAMPLES, after_long_help = format!("{EXAMPLES}\n\n{SCENE_FILES}"))]
pub(super) struct Render {
    #[command(flatten)]
    setup: Setup,
    #[command(flatten)]
    method: MethodOptions,
    /// The file of the image: .png (8 bits) or .exr (32-bit float)
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    #[command(flatten)]
    encoding: EncodingOption,
    /// Print one JSON object and nothing else; adds the error against the exact image
    #[arg(long)]
    json: bool,
    /// Print where the time goes, from the start of the command to the picture. The frame is rendered a second time,
    /// which says how much of the first one went into compiling shaders
    #[arg(long, conflicts_with = "json")]
    times: bool,
}

const EXAMPLES: &str = "\
Examples:
  onionskin render model.obj -o model.png                               the exact image
  onionskin render scene.toml -m painter -o painter.exr --size 800x600  triangles sorted
  onionskin render scene.toml -o four.png --peels 4 --layers           the four nearest layers
  onionskin render scene.toml -m coherent-layer-peeling-a -o a.png --sort objects
  onionskin render scene.toml -o scene.png --json | jq .lost";

impl Render {
    pub(super) fn run(self) -> Result<ExitCode> {
        let mut stages = Stages::begin();
        // All faults of the arguments are reported before anything long begins.
        let method = self.method.method()?;
        FileKind::of(&self.output)?;
        check_writable(&self.output)?;
        // Side by side, because a large model takes seconds to read, and a driver takes a twentieth of one to start.
        let (scene, context) = thread::scope(|scope| {
            let scene = scope.spawn(|| self.setup.scene());
            let context = self.setup.gl.context();
            (scene.join(), context)
        });
        let scene = scene.unwrap_or_else(|panic| resume_unwind(panic))?;
        self.method.slices.check_scene(&scene)?;
        let method = self.method.or_automatic(method);
        let context = context?;
        let mut renderer = self
            .method
            .slices
            .apply_to(self.setup.renderer(&context, &scene)?)?;
        stages.done("reading, OpenGL context");
        if self.method.chosen.has("layers") {
            let peels = self.method.chosen.value("peels").unwrap_or("0");
            let peels = peels.parse().unwrap_or(0);
            self.setup.check_layers(&mut renderer, &scene, peels)?;
        }
        let progress = Progress::new(1, &format!("rendering {} by {method}", scene.name));
        // A picture needs one frame, but a time that can be compared needs several.
        let frame = if self.json {
            renderer.measure(&scene, &method, FRAMES)?
        } else if method == Method::Exact {
            self.setup.exact(&mut renderer, &scene)?
        } else {
            renderer.render(&scene, &method)?
        };
        if self.times {
            let again = renderer.render(&scene, &method)?;
            let compiling = (frame.stats.ms - again.stats.ms).max(0.0);
            stages.frame_done(&frame, compiling);
        }
        let error = if self.json {
            let exact = self.setup.exact(&mut renderer, &scene)?;
            Some(Errors::new(&frame, &exact)?)
        } else {
            None
        };
        self.write(&frame)?;
        stages.done("writing the picture");
        drop(progress);
        match error {
            Some(error) => print_json(&Record::new(&scene.name, &frame.stats, &error))?,
            None => say(&frame.stats)?,
        }
        if self.times {
            say(format_args!("\n{stages}"))?;
        }
        if let Some(note) = loss(&frame.stats) {
            output::note(note);
        }
        Ok(ExitCode::SUCCESS)
    }

    /// This comes last, so that an earlier error leaves no file behind.
    fn write(&self, frame: &Frame) -> Result<()> {
        let encoding = self.encoding.encoding();
        // Listing 1 as printed keeps its layers even if they are not asked for.
        let layers = if self.method.chosen.has("layers") {
            &frame.layers[..]
        } else {
            &[]
        };
        let paths: Vec<_> = (0..layers.len()).map(|n| self.layer_path(n)).collect();
        for path in &paths {
            check_writable(path)?;
        }
        for (layer, path) in layers.iter().zip(&paths) {
            layer.color.save_as(path, encoding)?;
        }
        frame.image.save_as(&self.output, encoding)
    }

    fn layer_path(&self, number: usize) -> PathBuf {
        let stem = self
            .output
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy();
        let ending = self
            .output
            .extension()
            .unwrap_or_default()
            .to_string_lossy();
        self.output
            .with_file_name(format!("{stem}-layer-{number}.{ending}"))
    }
}
