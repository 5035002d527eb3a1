//! A pixel's history, as plain data.

use std::fmt;

use super::composite::Composite;
use super::fates::Fate;
use crate::emulator::{FragmentOutcome, InList, Resolve};
use crate::fragment::{Rgba, Source};
use crate::steps::{Held, Origin, Reason};

/// What a method has done at a pixel.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct History {
    /// The scene's name.
    pub scene: String,
    /// The method's name.
    pub method: String,
    /// The method that drew, if `method` chooses one.
    pub chosen: Option<String>,
    /// The image's width and height.
    pub size: [u32; 2],
    /// The pixel's column from the left and row from the top.
    pub pixel: [u32; 2],
    /// Whether depths are distances from the eye along the view direction: where 1/w is stored in place of window-space depth.
    /// What colour maps hold is as it is stored.
    pub by_distance: bool,
    /// Whether volumes are drawn as slices. The exact image is that of the slices, then.
    pub of_slices: bool,
    /// The fragments at the pixel, opaque ones too, in the order of submission. Their numbers, s0, s1 and so on, are their
    /// places in this list.
    pub fragments: Vec<FragmentHistory>,
    /// Every draw, with what it did.
    pub passes: Vec<Pass>,
    /// The fragments in the exact image, nearest first.
    pub exact: Composite,
    /// The parts of the ray that are inside of volumes, nearest first, in the exact image. Empty without volumes, and where
    /// they are drawn as slices.
    pub ray: Vec<RaySegment>,
    /// The fragments in the method's image, nearest first, or `None` if its steps are no compositing of fragments one by
    /// one, or cannot be followed.
    pub composited: Option<Composite>,
    /// The first place, from the front, at which the two have different fragments, or one of them ends.
    pub parts_at: Option<usize>,
    /// The colour in the method's image, as OpenGL has it.
    pub image: [f32; 4],
    /// The largest difference of a channel from the exact colour.
    pub error: f64,
    /// What resolving the pixel's fragment list took, if the method has lists.
    pub list: Option<ListCosts>,
    /// Whether the verified painter could not prove the pixel's order, or `None` by other methods.
    pub marked: Option<bool>,
    /// The reason for which the method's loop ended, if it has one.
    pub stopped: Option<Reason>,
    /// The steps that the emulated pixel could not follow, with the reason. From the first of them on, it is not compared.
    pub not_followed: Vec<String>,
}

/// A part of a pixel's ray, between two surfaces or faces of volumes' boxes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RaySegment {
    /// The distances from the eye at which it begins and ends, along the view direction.
    pub distances: [f64; 2],
    /// The names of the volumes in which it is.
    pub volumes: Vec<String>,
    /// The light that the pixel has from it.
    pub light: [f64; 3],
    /// The part of all light that it stops on the way from behind it to the eye.
    pub stopped: f64,
}

/// What resolving a fragment list takes, as the resolve shader counts it on OpenGL.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct ListCosts {
    /// The records that were read, each as often as it was.
    pub records_read: u32,
    /// The fragments that were composited.
    pub composited: u32,
    /// How often the list was walked.
    pub subpasses: u32,
    /// The Local Array's elements that were reserved, and those of them that held a fragment.
    pub slots: [u32; 2],
}

/// A fragment, and what became of it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct FragmentHistory {
    /// The name of its mesh.
    pub mesh: String,
    /// The number of its triangle in the mesh.
    pub triangle: u32,
    /// Whether it is opaque.
    pub opaque: bool,
    /// The window-space depth of the point where the ray through the pixel's centre meets the triangle, computed in f64; with
    /// [`History::by_distance`] its distance from the eye along the view direction.
    pub depth: f64,
    /// The same as OpenGL has computed it.
    pub stored_depth: f32,
    /// The colour, with straight alpha.
    pub color: Rgba,
    /// The last pass in which it passed every test, counted from 0: the one that peeled, composited or stored it, or `None`
    /// if there is none. If it is lost, another fragment may have taken its place in that pass.
    pub pass: Option<usize>,
    /// The part of its colour that is in the exact image of the pixel, 0 to 1, but for what volumes stop.
    pub exact_weight: f64,
    /// The part of its colour that is in the method's image, likewise, found on the emulated pixel, or `None` if that could not
    /// follow.
    pub weight: Option<f64>,
    /// What became of it.
    pub fate: Fate,
    /// Why it is not in the image, if it is lost and not tied.
    pub loss: Option<Loss>,
}

/// Why a fragment is lost that belongs in the image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Loss {
    /// The pixel's list had no room for it.
    NoRoom,
    /// The Local Array was full, and it was dropped.
    Dropped,
    /// The loop ended before it was peeled, for this reason.
    Ended(Reason),
    /// No pass has drawn it.
    NeverDrawn,
    /// It was drawn, and is not in the image: others took its place.
    Replaced,
}

impl Loss {
    /// The name in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Self::NoRoom => "no_room",
            Self::Dropped => "dropped",
            Self::Ended(_) => "ended",
            Self::NeverDrawn => "never_drawn",
            Self::Replaced => "replaced",
        }
    }
}

impl fmt::Display for Loss {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoRoom => f.write_str("no room in the list"),
            Self::Dropped => f.write_str("dropped, because the Local Array was full"),
            Self::Ended(reason) => write!(f, "not peeled before the loop ended: {reason}"),
            Self::NeverDrawn => f.write_str("never drawn"),
            Self::Replaced => f.write_str("drawn, but replaced by others"),
        }
    }
}

/// A draw, with the lines that lead to it.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Pass {
    /// The calls since the last draw, and the draw itself as the last one.
    pub lines: Vec<Line>,
    /// The program that drew.
    pub program: String,
    /// Whether it drew over the screen, and not surfaces.
    pub over_screen: bool,
    /// What happened to each fragment that was drawn, in the order of drawing. Empty if it drew over the screen.
    pub events: Vec<Event>,
    /// How it resolved the pixel's fragment list, subpass by subpass, if it did and if the emulated pixel could follow.
    /// Fragments have their numbers, and faces of boxes their ids ([`name`]). With volumes it has the ray, too.
    pub resolve: Option<Resolve>,
    /// What the pixel of the framebuffer holds after the draw, on OpenGL.
    pub held: Held,
    /// What the emulated pixel holds, or `None` if it could not follow. Numbers that run through all pixels, as of lists'
    /// records, are its own after the pixel's first one on OpenGL, which is compared with what the emulated machine's prefix
    /// scan makes of all pixels' counts.
    pub emulated: Option<Held>,
    /// How the two differ, in words.
    pub differences: Vec<String>,
}

/// A call, with the line that it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// The title of the listing.
    pub title: &'static str,
    /// Where the listing is printed: paper, section, listing.
    pub source: &'static str,
    /// The line as its listing prints it.
    pub text: String,
    /// The call, with the values of its variables.
    pub call: String,
    /// Where the line comes from, or `None` if nothing says so.
    pub origin: Option<Origin>,
}

/// What happened to a fragment when it was drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// The fragment's number, or the id of a face of the box around a volume ([`name`]).
    pub fragment: u32,
    /// The stage at which it ended.
    pub outcome: FragmentOutcome,
    /// The stencil value before and after it.
    pub stencil: [u8; 2],
    /// The stored depth before and after it.
    pub depth: [f32; 2],
    /// What became of it in the pixel's fragment list, if the program makes one.
    pub list: Option<InList>,
    /// The nodes after it, nearest first, each as the fragments that were merged into it, if the program makes nodes of
    /// fragments. Empty if not.
    pub nodes: Vec<Vec<u32>>,
}

impl History {
    /// Whether the emulated pixel could follow any pass, so that OpenGL was compared with it.
    pub fn is_compared(&self) -> bool {
        self.passes.iter().any(|pass| pass.emulated.is_some())
    }

    /// Every difference between OpenGL and the emulated pixel, with the number of the pass.
    pub fn differences(&self) -> impl Iterator<Item = (usize, &str)> {
        let passes = self.passes.iter().enumerate();
        passes.flat_map(|(number, pass)| {
            let differences = pass.differences.iter();
            differences.map(move |difference| (number, difference.as_str()))
        })
    }
}

/// What a fragment of this number is called: `s3`, or of a face of the box around volume 0 `v0 in` where the ray enters it, and
/// `v0 out` where it leaves it.
pub fn name(number: u32) -> String {
    match Source::of(number) {
        Source::Surface(number) => format!("s{number}"),
        Source::Proxy { volume, leaves } => match leaves {
            false => format!("v{volume} in"),
            true => format!("v{volume} out"),
        },
    }
}
