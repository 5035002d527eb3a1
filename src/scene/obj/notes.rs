//! Notes about a model. They are counted by kind while it is read, and printed as one sentence per kind.

use std::collections::BTreeMap;
use std::path::Path;

use super::words;

/// The kinds of things that were skipped, repaired or assumed, in the order in which they are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Note {
    LineElement,
    PointElement,
    FreeForm,
    UnknownKeyword,
    DecimalComma,
    UnreadableVertex,
    FaceOfUnreadable,
    FewCorners,
    CrossedPolygon,
    TangledPolygon,
    EmptyPolygon,
    ExtraIndex,
    NoTexture,
    NoNormal,
    ExtraNumbers,
    UnreadableColor,
    ColorOf255,
    ColorClamped,
    VertexOpacity,
    LibraryMissing,
    LibraryElsewhere,
    TooManyLibraries,
    MaterialUndefined,
}

/// The number of occurrences, and the first one.
struct Tally {
    count: usize,
    line: usize,
    word: String,
}

/// The counts of a file.
#[derive(Default)]
pub(super) struct Notes(BTreeMap<Note, Tally>);

impl Notes {
    /// Counts an occurrence in this line, at this word.
    pub(super) fn count(&mut self, note: Note, line: usize, word: &[u8]) {
        let first = || Tally {
            count: 0,
            line,
            word: words::shown(word),
        };
        self.0.entry(note).or_insert_with(first).count += 1;
    }

    /// The number of occurrences.
    pub(super) fn of(&self, note: Note) -> usize {
        self.0.get(&note).map_or(0, |tally| tally.count)
    }

    /// The line and the word of the first occurrence.
    pub(super) fn first(&self, note: Note) -> Option<(usize, &str)> {
        let tally = self.0.get(&note)?;
        Some((tally.line, &tally.word))
    }

    /// A sentence for each kind.
    pub(super) fn sentences(&self, path: &Path) -> impl Iterator<Item = String> {
        self.0.iter().map(move |(note, tally)| {
            let sentence = note.sentence(tally);
            match note {
                Note::LineElement | Note::PointElement | Note::FreeForm => {
                    format!("{}: {sentence}", path.display())
                }
                _ => format!("{}:{}: {sentence}", path.display(), tally.line),
            }
        })
    }
}

impl Note {
    fn sentence(self, Tally { count, word, .. }: &Tally) -> String {
        let some = |thing: &str| match thing {
            "vertex" if *count > 1 => format!("{count} vertices"),
            _ => counted(*count, thing),
        };
        let one = *count == 1;
        let (have, are) = if one { ("has", "is") } else { ("have", "are") };
        match self {
            Self::LineElement => format!("{} skipped, only faces are drawn", some("line element")),
            Self::PointElement => {
                format!("{} skipped, only faces are drawn", some("point element"))
            }
            Self::FreeForm => format!(
                "{} skipped, only faces are drawn",
                some("free-form curve or surface element")
            ),
            Self::UnknownKeyword => format!(
                "{} with an unknown keyword skipped, the first is '{word}'",
                some("line")
            ),
            Self::DecimalComma => format!(
                "{} of numbers with a decimal comma, which is read as a point, the first is '{word}'",
                some("line")
            ),
            Self::UnreadableVertex => format!(
                "{} {have} no place that can be read (three finite numbers, divided by the weight after them), the first at '{word}'",
                some("vertex")
            ),
            Self::FaceOfUnreadable => format!(
                "{} skipped for a vertex without a place, the first is '{word}'",
                some("face")
            ),
            Self::FewCorners => format!(
                "{} with fewer than three corners skipped, the first is '{word}'",
                some("face")
            ),
            Self::CrossedPolygon => format!(
                "{} {have} edges that cross: what lies within by the even-odd rule is drawn, once",
                some("polygon")
            ),
            Self::TangledPolygon => format!(
                "{} {have} edges that cross or run over each other too often for inside and outside to be told apart: drawn as a fan of triangles, which may lie over each other",
                some("polygon")
            ),
            Self::EmptyPolygon => format!(
                "{} enclosing nothing skipped, the first is '{word}'",
                some("polygon")
            ),
            Self::ExtraIndex => format!(
                "{} with more than three indices, the first is '{word}': those after the normal are left out",
                some("corner")
            ),
            Self::NoTexture => format!(
                "{} without the texture coordinates that they name, the first is '{word}'; nothing that is drawn needs them",
                some("corner")
            ),
            Self::NoNormal => format!(
                "{} without the normal that they name (empty, not there, not finite or of no length), the first is '{word}': the faces around them give one",
                some("corner")
            ),
            Self::ExtraNumbers => format!(
                "{} {have} numbers that mean nothing here, the first at '{word}': they are left out",
                some("vertex")
            ),
            Self::UnreadableColor => format!(
                "{} {have} a colour that cannot be read, the first at '{word}': the model's own is taken",
                some("vertex")
            ),
            Self::ColorOf255 => format!(
                "the colours of the vertices are whole numbers up to 255: taken as 255 times the colour ({})",
                some("vertex")
            ),
            Self::ColorClamped => format!(
                "{} {have} a colour beyond 0 to 1, the first at '{word}': the nearest within is taken",
                some("vertex")
            ),
            Self::VertexOpacity => format!(
                "{} {have} a seventh number: taken as opacity, by which that of the model is multiplied",
                some("vertex")
            ),
            Self::LibraryMissing => format!(
                "the material file '{word}'{} missing, default materials are used",
                and_others(*count)
            ),
            Self::LibraryElsewhere => format!(
                "{} {are} not under the name that the model gives, the first is '{word}': taken is the file next to the model whose name differs by folder, case or encoding only",
                some("material file")
            ),
            Self::TooManyLibraries => format!(
                "{} more than are looked for, the first is '{word}'",
                some("material file")
            ),
            Self::MaterialUndefined => format!(
                "the material '{word}'{} not defined, the default material is used",
                and_others(*count)
            ),
        }
    }
}

fn and_others(count: usize) -> String {
    match count {
        0 | 1 => " is".to_owned(),
        2 => " and 1 other are".to_owned(),
        some => format!(" and {} others are", some - 1),
    }
}

/// `1 face`, `2 faces`.
pub(super) fn counted(count: usize, thing: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {thing}{plural}")
}
