//! Errors for people: what is wrong, where, and what to do about it.

mod nearest;
mod place;
mod printable;

use std::io;
use std::path::PathBuf;

pub(crate) use nearest::with_slashes;
pub use nearest::{did_you_mean, nearest};
pub use place::Place;
use place::shown;
pub use printable::{printable, printable_json, printable_lines};

/// The crate's result.
pub type Result<T, E = Error> = std::result::Result<T, E>;

/// Everything that can go wrong. Each error has what its reader needs to put it right.
///
/// A printed error says what is wrong and where. The next line says what to do. A program may want to act on some errors:
///
/// | to | match |
/// | --- | --- |
/// | render smaller, or allow more memory | [`Memory`](Self::Memory), [`ImageSize`](Self::ImageSize) |
/// | offer another driver, or another method | [`NoContext`](Self::NoContext), [`Driver`](Self::Driver), [`Lost`](Self::Lost) |
/// | set its OpenGL context right and try again | [`HostContext`](Self::HostContext) |
/// | tell the owner of a file | [`Input`](Self::Input), [`Output`](Self::Output), [`FileName`](Self::FileName) |
/// | offer the known names | [`Unknown`](Self::Unknown) |
/// | correct an option | [`Option`](Self::Option) |
/// | correct a scene that it has built | [`Scene`](Self::Scene) |
/// | correct a listing, or its shaders | [`Listing`](Self::Listing), [`UnknownMap`](Self::UnknownMap), [`UnknownBuffer`](Self::UnknownBuffer), [`UnknownShader`](Self::UnknownShader), [`NoTwin`](Self::NoTwin), [`OutOfOrder`](Self::OutOfOrder), [`CannotPerform`](Self::CannotPerform), [`Shader`](Self::Shader), [`Step`](Self::Step) |
///
/// The other errors are for the person who wrote the call: [`Usage`](Self::Usage), [`SizesDiffer`](Self::SizesDiffer) and
/// [`Plot`](Self::Plot).
///
/// ```
/// use onionskin::{Context, Error, Method, Renderer};
///
/// let Err(Error::Unknown { known, .. }) = "depth-peling".parse::<Method>() else { panic!() };
/// assert!(known.contains(&"depth-peeling".to_owned()));
/// let context = Context::headless()?;
/// let Err(Error::ImageSize { largest, .. }) = Renderer::new(&context, 1 << 30, 1) else { panic!() };
/// assert!(largest < 1 << 30);
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file that cannot be used as it is.
    #[error("{place}: {}\n  {}", printable(.what), printable(.remedy))]
    #[non_exhaustive]
    Input {
        /// The file, and as far as known the line and the word.
        place: Place,
        /// What is wrong with it.
        what: String,
        /// What to do.
        remedy: String,
        /// The system's error, if the file could not be read.
        source: Option<io::Error>,
    },
    /// A result that could not be written. Nothing is left at `path`.
    #[error("cannot write {}: {}\n  {}", shown(.path), printable(.what), printable(.remedy))]
    Output {
        /// The path at which it should be.
        path: PathBuf,
        /// What stands in the way.
        what: String,
        /// What to do.
        remedy: String,
        /// The system's error, if it is one.
        source: Option<io::Error>,
    },
    /// A name of a file whose ending says that it is of another kind than was asked for.
    #[error("{}: this is not the name of a {kind}\n  {remedy}", shown(.path))]
    FileName {
        /// The name.
        path: PathBuf,
        /// The kind of file that was asked for, such as `picture`.
        kind: &'static str,
        /// The endings that such files have.
        remedy: &'static str,
    },
    /// More memory is wanted than may be taken. Nothing was taken.
    #[error("{}{}\n  {MORE_MEMORY}", at(.place), printable(.what))]
    #[non_exhaustive]
    Memory {
        /// The place in a file that wants it, if a file does.
        place: Option<Place>,
        /// What takes how much, and how much there is, as a sentence.
        what: String,
        /// The bytes that are wanted.
        wanted: u64,
        /// The bytes that may be taken.
        left: u64,
    },
    /// No way to OpenGL was found.
    #[error("no OpenGL 4.3 driver was found:\n{}\n  {INSTALL}", list(.tried))]
    NoContext {
        /// The ways that were tried, in order.
        tried: Vec<Attempt>,
    },
    /// The driver cannot do what is needed.
    #[error("{what}\n  {remedy}")]
    #[non_exhaustive]
    Driver {
        /// What it lacks.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// The driver refuses everything: it is out of memory, or its device is lost.
    #[error("the driver cannot {doing}: {answer}\n  {LOST}")]
    #[non_exhaustive]
    Lost {
        /// What it was asked to do, as in `make a texture`.
        doing: String,
        /// What it answers.
        answer: String,
    },
    /// Someone else's OpenGL context is not in a state in which it can be used, and given back as it was. Nothing in it
    /// was changed.
    #[error("{what}\n  {remedy}")]
    #[non_exhaustive]
    HostContext {
        /// The state.
        what: String,
        /// What to do before the call.
        remedy: String,
    },
    /// The driver does not render images of this size.
    #[error(
        "an image of {width} x {height} pixels cannot be rendered\n  this driver renders 1 x 1 to {largest} x {largest}"
    )]
    #[non_exhaustive]
    ImageSize {
        /// Pixels per row.
        width: u32,
        /// Rows.
        height: u32,
        /// The largest width and height that the driver renders.
        largest: u32,
    },
    /// Two pictures of different sizes cannot be compared.
    #[error("a picture of {} x {} cannot be compared to one of {} x {}\n  render both at the same size", .a[0], .a[1], .b[0], .b[1])]
    #[non_exhaustive]
    SizesDiffer {
        /// Width and height of the one.
        a: [u32; 2],
        /// Width and height of the other.
        b: [u32; 2],
    },
    /// A part of a scene, made by code, that cannot be rendered: a mesh, a volume, a camera, a generator's parameter.
    #[error("{}\n  {}", printable(.what), printable(.remedy))]
    #[non_exhaustive]
    Scene {
        /// The part, and what is wrong with it.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// A plot that could not be drawn.
    #[error("{what} cannot be plotted: {answer}\n  write the numbers instead")]
    #[non_exhaustive]
    Plot {
        /// The numbers.
        what: &'static str,
        /// The answer of the program that draws.
        answer: String,
    },
    /// A shader that the driver does not take, or whose includes are wrong.
    #[error("{file} does not compile:\n{log}")]
    #[non_exhaustive]
    Shader {
        /// The shader's file, as in `glsl/peel.frag`; a user's own as it was named.
        file: String,
        /// What the driver says, with the files named.
        log: String,
    },
    /// OpenGL reported an error after a step.
    #[error("OpenGL says {error} after the step {step}")]
    #[non_exhaustive]
    Step {
        /// The step, its arguments named.
        step: String,
        /// OpenGL's name for the error.
        error: String,
    },
    /// A listing that cannot run, as a check finds before it does.
    #[error("'{listing}' {what}\n  {remedy}")]
    #[non_exhaustive]
    Listing {
        /// The listing's title.
        listing: &'static str,
        /// What is wrong in it, and where.
        what: String,
        /// What to do.
        remedy: String,
    },
    /// A listing names a map that was not allocated.
    #[error("the listing names the map '{map}', which does not exist\n  {remedy}")]
    #[non_exhaustive]
    UnknownMap {
        /// The map's name.
        map: String,
        /// The map that was probably meant, or what to do.
        remedy: String,
    },
    /// A listing names a buffer that was not allocated.
    #[error("the listing names the buffer '{buffer}', which does not exist\n  {remedy}")]
    #[non_exhaustive]
    UnknownBuffer {
        /// The buffer's name.
        buffer: String,
        /// The buffer that was probably meant, or what to do.
        remedy: String,
    },
    /// A listing names a shader that is neither one of onionskin's own nor one that it was given.
    #[error("the listing names the shader '{shader}', which does not exist\n  {remedy}")]
    UnknownShader {
        /// The shader's name.
        shader: String,
        /// The shader that was probably meant.
        remedy: String,
    },
    /// The emulated pixel cannot run this shader.
    #[error("the emulated pixel has no twin of the shader '{shader}'\n  it has {}", .known.join(", "))]
    #[non_exhaustive]
    NoTwin {
        /// The shader's name.
        shader: String,
        /// The shaders that have a twin.
        known: Vec<&'static str>,
    },
    /// A step that needs an earlier one, which was not performed.
    #[error("{what}\n  {remedy}")]
    #[non_exhaustive]
    OutOfOrder {
        /// What the step does too early.
        what: String,
        /// The step that comes first.
        remedy: String,
    },
    /// A call that a machine does not have.
    #[error("{machine} cannot perform {call}: {why}\n  {remedy}")]
    #[non_exhaustive]
    CannotPerform {
        /// The machine.
        machine: &'static str,
        /// The call, its arguments named.
        call: String,
        /// The reason.
        why: &'static str,
        /// What to do instead.
        remedy: &'static str,
    },
    /// A value that an option cannot have. The option is a method's, or the renderer's.
    #[error("{}\n  {}", printable(.what), printable(.remedy))]
    #[non_exhaustive]
    Option {
        /// The option's name, in small letters and hyphens.
        option: String,
        /// What is wrong with the value.
        what: String,
        /// What to choose instead.
        remedy: String,
    },
    /// A name that nothing has: of a method, of a listing, of an option's value.
    #[error("there is no {kind} '{}'\n  {}", printable(.name), did_you_mean(.name, .known))]
    #[non_exhaustive]
    Unknown {
        /// The kind of thing that was named, without an article: `method`.
        kind: &'static str,
        /// The name.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// A request that makes no sense, whatever the files say. A program has nothing to act on but the text.
    ///
    /// The command line has it for its arguments, which no program sees but this one. The library has it where one value
    /// is parsed or counted, such as an amount of memory or the number of a frame: the caller knows which value it gave.
    /// If a method's option is chosen by its name, the error is an [`Option`](Self::Option) with that name.
    #[error("{}\n  {}", printable(.what), printable(.remedy))]
    #[non_exhaustive]
    Usage {
        /// What was asked for.
        what: String,
        /// What to ask for instead.
        remedy: String,
    },
}

/// A way to OpenGL that led nowhere.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Attempt {
    /// The way that was tried.
    pub what: String,
    /// The answer of the system or of the driver.
    pub answer: String,
}

const MORE_MEMORY: &str = "Ask for less, or allow more memory.";

const LOST: &str = "it is out of memory or lost: close what else uses the GPU, then start anew";

const INSTALL: &str =
    "install or update Mesa's software renderer, then try again (`onionskin doctor` shows what is there):
    Debian, Ubuntu: apt install libegl1 libgl1-mesa-dri (and libosmesa6, where there is one)
    Fedora:         dnf install mesa-libEGL mesa-dri-drivers
    Arch:           pacman -S mesa";

/// The place before what is said about it.
fn at(place: &Option<Place>) -> String {
    place
        .as_ref()
        .map_or(String::new(), |place| format!("{place}: "))
}

fn list(tried: &[Attempt]) -> String {
    tried
        .iter()
        .map(|Attempt { what, answer }| format!("  {what}: {answer}"))
        .collect::<Vec<_>>()
        .join("\n")
}

/// The remedy for a resource that was not allocated. It may be one that was, misspelt.
fn allocated_first(name: &str, allocated: impl IntoIterator<Item = String>) -> String {
    let mut allocated: Vec<_> = allocated.into_iter().collect();
    allocated.sort();
    let known: Vec<_> = allocated.iter().map(String::as_str).collect();
    match nearest(name, &known) {
        Some(meant) => format!("Did you mean '{meant}'? Otherwise allocate it first."),
        None => "Allocate it first.".into(),
    }
}

impl Error {
    /// A file that cannot be used as it is.
    pub fn input(place: Place, what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Input {
            place,
            what: what.into(),
            remedy: remedy.into(),
            source: None,
        }
    }

    /// The same error of a file, with the system's as its source.
    #[must_use]
    pub(crate) fn caused_by(mut self, error: io::Error) -> Self {
        if let Self::Input { source, .. } | Self::Output { source, .. } = &mut self {
            *source = Some(error);
        }
        self
    }

    /// A value that an option cannot have.
    pub fn option(
        option: impl Into<String>,
        what: impl Into<String>,
        remedy: impl Into<String>,
    ) -> Self {
        Self::Option {
            option: option.into(),
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// A map that is not among those that were allocated.
    pub(crate) fn unknown_map(map: String, allocated: impl IntoIterator<Item = String>) -> Self {
        let remedy = allocated_first(&map, allocated);
        Self::UnknownMap { map, remedy }
    }

    /// A buffer that is not among those that were allocated.
    pub(crate) fn unknown_buffer(
        buffer: String,
        allocated: impl IntoIterator<Item = String>,
    ) -> Self {
        let remedy = allocated_first(&buffer, allocated);
        Self::UnknownBuffer { buffer, remedy }
    }

    /// A step of a listing that needs an earlier one.
    pub(crate) fn out_of_order(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::OutOfOrder {
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// A part of a scene, made by code, that cannot be rendered.
    pub(crate) fn scene(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Scene {
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// A state of someone else's context.
    pub(crate) fn host(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::HostContext {
            what: what.into(),
            remedy: remedy.into(),
        }
    }

    /// A name that nothing has.
    pub(crate) fn unknown(kind: &'static str, name: &str, known: &[impl AsRef<str>]) -> Self {
        let known = known.iter().map(|known| known.as_ref().to_owned());
        Self::Unknown {
            kind,
            name: name.to_owned(),
            known: known.collect(),
        }
    }

    /// A request that makes no sense.
    pub fn usage(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Usage {
            what: what.into(),
            remedy: remedy.into(),
        }
    }
}
