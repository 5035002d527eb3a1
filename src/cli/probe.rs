//! Trying a backend of OpenGL in a separate process if it may crash or hang. Drivers that an environment variable has
//! chosen, and drivers without enough memory, do both.

use std::io::Read;
use std::process::{Child, Command, ExitCode, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use onionskin::low_level::error::Attempt;
use onionskin::low_level::gl::{GlMachine, suspect_variables};
use onionskin::{Backend, Context, ContextOptions, Error, Result};

use super::driver_report::{Form, Report};

/// The argument with which the child process is started.
const NAME: &str = "probe";

/// Making a context takes some tens of milliseconds, and seconds on a busy machine.
const PATIENCE: Duration = Duration::from_secs(30);

/// Make a context, draw with it and end
#[derive(Args)]
pub(super) struct Probe {
    backend: String,
    /// Print the doctor's report of it, as text or as JSON
    #[arg(long)]
    report: Option<Form>,
}

impl Probe {
    pub(super) fn run(self) -> Result<ExitCode> {
        let backend = self.backend.parse()?;
        let context = Context::new(of(backend))?;
        if let Some(form) = self.report {
            Report::of(backend, &context)?.print(form)?;
            return Ok(ExitCode::SUCCESS);
        }
        // Drivers without enough memory make contexts, and hang when they compile a shader.
        GlMachine::new(&context, [64, 64])?.traps()?;
        Ok(ExitCode::SUCCESS)
    }
}

/// A context of this backend, or of any backend if `None`. Backends that may crash are tried in a child process first.
pub(super) fn context(backend: Option<Backend>) -> Result<Context> {
    if !is_doubtful() {
        return Context::new(ContextOptions {
            backend,
            ..ContextOptions::default()
        });
    }
    let ways = backend.map_or_else(|| vec![Backend::Egl, Backend::OsMesa], |one| vec![one]);
    let mut all = Vec::new();
    for way in ways {
        match tried(way) {
            Err(Error::NoContext { tried }) => {
                let new = tried.into_iter().filter(|attempt| !all.contains(attempt));
                let new: Vec<_> = new.collect();
                all.extend(new);
            }
            answer => return answer,
        }
    }
    // The effect of the variables is reported once, after everything that was tried.
    let suspects = suspect_variables();
    all.retain(|attempt| !suspects.contains(attempt));
    all.extend(suspects);
    Err(Error::NoContext { tried: all })
}

/// A context of one backend, which is tried in a child process first.
pub(super) fn tried(way: Backend) -> Result<Context> {
    match child(way, None) {
        Some(Ended::Badly(answer)) => Err(crashed(way, answer)),
        _ => Context::new(of(way)),
    }
}

/// The doctor's report of one backend, made in a child process. The driver may hang even if the backend worked before,
/// because every context takes more of the limited memory.
pub(super) fn report(way: Backend, form: Form) -> Result<String> {
    match child(way, Some(form)) {
        Some(Ended::Well(report)) => Ok(report),
        Some(Ended::Badly(answer)) => Err(crashed(way, answer)),
        _ => {
            // The child has failed with a message. Here the error is made again.
            let context = Context::new(of(way))?;
            GlMachine::new(&context, [64, 64])?.traps()?;
            let answer = "it works, but not in a process of its own".to_owned();
            Err(crashed(way, answer))
        }
    }
}

fn crashed(way: Backend, answer: String) -> Error {
    let what = format!("{way}, in a process of its own");
    let mut tried = vec![Attempt { what, answer }];
    tried.extend(suspect_variables());
    Error::NoContext { tried }
}

fn of(way: Backend) -> ContextOptions {
    ContextOptions {
        backend: Some(way),
        ..ContextOptions::default()
    }
}

/// Whether a driver may crash or hang instead of failing.
fn is_doubtful() -> bool {
    !suspect_variables().is_empty() || memory_is_limited()
}

/// Whether the address space of this process is limited (`ulimit -v`), which Mesa does not survive.
fn memory_is_limited() -> bool {
    let limits = std::fs::read_to_string("/proc/self/limits").unwrap_or_default();
    let addresses = limits
        .lines()
        .find_map(|line| line.strip_prefix("Max address space"));
    addresses.is_some_and(|limit| !limit.trim_start().starts_with("unlimited"))
}

/// Other possible causes.
fn limit() -> &'static str {
    if memory_is_limited() {
        "; the memory of this process is limited (ulimit -v), which Mesa does not survive"
    } else {
        ""
    }
}

/// How the child process that made a context ended.
enum Ended {
    /// It drew an image. This is what it printed.
    Well(String),
    /// It returned an error.
    Refused,
    /// It crashed, or was killed.
    Badly(String),
}

/// Runs the child. `None` if no child can be started.
fn child(way: Backend, form: Option<Form>) -> Option<Ended> {
    let mut command = Command::new(std::env::current_exe().ok()?);
    command.args([NAME, &way.to_string()]);
    if let Some(form) = form.and_then(|form| form.to_possible_value()) {
        command.args(["--report", form.get_name()]);
    }
    // A report is shorter than a pipe's buffer, so the child never waits for a reader.
    let child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn();
    let mut child = child.ok()?;
    let Some(status) = wait(&mut child) else {
        let patience = PATIENCE.as_secs();
        let what = "making a context and drawing takes longer than";
        return Some(Ended::Badly(format!(
            "{what} {patience} seconds{}",
            limit()
        )));
    };
    if let Some(signal) = signal(status) {
        let what = "making a context crashes";
        return Some(Ended::Badly(format!("{what} (signal {signal}){}", limit())));
    }
    let mut printed = String::new();
    child.stdout.take()?.read_to_string(&mut printed).ok()?;
    Some(match status.success() {
        true => Ended::Well(printed),
        false => Ended::Refused,
    })
}

/// `None` if the child does not end in time. Then it is killed.
fn wait(child: &mut Child) -> Option<ExitStatus> {
    let start = Instant::now();
    while start.elapsed() < PATIENCE {
        match child.try_wait() {
            Ok(None) => std::thread::sleep(Duration::from_millis(3)),
            Ok(status) => return status,
            Err(_) => break,
        }
    }
    let _ = child.kill();
    let _ = child.wait();
    None
}

#[cfg(unix)]
fn signal(status: ExitStatus) -> Option<i32> {
    std::os::unix::process::ExitStatusExt::signal(&status)
}

/// On other systems, a crash is an exit code that this program does not use itself.
#[cfg(not(unix))]
fn signal(status: ExitStatus) -> Option<i32> {
    status.code().filter(|code| !(0..=2).contains(code))
}
