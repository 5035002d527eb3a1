//! The JSON object of a program, which `web/machine.js` runs on one pixel.
//!
//! | name | value |
//! | --- | --- |
//! | `key`, `method`, `title`, `source` | its name, the method's in the registry, what it does, where it is printed |
//! | `readings` | how it is read: the names of all readings in which it is the same |
//! | `maps` | `name` and `format` of each map that is there when it begins |
//! | `framebuffers` | `name`, the maps in `colors`, and in `depth` a map or null |
//! | `variables` | the values that it begins with; null is no limit |
//! | `order` | in which order surfaces are drawn: `submission`, or `sorted front to back`, of the group `sorted` after the others |
//! | `array` | the number of elements of the Local Array, or null |
//! | `on` | what its steps work on: `calls`, `fragments` or `lists` |
//! | `lines`, `steps` | as [`listing_json`](super::listing_json) has them, with the differences below |
//! | `silences` | the numbers of the lines at which the paper is silent and this reading does nothing |
//!
//! A step has no `origin`, but the number of its `line`, or null if it is not printed. A line of pseudocode also has a `name`
//! and `arguments`. There is one kind of step more: `resolve` has the steps of pseudocode on lists in its `body`, which
//! resolve the pixel's fragments before the opaque depth, over the map `behind`, into the map `into`, with a Local Array of
//! `array` elements.

use serde_json::{Map as Object, Value, json};

use super::listing_json::{Detail, line, steps};
use super::programs::{self, Program, Rest};
use crate::steps::{Format, Origin, Reading, Text, TextLine};

/// The objects of every program in each of its different readings.
pub fn programs() -> Vec<Value> {
    let all = programs::all().iter().flat_map(|program| {
        let readings = program.readings();
        readings
            .into_iter()
            .map(|readings| object(program, &readings))
    });
    all.collect()
}

/// The object of a program, in readings in which it is the same.
///
/// # Panics
/// If there is no reading.
pub fn object(program: &Program, readings: &[Reading]) -> Value {
    let mut written = Written::default();
    let mut all = written.steps(&program.text, readings[0]);
    if let Some(rest) = &program.rest {
        let rest = written.rest(program, rest, readings[0]);
        all.as_array_mut().expect("steps are a list").push(rest);
    }
    let resources = program.resources();
    let maps = resources.iter().flat_map(|it| it.maps);
    let maps = maps.map(|(map, holds)| {
        let format = holds.format(COLOR, DEPTH);
        json!({ "name": map.to_string(), "format": format.to_string() })
    });
    let framebuffers = resources.iter().flat_map(|it| it.framebuffers);
    let framebuffers = framebuffers.map(|it| {
        json!({
            "name": it.target.0,
            "colors": it.colors.iter().map(ToString::to_string).collect::<Vec<_>>(),
            "depth": it.depth.map(|map| map.to_string()),
        })
    });
    // JSON has no infinity: it writes null.
    let variables = program.variables.iter();
    let variables = variables.map(|(name, value)| ((*name).to_owned(), json!(value)));
    json!({
        "key": program.key,
        "method": program.method,
        "title": program.text.title(),
        "source": program.text.source(),
        "readings": readings.iter().map(|reading| reading.name()).collect::<Vec<_>>(),
        "maps": maps.collect::<Vec<_>>(),
        "framebuffers": framebuffers.collect::<Vec<_>>(),
        "variables": variables.collect::<Object<_, _>>(),
        "order": if program.sorts { "sorted front to back" } else { "submission" },
        "array": program.array,
        "on": match program.text {
            Text::Listing(..) => "calls",
            Text::Pseudocode(..) => "fragments",
            Text::Lists(..) => "lists",
        },
        "lines": written.lines.iter().map(line).collect::<Vec<_>>(),
        "silences": written.silences(),
        "steps": all,
    })
}

/// The formats of colours and of depths.
pub const COLOR: Format = Format::Rgba32F;
/// Likewise.
pub const DEPTH: Format = Format::Depth32FStencil8;

/// The lines so far.
#[derive(Default)]
struct Written {
    lines: Vec<TextLine>,
}

impl Written {
    fn steps(&mut self, text: &Text, reading: Reading) -> Value {
        let lines = text.lines(reading);
        let mut detail = Detail::program(&lines, self.lines.len());
        self.lines.extend(lines);
        steps(text, reading, &mut detail)
    }

    fn rest(&mut self, program: &Program, rest: &Rest, reading: Reading) -> Value {
        let query = rest.unless_zero.0;
        let decided = self.remark(
            program,
            format!("// if the query '{query}' has counted samples, their pixels' fragments go into lists:"),
        );
        let body = self.steps(&rest.lists, reading);
        let text = format!("// then: {}", rest.then.title());
        let run = self.remark(program, text);
        let then = self.steps(&rest.then, reading);
        json!({
            "step": "if",
            "when": ["GREATER", { "samples": query }, 0.0],
            "line": decided,
            "then": [
                {
                    "step": "resolve",
                    "line": decided,
                    "behind": rest.behind.to_string(),
                    "into": rest.into.to_string(),
                    "array": program.array,
                    "body": body,
                },
                {
                    "step": "run",
                    "line": run,
                    "title": rest.then.title(),
                    "source": rest.then.source(),
                    "body": then,
                },
            ],
            "otherwise": [],
        })
    }

    /// A line about what the method does between its texts, and the line's number.
    fn remark(&mut self, program: &Program, text: String) -> usize {
        self.lines.push(TextLine {
            text,
            origin: Some(Origin::Edition {
                why: "what the method does between its texts",
            }),
            source: program.text.source(),
            number: None,
            note: true,
            begins: true,
        });
        self.lines.len() - 1
    }

    fn silences(&self) -> Vec<usize> {
        let silent =
            |(_, line): &(usize, &TextLine)| matches!(line.origin, Some(Origin::Silence { .. }));
        let lines = self.lines.iter().enumerate().filter(silent);
        lines.map(|(number, _)| number).collect()
    }
}
