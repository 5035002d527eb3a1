//! What a method's frames spend their time on, step by step.

use std::ops::RangeInclusive;

use comfy_table::{CellAlignment, Table, presets};
use onionskin::low_level::gl::StepTime;
use serde::Serialize;

use super::statistics::Times;

/// Timer queries are trusted if, for each step that has a fiftieth of all steps' time or more, they have this part of the
/// time that was waited for it. A query that lies within a step cannot be longer but by its own overhead. One that is much
/// shorter has missed a part of the work: on llvmpipe, that of vertices.
const TRUSTED: RangeInclusive<f64> = 0.9..=1.05;
const WORTH_A_LOOK: f64 = 1.0 / 50.0;

/// The steps of a method, by the medians of some frames in which each of them was waited for.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Steps {
    /// The median of these frames, in milliseconds.
    pub(super) waited_ms: f64,
    /// The smallest and the largest part that timer queries have of a step's time.
    pub(super) parts_of_queries: [f64; 2],
    pub(super) steps: Vec<Step>,
}

/// A step in one frame.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Timed {
    step: String,
    times: u32,
    ms: f64,
    query_ms: f64,
}

impl From<StepTime> for Timed {
    fn from(time: StepTime) -> Self {
        Self {
            step: time.step,
            times: time.times,
            ms: time.ms,
            query_ms: time.query_ms,
        }
    }
}

/// A frame's time in milliseconds, and its steps.
pub(super) type Frame = (f64, Vec<Timed>);

#[derive(Clone, Debug, PartialEq, Serialize)]
pub(super) struct Step {
    pub(super) step: String,
    pub(super) times: u32,
    /// Between `glFinish` before and after.
    pub(super) ms: f64,
    /// By timer queries, if they are trusted.
    pub(super) query_ms: Option<f64>,
}

impl Steps {
    /// `None` without frames. A step that some of the frames have and others do not, such as one that is only drawn if any
    /// pixel is marked, takes no time in the others.
    pub(super) fn of(frames: &[Frame]) -> Option<Self> {
        let waited_ms = median(frames.iter().map(|(ms, _)| *ms))?;
        let mut steps: Vec<Step> = Vec::new();
        for time in frames.iter().flat_map(|(_, steps)| steps) {
            if steps.iter().any(|step| step.step == time.step) {
                continue;
            }
            let in_frames = |of: fn(&Timed) -> f64| {
                let of_frame = |(_, steps): &Frame| {
                    let mut steps = steps.iter();
                    steps.find(|step| step.step == time.step).map_or(0.0, of)
                };
                median(frames.iter().map(of_frame)).unwrap_or_default()
            };
            steps.push(Step {
                step: time.step.clone(),
                times: time.times,
                ms: in_frames(|step| step.ms),
                query_ms: Some(in_frames(|step| step.query_ms)),
            });
        }
        let all: f64 = steps.iter().map(|step| step.ms).sum();
        let looked_at = steps.iter().filter(|step| step.ms >= WORTH_A_LOOK * all);
        let parts = looked_at.filter_map(|step| step.query_ms.map(|ms| ms / step.ms));
        let parts_of_queries = parts.fold([f64::INFINITY, 0.0], |[low, high], part| {
            [low.min(part), high.max(part)]
        });
        if !parts_of_queries.iter().all(|part| TRUSTED.contains(part)) {
            steps.iter_mut().for_each(|step| step.query_ms = None);
        }
        Some(Self {
            waited_ms,
            parts_of_queries,
            steps,
        })
    }

    /// The table of the steps. `frame_ms` is the median of the frames in which no step was waited for.
    pub(super) fn table(&self, method: &str, frame_ms: f64) -> String {
        let trusted = self.steps.iter().any(|step| step.query_ms.is_some());
        let mut table = Table::new();
        table.load_style(presets::NOTHING);
        let mut header = vec![
            format!("steps of {method}"),
            "times".into(),
            "ms".into(),
            "%".into(),
        ];
        header.extend(trusted.then(|| "timer query".into()));
        table.set_header(header);
        let part = |ms: f64| format!("{:.0}", 100.0 * ms / self.waited_ms);
        for step in &self.steps {
            let mut cells = vec![
                step.step.clone(),
                step.times.to_string(),
                format!("{:.2}", step.ms),
                part(step.ms),
            ];
            cells.extend(step.query_ms.map(|ms| format!("{ms:.2}")));
            table.add_row(cells);
        }
        let rest = self.waited_ms - self.steps.iter().map(|step| step.ms).sum::<f64>();
        let rest = rest.max(0.0);
        table.add_row([
            "between them: sorting, uploads, scans, reading counts".into(),
            String::new(),
            format!("{rest:.2}"),
            part(rest),
        ]);
        for column in table.column_iter_mut().skip(1) {
            column.set_cell_alignment(CellAlignment::Right);
        }
        let queries = match trusted {
            true => "Timer queries agree",
            false => "Timer queries are not trusted",
        };
        let [low, high] = self.parts_of_queries.map(|part| 100.0 * part);
        format!(
            "{table}\nEach step waited for, by glFinish: a frame takes {:.2} times as long as without.\n\
             {queries}: they have {low:.0}% to {high:.0}% of the time of steps that matter.",
            self.waited_ms / frame_ms,
        )
    }
}

fn median(times: impl Iterator<Item = f64>) -> Option<f64> {
    Times::of(times.collect()).map(|times| times.median())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn timed(step: &str, ms: f64, query_ms: f64) -> Timed {
        Timed {
            step: step.into(),
            times: 1,
            ms,
            query_ms,
        }
    }

    #[test]
    fn a_step_has_the_median_of_its_frames_and_no_time_in_those_without_it() {
        let frames = [
            (
                10.0,
                vec![timed("clear", 1.0, 1.0), timed("draw", 6.0, 6.0)],
            ),
            (
                12.0,
                vec![
                    timed("clear", 3.0, 2.9),
                    timed("draw", 8.0, 7.9),
                    timed("lists", 2.0, 2.0),
                ],
            ),
            (
                11.0,
                vec![timed("clear", 2.0, 1.9), timed("draw", 7.0, 7.0)],
            ),
        ];
        let steps = Steps::of(&frames).unwrap();
        assert_eq!(steps.waited_ms, 11.0);
        let shown: Vec<_> = steps
            .steps
            .iter()
            .map(|step| (&*step.step, step.ms))
            .collect();
        assert_eq!(shown, [("clear", 2.0), ("draw", 7.0), ("lists", 0.0)]);
        assert_eq!(steps.steps[1].query_ms, Some(7.0));
        assert_eq!(Steps::of(&[]), None);
    }

    #[test]
    fn queries_that_miss_a_part_of_the_work_are_not_shown() {
        for (query_ms, trusted) in [(9.5, true), (8.0, false), (0.0, false), (20.0, false)] {
            let frames = [(12.0, vec![timed("draw", 10.0, query_ms)])];
            let steps = Steps::of(&frames).unwrap();
            assert_eq!(steps.steps[0].query_ms.is_some(), trusted, "{query_ms}");
            let table = steps.table("blend", 11.0);
            assert_eq!(
                table.contains("queries are not trusted"),
                !trusted,
                "{table}"
            );
            assert_eq!(table.contains("9.50"), trusted, "{table}");
        }
    }
}
