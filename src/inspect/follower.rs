//! The witness of a method: it performs on emulated pixels what the method performs on OpenGL, and compares.

use std::cell::RefCell;
use std::rc::Rc;

use super::compare::Bounds;
use super::drawn_order::Triangle;
use super::history::{Event, Line, Pass};
use super::nodes;
use super::recording::{Done, Place};
use super::trace;
use crate::emulator::{Emulator, Fate, Surface, prefix_scan};
use crate::error::Result;
use crate::gl::{CHUNK, Seen, Setting, Witness};
use crate::papers::stage::{COMPLEXITY, IMAGE_COLOR};
use crate::steps::{Call, CallLine, Format, Held, Map, Objects, Target, Texel};

/// The witness of a method's preparations, which are made on the emulated pixels, too.
#[derive(Clone, Default)]
pub(super) struct Preparations(Rc<RefCell<Vec<Done>>>);

impl Preparations {
    pub(super) fn done(&self) -> Vec<Done> {
        self.0.borrow().clone()
    }
}

impl Witness for Preparations {
    fn allocated(&mut self, map: Map, format: Format) -> Result<()> {
        self.0.borrow_mut().push(Done::Map(map, format));
        Ok(())
    }

    fn framed(&mut self, target: Target, colors: &[Map], depth: Option<Map>) -> Result<()> {
        let done = Done::Framebuffer(target, colors.to_vec(), depth);
        self.0.borrow_mut().push(done);
        Ok(())
    }

    fn follow(&mut self, _: &CallLine) {}

    fn performed(&mut self, _: &Call, _: &Seen<'_>) -> Result<()> {
        Ok(())
    }

    /// The order and the window are said again when the frame begins.
    fn set(&mut self, setting: Setting<'_>) {
        if !matches!(
            setting,
            Setting::Order(_) | Setting::Window(_) | Setting::Numbers(_)
        ) {
            self.0.borrow_mut().extend(Done::set(setting, &[]));
        }
    }
}

/// A pixel that is followed.
pub(super) struct Followed {
    place: Place,
    surfaces: Vec<Surface>,
    triangles: Vec<Triangle>,
    emulator: Emulator,
    done: Vec<Done>,
    /// The steps that the emulator could not perform. After the first, it performs no other.
    pub(super) not_followed: Vec<String>,
    /// The lines since the last pass.
    lines: Vec<Line>,
    /// Where the pixel's list begins among those of all pixels. On the emulated pixel it is 0.
    first: u32,
    /// The first row that is drawn, from the bottom, and how many are, if not all.
    band: Option<[u32; 2]>,
    /// Whether draws over the screen, bands and parts of the screen are those of maps that have the marked pixels side by
    /// side. The emulated pixel has its list at its own place.
    in_lists: bool,
    /// The pixel's number among the marked ones, if it is one.
    number: Option<u32>,
    /// The pixels that draws over the screen cover if the method does not say it.
    window: [u32; 4],
    /// The draws so far that resolved the pixel's list.
    resolves: usize,
    pub(super) passes: Vec<Pass>,
}

impl Followed {
    /// A pixel with these surfaces, of which the first belong to these triangles. So much was done before.
    pub(super) fn new(
        place: Place,
        surfaces: Vec<Surface>,
        triangles: Vec<Triangle>,
        before: Vec<Done>,
    ) -> Self {
        let mut followed = Self {
            emulator: place.emulator(surfaces.clone()).watching(0),
            place,
            surfaces,
            triangles,
            done: Vec::new(),
            not_followed: Vec::new(),
            lines: Vec::new(),
            first: 0,
            band: None,
            in_lists: false,
            number: None,
            window: [0; 4],
            resolves: 0,
            passes: Vec::new(),
        };
        before.into_iter().for_each(|done| followed.follow(done));
        followed
    }

    /// The fragments in the image, nearest first, if it could be followed to the end, and if they are composited one by one.
    pub(super) fn composited(&mut self) -> Option<Vec<u32>> {
        self.traced(trace::composited).flatten()
    }

    /// The part of each fragment's colour that is in the image, if it could be followed to the end.
    pub(super) fn weights(&mut self) -> Option<Vec<f64>> {
        self.traced(trace::weights)
    }

    /// The colour that the emulated pixel has in the image, if it could be followed to the end.
    pub(super) fn image(&self) -> Option<[f64; 4]> {
        let colors = self.emulator.colors(IMAGE_COLOR).ok();
        let colors = colors.filter(|_| self.not_followed.is_empty());
        colors.map(|colors| colors[0].map(f64::from))
    }

    fn traced<T>(&mut self, trace: fn(&Place, &[Surface], &[Done]) -> Result<T>) -> Option<T> {
        if !self.not_followed.is_empty() {
            return None;
        }
        let traced = trace(&self.place, &self.surfaces, &self.done);
        traced
            .map_err(|error| self.not_followed.push(error.to_string()))
            .ok()
    }

    fn follow(&mut self, done: Done) {
        if self.not_followed.is_empty()
            && let Err(error) = done.repeat(&mut self.emulator)
        {
            self.not_followed.push(error.to_string());
        }
        self.done.push(done);
    }

    fn set(&mut self, setting: Setting<'_>) {
        match setting {
            Setting::Window(window) => self.window = window,
            Setting::Band(band) => self.band = band,
            Setting::Numbers(numbers) => {
                self.number = numbers.number(self.place.pixel);
                self.in_lists = true;
                return;
            }
            _ => {}
        }
        let setting = match setting {
            Setting::Band(Some(_)) if self.in_lists => Setting::Band(None),
            Setting::Screen(Some(_)) if self.in_lists => Setting::Screen(None),
            Setting::Screen(None) => Setting::Window(self.window),
            setting => setting,
        };
        match Done::set(setting, &self.triangles) {
            Ok(done) => self.follow(done),
            Err(why) => self.not_followed.push(why.into()),
        }
    }

    /// The place at which the current framebuffer has the pixel, or `None` if it does not. Lists of marked pixels begin and are
    /// resolved in maps that have them side by side.
    fn place_in_maps(&self, program: &str, over_screen: bool, width: u32) -> Option<[u32; 2]> {
        match self.in_lists && over_screen && program.starts_with("a_buffer/") {
            true => self.number.map(|number| [number % width, number / width]),
            false => Some(self.place.pixel),
        }
    }

    fn performed(&mut self, call: &Call, seen: &Seen<'_>, line: Line, bounds: &Bounds) {
        self.lines.push(line);
        self.follow(Done::Call(*call));
        let Call::Draw { objects } = *call else {
            return;
        };
        let over_screen = objects == Objects::Screen;
        let program = seen.program.unwrap_or_default().to_owned();
        if program == PLACED {
            self.in_lists = false;
        }
        let [width, _] = seen.size;
        let Some(place) = self.place_in_maps(&program, over_screen, width) else {
            self.lines.clear();
            return;
        };
        let held = (seen.held)(place);
        let follows = self.not_followed.is_empty();
        let emulated = follows.then(|| self.emulator.held(0).ok()).flatten();
        let emulated = emulated.map(|emulated| self.among_all(&program, emulated, &held));
        let casts_rays = !self.place.volumes.is_empty() && program.starts_with(RESOLVES);
        let bounds = match &emulated {
            Some(emulated) if casts_rays => bounds.and(self.rounding_of_rays(emulated)),
            _ => *bounds,
        };
        let mut differences = emulated
            .as_ref()
            .map(|emulated| bounds.differences(&program, emulated, &held))
            .unwrap_or_default();
        if program == LISTS_BEGIN && !self.in_lists && emulated.is_some() {
            differences.extend(self.wrong_offset(seen));
        }
        let record = self.emulator.record();
        let drawn = record.draws.last().filter(|_| follows && !over_screen);
        let resolved = record.resolves.get(self.resolves..).unwrap_or_default();
        let resolve = resolved.last().filter(|_| follows).cloned();
        self.resolves = record.resolves.len();
        self.passes.push(Pass {
            lines: std::mem::take(&mut self.lines),
            program,
            over_screen,
            events: drawn.map_or_else(Vec::new, |draw| events(&draw.fates, draw.program)),
            resolve,
            held,
            emulated,
            differences,
        });
    }

    /// Says how the base offset of the pixel's list on OpenGL differs from what the emulated machine's scan makes of the counts.
    /// A band's offsets begin at its first row.
    fn wrong_offset(&self, seen: &Seen<'_>) -> Option<String> {
        let ([x, y], [width, height]) = (self.place.pixel, seen.size);
        let [first_row, rows] = self.band.unwrap_or([0, height]);
        let [left, bottom, across, up] = self.window;
        let begins = (first_row..first_row + rows).contains(&y)
            && (left..left + across).contains(&x)
            && (bottom..bottom + up).contains(&y);
        if !begins {
            return None;
        }
        let counts = (seen.counts)(COMPLEXITY).ok()?;
        let counts: Vec<f32> = counts.into_iter().map(|count| count as f32).collect();
        let offsets = prefix_scan(&counts, CHUNK as usize).swap_remove(0);
        let offset = |x: u32, y: u32| offsets[(y * width + x) as usize];
        let ours = offset(x, y).wrapping_sub(offset(0, first_row));
        let theirs = self.first;
        (ours != theirs).then(|| format!("base offset: OpenGL {theirs}, emulated {ours}"))
    }

    /// By how much a ray's light may differ, of which the emulated pixel holds this much.
    ///
    /// The shader casts rays in f32, the emulated pixel in f64. So a sample lies elsewhere on OpenGL, by some roundings of
    /// 2^-24 of its distance: four at most matter, those of the distance itself, of the step's middle, of the direction, and of
    /// the sum. How much light that makes, the emulated pixel is asked: with everything nearer and farther by so much. That
    /// moves all samples in one way, which may cancel, so it counts eight times. Each sample's light is rounded, too.
    fn rounding_of_rays(&self, emulated: &Held) -> f32 {
        const MOVED: f64 = 4.0 / (1 << 24) as f64;
        let light = |held: &Held| match held.colors.first() {
            Some(Texel::Color(light)) => *light,
            _ => [0.0; 4],
        };
        let moved = [1.0 - MOVED, 1.0 + MOVED].map(|times| {
            let mut emulator = self
                .place
                .at_distance(times)
                .emulator(self.surfaces.clone());
            let repeated = self.done.iter().try_for_each(|it| it.repeat(&mut emulator));
            repeated.and_then(|()| emulator.held(0)).ok()
        });
        let channels = moved.iter().flatten().flat_map(|moved| {
            let pairs = light(moved).into_iter().zip(light(emulated));
            pairs.map(|(a, b)| (a - b).abs())
        });
        8.0 * channels.fold(0.0, f32::max) + 64.0 * 2.0_f32.powi(-24)
    }

    /// What the emulated pixel holds, with the numbers of records as they run through all pixels of the image. Where a list
    /// begins, OpenGL says by how much the two differ.
    fn among_all(&mut self, program: &str, mut emulated: Held, gl: &Held) -> Held {
        let number = |held: &Held| match held.colors.first() {
            Some(Texel::Integers([number, ..])) => Some(*number),
            _ => None,
        };
        if let (Some(theirs), Some(ours)) = (number(gl), number(&emulated))
            && program == LISTS_BEGIN
        {
            self.first = theirs.wrapping_sub(ours);
        }
        if let Some(Texel::Integers([number, ..])) = emulated.colors.first_mut() {
            *number = number.wrapping_add(self.first);
        }
        emulated
    }
}

/// The programs that resolve lists.
const RESOLVES: &str = "a_buffer/resolve";
/// The program after which a pixel's counter is the number of its list's first record.
const LISTS_BEGIN: &str = "a_buffer/begin";
/// The program that puts what the lists gave in its place.
const PLACED: &str = "verified/place";

fn events(fates: &[Fate], program: &str) -> Vec<Event> {
    let nodes = match program {
        nodes::INSERTS => nodes::after_each(fates),
        _ => vec![Vec::new(); fates.len()],
    };
    let event = |(fate, nodes): (&Fate, Vec<Vec<u32>>)| Event {
        fragment: fate.order,
        outcome: fate.outcome,
        stencil: fate.stencil,
        depth: fate.stored_depth,
        list: fate.list,
        nodes,
    };
    fates.iter().zip(nodes).map(event).collect()
}

/// The witness of a method's frame.
#[derive(Clone)]
pub(super) struct Follower {
    pub(super) pixels: Rc<RefCell<Vec<Followed>>>,
    bounds: Bounds,
    line: Option<CallLine>,
}

impl Follower {
    pub(super) fn new(pixels: Vec<Followed>, bounds: Bounds) -> Self {
        Self {
            pixels: Rc::new(RefCell::new(pixels)),
            bounds,
            line: None,
        }
    }

    /// The line of the call. A call that a method makes by itself stands in no listing.
    fn line_of(&mut self, call: &Call) -> Line {
        let line = self.line.take();
        Line {
            title: line.map_or("", |line| line.title),
            source: line.map_or("onionskin", |line| line.source),
            text: line.map_or_else(|| call.to_string(), |line| line.text()),
            call: call.to_string(),
            origin: line.and_then(|line| line.origin),
        }
    }
}

impl Witness for Follower {
    fn allocated(&mut self, map: Map, format: Format) -> Result<()> {
        for pixel in self.pixels.borrow_mut().iter_mut() {
            pixel.follow(Done::Map(map, format));
        }
        Ok(())
    }

    fn framed(&mut self, target: Target, colors: &[Map], depth: Option<Map>) -> Result<()> {
        for pixel in self.pixels.borrow_mut().iter_mut() {
            pixel.follow(Done::Framebuffer(target, colors.to_vec(), depth));
        }
        Ok(())
    }

    fn follow(&mut self, line: &CallLine) {
        self.line = Some(*line);
    }

    fn performed(&mut self, call: &Call, seen: &Seen<'_>) -> Result<()> {
        let line = self.line_of(call);
        for pixel in self.pixels.borrow_mut().iter_mut() {
            pixel.performed(call, seen, line.clone(), &self.bounds);
        }
        Ok(())
    }

    fn set(&mut self, setting: Setting<'_>) {
        for pixel in self.pixels.borrow_mut().iter_mut() {
            pixel.set(setting);
        }
    }
}
