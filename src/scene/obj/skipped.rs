//! What a model holds that is not drawn, to be said in a notice.

use std::path::Path;

use super::counted;

/// Counts of what was left out.
#[derive(Default)]
pub(super) struct Skipped {
    lines: usize,
    points: usize,
    free_form: usize,
    unknown: usize,
    first_unknown: Option<(String, usize)>,
}

/// Keywords of the format that change nothing that is drawn here, or belong to a free-form curve that was counted.
const SILENT: [&str; 29] = [
    "s",
    "vp",
    "deg",
    "bmat",
    "step",
    "cstype",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "mg",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "usemap",
    "maplib",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "call",
    "csh",
    "res",
    "cdc",
    "cdp",
];

impl Skipped {
    /// A line with this keyword was left out.
    pub(super) fn count(&mut self, keyword: &str, line: usize) {
        match keyword {
            "l" => self.lines += 1,
            "p" => self.points += 1,
            "curv" | "curv2" | "surf" => self.free_form += 1,
            _ if SILENT.contains(&keyword) => {}
            _ => {
                self.unknown += 1;
                let first = || (keyword.chars().take(40).collect(), line);
                self.first_unknown.get_or_insert_with(first);
            }
        }
    }

    /// Whether there were shapes other than faces.
    pub(super) fn has_other_shapes(&self) -> bool {
        self.lines + self.points + self.free_form > 0
    }

    /// A sentence for each kind.
    pub(super) fn notices(&self, path: &Path) -> Vec<String> {
        let kinds = [
            (self.lines, "line element"),
            (self.points, "point element"),
            (self.free_form, "free-form curve or surface element"),
        ];
        let mut notices: Vec<String> = kinds
            .into_iter()
            .filter(|&(count, _)| count > 0)
            .map(|(count, kind)| {
                let some = counted(count, kind);
                format!("{}: {some} skipped, only faces are drawn", path.display())
            })
            .collect();
        if let Some((keyword, line)) = &self.first_unknown {
            let some = counted(self.unknown, "line");
            notices.push(format!(
                "{}:{line}: {some} with an unknown keyword skipped, the first is '{keyword}'",
                path.display()
            ));
        }
        notices
    }
}
