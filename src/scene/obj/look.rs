//! What a material looks like: its colour and its opacity, and what had to be assumed for that.

use std::collections::BTreeMap;
use std::path::Path;

use super::counted;
use super::materials::{Library, Material, Statement};
use super::numbers;
use super::words;

/// A material's colour and opacity; `None` where nothing is said that can be read.
#[derive(Clone, Copy)]
pub(super) struct Look {
    pub(super) color: Option<[f32; 3]>,
    pub(super) opacity: Option<f32>,
}

/// What `Tr` means in a file. By the format's documents it is transparency, 1 less `d`; many programs write the opacity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tr {
    Transparency,
    /// This program, which is named in the file, writes the opacity.
    OpacityOf(&'static str),
    /// The other materials of the file have a `d`, too, and it is equal to their `Tr`.
    OpacityLikeD,
    /// By the other meaning nothing could be seen.
    OpacityToBeSeen,
    /// The same, where the opacity was to be expected.
    TransparencyToBeSeen,
}

/// What the comments of programs say that write opacity as `Tr`, in lower case, and what the programs are called.
const WRITERS: [(&[u8], &str); 8] = [
    (b"visualization toolkit", "VTK"),
    (b"vtk", "VTK"),
    (b"pyvista", "PyVista"),
    (b"paraview", "ParaView"),
    (b"meshlab", "MeshLab"),
    (b"vcglib", "VCGLib"),
    (b"openmvs", "OpenMVS"),
    (b"texrecon", "MVS-Texturing"),
];

/// Two numbers that a program has written of the same: they differ by the rounding of two decimals at most.
const SAME: f64 = 0.01;

/// What a file's `Tr` means: by who wrote it, or by what its `d` say, or by the format; but not so that all of its
/// materials without a `d` are invisible if there is another way.
pub(super) fn meaning_of_tr(library: &Library) -> Tr {
    let writer = WRITERS.iter().find(|(comment, _)| {
        let mut windows = library.head.windows(comment.len());
        windows.any(|window| window == *comment)
    });
    let number = |statement: &Option<Statement>| first_number(statement.as_ref()?);
    let both = library
        .materials
        .iter()
        .filter_map(|m| Some((number(&m.d)?, number(&m.tr)?)));
    let telling = both.filter(|(d, tr)| (d - tr).abs() > SAME || (1.0 - d - tr).abs() > SAME);
    let (mut alike, mut opposite) = (0, 0);
    for (d, tr) in telling {
        alike += usize::from((d - tr).abs() <= SAME);
        opposite += usize::from((1.0 - d - tr).abs() <= SAME);
    }
    let expected = match writer {
        Some((_, name)) => Tr::OpacityOf(name),
        None if alike > 0 && opposite == 0 => Tr::OpacityLikeD,
        None => Tr::Transparency,
    };
    let alone = library
        .materials
        .iter()
        .filter(|material| number(&material.d).is_none());
    let alone: Vec<f64> = alone.filter_map(|material| number(&material.tr)).collect();
    let all = |bound: fn(f64) -> bool| !alone.is_empty() && alone.iter().all(|&tr| bound(tr));
    match expected {
        Tr::Transparency if all(|tr| tr >= 1.0) => Tr::OpacityToBeSeen,
        Tr::OpacityOf(_) | Tr::OpacityLikeD if all(|tr| tr <= 0.0) => Tr::TransparencyToBeSeen,
        expected => expected,
    }
}

impl Tr {
    fn opacity(self, tr: f64) -> f64 {
        match self {
            Self::Transparency | Self::TransparencyToBeSeen => 1.0 - tr,
            Self::OpacityOf(_) | Self::OpacityLikeD | Self::OpacityToBeSeen => tr,
        }
    }

    fn sentence(self) -> String {
        match self {
            Self::Transparency => {
                "taken as transparency, 1 less the opacity, as the format has it".to_owned()
            }
            Self::OpacityOf(writer) => {
                format!("taken as opacity, which is what {writer} writes there")
            }
            Self::OpacityLikeD => {
                "taken as opacity, since other materials of the file have a `d` that is equal to it"
                    .to_owned()
            }
            Self::OpacityToBeSeen => {
                "taken as opacity: as transparency it would leave none of them to be seen"
                    .to_owned()
            }
            Self::TransparencyToBeSeen => {
                "taken as transparency: as opacity it would leave none of them to be seen"
                    .to_owned()
            }
        }
    }
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

/// From this on a colour of whole numbers goes from 0 to 255: no exporter lights a surface so much.
const TOO_BRIGHT: f64 = 16.0;

/// By `d` if it can be read, or else by `Tr`.
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
    // It is not needed, so it may be anything.
    let agrees = first_number(tr).is_some_and(|tr| (meaning.opacity(tr) - d).abs() <= SAME);
    if !agrees {
        notes.count(Kind::Disagree, tr, &tr.rest);
    }
    Some(d as f32)
}

/// A number from 0 to 1, or brought there.
fn fraction(statement: &Statement, notes: &mut LookNotes) -> Option<f64> {
    let Some(number) = first_number(statement) else {
        notes.count(Kind::UnreadableOpacity, statement, &statement.rest);
        return None;
    };
    if !(0.0..=1.0).contains(&number) {
        notes.count(Kind::OpacityClamped, statement, &statement.rest);
    }
    Some(number.clamp(0.0, 1.0))
}

/// Of `d 0.5`, or of `d -halo 0.5`.
fn first_number(statement: &Statement) -> Option<f64> {
    let mut words = words::words(&statement.rest);
    numbers::number(words.find(|&word| word != b"-halo")?)
}

/// What there is to say about the materials of a file, in the order in which it is said.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
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

/// Counts of it, each with the line and the word of the first.
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

    /// The same file has defined it before.
    pub(super) fn repeated(&mut self, material: &Material) {
        let statement = Statement {
            line: material.line,
            rest: Vec::new(),
        };
        self.count(Kind::Repeated, &statement, &material.name);
    }

    /// A sentence for each.
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
