//! Running pseudocode on Fragment Lists, one list per pixel.

mod followed;
mod pixel;
mod ray;

pub use followed::{ExecutedListLine, ListState};
use pixel::{Peel, Pixel, orders};
pub use pixel::{Resolved, Subpass};
use ray::Ray;
pub use ray::{RayEvent, RayHappening, RayRun, RayScene, RayVolume};

use crate::error::{Error, Result};
use crate::fragment::{Fragment, Source};
use crate::steps::pseudo::Pseudocode;
use crate::steps::pseudo::list::{End, Key, ListLine, ListTest, Taken};
use crate::steps::{Amendment, Met, Scope};

/// The result of an algorithm.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ListRun {
    /// The result at each pixel.
    pub pixels: Vec<Resolved>,
    /// Whether every `repeat` ended by itself. If not, it was left after the limit.
    pub ended: bool,
}

/// ppAO's first complexity segment.
const FIRST_SEGMENT: u32 = 8;

/// Runs an algorithm on lists of fragments, one per pixel. `array` is the size of the Local Array, or of the last
/// segment's. A `repeat` is left after `limit` subpasses.
///
/// # Errors
/// If the array has no element, if the first segment's array is larger, or if a line stands where it has nothing to
/// work on.
pub fn run_on_lists(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
    lists: &[Vec<Fragment>],
    array: u32,
    limit: u32,
) -> Result<ListRun> {
    follow_on_lists(algorithm, amendments, lists, array, limit, &mut |_| {})
}

/// The same, and `follower` is told of every line that is executed: of a loop before each round, of a line that runs another
/// algorithm before it does, of all others afterwards. Lines at which there is nothing to do are not told.
///
/// # Errors
/// As [`run_on_lists`].
pub fn follow_on_lists(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
    lists: &[Vec<Fragment>],
    array: u32,
    limit: u32,
    follower: &mut dyn FnMut(&ExecutedListLine<'_>),
) -> Result<ListRun> {
    let pixels = lists.iter().map(|list| Pixel::new(list)).collect();
    let run = run_on_pixels(algorithm, amendments, pixels, (array, limit), follower)?;
    Ok(run.resolved())
}

/// The same with a ray cast between the fragments of each list. A fragment's `order` is a record's id, of a proxy or of
/// a surface ([`Source::id`]).
///
/// # Errors
/// As [`run_on_lists`].
pub fn run_on_rays(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
    pixels: &[(Vec<Fragment>, RayScene<'_>)],
    array: u32,
    limit: u32,
) -> Result<(ListRun, Vec<RayRun>)> {
    let pixels = pixels.iter().map(|(list, scene)| Pixel {
        ray: Some(Ray::new(scene)),
        ..Pixel::new(list)
    });
    let (pixels, follower) = (pixels.collect(), &mut |_: &ExecutedListLine<'_>| {});
    let run = run_on_pixels(algorithm, amendments, pixels, (array, limit), follower)?;
    let rays = run.pixels.iter().filter_map(|pixel| pixel.ray.as_ref());
    let rays = rays.map(|ray| ray.done.clone()).collect();
    Ok((run.resolved(), rays))
}

fn run_on_pixels<'a, 'f>(
    algorithm: &Pseudocode<ListLine>,
    amendments: &[Amendment<ListLine>],
    pixels: Vec<Pixel<'a>>,
    (array, limit): (u32, u32),
    follower: &'f mut dyn FnMut(&ExecutedListLine<'_>),
) -> Result<Run<'a, 'f>> {
    if array == 0 {
        return Err(Error::option(
            "array",
            "a Local Array of 0 takes no fragment",
            "choose 1 or more",
        ));
    }
    let mut run = Run {
        follower,
        pixels,
        array,
        limit,
        ended: true,
    };
    let nowhere = Here {
        pixel: None,
        fragment: None,
        size: array,
    };
    if algorithm.lines.contains(&ListLine::Input) {
        for pixel in 0..run.pixels.len() {
            run.resolve(pixel, algorithm, amendments, array)?;
        }
    } else {
        run.lines(algorithm.lines, Scope::of(amendments), nowhere)?;
    }
    Ok(run)
}

struct Run<'a, 'f> {
    follower: &'f mut dyn FnMut(&ExecutedListLine<'_>),
    pixels: Vec<Pixel<'a>>,
    array: u32,
    limit: u32,
    ended: bool,
}

/// The place at which a line is executed.
#[derive(Clone, Copy)]
struct Here {
    pixel: Option<usize>,
    fragment: Option<Fragment>,
    /// i, or the size of the Local Array.
    size: u32,
}

/// A line that is executed again and again, and those inside of it.
#[derive(Clone, Copy)]
struct Loop<'s> {
    line: &'static ListLine,
    body: &'static [ListLine],
    scope: Scope<'s, ListLine>,
}

impl Run<'_, '_> {
    fn lines(
        &mut self,
        lines: &'static [ListLine],
        scope: Scope<'_, ListLine>,
        here: Here,
    ) -> Result<()> {
        for met in scope.walk(lines) {
            if let Met::Statement(line, scope) = met {
                self.line(line, scope, here)?;
            }
        }
        Ok(())
    }

    fn line(
        &mut self,
        line: &'static ListLine,
        scope: Scope<'_, ListLine>,
        here: Here,
    ) -> Result<()> {
        let of = |body| Loop { line, body, scope };
        match *line {
            ListLine::Pixels(body) | ListLine::UnresolvedPixels(body) => {
                self.each_pixel(of(body), here)
            }
            ListLine::Segments(body) => self.segments(of(body), here),
            ListLine::Fragments(body) => {
                let pixel = self.pixel(here, line)?;
                pixel.begin_pass();
                for &fragment in pixel.list {
                    self.pixel(here, line)?.done.records_read += 1;
                    let fragment = Some(fragment);
                    self.round(of(body), Here { fragment, ..here })?;
                }
                Ok(())
            }
            ListLine::Sorted(body) => {
                let pixel = self.pixel(here, line)?;
                pixel.begin_pass();
                pixel.done.records_read += pixel.list.len() as u32;
                let fragments = pixel.sorted();
                pixel.pass().array = orders(&fragments);
                self.resolve_each(fragments, of(body), here)
            }
            ListLine::Elements(body) => {
                let fragments = self.peel(here, line)?.resolve(Taken::All);
                self.pixel(here, line)?.pass().array = orders(&fragments);
                self.resolve_each(fragments, of(body), here)
            }
            ListLine::Repeat(body) => self.repeat(of(body), here),
            ListLine::If(test, then, otherwise) => {
                let holds = self.holds(test, here, line)?;
                self.tell(line, here, Some(holds));
                self.lines(if holds { then } else { otherwise }, scope, here)
            }
            ListLine::Run(algorithm, its_amendments) => {
                let pixel = here.pixel.ok_or_else(|| misplaced(line))?;
                self.tell(line, here, None);
                self.resolve(pixel, algorithm, its_amendments, here.size)
            }
            ListLine::Until(_) => Err(misplaced(line)),
            _ => self.statement(line, here),
        }
    }

    /// Runs a statement that has no others inside.
    fn statement(&mut self, line: &ListLine, here: Here) -> Result<()> {
        match *line {
            // There is nothing to do here. The list exists, the size chooses the program, and no volume has a state.
            ListLine::Input
            | ListLine::Margin(_)
            | ListLine::Note(_)
            | ListLine::ActivateProgram
            | ListLine::SizeOfLocalArray
            | ListLine::InitializeState => return Ok(()),
            // A fragment that is not inserted is skipped.
            ListLine::Skip => {
                let fragment = here.fragment.ok_or_else(|| misplaced(line))?;
                self.pixel(here, line)?.pass().skipped.push(fragment.order);
            }
            ListLine::Count(counter) => self.pixel(here, line)?.count(counter),
            ListLine::Mark(mark) => self.pixel(here, line)?.mark(mark, here.size),
            ListLine::ResolveSegment => self.pixel(here, line)?.resolve_statically(here.size),
            ListLine::CreateBuffer => self.pixel(here, line)?.peel = Some(Peel::new(here.size)),
            ListLine::SetMin(start) => self.peel(here, line)?.start(start),
            ListLine::Insert(key) => {
                let fragment = here.fragment.ok_or_else(|| misplaced(line))?;
                let dropped = self.peel(here, line)?.insert(fragment, key);
                let pass = self.pixel(here, line)?.pass();
                pass.dropped.extend(dropped.map(|fragment| fragment.order));
            }
            ListLine::ResolveBuffer(taken) => {
                let peel = self.peel(here, line)?;
                let array = orders(&peel.buffer);
                let taken = peel.resolve(taken);
                let pixel = self.pixel(here, line)?;
                pixel.pass().array = array;
                pixel.composite(&taken);
            }
            ListLine::Store(key, element) => self.peel(here, line)?.store(key, element),
            ListLine::ClearBuffer => self.peel(here, line)?.buffer.clear(),
            ListLine::BeginRay(beginning) => {
                let pixel = self.pixel(here, line)?;
                let ray = pixel.ray.as_mut().ok_or_else(|| misplaced(line))?;
                ray.begin(beginning, pixel.list);
            }
            ListLine::Cast(_) | ListLine::Toggle | ListLine::Blend => {
                let f = here.fragment.ok_or_else(|| misplaced(line))?;
                let ray = self.pixel(here, line)?.ray.as_mut();
                let ray = ray.ok_or_else(|| misplaced(line))?;
                match *line {
                    ListLine::Cast(end) => ray.cast(end, f),
                    ListLine::Toggle => ray.toggle(f),
                    _ => ray.blend(f),
                }
            }
            _ => return Err(misplaced(line)),
        }
        self.tell(line, here, None);
        Ok(())
    }

    fn tell(&mut self, line: &ListLine, here: Here, holds: Option<bool>) {
        (self.follower)(&ExecutedListLine {
            line,
            pixel: here.pixel,
            fragment: here.fragment.map(|fragment| fragment.order),
            size: here.size,
            holds,
            pixels: &self.pixels,
        });
    }

    /// A round of a loop.
    fn round(&mut self, it: Loop<'_>, here: Here) -> Result<()> {
        self.tell(it.line, here, None);
        self.lines(it.body, it.scope, here)
    }

    fn each_pixel(&mut self, it: Loop<'_>, here: Here) -> Result<()> {
        for pixel in 0..self.pixels.len() {
            if matches!(it.line, ListLine::Pixels(_)) || !self.pixels[pixel].marked {
                let pixel = Some(pixel);
                self.round(it, Here { pixel, ..here })?;
            }
        }
        Ok(())
    }

    /// Composites fragments in this order, each by the lines of the body.
    fn resolve_each(&mut self, fragments: Vec<Fragment>, it: Loop<'_>, here: Here) -> Result<()> {
        for fragment in fragments {
            self.pixel(here, it.line)?.composite(&[fragment]);
            let fragment = Some(fragment);
            self.round(it, Here { fragment, ..here })?;
        }
        Ok(())
    }

    fn segments(&mut self, it: Loop<'_>, here: Here) -> Result<()> {
        if self.array < FIRST_SEGMENT {
            return Err(Error::option(
                "array",
                format!(
                    "the last segment cannot be {}: the first is {FIRST_SEGMENT}",
                    self.array
                ),
                "choose 8, 16, 32 ...",
            ));
        }
        let segments = std::iter::successors(Some(FIRST_SEGMENT), |i| i.checked_mul(2));
        let array = self.array;
        for size in segments.take_while(|&i| i <= array) {
            self.round(it, Here { size, ..here })?;
        }
        Ok(())
    }

    /// The loop's end is its last line.
    fn repeat(&mut self, it: Loop<'_>, here: Here) -> Result<()> {
        for _ in 0..self.limit {
            self.peel(here, it.line)?.dropped = false;
            self.tell(it.line, here, None);
            let mut until = None;
            for met in it.scope.walk(it.body) {
                match met {
                    Met::Statement(line, _) if until.is_some() => return Err(misplaced(line)),
                    Met::Statement(line @ ListLine::Until(end), _) => until = Some((line, *end)),
                    Met::Statement(line, scope) => self.line(line, scope, here)?,
                    Met::Amendment(_) | Met::Line(..) => {}
                }
            }
            let (until, end) = until.ok_or_else(|| misplaced(it.line))?;
            let count = self.pixel(here, until)?.list.len();
            let peel = self.peel(here, until)?;
            let ends = match end {
                End::AllResolved => peel.resolved == count,
                End::NothingDropped => !peel.dropped,
            };
            self.tell(until, here, Some(ends));
            if ends {
                return Ok(());
            }
        }
        self.ended = false;
        Ok(())
    }

    /// Resolves a pixel by an algorithm for single pixels, with a Local Array of `size`.
    fn resolve(
        &mut self,
        pixel: usize,
        algorithm: &Pseudocode<ListLine>,
        amendments: &[Amendment<ListLine>],
        size: u32,
    ) -> Result<()> {
        self.pixels[pixel].begin_resolve(size);
        let here = Here {
            pixel: Some(pixel),
            fragment: None,
            size,
        };
        self.lines(algorithm.lines, Scope::of(amendments), here)
    }

    fn holds(&mut self, test: ListTest, here: Here, line: &ListLine) -> Result<bool> {
        let (size, last) = (here.size, here.size > self.array / 2);
        if let ListTest::NotBehindMin(key) = test {
            let f = here.fragment.ok_or_else(|| misplaced(line))?;
            let min = self.peel(here, line)?.min;
            let (min_depth, min_id) = min.ok_or_else(|| unset(line))?;
            let tie = f.depth == min_depth && (key == Key::Depth || i64::from(f.order) <= min_id);
            return Ok(f.depth < min_depth || tie);
        }
        if test == ListTest::IsProxy {
            let f = here.fragment.ok_or_else(|| misplaced(line))?;
            return Ok(matches!(Source::of(f.order), Source::Proxy { .. }));
        }
        let pixel = self.pixel(here, line)?;
        let complexity = pixel.complexity;
        Ok(match test {
            ListTest::StencilFitsSegment => u32::from(pixel.stencil) <= size.min(255),
            ListTest::FitsSegmentOrLast => complexity <= size || last,
            ListTest::Overflows => complexity > size,
            ListTest::FitsSegment | ListTest::NotBehindMin(_) | ListTest::IsProxy => {
                complexity <= size
            }
        })
    }
}

impl<'a> Run<'a, '_> {
    fn resolved(self) -> ListRun {
        ListRun {
            pixels: self.pixels.into_iter().map(|pixel| pixel.done).collect(),
            ended: self.ended,
        }
    }

    fn pixel(&mut self, here: Here, line: &ListLine) -> Result<&mut Pixel<'a>> {
        let pixel = here.pixel.ok_or_else(|| misplaced(line))?;
        Ok(&mut self.pixels[pixel])
    }

    fn peel(&mut self, here: Here, line: &ListLine) -> Result<&mut Peel> {
        let peel = self.pixel(here, line)?.peel.as_mut();
        peel.ok_or_else(|| misplaced(line))
    }
}

fn unset(line: &ListLine) -> Error {
    Error::out_of_order(
        format!("'{line}' reads a min depth that nothing has set"),
        "set it before the loop",
    )
}

fn misplaced(line: &ListLine) -> Error {
    Error::out_of_order(
        format!("there is nothing for '{line}' to work on"),
        "it stands outside of its loop, or before its buffer is created",
    )
}
