//! The header's fields, each with its line.

use std::collections::BTreeMap;
use std::path::Path;

use crate::error::{Error, Place, Result};

/// The header's fields, and where they end.
pub(super) struct Header<'a> {
    pub(super) path: &'a Path,
    fields: BTreeMap<&'static str, Field>,
    /// The names of the files after `data file: LIST`, one per line.
    pub(super) list: Vec<String>,
    /// The offset of the samples after an attached header.
    pub(super) end: usize,
}

/// A field's value: the text after its colon.
pub(super) struct Field {
    line: usize,
    pub(super) text: String,
}

/// Every field of the format. The fields of the first list are used. No image depends on the fields of the second.
const USED: [&str; 13] = [
    "dimension",
    "type",
    "encoding",
    "endian",
    "sizes",
    "spacings",
    "space directions",
    "space origin",
    "data file",
    "line skip",
    "byte skip",
    "space dimension",
    "space",
];
const UNUSED: [&str; 18] = [
    "content",
    "number",
    "block size",
    "thicknesses",
    "axis mins",
    "axis maxs",
    "centers",
    "centerings",
    "labels",
    "units",
    "kinds",
    "min",
    "max",
    "old min",
    "old max",
    "sample units",
    "space units",
    "measurement frame",
];
/// The fields of the second list that a reader might expect to place the volume.
const PLACING: [&str; 2] = ["axis mins", "axis maxs"];

impl<'a> Header<'a> {
    pub(super) fn parse(path: &'a Path, bytes: &[u8]) -> Result<Self> {
        let mut header = Self {
            path,
            fields: BTreeMap::new(),
            list: Vec::new(),
            end: 0,
        };
        let mut number = 0;
        while let Some(line) = header.next_line(bytes) {
            number += 1;
            if number == 1 {
                expect_magic(path, line)?;
            } else if header.is_list() {
                let name = String::from_utf8_lossy(line.trim_ascii());
                if !name.is_empty() {
                    header.list.push(name.into_owned());
                }
            } else if line.is_empty() {
                break;
            } else if line[0] != b'#' {
                header.add(number, &String::from_utf8_lossy(line))?;
            }
        }
        if number == 0 {
            expect_magic(path, b"")?;
        }
        Ok(header)
    }

    /// Reads the line at `end`, without its line end, and moves `end` behind it.
    fn next_line<'b>(&mut self, bytes: &'b [u8]) -> Option<&'b [u8]> {
        let rest = &bytes[self.end..];
        if rest.is_empty() {
            return None;
        }
        let length = rest.iter().position(|&byte| byte == b'\n');
        let line = &rest[..length.unwrap_or(rest.len())];
        self.end += length.map_or(rest.len(), |length| length + 1);
        Some(line.strip_suffix(b"\r").unwrap_or(line))
    }

    fn add(&mut self, line: usize, text: &str) -> Result<()> {
        let place = || Place::line(self.path, line);
        let Some((name, value)) = text.split_once(':') else {
            return Err(Error::input(
                place().token(text),
                "this is not a field of a NRRD header",
                "Fields are written `name: value`; an empty line ends the header.",
            ));
        };
        if value.starts_with('=') {
            // A key and its value are notes for people and programs, and change nothing here.
            return Ok(());
        }
        let known = USED.into_iter().chain(UNUSED);
        let squeezed = |text: &str| text.replace(' ', "").to_ascii_lowercase();
        let Some(name) = known
            .into_iter()
            .find(|known| squeezed(known) == squeezed(name))
        else {
            return Err(Error::input(
                place().token(name),
                "there is no such field in a NRRD header",
                "Correct or remove it; a note of your own is written `name:=value`.",
            ));
        };
        let text = value.trim().to_owned();
        if self.fields.insert(name, Field { line, text }).is_some() {
            return Err(Error::input(
                Place::line(self.path, line).token(name),
                format!("the field `{name}` is there twice"),
                "Remove one of the two.",
            ));
        }
        Ok(())
    }

    /// Whether names of files follow, up to the file's end.
    fn is_list(&self) -> bool {
        let field = self.optional("data file");
        field.is_some_and(|field| field.text.split_whitespace().next() == Some("LIST"))
    }

    pub(super) fn optional(&self, name: &str) -> Option<&Field> {
        self.fields.get(name)
    }

    pub(super) fn required(&self, name: &str) -> Result<&Field> {
        self.optional(name).ok_or_else(|| {
            Error::input(
                Place::file(self.path),
                format!("the field `{name}` is missing from the header"),
                format!("Add a line `{name}: ...`."),
            )
        })
    }

    /// A field with a word for each axis.
    pub(super) fn words(&self, name: &str, axes: usize) -> Result<Vec<&str>> {
        let words: Vec<&str> = self.required(name)?.text.split_whitespace().collect();
        if words.len() == axes {
            return Ok(words);
        }
        let what = format!("these are {} words for {axes} axes", words.len());
        Err(self.wrong(name, what, "Give one for each axis."))
    }

    pub(super) fn integer(&self, name: &str) -> Result<Option<i64>> {
        let Some(field) = self.optional(name) else {
            return Ok(None);
        };
        let integer = field.text.parse().ok().filter(|&number| number >= -1);
        match integer {
            Some(number) => Ok(Some(number)),
            None => Err(self.wrong(name, "this is not a whole number", "Correct the line.")),
        }
    }

    /// The line of a field with its text as the token, or the file if the field is missing.
    pub(super) fn place(&self, name: &str) -> Place {
        match self.optional(name) {
            Some(field) => Place::line(self.path, field.line).token(&field.text),
            None => Place::file(self.path),
        }
    }

    /// The error for a field.
    pub(super) fn wrong(&self, name: &str, what: impl AsRef<str>, remedy: &str) -> Error {
        let what = format!("`{name}`: {}", what.as_ref());
        Error::input(self.place(name), what, remedy)
    }

    /// A sentence about fields that have no effect here.
    pub(super) fn notices(&self) -> Vec<String> {
        let found = PLACING.iter().filter(|name| self.optional(name).is_some());
        let notice = |name: &&str| {
            format!(
                "{}: `{name}` is not used; spacings, space directions and space origin place a volume",
                self.path.display()
            )
        };
        found.map(notice).collect()
    }
}

/// The known versions. They differ in their fields, and each of these fields is known here.
const VERSIONS: std::ops::RangeInclusive<u8> = b'1'..=b'6';

fn expect_magic(path: &Path, line: &[u8]) -> Result<()> {
    let version = line.strip_prefix(b"NRRD000").and_then(<[u8]>::first);
    if version.is_some_and(|digit| VERSIONS.contains(digit)) {
        return Ok(());
    }
    let place = Place::line(path, 1);
    if line.starts_with(b"NRRD") {
        let shown = line[..line.len().min(20)].escape_ascii();
        let what = format!("this is NRRD of the version {shown}; known are NRRD0001 to NRRD0006");
        return Err(Error::input(
            place,
            what,
            "Save the volume again, with teem or Slicer.",
        ));
    }
    Err(Error::input(
        place,
        "this is not a NRRD file: it does not begin with NRRD000 and a digit",
        "Check that its ending is right.",
    ))
}
