//! A progress bar for work that takes longer than a second. Nothing is shown before that, or if standard error is not a
//! terminal.

use std::sync::mpsc::{Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use onionskin::low_level::error::printable;

const PATIENCE: Duration = Duration::from_secs(1);

pub(super) struct Progress {
    bar: ProgressBar,
    /// It is dropped when the work is done, which ends the thread.
    done: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    /// Progress of work of so many parts.
    pub(super) fn new(parts: u64, message: &str) -> Self {
        let template = if parts > 1 {
            "{bar:30} {pos}/{len} {msg} {elapsed}"
        } else {
            "{spinner} {msg} {elapsed}"
        };
        let style =
            ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let bar = ProgressBar::with_draw_target(Some(parts), ProgressDrawTarget::hidden())
            .with_style(style)
            .with_message(printable(message).into_owned());
        let (done, is_done) = channel::<()>();
        let late = bar.clone();
        let thread = std::thread::spawn(move || {
            // An error within less than a second means that the work is done.
            if is_done.recv_timeout(PATIENCE) == Err(std::sync::mpsc::RecvTimeoutError::Timeout) {
                late.set_draw_target(ProgressDrawTarget::stderr());
                late.enable_steady_tick(Duration::from_millis(100));
            }
        });
        Self {
            bar,
            done: Some(done),
            thread: Some(thread),
        }
    }

    /// Begins the next part.
    pub(super) fn next(&self, message: &str) {
        self.bar.set_message(printable(message).into_owned());
    }

    /// Ends a part.
    pub(super) fn part_done(&self) {
        self.bar.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.done = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
        self.bar.finish_and_clear();
    }
}
