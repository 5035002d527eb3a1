//! Pseudocode on Fragment Lists: ppAO and ppDP as Lindholm et al. print them, line by line.
//!
//! A [`super::Line`] works on fragments as they are rasterised. A [`ListLine`] here works on lists that the
//! Fill Step has left, one per pixel, and on a Local Array for a few of their fragments.

use std::fmt;

use super::Pseudocode;
use crate::steps::lines::{Lines, TextLine, text};
use crate::steps::{Amendment, Margin, Met, Ran, Scope, Statement};

/// One statement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ListLine {
    /// `input : list of fragment data per pixel`: the lines are for a single pixel.
    Input,
    /// A comment of the paper.
    Note(&'static str),
    /// `forall the pixels of the framebuffer do`
    Pixels(&'static [ListLine]),
    /// `forall the unresolved pixels of the framebuffer do`: those without [`Mark::Resolved`].
    UnresolvedPixels(&'static [ListLine]),
    /// `foreach i ∈ {8,16, . . . ,max} do`: i doubles. max is the size of the largest Local Array.
    Segments(&'static [ListLine]),
    /// `foreach fragment f ∈ fragment list do`
    Fragments(&'static [ListLine]),
    /// `repeat ... until ...;`: its last line is an [`Until`](Self::Until).
    Repeat(&'static [ListLine]),
    /// The end of a repeat.
    Until(End),
    /// `if ... then ... else ... end`
    If(ListTest, &'static [ListLine], &'static [ListLine]),

    /// `count depth complexity;`
    Count(Counter),
    /// `activate shader program for complexity segment i;`
    ActivateProgram,
    /// `resolve segment with Local Array of size i;`: sorts the first i fragments of the list, and drops the others.
    ResolveSegment,
    /// Resolves the pixel by another algorithm, with a Local Array of size i.
    Run(
        &'static Pseudocode<ListLine>,
        &'static [Amendment<ListLine>],
    ),
    /// `// mark pixel as resolved`
    Mark(Mark),

    /// `n ← sizeof(Local Array);`
    SizeOfLocalArray,
    /// `create buffer with n elements;`
    CreateBuffer,
    /// `set min depth to 0;`
    SetMin(Start),
    /// `initialize current state;`: nothing has been composited.
    InitializeState,
    /// `skip f in current pass;`
    Skip,
    /// `insert f into buffer with insertion sort;`: f goes behind equal elements. If there is then an element n + 1, it
    /// is dropped.
    Insert(Key),
    /// `resolve buffer considering current state;`
    ResolveBuffer(Taken),
    /// `store min depth and state of last buffer element;`: nothing is stored if the buffer is empty.
    Store(Key, Element),
    /// `clear buffer;`
    ClearBuffer,

    /// `foreach fragment f ∈ sorted fragment list do`: by depth, then id.
    Sorted(&'static [ListLine]),
    /// `foreach fragment f ∈ buffer do`: resolves the buffer.
    Elements(&'static [ListLine]),
    /// `ray position, occupancy ← near plane, ...;`
    BeginRay(Beginning),
    /// `cast ray through the occupied volumes up to ...;`, after which the ray's position is there.
    Cast(SegmentEnd),
    /// `toggle the volume of f in occupancy;`
    Toggle,
    /// `blend f;`
    Blend,

    /// Says where the lines that follow come from, or how the paper spells them. It is no statement itself.
    Margin(Margin),
}

impl Statement for ListLine {
    fn margin(&self) -> Option<Margin> {
        match *self {
            Self::Margin(margin) => Some(margin),
            _ => None,
        }
    }

    fn bodies(&self) -> [&'static [Self]; 2] {
        match *self {
            Self::Pixels(body)
            | Self::UnresolvedPixels(body)
            | Self::Segments(body)
            | Self::Fragments(body)
            | Self::Sorted(body)
            | Self::Elements(body)
            | Self::Repeat(body) => [body, &[]],
            Self::If(_, then, otherwise) => [then, otherwise],
            _ => [&[], &[]],
        }
    }

    fn runs(&self) -> Option<Ran<Self>> {
        match *self {
            Self::Run(algorithm, amendments) => Some((algorithm.lines, amendments)),
            _ => None,
        }
    }
}

/// The condition of an `if`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListTest {
    /// `depth complexity(p)<= i`
    FitsSegment,
    /// The same by the stencil buffer, whose reference is at most 255.
    StencilFitsSegment,
    /// The same, and whatever comes to the last segment.
    FitsSegmentOrLast,
    /// `depth complexity(p) > i`
    Overflows,
    /// `depth(f) ≤ min depth`, or with the id.
    NotBehindMin(Key),
    /// `f is of a volume proxy geometry`
    IsProxy,
}

/// The volumes in which a ray begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// None.
    Outside,
    /// The volumes that the list leaves without entering them.
    WhatIsOnlyLeft,
}

/// The end of a segment of a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentEnd {
    /// At a fragment.
    Fragment,
    /// At a fragment, or at the opaque surface if that is nearer.
    FragmentOrOpaque,
}

/// The order of two fragments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// Depth alone.
    Depth,
    /// Depth, and between equal depths the id, which is the place in the order of submission.
    DepthAndId,
}

/// The start of peeling.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Depth 0, with every id.
    Zero,
    /// Before every possible fragment.
    BeforeAll,
}

/// The elements of the buffer that are resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Taken {
    /// All elements.
    All,
    /// The first n - 1 elements if an element was dropped, otherwise all.
    AllButLastOnOverflow,
}

/// The element whose depth becomes min depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// The last element in the buffer.
    Last,
    /// The last element that was resolved.
    LastResolved,
}

/// The end of a repeat.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// It ends when as many fragments have been resolved as the list has.
    AllResolved,
    /// It ends when the subpass has dropped no element.
    NothingDropped,
}

/// The counter of a pixel's fragments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counter {
    /// An integer that is large enough.
    Integer,
    /// Eight bits of stencil by `INCR`, which stays at 255.
    Stencil,
    /// Eight bits of stencil by `INCR_WRAP`, which continues at 0.
    StencilWrapping,
}

/// The mark of a resolved pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A flag, as the paper suggests.
    Resolved,
    /// The stencil operation `KEEP`.
    Keep,
    /// The stencil operation `REPLACE`.
    Replace,
    /// The stencil operation `INVERT`.
    Invert,
}

/// The algorithm as its paper prints it, with `amendments` applied. Without any amendment, it is as it stands here.
pub fn print(algorithm: &Pseudocode<ListLine>, amendments: &[Amendment<ListLine>]) -> String {
    text(&lines(algorithm, amendments))
}

/// The lines of the algorithm, with `amendments` applied.
pub fn lines(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
) -> Vec<TextLine> {
    let mut lines = Lines::of(algorithm.source);
    print_lines(&mut lines, algorithm.lines, Scope::of(amendments), 0);
    lines.done()
}

fn print_lines(
    done: &mut Lines,
    lines: &'static [ListLine],
    scope: Scope<'_, ListLine>,
    indent: usize,
) {
    for met in scope.walk(lines) {
        match met {
            Met::Amendment(it) => {
                // An `until` stands where its `repeat` does.
                let indent = match it.printed {
                    [ListLine::Until(_), ..] => indent - 1,
                    _ => indent,
                };
                done.amendment(&lead(indent), it);
            }
            Met::Statement(line, scope) => print_statement(done, line, scope, indent),
            Met::Line(line, scope) => done.rest(&lead(indent), line, scope),
        }
    }
}

fn print_statement(done: &mut Lines, line: &ListLine, scope: Scope<'_, ListLine>, indent: usize) {
    match line {
        ListLine::Until(_) => done.statement(&lead(indent - 1), line, scope),
        ListLine::Repeat(body) => {
            done.statement(&lead(indent), line, scope);
            print_lines(done, body, scope, indent + 1);
        }
        ListLine::Pixels(body)
        | ListLine::UnresolvedPixels(body)
        | ListLine::Segments(body)
        | ListLine::Fragments(body)
        | ListLine::Sorted(body)
        | ListLine::Elements(body) => {
            done.statement(&lead(indent), line, scope);
            print_lines(done, body, scope, indent + 1);
            done.rest(&lead(indent), "end", scope);
        }
        ListLine::If(_, then, otherwise) => {
            done.statement(&lead(indent), line, scope);
            print_lines(done, then, scope, indent + 1);
            if !otherwise.is_empty() {
                done.rest(&lead(indent), "else", scope);
                print_lines(done, otherwise, scope, indent + 1);
            }
            done.rest(&lead(indent), "end", scope);
        }
        _ => done.statement(&lead(indent), line, scope),
    }
}

fn lead(indent: usize) -> String {
    "  ".repeat(indent)
}

/// A statement's own line, without the statements inside of it.
impl fmt::Display for ListLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Input => "input : list of fragment data per pixel",
            Self::Note(note) => return write!(f, "// {note}"),
            Self::Pixels(_) => "forall the pixels of the framebuffer do",
            Self::UnresolvedPixels(_) => "forall the unresolved pixels of the framebuffer do",
            Self::Segments(_) => "foreach i ∈ {8,16,...,max} do",
            Self::Fragments(_) => "foreach fragment f ∈ fragment list do",
            Self::Repeat(_) => "repeat",
            Self::Until(End::AllResolved) => "until all fragments f ∈ fragment list are resolved;",
            Self::Until(End::NothingDropped) => "until no element was dropped;",
            Self::If(test, ..) => return write!(f, "if {test} then"),
            Self::Count(Counter::Integer) => "count depth complexity;",
            Self::Count(Counter::Stencil) => "count depth complexity by stencil INCR;",
            Self::Count(Counter::StencilWrapping) => "count depth complexity by stencil INCR_WRAP;",
            Self::ActivateProgram => "activate shader program for complexity segment i;",
            Self::ResolveSegment => "resolve segment with Local Array of size i;",
            Self::Run(algorithm, _) => {
                return write!(f, "resolve segment by {};", algorithm.title);
            }
            Self::Mark(Mark::Resolved) => "// mark pixel as resolved",
            Self::Mark(Mark::Keep) => "mark pixel as resolved by stencil KEEP;",
            Self::Mark(Mark::Replace) => "mark pixel as resolved by stencil REPLACE;",
            Self::Mark(Mark::Invert) => "mark pixel as resolved by stencil INVERT;",
            Self::SizeOfLocalArray => "n ← sizeof(Local Array);",
            Self::CreateBuffer => "create buffer with n elements;",
            Self::SetMin(Start::Zero) => "set min depth to 0;",
            Self::SetMin(Start::BeforeAll) => "set min depth, min id to -∞, -1;",
            Self::InitializeState => "initialize current state;",
            Self::Skip => "skip f in current pass;",
            Self::Insert(Key::Depth) => "insert f into buffer with insertion sort;",
            Self::Insert(Key::DepthAndId) => {
                "insert f into buffer with insertion sort by depth, then id;"
            }
            Self::ResolveBuffer(Taken::All) => "resolve buffer considering current state;",
            Self::ResolveBuffer(Taken::AllButLastOnOverflow) => {
                "resolve buffer, on overflow its first n-1 elements, considering current state;"
            }
            Self::Store(key, element) => {
                let key = match key {
                    Key::Depth => "min depth",
                    Key::DepthAndId => "min depth, min id",
                };
                let element = match element {
                    Element::Last => "last buffer element",
                    Element::LastResolved => "last resolved element",
                };
                return write!(f, "store {key} and state of {element};");
            }
            Self::ClearBuffer => "clear buffer;",
            Self::Sorted(_) => "foreach fragment f ∈ sorted fragment list do",
            Self::Elements(_) => "foreach fragment f ∈ buffer do",
            Self::BeginRay(Beginning::Outside) => "ray position, occupancy ← near plane, ∅;",
            Self::BeginRay(Beginning::WhatIsOnlyLeft) => {
                "ray position, occupancy ← near plane, the volumes that the list leaves but does not enter;"
            }
            Self::Cast(SegmentEnd::Fragment) => {
                "cast ray through the occupied volumes up to depth(f);"
            }
            Self::Cast(SegmentEnd::FragmentOrOpaque) => {
                "cast ray through the occupied volumes up to min(depth(f), opaque depth);"
            }
            Self::Toggle => "toggle the volume of f in occupancy;",
            Self::Blend => "blend f;",
            Self::Margin(_) => "",
        })
    }
}

impl fmt::Display for ListTest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::FitsSegment => "depth complexity(p)<= i",
            Self::StencilFitsSegment => "stencil(p) <= min(i, 255)",
            Self::FitsSegmentOrLast => "depth complexity(p)<= i or i = max",
            Self::Overflows => "depth complexity(p) > i",
            Self::IsProxy => "f is of a volume proxy geometry",
            Self::NotBehindMin(Key::Depth) => "depth(f) ≤ min depth",
            Self::NotBehindMin(Key::DepthAndId) => "(depth(f), id(f)) ≤ (min depth, min id)",
        })
    }
}
