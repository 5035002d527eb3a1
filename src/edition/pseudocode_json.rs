//! Pseudocode as data that a machine runs: each line has a name, and as arguments the words that might be others.

use serde_json::{Value, json};

use crate::steps::Compare;
use crate::steps::pseudo::list::{
    Counter, Element, End, Key, ListLine, ListTest, Mark, Start, Taken,
};
use crate::steps::pseudo::{self, Line, Test};

/// What a line does, and on what.
pub(super) type Named = (&'static str, Value);

/// A line of an algorithm on fragments as they are rasterised.
pub(super) fn line(line: &Line) -> Named {
    match *line {
        Line::Pixels(_) => ("for pixels", json!({})),
        Line::Fragments { of, .. } => ("for fragments", json!({ "of": format!("{of:?}") })),
        Line::While { flag, .. } => ("while", json!({ "flag": flag })),
        Line::If { test, .. } => ("if", compared(test)),
        Line::Set { variable, value } => {
            let mut arguments = valued(value);
            arguments["variable"] = variable.into();
            ("set", arguments)
        }
        Line::Swap(a, b) => ("swap", json!({ "a": a, "b": b })),
        Line::Composite => ("composite", json!({})),
        Line::Margin(_) => ("nothing", json!({})),
    }
}

/// `a ab b`, and as far as they are there also `b bc c` and `c cd d`.
fn compared(test: Test) -> Value {
    match test {
        Test::One(a, ab, b) => json!({ "a": a, "ab": sign(ab), "b": b }),
        Test::Two(a, ab, b, bc, c) => {
            json!({ "a": a, "ab": sign(ab), "b": b, "bc": sign(bc), "c": c })
        }
        Test::Both((a, ab, b), (c, cd, d)) => {
            json!({ "a": a, "ab": sign(ab), "b": b, "c": c, "cd": sign(cd), "d": d })
        }
        Test::Set(flag) => json!({ "a": flag, "ab": "=", "b": "true" }),
    }
}

fn valued(value: pseudo::Value) -> Value {
    match value {
        pseudo::Value::Of(variable) => json!({ "value": variable }),
        pseudo::Value::Flag(flag) => json!({ "value": flag.to_string() }),
        pseudo::Value::BeforeEverything => json!({ "value": "before zNear" }),
        pseudo::Value::Either(flag, a, b) => json!({ "value": a, "if": flag, "else": b }),
    }
}

fn sign(compare: Compare) -> &'static str {
    match compare {
        Compare::Never => "never",
        Compare::Less => "<",
        Compare::Equal => "=",
        Compare::Lequal => "<=",
        Compare::Greater => ">",
        Compare::Notequal => "!=",
        Compare::Gequal => ">=",
        Compare::Always => "always",
    }
}

/// A line of an algorithm on finished lists.
pub(super) fn list_line(line: &ListLine) -> Named {
    match *line {
        ListLine::Input => ("input", json!({})),
        ListLine::Pixels(_) => ("for pixels", json!({})),
        ListLine::UnresolvedPixels(_) => ("for unresolved pixels", json!({})),
        ListLine::Segments(_) => ("for segments", json!({})),
        ListLine::Fragments(_) => ("for fragments", json!({})),
        ListLine::Repeat(_) => ("repeat", json!({})),
        ListLine::Until(End::AllResolved) => ("until", json!({ "end": "all resolved" })),
        ListLine::Until(End::NothingDropped) => ("until", json!({ "end": "nothing dropped" })),
        ListLine::If(test, ..) => ("if", tested(test)),
        ListLine::Count(counter) => ("count", json!({ "by": counted(counter) })),
        ListLine::Mark(mark) => ("mark", json!({ "by": marked(mark) })),
        ListLine::ResolveSegment => ("resolve", json!({})),
        ListLine::Run(..) => ("run", json!({})),
        ListLine::CreateBuffer => ("create buffer", json!({})),
        ListLine::SetMin(start) => ("set min", json!({ "to": begun(start) })),
        ListLine::Skip => ("skip", json!({})),
        ListLine::Insert(key) => ("insert", json!({ "by": keyed(key) })),
        ListLine::ResolveBuffer(Taken::All) => ("resolve buffer", json!({ "taken": "all" })),
        ListLine::ResolveBuffer(Taken::AllButLastOnOverflow) => (
            "resolve buffer",
            json!({ "taken": "all but the last on overflow" }),
        ),
        ListLine::Store(key, element) => {
            let of = match element {
                Element::Last => "last",
                Element::LastResolved => "last resolved",
            };
            ("store", json!({ "by": keyed(key), "of": of }))
        }
        ListLine::ClearBuffer => ("clear buffer", json!({})),
        // There is nothing to do here: the list exists, the size chooses the program, no volume has a state.
        ListLine::Note(_)
        | ListLine::ActivateProgram
        | ListLine::SizeOfLocalArray
        | ListLine::InitializeState
        | ListLine::Margin(_) => ("nothing", json!({})),
        ListLine::Sorted(_)
        | ListLine::Elements(_)
        | ListLine::BeginRay(_)
        | ListLine::Cast(_)
        | ListLine::Toggle
        | ListLine::Blend => ("cast ray", json!({})),
    }
}

fn tested(test: ListTest) -> Value {
    match test {
        ListTest::FitsSegment => json!({ "is": "complexity fits" }),
        ListTest::StencilFitsSegment => json!({ "is": "stencil fits" }),
        ListTest::FitsSegmentOrLast => json!({ "is": "complexity fits or last" }),
        ListTest::Overflows => json!({ "is": "overflows" }),
        ListTest::NotBehindMin(key) => json!({ "is": "not behind min", "by": keyed(key) }),
        ListTest::IsProxy => json!({ "is": "proxy" }),
    }
}

fn keyed(key: Key) -> &'static str {
    match key {
        Key::Depth => "depth",
        Key::DepthAndId => "depth, id",
    }
}

fn begun(start: Start) -> &'static str {
    match start {
        Start::Zero => "0",
        Start::BeforeAll => "before all",
    }
}

fn counted(counter: Counter) -> &'static str {
    match counter {
        Counter::Integer => "integer",
        Counter::Stencil => "INCR",
        Counter::StencilWrapping => "INCR_WRAP",
    }
}

fn marked(mark: Mark) -> &'static str {
    match mark {
        Mark::Resolved => "flag",
        Mark::Keep => "KEEP",
        Mark::Replace => "REPLACE",
        Mark::Invert => "INVERT",
    }
}
