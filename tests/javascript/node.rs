//! A process of node that runs programs.

use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};

use onionskin::low_level::edition::script;
use serde_json::{Value, json};

/// The first node that knows the language of the scripts. Browsers have known it since 2020.
const OLDEST: u32 = 16;

fn is_there() -> bool {
    let Ok(said) = Command::new("node").arg("--version").output() else {
        return false;
    };
    let version = String::from_utf8_lossy(&said.stdout);
    let first = version.trim_start_matches('v').split('.').next();
    first
        .and_then(|first| first.parse().ok())
        .is_some_and(|first: u32| first >= OLDEST)
}

pub(crate) struct Node {
    child: Child,
    asks: Option<ChildStdin>,
    answers: BufReader<ChildStdout>,
}

impl Node {
    /// `None` if there is no node, which is said.
    pub(crate) fn start() -> Option<Self> {
        if !is_there() {
            println!(
                "skipped: the machine of the pages runs on node {OLDEST} or later, which is not installed"
            );
            return None;
        }
        let root = env!("CARGO_MANIFEST_DIR");
        let mut command = Command::new("node");
        command.arg(format!("{root}/tests/javascript/node.js"));
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().unwrap();
        let mut node = Self {
            asks: child.stdin.take(),
            answers: BufReader::new(child.stdout.take().unwrap()),
            child,
        };
        // As pages have it.
        let script = tempfile::Builder::new().suffix(".js").tempfile().unwrap();
        std::fs::write(script.path(), script::machine()).unwrap();
        node.answer_to(&json!({ "machine": script.path() }));
        Some(node)
    }

    /// The program that is run from now on.
    pub(crate) fn run(&mut self, program: &Value) {
        self.answer_to(&json!({ "program": program }));
    }

    pub(crate) fn answer_to(&mut self, what: &Value) -> Value {
        self.ask(what);
        self.answer()
    }

    pub(crate) fn ask(&mut self, what: &Value) {
        let asks = self.asks.as_mut().unwrap();
        writeln!(asks, "{what}").unwrap();
        asks.flush().unwrap();
    }

    pub(crate) fn answer(&mut self) -> Value {
        let mut line = String::new();
        self.answers.read_line(&mut line).unwrap();
        assert!(!line.is_empty(), "node ended: its message is above");
        serde_json::from_str(&line).unwrap()
    }
}

impl Drop for Node {
    fn drop(&mut self) {
        // It ends when there is nothing left to read.
        self.asks = None;
        _ = self.child.wait();
    }
}
