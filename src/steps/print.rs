//! Printing listings as their papers write them.

use std::fmt;

use super::amend::{Met, Scope};
use super::call::{Call, ClassicCall};
use super::constants::*;
use super::expr::Condition;
use super::listing::{Amendment, Dialect, Listing, Step};
use super::names::{Index, Map};

/// The listing as its paper prints it, with `amendments` applied. Without any amendment, it is as printed.
pub fn listing(listing: &Listing, amendments: &[Amendment]) -> String {
    let mut printer = Printer {
        dialect: listing.dialect,
        text: String::new(),
    };
    printer.steps(listing.steps, Scope::of(amendments), 0);
    printer.text
}

struct Printer {
    dialect: Dialect,
    text: String,
}

impl Printer {
    fn line(&mut self, indent: usize, line: impl fmt::Display) {
        self.text += &format!("{:1$}{line}\n", "", indent * 2);
    }

    fn block(&mut self, indent: usize, body: &'static [Step], scope: Scope<'_, Step>) {
        self.line(indent, "{");
        self.steps(body, scope, indent + 1);
        self.line(indent, "}");
    }

    fn steps(&mut self, steps: &'static [Step], scope: Scope<'_, Step>, indent: usize) {
        for met in scope.walk(steps) {
            match met {
                Met::Amendment(it) => self.line(indent, format_args!("// {}: {}", it.key, it.why)),
                Met::Statement(step, scope) => self.step(step, scope, indent),
            }
        }
    }

    fn step(&mut self, step: &Step, scope: Scope<'_, Step>, indent: usize) {
        match *step {
            Step::Call(call) => self.line(indent, self.call(&call)),
            Step::DepthUnit { unit, body } => {
                self.line(indent, format_args!("depth unit {unit}:"));
                self.steps(body, scope, indent + 1);
            }
            Step::Let { variable, value } => {
                let end = self.end();
                // Listing 1 writes an inner operation without spaces, `(i+1) % 2`; Expr does the same.
                self.line(indent, format_args!("{variable} = {value}{end}"));
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
                self.line(indent, format_args!("for ({i}={from}; {i}<{to}; {i}++)"));
                self.block(indent, body, scope);
            }
            Step::ForDown {
                variable: i,
                from,
                body,
            } => {
                self.line(indent, format_args!("for ({i}={from}-1; {i}>=0; {i}--)"));
                self.block(indent, body, scope);
            }
            Step::Stop { when, why } => {
                let end = self.end();
                self.line(indent, format_args!("if({when}) break{end}  // {why}"));
            }
            Step::Run {
                listing,
                amendments,
            } => {
                self.line(
                    indent,
                    format_args!("// {}: {}", listing.source, listing.title),
                );
                let dialect = std::mem::replace(&mut self.dialect, listing.dialect);
                self.steps(listing.steps, scope.around(amendments), indent);
                self.dialect = dialect;
            }
        }
    }

    fn branch(
        &mut self,
        condition: &Condition,
        then: &'static [Step],
        otherwise: &'static [Step],
        scope: Scope<'_, Step>,
        indent: usize,
    ) {
        self.line(indent, format_args!("if({condition})"));
        let mut arm = |body: &'static [Step]| match body {
            // A single statement needs no braces.
            [_] => self.steps(body, scope, indent + 1),
            _ => self.block(indent, body, scope),
        };
        arm(then);
        if !otherwise.is_empty() {
            self.line(indent, "else");
            match otherwise {
                [_] => self.steps(otherwise, scope, indent + 1),
                _ => self.block(indent, otherwise, scope),
            }
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
            format!("{name}({}){}", values.join(", "), self.end())
        })
    }
}

/// Carr et al.'s short forms of two masks.
fn short_form(call: &Call) -> Option<String> {
    match *call {
        Call::Clear {
            mask: super::gl::COLOR_AND_DEPTH_BUFFER_BITS,
        } => Some("glClear(COLOR_AND_DEPTH_BUFFER_BITS);".into()),
        Call::Clear {
            mask: super::gl::DEPTH_AND_STENCIL_BUFFER_BITS,
        } => Some("glClear(DEPTH_AND_STENCIL_BUFFER_BITS);".into()),
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
