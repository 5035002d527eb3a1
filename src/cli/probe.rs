//! Trying a way to OpenGL in a process of its own, where that may crash or hang: drivers that an environment variable has
//! chosen, and drivers without memory, do both.

use std::process::{Child, Command, ExitCode, ExitStatus, Stdio};
use std::time::{Duration, Instant};

use clap::Args;
use onionskin::error::Attempt;
use onionskin::gl::{Backend, ContextOptions, GlMachine, suspect_variables};
use onionskin::{Context, Error, Result};

/// What the child is called with.
const NAME: &str = "probe";

/// A context takes some tens of milliseconds; on a machine that is busy with other things, seconds.
const PATIENCE: Duration = Duration::from_secs(30);

/// Make a context, draw with it and end
#[derive(Args)]
pub(super) struct Probe {
    backend: String,
}

impl Probe {
    pub(super) fn run(self) -> Result<ExitCode> {
        let context = Context::new(of(self.backend.parse()?))?;
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
    if let Some(answer) = crash(way) {
        let what = format!("{way}, in a process of its own");
        let mut tried = vec![Attempt { what, answer }];
        tried.extend(suspect_variables());
        return Err(Error::NoContext { tried });
    }
    Context::new(of(way))
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

/// How a child came to its end that made a context, if it was not by itself. Nothing, too, if no child could be made.
fn crash(way: Backend) -> Option<String> {
    let child = Command::new(std::env::current_exe().ok()?)
        .args([NAME, &way.to_string()])
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    let Some(status) = wait(child.ok()?) else {
        return Some(format!(
            "making a context and drawing takes longer than {} seconds{}",
            PATIENCE.as_secs(),
            limit()
        ));
    };
    let signal = signal(status)?;
    Some(format!(
        "making a context crashes (signal {signal}){}",
        limit()
    ))
}

/// Nothing if it does not end; then it is ended.
fn wait(mut child: Child) -> Option<ExitStatus> {
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
