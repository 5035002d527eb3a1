//! The JSON object of a listing, for `listing --json`. Its names are part of the command line's interface.
//!
//! | name | value |
//! | --- | --- |
//! | `key`, `title`, `source`, `reading` | the name on the command line, what it does, where it is printed, how it is read |
//! | `lines` | the printed text, line by line: `text`, `note`, `source`, `number` among the printed lines, `origin` |
//! | `steps` | the same as data, with the amendments of the reading in place |
//!
//! An `origin` has `is` (printed, prose, silence, filling, amendment or edition) and, as far as it has them, `quote`, `key`, `why`,
//! `rests_on` and `test`. Each step has `origin`, and `step`, which says what it is:
//!
//! | `step` | besides |
//! | --- | --- |
//! | `call` | `name`, and `arguments` with their names |
//! | `let` | `variable`, `value` |
//! | `if` | `when`, `then`, `otherwise` |
//! | `for`, `for-down` | `variable`, `from`, `to` (of a `for`), `body` |
//! | `stop` | `when`, `why` |
//! | `depth-unit` | `unit`, `body` |
//! | `run` | `title`, `source`, `body` |
//! | `silence` | nothing: read literally, the paper leaves something open here |
//! | any other | `text`, and of pseudocode that has statements inside, `body` and `otherwise` |
//!
//! An expression is a number, the name of a variable, `{"samples": query}`, or `[operator, a, b]`; a condition is
//! `[comparison, a, b]`.

use std::vec;

use serde_json::{Map, Value, json};

use super::pseudocode_json::{self, Named};
use crate::steps::pseudo::{self, list};
use crate::steps::{
    Amendment, Condition, Expr, Met, Origin, Reading, Scope, Statement, Step, Text, TextLine,
};

/// The object of a text, read like this.
pub fn object(key: &str, text: &Text, reading: Reading) -> Value {
    let lines: Vec<_> = text.lines(reading).iter().map(line).collect();
    json!({
        "key": key,
        "title": text.title(),
        "source": text.source(),
        "reading": reading.name(),
        "lines": lines,
        "steps": steps(text, reading, &mut Detail::Text),
    })
}

/// What is said of a statement besides.
pub(super) enum Detail {
    /// Where it comes from.
    Text,
    /// What a machine needs: the number of the line where it begins, and what it does if it is pseudocode. These are the
    /// numbers that are left.
    Program(vec::IntoIter<usize>),
}

impl Detail {
    /// For a text whose first line is that of this number.
    pub(super) fn program(lines: &[TextLine], first: usize) -> Self {
        let begins = (first..).zip(lines).filter(|(_, line)| line.begins);
        let numbers: Vec<_> = begins.map(|(number, _)| number).collect();
        Self::Program(numbers.into_iter())
    }
}

/// The statements of a text, read like this.
pub(super) fn steps(text: &Text, reading: Reading, detail: &mut Detail) -> Value {
    match text {
        Text::Listing(listing, amendments) => {
            tree(listing.steps, &reading.shown(amendments), step, detail)
        }
        Text::Pseudocode(algorithm, amendments) => tree(
            algorithm.lines,
            &reading.shown(amendments),
            pseudocode,
            detail,
        ),
        Text::Lists(algorithm, amendments) => tree(
            algorithm.lines,
            &reading.shown(amendments),
            on_lists,
            detail,
        ),
    }
}

pub(super) fn line(line: &TextLine) -> Value {
    json!({
        "text": line.text,
        "note": line.note,
        "source": line.source,
        "number": line.number,
        "origin": line.origin.map(origin),
    })
}

fn origin(origin: Origin) -> Value {
    let is = origin.name();
    match origin {
        Origin::Printed => json!({ "is": is }),
        Origin::Prose { quote } => json!({ "is": is, "quote": quote }),
        Origin::Filling { key, why, rests_on } | Origin::Silence { key, why, rests_on } => {
            json!({ "is": is, "key": key, "why": why, "rests_on": rests_on })
        }
        Origin::Amendment { key, why, test } => {
            json!({ "is": is, "key": key, "why": why, "test": test })
        }
        Origin::Edition { why } => json!({ "is": is, "why": why }),
    }
}

/// Makes an object of a statement. Statements inside of it are in the scope.
type Maker<S> = fn(&'static S, Scope<'_, S>, &mut Detail) -> Value;

fn tree<S: Statement>(
    statements: &'static [S],
    amendments: &[Amendment<S>],
    make: Maker<S>,
    detail: &mut Detail,
) -> Value {
    body(statements, Scope::of(amendments), make, detail)
}

fn body<S: Statement>(
    statements: &'static [S],
    scope: Scope<'_, S>,
    make: Maker<S>,
    detail: &mut Detail,
) -> Value {
    let made = scope.walk(statements).filter_map(|met| match met {
        Met::Amendment(amendment) => match amendment.origin() {
            silence @ Origin::Silence { .. } => Some(match detail {
                Detail::Text => json!({ "step": "silence", "origin": origin(silence) }),
                Detail::Program(lines) => json!({ "step": "silence", "line": lines.next() }),
            }),
            _ => None,
        },
        Met::Line(..) => None,
        Met::Statement(statement, scope) => Some(detailed(statement, scope, make, detail)),
    });
    made.collect()
}

fn detailed<S: Statement>(
    statement: &'static S,
    scope: Scope<'_, S>,
    make: Maker<S>,
    detail: &mut Detail,
) -> Value {
    // Its line comes before those inside of it.
    if let Detail::Program(lines) = detail {
        let line = lines.next();
        let mut object = make(statement, scope, detail);
        object["line"] = line.into();
        return object;
    }
    let mut object = make(statement, scope, detail);
    object["origin"] = scope.origin().map_or(Value::Null, origin);
    if let Some(spelling) = scope.spelling() {
        object["spelt"] = spelling.text.into();
    }
    object
}

fn step(step: &'static Step, scope: Scope<'_, Step>, detail: &mut Detail) -> Value {
    let mut inside = |steps| body(steps, scope, self::step, detail);
    match *step {
        Step::Call(call) => {
            let (name, arguments) = call.signature();
            let named = arguments
                .into_iter()
                .map(|(name, value)| (name.to_owned(), value.into()));
            json!({ "step": "call", "name": name, "arguments": named.collect::<Map<_, _>>() })
        }
        Step::DepthUnit { unit, body } => {
            json!({ "step": "depth-unit", "unit": unit, "body": inside(body) })
        }
        Step::Let { variable, value } => {
            json!({ "step": "let", "variable": variable, "value": expr(&value) })
        }
        Step::If {
            condition,
            then,
            otherwise,
        } => json!({
            "step": "if",
            "when": when(&condition),
            "then": inside(then),
            "otherwise": inside(otherwise),
        }),
        Step::For {
            variable,
            from,
            to,
            body,
        } => json!({
            "step": "for",
            "variable": variable,
            "from": expr(&from),
            "to": expr(&to),
            "body": inside(body),
        }),
        Step::ForDown {
            variable,
            from,
            body,
        } => json!({
            "step": "for-down",
            "variable": variable,
            "from": expr(&from),
            "body": inside(body),
        }),
        Step::Stop {
            when: condition,
            why,
        } => {
            json!({ "step": "stop", "when": when(&condition), "why": why.to_string() })
        }
        Step::Run {
            listing,
            amendments,
        } => json!({
            "step": "run",
            "title": listing.title,
            "source": listing.source,
            "body": body(listing.steps, scope.around(amendments), self::step, detail),
        }),
        Step::Margin(_) => Value::Null,
    }
}

fn expr(expr: &Expr) -> Value {
    match *expr {
        Expr::Number(number) => json!(number),
        Expr::Variable(name) => json!(name),
        Expr::Samples(query) => json!({ "samples": query.0 }),
        Expr::Sum(a, b) => json!(["+", self::expr(a), self::expr(b)]),
        Expr::Difference(a, b) => json!(["-", self::expr(a), self::expr(b)]),
        Expr::Product(a, b) => json!(["*", self::expr(a), self::expr(b)]),
        Expr::Remainder(a, b) => json!(["%", self::expr(a), self::expr(b)]),
    }
}

fn when(condition: &Condition) -> Value {
    let [a, b] = [&condition.left, &condition.right].map(expr);
    json!([condition.compare.name(), a, b])
}

fn pseudocode(
    line: &'static pseudo::Line,
    scope: Scope<'_, pseudo::Line>,
    detail: &mut Detail,
) -> Value {
    let named = pseudocode_json::line(line);
    inner(line, line.to_string(), named, scope, pseudocode, detail)
}

fn on_lists(
    line: &'static list::ListLine,
    scope: Scope<'_, list::ListLine>,
    detail: &mut Detail,
) -> Value {
    let named = pseudocode_json::list_line(line);
    inner(line, line.to_string(), named, scope, on_lists, detail)
}

/// A line of pseudocode, and what stands inside of it or is run by it.
fn inner<S: Statement>(
    line: &'static S,
    text: String,
    (name, arguments): Named,
    scope: Scope<'_, S>,
    make: Maker<S>,
    detail: &mut Detail,
) -> Value {
    let mut object = json!({ "step": "line", "text": text });
    if let Detail::Program(_) = detail {
        object["name"] = name.into();
        object["arguments"] = arguments;
    }
    let [first, second] = line.bodies();
    if let Some((lines, amendments)) = line.runs() {
        // The text that it runs is not printed.
        let unprinted = &mut match detail {
            Detail::Text => Detail::Text,
            Detail::Program(_) => Detail::Program(vec![].into_iter()),
        };
        object["body"] = body(lines, scope.around(amendments), make, unprinted);
    } else if !first.is_empty() {
        object["body"] = body(first, scope, make, detail);
    }
    if !second.is_empty() {
        object["otherwise"] = body(second, scope, make, detail);
    }
    object
}
