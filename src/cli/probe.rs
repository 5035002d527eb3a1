//! Trying a way to OpenGL in a process of its own, where that may crash or hang: drivers that an environment variable has
//! chosen, and drivers without memory, do both.

use std::io::Read;
use std::process::{Child, Command, ExitCode, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use clap::{Args, ValueEnum};
use onionskin::error::Attempt;
use onionskin::gl::{Backend, ContextOptions, GlMachine, suspect_variables};
use onionskin::{Context, Error, Result};

use super::driver_report::{Form, Report};

/// What the child is called with.
const NAME: &str = "probe";

/// A context takes some tens of milliseconds; on a machine that is busy with other things, seconds.
const PATIENCE: Duration = Duration::from_secs(30);

/// Make a context, draw with it and end
#[derive(Args)]
pub(super) struct Probe {
    backend: String,
    /// Say what the doctor says of it, as text or as JSON
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
        // Drivers without memory make contexts, and hang when they compile a shader.
        GlMachine::new(&context, [64, 64])?.traps()?;
        Ok(ExitCode::SUCCESS)
    }
}

/// A context by this way, or by any if none is said. Ways that may crash are tried in a child first.
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
    // What the variables do is said once, after everything that was tried.
    let suspects = suspect_variables();
    all.retain(|attempt| !suspects.contains(attempt));
    all.extend(suspects);
    Err(Error::NoContext { tried: all })
}

/// A context by one way, which is tried in a child first.
pub(super) fn tried(way: Backend) -> Result<Context> {
    match child(way, None) {
        Some(Ended::Badly(answer)) => Err(crashed(way, answer)),
        _ => Context::new(of(way)),
    }
}

/// What the doctor says of one way, made in a child: the driver may hang even where the way was found good before, since
/// every context takes more of a memory that is limited.
pub(super) fn report(way: Backend, form: Form) -> Result<String> {
    match child(way, Some(form)) {
        Some(Ended::Well(report)) => Ok(report),
        Some(Ended::Badly(answer)) => Err(crashed(way, answer)),
        _ => {
            // The child has refused with words. They are had here.
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

/// Whether a driver may do worse than refuse.
fn is_doubtful() -> bool {
    !suspect_variables().is_empty() || memory_is_limited()
}

/// Whether this process may not have as many addresses as it likes (`ulimit -v`): Mesa does not survive that.
fn memory_is_limited() -> bool {
    let limits = std::fs::read_to_string("/proc/self/limits").unwrap_or_default();
    let addresses = limits
        .lines()
        .find_map(|line| line.strip_prefix("Max address space"));
    addresses.is_some_and(|limit| !limit.trim_start().starts_with("unlimited"))
}

/// What else may be to blame.
fn limit() -> &'static str {
    if memory_is_limited() {
        "; the memory of this process is limited (ulimit -v), which Mesa does not survive"
    } else {
        ""
    }
}

/// How a child ended that made a context.
enum Ended {
    /// With an image, and what it has printed.
    Well(String),
    /// With an error.
    Refused,
    /// By a crash, or by us.
    Badly(String),
}

/// `None` if no child can be made.
fn child(way: Backend, form: Option<Form>) -> Option<Ended> {
    let mut command = Command::new(std::env::current_exe().ok()?);
    command.args([NAME, &way.to_string()]);
    if let Some(form) = form.and_then(|form| form.to_possible_value()) {
        command.args(["--report", form.get_name()]);
    }
    // A report is shorter than what a pipe holds, so the child never waits for it to be read.
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

/// `None` if it does not end; then it is ended.
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

/// Elsewhere a crash is an exit code that no part of this program ends with.
#[cfg(not(unix))]
fn signal(status: ExitStatus) -> Option<i32> {
    status.code().filter(|code| !(0..=2).contains(code))
}
