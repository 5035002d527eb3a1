//! What the tests of the command line share: a folder to run it in, and what it answered.

use std::collections::BTreeMap;
use std::path::PathBuf;

use assert_cmd::Command;
use tempfile::TempDir;

/// A square of two triangles, which `render` shows with a fitted camera.
pub const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";

/// A folder that goes away with it, and the program run in it, so that messages name files without their folder.
pub struct Desk {
    folder: TempDir,
    variables: Vec<(String, String)>,
}

/// What the program answered.
#[derive(Debug)]
pub struct Answer {
    pub code: i32,
    pub out: String,
    pub err: String,
    /// The arguments, for messages.
    pub arguments: String,
}

impl Desk {
    pub fn new() -> Self {
        Self {
            folder: tempfile::tempdir().expect("a temporary folder"),
            variables: Vec::new(),
        }
    }

    /// Writes a file there.
    pub fn with(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        std::fs::write(self.path(name), content).expect("the folder can be written to");
        self
    }

    /// Sets an environment variable for the program.
    pub fn with_variable(mut self, name: &str, value: impl Into<String>) -> Self {
        self.variables.push((name.to_owned(), value.into()));
        self
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Every file there with its content, hidden ones too; a folder has none.
    pub fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let entries = std::fs::read_dir(self.folder.path()).expect("the folder");
        let file = |entry: std::io::Result<std::fs::DirEntry>| {
            let entry = entry.expect("an entry");
            // Sparse files of gigabytes are told by their size alone.
            let small = entry.metadata().is_ok_and(|m| m.len() < 1 << 20);
            let content = small.then(|| std::fs::read(entry.path()).unwrap_or_default());
            let name = entry.file_name().to_string_lossy().into_owned();
            (name, content.unwrap_or_default())
        };
        entries.map(file).collect()
    }

    pub fn names(&self) -> Vec<String> {
        self.files().into_keys().collect()
    }

    /// Runs the program there.
    #[track_caller]
    pub fn run(&self, arguments: &[&str]) -> Answer {
        let output = Command::new(env!("CARGO_BIN_EXE_onionskin"))
            .current_dir(self.folder.path())
            .args(arguments)
            // Help is wrapped to this where there is no terminal.
            .env("COLUMNS", "100")
            .envs(self.variables.iter().map(|(name, value)| (name, value)))
            .output()
            .expect("the program runs");
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        let answer = Answer {
            code: output.status.code().expect("it ends by itself"),
            out: text(output.stdout),
            err: text(output.stderr),
            arguments: arguments.join(" "),
        };
        assert!(!answer.err.contains("panicked"), "{answer}");
        answer
    }

    /// Runs the program, which must succeed with nothing to say besides its result.
    #[track_caller]
    pub fn result(&self, arguments: &[&str]) -> String {
        let answer = self.run(arguments);
        assert_eq!((answer.code, answer.err.as_str()), (0, ""), "{answer}");
        answer.out
    }

    /// Runs the program, which must refuse, print no result, and leave every file there as it was, with none added.
    #[track_caller]
    pub fn refused(&self, arguments: &[&str]) -> Answer {
        let before = self.files();
        let answer = self.run(arguments);
        assert_eq!((answer.code, answer.out.as_str()), (2, ""), "{answer}");
        assert!(
            self.files() == before,
            "files: {:?}\n{answer}",
            self.names()
        );
        answer
    }
}

impl Answer {
    /// Standard error has all of these.
    #[track_caller]
    pub fn says(&self, parts: &[&str]) -> &Self {
        for part in parts {
            assert!(self.err.contains(part), "no '{part}' in: {self}");
        }
        self
    }

    /// Each line of standard output is one JSON object.
    #[track_caller]
    pub fn objects(&self) -> Vec<serde_json::Map<String, serde_json::Value>> {
        let object = |line| serde_json::from_str(line).unwrap_or_else(|e| panic!("{e}: {self}"));
        self.out.lines().map(object).collect()
    }
}

impl std::fmt::Display for Answer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self {
            code,
            out,
            err,
            arguments,
        } = self;
        write!(
            f,
            "`onionskin {arguments}` answered {code}\n--- output\n{out}--- error\n{err}---"
        )
    }
}
