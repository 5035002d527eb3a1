//! The samples of a `DataArray`.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use roxmltree::Node;

use super::document::Document;
use crate::error::{Error, Result};
use crate::scene::volume::gzip;
use crate::scene::volume::load::Layout;
use crate::scene::volume::samples::Endian;

const AGAIN: &str = "The file is damaged or cut off: save the image again.";

pub(super) fn endian(document: &Document, root: Node) -> Result<Endian> {
    match root.attribute("byte_order") {
        Some("LittleEndian") | None => Ok(Endian::Little),
        Some("BigEndian") => Ok(Endian::Big),
        Some(other) => Err(document.wrong(
            "byte_order",
            format!("there is no byte order '{other}'"),
            "Write LittleEndian or BigEndian.",
        )),
    }
}

pub(super) fn samples(
    document: &Document,
    root: Node,
    array: Node,
    layout: &Layout,
) -> Result<Vec<f32>> {
    let text = || array.text().unwrap_or_default();
    let blocks = match array.attribute("format") {
        Some("ascii") => return ascii(document, text(), layout),
        Some("binary") => base64(document, text().as_bytes())?,
        Some("appended") => appended(document, root, array)?,
        other => {
            let what = format!("there is no format '{}'", other.unwrap_or_default());
            let remedy = "Save the image as ascii, binary or appended.";
            return Err(document.wrong("DataArray format", what, remedy));
        }
    };
    let bytes = Blocks::new(document, root, layout, &blocks)?.unpack(root)?;
    Ok(layout.stored.convert(&bytes, layout.endian))
}

fn short(document: &Document, layout: &Layout, found: usize) -> Result<()> {
    let fault = layout.expect(found);
    fault.map_err(|(what, remedy)| document.wrong("DataArray", what, remedy))
}

/// Each number takes at least two characters, so that the text's length bounds what is allocated.
fn ascii(document: &Document, text: &str, layout: &Layout) -> Result<Vec<f32>> {
    let words = text.split_whitespace();
    let samples: Option<Vec<f32>> = words
        .map(|word| Some(word.parse::<f64>().ok()? as f32))
        .collect();
    let samples = samples.ok_or_else(|| {
        let what = "there is a word that is not a number".to_owned();
        document.wrong("DataArray", what, AGAIN)
    })?;
    let wanted: usize = layout.dims.iter().product();
    if samples.len() == wanted {
        return Ok(samples);
    }
    let what = format!("{} numbers for {wanted} points", samples.len());
    Err(document.wrong("DataArray", what, AGAIN))
}

/// The array's part of the appended data and all that follows.
fn appended(document: &Document, root: Node, array: Node) -> Result<Vec<u8>> {
    let offset = array.attribute("offset").unwrap_or("0");
    let found = document.appended.len();
    let part = offset
        .parse()
        .ok()
        .and_then(|offset: usize| document.appended.get(offset..));
    let part = part.ok_or_else(|| {
        let what = format!("'{offset}' is not a place in {found} bytes");
        document.wrong("DataArray offset", what, AGAIN)
    })?;
    let element = document.child(root, "AppendedData")?;
    match element.attribute("encoding").unwrap_or("base64") {
        "raw" => Ok(part.to_vec()),
        "base64" => {
            let end = part.iter().position(|&byte| byte == b'<');
            base64(document, &part[..end.unwrap_or(part.len())])
        }
        other => {
            let what = format!("there is no encoding '{other}'");
            let remedy = "Save the image as raw or base64.";
            Err(document.wrong("AppendedData encoding", what, remedy))
        }
    }
}

/// Head and samples may be encoded one after the other, each with its padding. Of appended data more arrays may follow.
fn base64(document: &Document, text: &[u8]) -> Result<Vec<u8>> {
    let text: Vec<u8> = text
        .iter()
        .copied()
        .filter(|byte| !byte.is_ascii_whitespace())
        .collect();
    let mut bytes = Vec::new();
    let mut rest = text.as_slice();
    while !rest.is_empty() {
        let padding = rest
            .iter()
            .position(|&byte| byte == b'=')
            .unwrap_or(rest.len());
        let end = padding.next_multiple_of(4).min(rest.len());
        let decoded = STANDARD.decode(&rest[..end]).map_err(|error| {
            let what = format!("this is not base64: {error}");
            document.wrong("DataArray", what, AGAIN)
        })?;
        bytes.extend(decoded);
        rest = &rest[end..];
    }
    Ok(bytes)
}

/// An array's bytes: whole numbers that say how long it is, then the samples, packed or not.
struct Blocks<'a> {
    document: &'a Document<'a>,
    layout: &'a Layout,
    /// Bytes of a whole number of the head.
    width: usize,
    bytes: &'a [u8],
}

impl<'a> Blocks<'a> {
    fn new(
        document: &'a Document<'a>,
        root: Node,
        layout: &'a Layout,
        bytes: &'a [u8],
    ) -> Result<Self> {
        let width = match root.attribute("header_type") {
            Some("UInt32") | None => 4,
            Some("UInt64") => 8,
            Some(other) => {
                let what = format!("there is no header type '{other}'");
                return Err(document.wrong("header_type", what, "Write UInt32 or UInt64."));
            }
        };
        Ok(Self {
            document,
            layout,
            width,
            bytes,
        })
    }

    fn unpack(&self, root: Node) -> Result<Vec<u8>> {
        match root.attribute("compressor") {
            None | Some("") => self.plain(),
            Some("vtkZLibDataCompressor") => self.packed(),
            Some(other) => Err(self.document.wrong(
                "compressor",
                format!("{other} is not supported"),
                "Save the image with VTK's zlib compressor or without compression.",
            )),
        }
    }

    fn plain(&self) -> Result<Vec<u8>> {
        let said = self.number(0)?;
        let rest = &self.bytes[self.width..];
        short(self.document, self.layout, said.min(rest.len()))?;
        Ok(rest[..self.layout.bytes()].to_vec())
    }

    /// Number of blocks, bytes of a block unpacked, those of the last one, then each one's bytes packed.
    fn packed(&self) -> Result<Vec<u8>> {
        let count = self.number(0)?;
        let block = self.number(1)?;
        let head = count
            .checked_add(3)
            .and_then(|count| count.checked_mul(self.width));
        let mut rest = head
            .and_then(|head| self.bytes.get(head..))
            .ok_or_else(|| self.cut_off())?;
        let wanted = self.layout.bytes();
        if !gzip::can_hold(rest.len(), wanted as u64) {
            short(self.document, self.layout, 0)?;
        }
        let mut samples = Vec::new();
        for number in 0..count {
            let length = self.number(3 + number)?;
            let packed = rest.get(..length).ok_or_else(|| self.cut_off())?;
            rest = &rest[length..];
            // The last block may be shorter; what is too long for the samples is of no use.
            let room = block.min(wanted - samples.len());
            samples.extend(gzip::unpack_zlib(packed, room).map_err(|error| {
                let what = format!("block {number} does not unpack: {error}");
                self.document.wrong("DataArray", what, AGAIN)
            })?);
        }
        short(self.document, self.layout, samples.len())?;
        Ok(samples)
    }

    /// A whole number of the head.
    fn number(&self, index: usize) -> Result<usize> {
        let start = index.checked_mul(self.width);
        let bytes = start.and_then(|start| self.bytes.get(start..)?.get(..self.width));
        let bytes = bytes.ok_or_else(|| self.cut_off())?;
        let digits = bytes.iter().map(|&byte| u64::from(byte));
        let number = match self.layout.endian {
            Endian::Big => digits.fold(0, |number, digit| number << 8 | digit),
            Endian::Little => digits.rev().fold(0, |number, digit| number << 8 | digit),
        };
        usize::try_from(number).map_err(|_| self.cut_off())
    }

    fn cut_off(&self) -> Error {
        let what = format!("it ends after {} bytes", self.bytes.len());
        self.document.wrong("DataArray", what, AGAIN)
    }
}
