//! Plots of lines. A page draws them as SVG, with a readout of the nearest point.

use serde_json::{Value, json};

/// A plot of lines over one quantity.
#[derive(Clone, Debug, Default)]
pub struct Chart {
    /// What it shows.
    pub title: String,
    /// The quantity across, with its unit.
    pub across: String,
    /// The quantity upwards, with its unit.
    pub up: String,
    /// Whether powers of ten are equally far apart upwards. Then what is not above 0 is left out.
    pub logarithmic: bool,
    /// The lines.
    pub lines: Vec<Line>,
}

/// A line of a plot.
#[derive(Clone, Debug, Default)]
pub struct Line {
    /// Its name.
    pub label: String,
    /// Its points, in the order in which they are joined.
    pub points: Vec<[f64; 2]>,
}

const WIDTH: f64 = 640.0;
const HEIGHT: f64 = 320.0;
/// Space at the left, the top, the right and the bottom.
const MARGIN: [f64; 4] = [70.0, 14.0, 14.0, 46.0];

impl Chart {
    /// A plot without lines.
    pub fn new(title: &str, across: &str, up: &str) -> Self {
        Self {
            title: title.into(),
            across: across.into(),
            up: up.into(),
            ..Self::default()
        }
    }

    /// The same with powers of ten equally far apart upwards.
    #[must_use]
    pub fn logarithmic(self) -> Self {
        Self {
            logarithmic: true,
            ..self
        }
    }

    /// One more line.
    #[must_use]
    pub fn line(mut self, label: &str, points: impl IntoIterator<Item = [f64; 2]>) -> Self {
        self.lines.push(Line {
            label: label.into(),
            points: points.into_iter().collect(),
        });
        self
    }

    /// What the page's template draws: places in units of the SVG, and texts.
    pub(in crate::low_level::edition) fn laid_out(&self) -> Value {
        let shown = |line: &Line| -> Vec<[f64; 2]> {
            let points = line.points.iter().copied();
            points
                .filter(|[x, y]| x.is_finite() && y.is_finite() && (!self.logarithmic || *y > 0.0))
                .collect()
        };
        let lines: Vec<(&str, Vec<[f64; 2]>)> = self
            .lines
            .iter()
            .map(|line| (line.label.as_str(), shown(line)))
            .collect();
        let all = || lines.iter().flat_map(|(_, points)| points);
        let across = Axis::linear(all().map(|p| p[0]), [MARGIN[0], WIDTH - MARGIN[2]], false);
        let upwards = [HEIGHT - MARGIN[3], MARGIN[1]];
        let up = match self.logarithmic {
            true => Axis::powers(all().map(|p| p[1]), upwards),
            false => Axis::linear(all().map(|p| p[1]), upwards, true),
        };
        let points = |points: &[[f64; 2]]| -> Vec<Value> {
            let place = |&[x, y]: &[f64; 2]| {
                json!({
                    "x": rounded(across.at(x)),
                    "y": rounded(up.at(y)),
                    "across": short(x),
                    "up": short(y),
                })
            };
            points.iter().map(place).collect()
        };
        json!({
            "title": self.title,
            "across": self.across,
            "up": self.up,
            "width": WIDTH,
            "height": HEIGHT,
            "left": MARGIN[0],
            "top": MARGIN[1],
            "right": WIDTH - MARGIN[2],
            "bottom": HEIGHT - MARGIN[3],
            "ticks_across": across.ticks(),
            "ticks_up": up.ticks(),
            "lines": lines
                .iter()
                .map(|(label, at)| json!({ "label": label, "points": points(at) }))
                .collect::<Vec<_>>(),
        })
    }
}

/// One direction of a plot.
struct Axis {
    /// The values at the ends, as logarithms if powers are equally far apart.
    ends: [f64; 2],
    places: [f64; 2],
    powers: bool,
    step: f64,
}

impl Axis {
    fn linear(values: impl Iterator<Item = f64>, places: [f64; 2], from_zero: bool) -> Self {
        let [low, high] = ends(values);
        let low = if from_zero { low.min(0.0) } else { low };
        let high = if high > low { high } else { low + 1.0 };
        let step = step((high - low) / 5.0);
        Self {
            ends: [(low / step).floor() * step, (high / step).ceil() * step],
            places,
            powers: false,
            step,
        }
    }

    fn powers(values: impl Iterator<Item = f64>, places: [f64; 2]) -> Self {
        let [low, high] =
            ends(values.map(f64::log10)).map(|it| if it.is_finite() { it } else { 0.0 });
        let (low, high) = (low.floor(), high.ceil().max(low.floor() + 1.0));
        Self {
            ends: [low, high],
            places,
            powers: true,
            step: ((high - low) / 6.0).ceil(),
        }
    }

    fn at(&self, value: f64) -> f64 {
        let value = if self.powers { value.log10() } else { value };
        let along = (value - self.ends[0]) / (self.ends[1] - self.ends[0]);
        self.places[0] + along * (self.places[1] - self.places[0])
    }

    fn ticks(&self) -> Vec<Value> {
        let count = ((self.ends[1] - self.ends[0]) / self.step).round() as i32;
        let tick = |number: i32| {
            let value = self.ends[0] + f64::from(number) * self.step;
            let value = if self.powers {
                10f64.powf(value)
            } else {
                value
            };
            json!({ "at": rounded(self.at(value)), "text": short(value) })
        };
        (0..=count).map(tick).collect()
    }
}

fn ends(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], it| {
        [low.min(it), high.max(it)]
    });
    match low <= high {
        true => [low, high],
        false => [0.0, 1.0],
    }
}

/// The least of 1, 2 and 5 times a power of ten that is not less.
fn step(least: f64) -> f64 {
    let power = 10f64.powf(least.log10().floor());
    let factor = [1.0, 2.0, 5.0, 10.0]
        .into_iter()
        .find(|factor| factor * power >= least * (1.0 - 1e-9));
    factor.unwrap_or(10.0) * power
}

/// A place, to a tenth of a unit.
fn rounded(place: f64) -> f64 {
    (place * 10.0).round() / 10.0
}

/// A number with three digits that count.
fn short(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 || value.fract() == 0.0 && size < 1e6 {
        return format!("{value:.0}");
    }
    if !(1e-3..1e6).contains(&size) {
        return format!("{value:.2e}")
            .replace(".00e", "e")
            .replace("0e", "e");
    }
    let digits = (2 - size.log10().floor() as i32).max(0) as usize;
    let text = format!("{value:.digits$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').into(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_digits_that_count() {
        let texts = [
            0.0, 1.0, 12.0, 0.5, 0.12345, 123.456, 1e-5, 1.234e-7, 20_000.0, -0.25,
        ];
        let expected = [
            "0", "1", "12", "0.5", "0.123", "123", "1e-5", "1.23e-7", "20000", "-0.25",
        ];
        assert_eq!(texts.map(short), expected);
    }

    #[test]
    fn the_ends_of_an_axis_are_steps_and_hold_every_value() {
        let chart = Chart::new("", "", "").line("a", [[1.0, 0.2], [12.0, 0.93]]);
        let laid = chart.laid_out();
        let ticks = |name: &str| -> Vec<String> {
            let all = laid[name].as_array().unwrap().iter();
            all.map(|tick| tick["text"].as_str().unwrap().to_owned())
                .collect()
        };
        assert_eq!(ticks("ticks_across"), ["0", "5", "10", "15"]);
        assert_eq!(ticks("ticks_up"), ["0", "0.2", "0.4", "0.6", "0.8", "1"]);
        let points = laid["lines"][0]["points"].as_array().unwrap();
        // 12 of 15 of the way from 70 to 626, and 0.93 of the way from 274 up to 14.
        assert_eq!(points[1]["x"], 514.8);
        assert_eq!(points[1]["y"], 32.2);
    }

    #[test]
    fn powers_leave_out_what_is_not_above_0_and_a_chart_may_be_empty() {
        let chart = Chart::new("", "", "").logarithmic();
        let laid = chart
            .clone()
            .line("a", [[1.0, 0.1], [2.0, 0.001], [3.0, 0.0]])
            .laid_out();
        assert_eq!(laid["lines"][0]["points"].as_array().unwrap().len(), 2);
        assert_eq!(laid["ticks_up"].as_array().unwrap().len(), 3);
        chart.laid_out();
    }
}
