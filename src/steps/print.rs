//! Printing listings as their papers write them.

use std::fmt;

use super::amend::{Met, Scope};
use super::argument::Argument;
use super::call::{Call, ClassicCall};
use super::constants::*;
use super::expr::Condition;
use super::lines::{Lines, TextLine, text};
use super::listing::{Amendment, Dialect, Listing, Step};
use super::names::{Index, Map};
use super::walk::CallLine;

/// The listing as its paper prints it, with `amendments` applied. Without any amendment, it is as it stands here.
pub fn listing(listing: &Listing, amendments: &[Amendment]) -> String {
    text(&lines(listing, amendments))
}

/// The lines of the listing, with `amendments` applied.
pub fn lines(listing: &Listing, amendments: &[Amendment]) -> Vec<TextLine> {
    let mut printer = Printer {
        dialect: listing.dialect,
        lines: Lines::of(listing.source),
    };
    printer.steps(listing.steps, Scope::of(amendments), 0);
    printer.lines.done()
}

impl CallLine {
    /// The line as its listing prints it.
    pub fn text(&self) -> String {
        match self.spelling {
            Some(spelling) => spelling.text.to_owned(),
            None => Printer {
                dialect: self.dialect,
                lines: Lines::of(self.source),
            }
            .call(&self.call),
        }
    }
}

struct Printer {
    dialect: Dialect,
    lines: Lines,
}

impl Printer {
    fn lead(&self, indent: usize) -> String {
        let width = match self.dialect {
            Dialect::Phrases => 1,
            Dialect::Calls | Dialect::Source => 2,
        };
        " ".repeat(indent * width)
    }

    /// The first line of a step.
    fn line(&mut self, indent: usize, line: impl fmt::Display, scope: Scope<'_, Step>) {
        self.lines.statement(&self.lead(indent), line, scope);
    }

    /// A further line of a step.
    fn rest(&mut self, indent: usize, line: impl fmt::Display, scope: Scope<'_, Step>) {
        self.lines.rest(&self.lead(indent), line, scope);
    }

    fn block(&mut self, indent: usize, body: &'static [Step], scope: Scope<'_, Step>) {
        self.rest(indent, "{", scope);
        self.steps(body, scope, indent + 1);
        self.rest(indent, "}", scope);
    }

    fn steps(&mut self, steps: &'static [Step], scope: Scope<'_, Step>, indent: usize) {
        for met in scope.walk(steps) {
            match met {
                Met::Amendment(it) => self.lines.amendment(&self.lead(indent), it),
                Met::Statement(step, scope) => self.step(step, scope, indent),
                Met::Line(line, scope) => self.rest(indent, line, scope),
            }
        }
    }

    fn step(&mut self, step: &Step, scope: Scope<'_, Step>, indent: usize) {
        match *step {
            Step::Call(call) => self.line(indent, self.call(&call), scope),
            Step::DepthUnit { unit, body } => {
                self.line(indent, format_args!("depth unit {unit}:"), scope);
                self.steps(body, scope, indent + 1);
            }
            Step::Let { variable, value } => {
                let end = self.end();
                // Listing 1 writes an inner operation without spaces, `(i+1) % 2`; Expr does the same.
                self.line(indent, format_args!("{variable} = {value}{end}"), scope);
            }
            Step::If {
                condition,
                then,
                otherwise,
            } => self.branch(&condition, then, otherwise, scope, indent),
            Step::For {
                variable: i,
                from,
                to,
                body,
            } => {
                let line = format_args!("for ({i}={from}; {i}<{to}; {i}++)");
                self.line(indent, line, scope);
                self.block(indent, body, scope);
            }
            Step::ForDown {
                variable: i,
                from,
                body,
            } => {
                let line = format_args!("for ({i}={from}-1; {i}>=0; {i}--)");
                self.line(indent, line, scope);
                self.block(indent, body, scope);
            }
            Step::Stop { when, why } => {
                let line = format!("if({when}) break{}  // {why}", self.end());
                self.line(indent, line, scope);
            }
            Step::Run {
                listing,
                amendments,
            } => self.run(listing, scope.around(amendments), indent),
            Step::Margin(_) => {}
        }
    }

    fn run(&mut self, listing: &Listing, scope: Scope<'_, Step>, indent: usize) {
        let title = format!("{}: {}", listing.source, listing.title);
        self.lines.stand_in(&self.lead(indent), title, None);
        let dialect = std::mem::replace(&mut self.dialect, listing.dialect);
        let source = std::mem::replace(&mut self.lines.source, listing.source);
        self.steps(listing.steps, scope, indent);
        self.dialect = dialect;
        self.lines.source = source;
    }

    fn branch(
        &mut self,
        condition: &Condition,
        then: &'static [Step],
        otherwise: &'static [Step],
        scope: Scope<'_, Step>,
        indent: usize,
    ) {
        self.line(indent, format_args!("if({condition})"), scope);
        self.arm(then, scope, indent);
        if !otherwise.is_empty() {
            self.rest(indent, "else", scope);
            self.arm(otherwise, scope, indent);
        }
    }

    /// A single statement needs no braces.
    fn arm(&mut self, body: &'static [Step], scope: Scope<'_, Step>, indent: usize) {
        match body {
            [_] => self.steps(body, scope, indent + 1),
            _ => self.block(indent, body, scope),
        }
    }

    fn end(&self) -> &'static str {
        match self.dialect {
            Dialect::Phrases => "",
            Dialect::Calls | Dialect::Source => ";",
        }
    }

    fn call(&self, call: &Call) -> String {
        let said = match self.dialect {
            Dialect::Phrases => phrase(call),
            Dialect::Calls => short_form(call),
            Dialect::Source => source(call),
        };
        said.unwrap_or_else(|| {
            let (name, arguments) = call.signature();
            let values: Vec<_> = arguments
                .into_iter()
                .map(|(_, value)| value.replace("GL_", ""))
                .collect();
            // As Carr et al. print them, without spaces.
            format!("{name}({}){}", values.join(","), self.end())
        })
    }
}

/// Carr et al.'s short forms of two masks, and of a program with a number.
fn short_form(call: &Call) -> Option<String> {
    match *call {
        Call::Clear {
            mask: super::gl::COLOR_AND_DEPTH_BUFFER_BITS,
        } => Some("glClear(COLOR_AND_DEPTH_BUFFER_BITS);".into()),
        Call::Clear {
            mask: super::gl::DEPTH_AND_STENCIL_BUFFER_BITS,
        } => Some("glClear(DEPTH_AND_STENCIL_BUFFER_BITS);".into()),
        // No OpenGL has it, so it says what its second argument is.
        Call::UseProgramOfSize { program, size } => {
            let size = Argument::text(&size);
            Some(format!("glUseProgram({}, N = {size});", program.0))
        }
        _ => None,
    }
}

/// The call as C source with every `GL_` prefix, for the calls of Listing 2.
fn source(call: &Call) -> Option<String> {
    match call {
        Call::Classic(ClassicCall::SetM { rows }) => Some(assignments(rows)),
        Call::Classic(call) => {
            let (name, arguments) = call.signature();
            let values: Vec<_> = arguments.into_iter().map(|(_, value)| value).collect();
            Some(format!("{name}({});", values.join(", ")))
        }
        _ => None,
    }
}

/// Sixteen assignments, four per line.
fn assignments(rows: &[[f32; 4]; 4]) -> String {
    let lines = rows.iter().enumerate().map(|(row, values)| {
        let sets = values.iter().enumerate();
        let sets: Vec<_> = sets
            .map(|(column, value)| format!("m({row},{column}) = {value};"))
            .collect();
        sets.join("   ")
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// The call in Everitt's words, or `None` if he has none for it.
fn phrase(call: &Call) -> Option<String> {
    Some(match *call {
        Call::Clear {
            mask:
                Buffers {
                    color: true,
                    depth: false,
                    stencil: false,
                },
        } => "clear color buffer".into(),
        Call::Clear {
            mask:
                Buffers {
                    color: false,
                    depth: true,
                    stencil: false,
                },
        } => "clear depth buffer".into(),
        Call::Enable {
            cap: Capability::DepthTest,
        } => "enable depth test".into(),
        Call::Disable {
            cap: Capability::DepthTest,
        } => "disable depth test".into(),
        Call::DepthMask { flag: true } => "enable depth writes".into(),
        Call::DepthMask { flag: false } => "disable depth writes".into(),
        Call::DepthFunc { func } => format!("set depth func to {}", func.name()),
        Call::BindDepthBuffer {
            buffer:
                Map {
                    index: Index::Variable(name),
                    ..
                },
        } => format!("bind buffer {name}"),
        Call::Draw {
            objects: Objects::Scene,
        } => "render scene".into(),
        Call::CopyImage { from, to } if from == Map::named("color buffer") => {
            format!("save {from} RGBA as {to}")
        }
        Call::CopyImage { from, to } => format!("copy {from} into {to}"),
        _ => return None,
    })
}
