//! The look of a material: its colour and its opacity, and the assumptions behind them.

use std::collections::BTreeMap;
use std::path::Path;

use super::library::{Library, Material, Statement};
use super::notes::counted;
use super::numbers;
use super::transparency::{SAME, Tr};
use super::words;

/// A material's colour and opacity. `None` if the file has no value that can be read.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) color: Option<[f32; 3]>,
    pub(super) opacity: Option<f32>,
}

impl Look {
    /// Resolves a material.
    pub(super) fn of(material: &Material, tr: Tr, notes: &mut LookNotes) -> Self {
        notes.maps(material);
        let color = match (&material.kd, &material.ka) {
            (Some(kd), _) => color(kd, notes),
            (None, Some(ka)) => color(ka, notes),
            (None, None) => None,
        };
        let opacity = opacity(material, tr, notes);
        Self { color, opacity }
    }
}

/// Three channels, or one for all three.
fn color(statement: &Statement, notes: &mut LookNotes) -> Option<[f32; 3]> {
    let mut words = words::words(&statement.rest);
    let first = words.next().unwrap_or_default();
    if first.eq_ignore_ascii_case(b"spectral") || first.eq_ignore_ascii_case(b"xyz") {
        notes.count(Kind::OtherColor, statement, first);
        return None;
    }
    let numbers: Vec<Option<f64>> = words::words(&statement.rest)
        .take(4)
        .map(numbers::number)
        .collect();
    let channels = match numbers[..] {
        [Some(grey)] => [grey; 3],
        [Some(r), Some(g), Some(b)] => [r, g, b],
        [Some(r), Some(g), Some(b), _] => {
            notes.count(Kind::LongColor, statement, &statement.rest);
            [r, g, b]
        }
        _ => {
            notes.count(Kind::UnreadableColor, statement, &statement.rest);
            return None;
        }
    };
    let whole = channels
        .iter()
        .all(|channel| channel.fract() == 0.0 && (0.0..=255.0).contains(channel));
    if whole && channels.iter().any(|&channel| channel >= TOO_BRIGHT) {
        notes.count(Kind::ColorOf255, statement, &statement.rest);
        return Some(channels.map(|channel| (channel / 255.0) as f32));
    }
    if channels
        .iter()
        .any(|channel| !(0.0..=1.0).contains(channel))
    {
        notes.count(Kind::ColorClamped, statement, &statement.rest);
    }
    Some(channels.map(|channel| channel.clamp(0.0, 1.0) as f32))
}

/// A colour of whole numbers that reaches this value goes from 0 to 255. No exporter writes a colour so bright
/// otherwise.
const TOO_BRIGHT: f64 = 16.0;

/// The opacity: from `d` if that can be read, or else from `Tr`.
fn opacity(material: &Material, meaning: Tr, notes: &mut LookNotes) -> Option<f32> {
    let d = material.d.as_ref().and_then(|d| {
        if words::words(&d.rest).next() == Some(b"-halo") {
            notes.count(Kind::Halo, d, b"-halo");
        }
        Some((d, fraction(d, notes)?))
    });
    let Some(tr) = &material.tr else {
        return d.map(|(_, d)| d as f32);
    };
    let Some((_, d)) = d else {
        let opacity = meaning.opacity(fraction(tr, notes)?);
        notes.tr(meaning, tr);
        return Some(opacity as f32);
    };
    // It is not needed, so it may have any value.
    let agrees = tr
        .number()
        .is_some_and(|tr| (meaning.opacity(tr) - d).abs() <= SAME);
    if !agrees {
        notes.count(Kind::Disagree, tr, &tr.rest);
    }
    Some(d as f32)
}

/// A number from 0 to 1, or the nearest number in this range.
fn fraction(statement: &Statement, notes: &mut LookNotes) -> Option<f64> {
    let Some(number) = statement.number() else {
        notes.count(Kind::UnreadableOpacity, statement, &statement.rest);
        return None;
    };
    if !(0.0..=1.0).contains(&number) {
        notes.count(Kind::OpacityClamped, statement, &statement.rest);
    }
    Some(number.clamp(0.0, 1.0))
}

/// The kinds of notes about the materials of a file, in the order in which they are printed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Homeless,
    Tr,
    Disagree,
    OpacityClamped,
    UnreadableOpacity,
    Halo,
    ColorClamped,
    ColorOf255,
    LongColor,
    OtherColor,
    UnreadableColor,
    Repeated,
    OpacityMap,
    ColorMap,
    OtherMap,
}

/// The count of each kind, with the line and the word of the first occurrence.
#[derive(Default)]
pub(super) struct LookNotes {
    found: BTreeMap<Kind, (usize, usize, String)>,
    tr: Option<Tr>,
}

impl LookNotes {
    fn count(&mut self, kind: Kind, statement: &Statement, word: &[u8]) {
        let first = || (0, statement.line, words::shown(word));
        self.found.entry(kind).or_insert_with(first).0 += 1;
    }

    fn tr(&mut self, meaning: Tr, statement: &Statement) {
        self.tr = Some(meaning);
        self.count(Kind::Tr, statement, &statement.rest);
    }

    fn maps(&mut self, material: &Material) {
        let maps = [
            (Kind::OpacityMap, &material.map_d),
            (Kind::ColorMap, &material.map_kd),
            (Kind::OtherMap, &material.map),
        ];
        for (kind, map) in maps {
            if let Some(map) = map {
                self.count(kind, map, &map.rest);
            }
        }
    }

    /// Statements that belong to no material.
    pub(super) fn homeless(&mut self, library: &Library) {
        if let (1.., line) = library.homeless {
            let rest = Vec::new();
            self.count(Kind::Homeless, &Statement { line, rest }, &[]);
        }
    }

    /// The same file has defined it before.
    pub(super) fn repeated(&mut self, material: &Material) {
        let statement = Statement {
            line: material.line,
            rest: Vec::new(),
        };
        self.count(Kind::Repeated, &statement, &material.name);
    }

    /// One sentence for each kind.
    pub(super) fn sentences(&self, file: &Path) -> impl Iterator<Item = String> {
        self.found.iter().map(|(kind, (count, line, word))| {
            let some = counted(*count, "material");
            let sentence = self.sentence(*kind, &some, word);
            format!("{}:{line}: {sentence}", file.display())
        })
    }

    fn sentence(&self, kind: Kind, some: &str, word: &str) -> String {
        let tr = self.tr.map(Tr::sentence).unwrap_or_default();
        match kind {
            Kind::Homeless => "what stands before the first material is skipped".to_owned(),
            Kind::Tr => format!("`Tr` without `d` in {some}: {tr}"),
            Kind::Disagree => {
                format!("`Tr {word}` does not fit the `d` beside it in {some}: `d` is used")
            }
            Kind::OpacityClamped => format!(
                "an opacity or transparency beyond 0 to 1 in {some}, the first is '{word}': the nearest within is taken"
            ),
            Kind::UnreadableOpacity => format!(
                "an opacity or transparency that cannot be read in {some}, the first is '{word}': it is left out"
            ),
            Kind::Halo => format!(
                "an opacity that depends on the viewing angle (`-halo`) in {some}: taken as the same from everywhere"
            ),
            Kind::ColorClamped => format!(
                "a colour beyond 0 to 1 in {some}, the first is '{word}': the nearest within is taken"
            ),
            Kind::ColorOf255 => format!(
                "a colour of whole numbers up to 255 in {some}, the first is '{word}': taken as 255 times the colour"
            ),
            Kind::LongColor => format!(
                "a colour of more than three numbers in {some}, the first is '{word}': those after the third are left out"
            ),
            Kind::OtherColor => format!(
                "a colour other than red, green and blue ({word}) in {some}: it is not read, the default colour is used"
            ),
            Kind::UnreadableColor => format!(
                "a colour that cannot be read in {some}, the first is '{word}': the default colour is used"
            ),
            Kind::Repeated => format!(
                "{some} defined more than once, the first is '{word}': the first definition is used"
            ),
            Kind::OpacityMap => format!(
                "an opacity map in {some}, the first is '{word}': textures are not used, so what it makes transparent is as opaque as the rest"
            ),
            Kind::ColorMap => format!(
                "a texture in {some}, the first is '{word}': textures are not used, neither the colours of this one nor, if it has an alpha channel, the opacity"
            ),
            Kind::OtherMap => {
                format!("other textures in {some}, the first is '{word}': textures are not used")
            }
        }
    }
}
