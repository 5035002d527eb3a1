//! What came of one method on one scene: a row of the table, a JSON object, a line of the CSV.

use onionskin::{Method, Scene, Stats};
use serde::ser::{Serialize, SerializeMap, Serializer};
use serde_json::Value;

use super::statistics::Times;
use super::steps::Steps;

/// Who draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum By {
    Onionskin,
    Vtk,
}

/// One who took part.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) by: By,
    pub(super) method: String,
    pub(super) counts: Counts,
    /// The times, or why there are none.
    pub(super) times: Result<Times, String>,
    /// The times of its steps, if they are asked for.
    pub(super) steps: Option<Steps>,
}

/// Counts of the frame that is seen as the scene's camera sees it. They are the same in every run.
#[derive(Clone, Debug, Default)]
pub(super) struct Counts {
    pub(super) iterations: Option<u32>,
    pub(super) geometry_passes: Option<u64>,
    pub(super) triangles: Option<u64>,
    pub(super) fragments: Option<u64>,
    pub(super) bytes: Option<u64>,
    pub(super) slices: Option<u32>,
    pub(super) marked_pixels: Option<u64>,
    /// The fragments that were put into lists.
    pub(super) list_fragments: Option<u64>,
}

impl Counts {
    pub(super) fn of(method: &Method, stats: &Stats) -> Self {
        let verified = stats.verified.as_ref();
        Self {
            iterations: Some(stats.iterations),
            geometry_passes: Some(stats.geometry_passes),
            triangles: Some(stats.triangles),
            fragments: Some(stats.fragments),
            bytes: Some(stats.bytes),
            slices: stats.slices,
            marked_pixels: verified.map(|counts| counts.marked_pixels),
            list_fragments: match method {
                Method::ABuffer(_) => Some(stats.fragments),
                _ => verified.map(|counts| counts.list_fragments),
            },
        }
    }
}

impl Row {
    /// The name of who draws, and how.
    pub(super) fn name(&self) -> String {
        match self.by {
            By::Onionskin => self.method.clone(),
            By::Vtk => format!("VTK {}", self.method),
        }
    }

    /// A row before anything is measured.
    pub(super) fn begun(by: By, method: &str) -> Self {
        Self {
            by,
            method: method.into(),
            counts: Counts::default(),
            times: Err("not measured".into()),
            steps: None,
        }
    }
}

/// All rows of a scene.
pub(super) struct Rows<'s> {
    pub(super) scene: &'s Scene,
    /// The name of the device that drew.
    pub(super) device: &'s str,
    pub(super) rows: Vec<Row>,
}

/// A row's values by their names, in order. The names are part of the command line's interface.
pub(super) struct Fields(Vec<(&'static str, Value)>);

impl Rows<'_> {
    /// The median of plain blending.
    pub(super) fn base(&self) -> Option<f64> {
        self.median(By::Onionskin, super::methods::BASE.name())
    }

    pub(super) fn median(&self, by: By, method: &str) -> Option<f64> {
        let mut rows = self.rows.iter();
        let row = rows.find(|row| row.by == by && row.method == method)?;
        row.times.as_ref().ok().map(Times::median)
    }

    pub(super) fn fields(&self, row: &Row) -> Fields {
        let counts = &row.counts;
        let times = row.times.as_ref().ok();
        let median = times.map(Times::median);
        let of = |base: Option<f64>| Value::from(median.zip(base).map(|(ms, base)| ms / base));
        let of_vtk = |mode| {
            of(self
                .median(By::Vtk, mode)
                .filter(|_| row.by == By::Onionskin))
        };
        let [width, height] = self.scene.size;
        Fields(vec![
            ("scene", self.scene.name.as_str().into()),
            ("width", width.into()),
            ("height", height.into()),
            ("device", self.device.into()),
            (
                "by",
                match row.by {
                    By::Onionskin => "onionskin",
                    By::Vtk => "VTK",
                }
                .into(),
            ),
            ("method", row.method.as_str().into()),
            ("iterations", counts.iterations.into()),
            ("geometry_passes", counts.geometry_passes.into()),
            ("triangles", counts.triangles.into()),
            ("fragments", counts.fragments.into()),
            ("slices", counts.slices.into()),
            ("marked_pixels", counts.marked_pixels.into()),
            ("list_fragments", counts.list_fragments.into()),
            ("bytes", counts.bytes.into()),
            ("frames", times.map(Times::count).into()),
            ("ms", median.into()),
            ("ms_min", times.map(Times::min).into()),
            ("ms_max", times.map(Times::max).into()),
            ("of_blend", of(self.base())),
            ("of_vtk_alpha", of_vtk("alpha")),
            ("of_vtk_peel", of_vtk("peel")),
            ("of_vtk_dual", of_vtk("dual")),
            ("left_out", row.times.as_ref().err().cloned().into()),
        ])
    }

    /// The rows as CSV, after a line of names if `with_names`.
    pub(super) fn csv(&self, with_names: bool) -> String {
        let mut text = String::new();
        for (number, row) in self.rows.iter().enumerate() {
            let Fields(fields) = self.fields(row);
            if number == 0 && with_names {
                let names: Vec<_> = fields.iter().map(|(name, _)| *name).collect();
                text += &(names.join(",") + "\n");
            }
            let cells: Vec<_> = fields.iter().map(|(_, value)| cell(value)).collect();
            text += &(cells.join(",") + "\n");
        }
        text
    }
}

/// Text with a comma, a quotation mark or a line end is quoted (RFC 4180).
fn cell(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) if text.contains([',', '"', '\n', '\r']) => {
            format!("\"{}\"", text.replace('"', "\"\""))
        }
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(by: By, method: &str, times: &[f64]) -> Row {
        Row {
            by,
            method: method.into(),
            counts: Counts::default(),
            times: Times::of(times.to_vec()).ok_or("no, \"never\"".into()),
            steps: None,
        }
    }

    #[test]
    fn ratios_are_those_of_medians() {
        let scene = Scene::of("two, or three", Vec::new());
        let rows = Rows {
            scene: &scene,
            device: "none",
            rows: vec![
                row(By::Onionskin, "blend", &[2.0, 4.0, 9.0]),
                row(By::Onionskin, "dfb", &[10.0]),
                row(By::Vtk, "dual", &[40.0]),
                row(By::Onionskin, "ffb", &[]),
            ],
        };
        let value = |number: usize, name: &str| {
            let Fields(fields) = rows.fields(&rows.rows[number]);
            fields
                .into_iter()
                .find(|(known, _)| *known == name)
                .unwrap()
                .1
        };
        assert_eq!(value(1, "of_blend"), 2.5);
        assert_eq!(value(1, "of_vtk_dual"), 0.25);
        assert_eq!(value(1, "of_vtk_peel"), Value::Null);
        assert_eq!(value(2, "of_blend"), 10.0);
        assert_eq!(value(2, "of_vtk_dual"), Value::Null);
        assert_eq!(value(3, "ms"), Value::Null);
        let csv = rows.csv(true);
        let lines: Vec<_> = csv.lines().collect();
        assert_eq!(lines.len(), 5);
        assert!(
            lines[1].starts_with("\"two, or three\",1024,768,none,onionskin,blend,"),
            "{csv}"
        );
        assert!(lines[4].ends_with(",\"no, \"\"never\"\"\""), "{csv}");
    }
}
