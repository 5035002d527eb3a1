//! Running pseudocode on the emulated pixels.

use super::surface::{Group, Surface};
use crate::error::{Error, Result};
use crate::fragment::Fragment;
use crate::steps::pseudo::{Line, Pseudocode, Test, Value};
use crate::steps::{Amendment, Compare, Met, Scope};

/// The result of an algorithm.
#[derive(Clone, Debug, PartialEq)]
pub struct AlgorithmRun {
    /// For each pixel, the composited transparent surfaces in their order of compositing, each by its place in the
    /// order of submission.
    pub composited: Vec<Vec<u32>>,
    /// The rounds of its `while`.
    pub iterations: u32,
    /// The passes over transparent geometry, not counting empty geometry.
    pub geometry_passes: u32,
    /// Whether the `while` ended by itself. If not, it was left after the limit.
    pub ended: bool,
}

/// A line that an algorithm has just executed, and what the pixels hold now.
pub struct ExecutedLine<'a> {
    /// The line.
    pub line: &'a Line,
    /// The pixel, or `None` of a line for all of them.
    pub pixel: Option<usize>,
    /// The fragment, by its place in the order of submission.
    pub fragment: Option<u32>,
    /// Whether the test of an `if` holds.
    pub holds: Option<bool>,
    /// `gChanged`, which the pixels share.
    pub changed: bool,
    /// What each pixel has composited so far, as in [`AlgorithmRun`].
    pub composited: &'a [Vec<u32>],
    names: &'a [&'static str],
    values: &'a [Vec<f32>],
}

impl ExecutedLine<'_> {
    /// The variables that a pixel has set, in the order in which they were first set.
    pub fn variables(&self, pixel: usize) -> impl Iterator<Item = (&'static str, f32)> {
        let all = self.names.iter().zip(&self.values[pixel]);
        all.map(|(name, value)| (*name, *value))
            .filter(|(_, value)| !value.is_nan())
    }
}

/// Runs an algorithm on pixels with these surfaces. `zNear` is 0; `zOpaque` is the depth of the nearest opaque surface,
/// or 1 if there is none. The `while` is left after `limit` rounds.
///
/// # Errors
/// If the algorithm reads a variable that it has not set.
pub fn run_algorithm(
    algorithm: &Pseudocode,
    amendments: &[Amendment<Line>],
    pixels: &[Vec<Surface>],
    limit: u32,
) -> Result<AlgorithmRun> {
    follow_algorithm(algorithm, amendments, pixels, limit, &mut |_| {})
}

/// The same, and `follower` is told of every line that is executed: of a loop before each round, of all others afterwards.
///
/// # Errors
/// As [`run_algorithm`].
pub fn follow_algorithm(
    algorithm: &Pseudocode,
    amendments: &[Amendment<Line>],
    pixels: &[Vec<Surface>],
    limit: u32,
    follower: &mut dyn FnMut(&ExecutedLine<'_>),
) -> Result<AlgorithmRun> {
    let mut run = Run {
        follower,
        pixels,
        names: vec!["zNear", "zOpaque", FRAGMENT],
        values: pixels
            .iter()
            .map(|surfaces| vec![0.0, opaque_depth(surfaces), f32::NAN])
            .collect(),
        changed: false,
        limit,
        done: AlgorithmRun {
            composited: vec![Vec::new(); pixels.len()],
            iterations: 0,
            geometry_passes: 0,
            ended: true,
        },
    };
    run.lines(algorithm.lines, Scope::of(amendments), Here::Nowhere)?;
    Ok(run.done)
}

/// The fragment's own depth.
const FRAGMENT: &str = "zFragment";
/// The one variable that all pixels share.
const CHANGED: &str = "gChanged";

fn opaque_depth(surfaces: &[Surface]) -> f32 {
    surfaces
        .iter()
        .filter(|surface| surface.group == Group::Opaque)
        .map(|surface| surface.fragment.depth)
        .fold(1.0, f32::min)
}

struct Run<'a> {
    follower: &'a mut dyn FnMut(&ExecutedLine<'_>),
    pixels: &'a [Vec<Surface>],
    names: Vec<&'static str>,
    /// Per pixel, in the order of the names.
    values: Vec<Vec<f32>>,
    changed: bool,
    limit: u32,
    done: AlgorithmRun,
}

/// The place at which a line is executed.
#[derive(Clone, Copy)]
enum Here<'a> {
    Nowhere,
    Pixel(usize),
    Fragment(usize, &'a Fragment),
}

impl<'a> Run<'a> {
    fn lines(
        &mut self,
        lines: &'static [Line],
        scope: Scope<'_, Line>,
        here: Here<'a>,
    ) -> Result<()> {
        for met in scope.walk(lines) {
            if let Met::Statement(line, scope) = met {
                self.line(line, scope, here)?;
            }
        }
        Ok(())
    }

    fn line(&mut self, line: &Line, scope: Scope<'_, Line>, here: Here<'a>) -> Result<()> {
        match *line {
            Line::Pixels(body) => {
                for pixel in 0..self.pixels.len() {
                    self.tell(line, Here::Pixel(pixel), None);
                    self.lines(body, scope, Here::Pixel(pixel))?;
                }
            }
            Line::Fragments { of, body, .. } => {
                let mut any = false;
                for pixel in 0..self.pixels.len() {
                    for surface in &self.pixels[pixel] {
                        if surface.group.is_among(of) {
                            any = true;
                            self.set_of(pixel, FRAGMENT, surface.fragment.depth);
                            let here = Here::Fragment(pixel, &surface.fragment);
                            self.tell(line, here, None);
                            self.lines(body, scope, here)?;
                        }
                    }
                }
                self.done.geometry_passes += u32::from(any);
            }
            Line::While { flag, body } => {
                while self.get(flag, here)? != 0.0 {
                    if self.done.iterations == self.limit {
                        self.done.ended = false;
                        break;
                    }
                    self.done.iterations += 1;
                    self.tell(line, here, None);
                    self.lines(body, scope, here)?;
                }
            }
            Line::If {
                test,
                then,
                otherwise,
            } => {
                let holds = self.holds(test, here)?;
                self.tell(line, here, Some(holds));
                self.lines(if holds { then } else { otherwise }, scope, here)?;
            }
            Line::Set { variable, value } => {
                let value = self.value(value, here)?;
                self.set(variable, value, here);
                self.tell(line, here, None);
            }
            Line::Swap(a, b) => {
                for pixel in 0..self.pixels.len() {
                    let here = Here::Pixel(pixel);
                    let (of_a, of_b) = (self.get(a, here)?, self.get(b, here)?);
                    self.set(a, of_b, here);
                    self.set(b, of_a, here);
                }
                self.tell(line, here, None);
            }
            Line::Composite => {
                if let Here::Fragment(pixel, fragment) = here {
                    self.done.composited[pixel].push(fragment.order);
                }
                self.tell(line, here, None);
            }
            Line::Margin(_) => {}
        }
        Ok(())
    }

    fn tell(&mut self, line: &Line, here: Here<'_>, holds: Option<bool>) {
        let (pixel, fragment) = match here {
            Here::Nowhere => (None, None),
            Here::Pixel(pixel) => (Some(pixel), None),
            Here::Fragment(pixel, fragment) => (Some(pixel), Some(fragment.order)),
        };
        (self.follower)(&ExecutedLine {
            line,
            pixel,
            fragment,
            holds,
            changed: self.changed,
            composited: &self.done.composited,
            names: &self.names,
            values: &self.values,
        });
    }

    fn holds(&self, test: Test, here: Here<'_>) -> Result<bool> {
        let one =
            |a, compare: Compare, b| Ok(compare.holds(self.get(a, here)?, self.get(b, here)?));
        match test {
            Test::One(a, compare, b) => one(a, compare, b),
            Test::Two(a, ab, b, bc, c) => Ok(one(a, ab, b)? && one(b, bc, c)?),
            Test::Both((a, ab, b), (c, cd, d)) => Ok(one(a, ab, b)? && one(c, cd, d)?),
            Test::Set(flag) => Ok(self.get(flag, here)? != 0.0),
        }
    }

    fn value(&self, value: Value, here: Here<'_>) -> Result<f32> {
        Ok(match value {
            Value::Of(variable) => self.get(variable, here)?,
            Value::Flag(flag) => f32::from(u8::from(flag)),
            Value::BeforeEverything => -1.0,
            Value::Either(flag, a, b) => {
                let chosen = if self.get(flag, here)? != 0.0 { a } else { b };
                self.get(chosen, here)?
            }
        })
    }

    fn get(&self, variable: &'static str, here: Here<'_>) -> Result<f32> {
        let unset = || {
            Error::out_of_order(
                format!("the algorithm reads {variable} before it is set"),
                "set it for all pixels first",
            )
        };
        if variable == CHANGED {
            return Ok(f32::from(u8::from(self.changed)));
        }
        let (Here::Pixel(pixel) | Here::Fragment(pixel, _)) = here else {
            return Err(unset());
        };
        let place = self
            .names
            .iter()
            .position(|name| *name == variable)
            .ok_or_else(unset)?;
        self.values[pixel].get(place).copied().ok_or_else(unset)
    }

    fn set(&mut self, variable: &'static str, value: f32, here: Here<'_>) {
        if variable == CHANGED {
            self.changed = value != 0.0;
        } else if let Here::Pixel(pixel) | Here::Fragment(pixel, _) = here {
            self.set_of(pixel, variable, value);
        }
    }

    fn set_of(&mut self, pixel: usize, variable: &'static str, value: f32) {
        let known = self.names.iter().position(|name| *name == variable);
        let place = known.unwrap_or_else(|| {
            self.names.push(variable);
            self.names.len() - 1
        });
        let values = &mut self.values[pixel];
        if values.len() <= place {
            values.resize(place + 1, f32::NAN);
        }
        values[place] = value;
    }
}
