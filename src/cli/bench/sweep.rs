//! Generated scenes of which each has more of something than the one before: layers, or disorder.

use clap::ValueEnum;
use onionskin::generate::{Quads, SubmissionOrder, quads};
use onionskin::{Camera, Error, Mesh, Method, Result, Rgba, Scene, Vertex};

use super::row::{By, Rows};

/// What grows from scene to scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Sweep {
    /// Depth complexity: 1 to 64 sheets that fill the image, in random order
    Depth,
    /// Disorder: 16 layers everywhere, which cross each other in 1/64 of the image, then in 1/32, up to all of it
    Disorder,
}

/// Layers of the scenes of growing disorder.
const LAYERS: u32 = 16;
/// Strips side by side, in each of which layers may cross each other.
const STRIPS: u32 = 64;
const SIZE: [u32; 2] = [512, 384];
/// From the eye to the first layer. It is far, so that all layers of a strip lie behind each other in the image.
const DISTANCE: f64 = 40.0;

impl Sweep {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Disorder => "disorder",
        }
    }

    /// Checks that what its horizontal axis shows will be counted.
    pub(super) fn check(self, methods: &[Method]) -> Result<()> {
        if self == Self::Disorder && !methods.contains(&Method::VerifiedPainter) {
            return Err(Error::usage(
                "disorder is measured by the pixels that the verified painter marks, and it takes no part",
                "add verified-painter to --method",
            ));
        }
        Ok(())
    }

    /// Its scenes, `size` pixels large if it is given.
    pub(super) fn scenes(self, size: Option<[u32; 2]>) -> Result<Vec<Scene>> {
        let steps = [1, 2, 4, 8, 16, 32, 64];
        let scene = |step| match self {
            Self::Depth => Ok(scene(format!("{step} sheets"), sheets(step)?, size)),
            Self::Disorder => {
                let name = format!("{step} of {STRIPS} strips in disorder");
                Ok(scene(name, strips(step), size))
            }
        };
        steps.into_iter().map(scene).collect()
    }

    /// What the horizontal axis shows.
    pub(super) fn across(self) -> &'static str {
        match self {
            Self::Depth => "depth complexity, fragments per pixel",
            Self::Disorder => {
                "marked pixels, % of the image (order not proved by the verified painter)"
            }
        }
    }

    pub(super) fn caption(self, device: &str, [width, height]: [u32; 2]) -> String {
        let what = match self {
            Self::Depth => "sheets in random order".into(),
            Self::Disorder => format!("{LAYERS} layers, some in disorder"),
        };
        format!("Cost of a frame: {what}, {width} x {height}, {device}")
    }

    /// Where a scene lies on the horizontal axis. `None` if what it takes was not counted.
    pub(super) fn place(self, rows: &Rows<'_>) -> Option<f64> {
        let [width, height] = rows.scene.size.map(f64::from);
        let mut ours = rows.rows.iter().filter(|row| row.by == By::Onionskin);
        match self {
            Self::Depth => {
                let fragments = ours.find_map(|row| row.counts.fragments)?;
                Some(fragments as f64 / (width * height))
            }
            Self::Disorder => {
                let marked = ours.find_map(|row| row.counts.marked_pixels)?;
                Some(100.0 * marked as f64 / (width * height))
            }
        }
    }
}

fn scene(name: String, mesh: Mesh, size: Option<[u32; 2]>) -> Scene {
    let eye = [0.0, 0.0, DISTANCE];
    let mut scene = Scene::of(name, vec![mesh]);
    scene.camera = Camera::looking(eye.into(), [0.0; 3].into());
    scene.size = size.unwrap_or(SIZE);
    scene.background = [1.0; 3];
    scene
}

fn sheets(count: u32) -> Result<Mesh> {
    quads(&Quads {
        count,
        size: [80.0, 60.0],
        spacing: 0.02,
        alpha: 0.1,
        order: SubmissionOrder::Shuffled,
        seed: 1,
        ..Quads::default()
    })
}

/// Strips of layers. In the first so many, each layer is turned about the strip's middle, every second one the other way, so
/// that it goes through others.
fn strips(in_disorder: u32) -> Mesh {
    // Together they are a little wider than an image of 4 to 3.
    let (width, height, spacing) = (0.46, 24.0, 0.02);
    let (mut vertices, mut triangles) = (Vec::new(), Vec::new());
    for strip in 0..STRIPS {
        // In disorder are strips all over the image: each odd number comes once among the remainders of 64.
        let turned = strip * 27 % STRIPS < in_disorder;
        for layer in 0..LAYERS {
            let lean = match (turned, layer % 2) {
                (false, _) => 0.0,
                (true, 0) => 4.0 * spacing,
                (true, _) => -4.0 * spacing,
            };
            // Layers in an order that is not theirs in depth, the same in every strip.
            let depth = -spacing * f64::from(layer * 7 % LAYERS);
            let left = width * (f64::from(strip) - f64::from(STRIPS) / 2.0);
            let color = Rgba::new(
                f32::from(layer % 2 == 0),
                0.5,
                layer as f32 / LAYERS as f32,
                0.2,
            );
            let first = vertices.len() as u32;
            for (side, bottom) in [(0.0, true), (1.0, true), (1.0, false), (0.0, false)] {
                let y = if bottom { -height } else { height };
                vertices.push(Vertex {
                    position: [left + side * width, y, depth + (2.0 * side - 1.0) * lean].into(),
                    normal: [0.0, 0.0, 1.0].into(),
                    color,
                });
            }
            triangles.push([first, first + 1, first + 2]);
            triangles.push([first, first + 2, first + 3]);
        }
    }
    Mesh::new("strips", vertices, triangles)
}
