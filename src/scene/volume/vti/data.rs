//! The samples of a `DataArray`.

use std::io::{self, Read};

use roxmltree::Node;

use super::base64::Base64;
use super::document::Document;
use crate::error::Result;
use crate::scene::volume::gzip;
use crate::scene::volume::samples::{Endian, Layout, SampleType, make_room, numbers};

const AGAIN: &str = "The file is damaged or cut off: save the image again.";

/// What a file says in its first element about all of its data.
pub(super) struct Form<'a> {
    document: &'a Document<'a>,
    root: Node<'a, 'a>,
    endian: Endian,
    /// The number of bytes of the whole numbers before the samples.
    width: usize,
}

impl<'a> Form<'a> {
    pub(super) fn read(document: &'a Document<'a>, root: Node<'a, 'a>) -> Result<Self> {
        Ok(Self {
            document,
            root,
            endian: endian(document, root)?,
            width: width(document, root)?,
        })
    }

    /// All samples of an array.
    pub(super) fn samples(&self, array: Node, dims: [usize; 3]) -> Result<Vec<f32>> {
        let layout = Layout {
            dims,
            stored: self.stored(array)?,
            endian: self.endian,
        };
        // The text may be in several parts, between elements that say more about the array.
        let texts = array.children().filter(Node::is_text);
        let texts: Vec<&str> = texts.filter_map(|node| node.text()).collect();
        match array.attribute("format") {
            Some("ascii") => self.ascii(&texts, &layout),
            Some("binary") => {
                let text = texts.concat();
                self.binary(Base64::new(text.as_bytes()), text.len(), &layout)
            }
            Some("appended") => self.appended(array, &layout),
            other => {
                let what = format!("there is no format '{}'", other.unwrap_or_default());
                let remedy = "Save the image as ascii, binary or appended.";
                Err(self.document.wrong("DataArray format", what, remedy))
            }
        }
    }

    fn stored(&self, array: Node) -> Result<SampleType> {
        let name = array.attribute("type").unwrap_or_default();
        stored(name).ok_or_else(|| {
            let what = format!("'{name}' is not a type of samples that can be read");
            let remedy = "Known are Int8 to UInt64, Float32 and Float64.";
            self.document.wrong("DataArray type", what, remedy)
        })
    }

    /// Samples as text. Each number takes at least two characters, so the text's length bounds the memory.
    fn ascii(&self, texts: &[&str], layout: &Layout) -> Result<Vec<f32>> {
        let wanted = layout.count();
        let words = || texts.iter().flat_map(|text| text.split_whitespace());
        let mut samples = Vec::new();
        // One more number than wanted shows that there are too many.
        numbers(words().take(wanted + 1), &mut samples).map_err(|word| {
            let shown: String = word.chars().take(20).collect();
            let what = format!("the word '{shown}' is not a number");
            self.document.wrong("DataArray", what, AGAIN)
        })?;
        if samples.len() == wanted {
            return Ok(samples);
        }
        let what = format!("{} numbers for {wanted} samples", words().count());
        Err(self.document.wrong("DataArray", what, AGAIN))
    }

    /// The array's part of the appended data. Other arrays may follow it.
    fn appended(&self, array: Node, layout: &Layout) -> Result<Vec<f32>> {
        let document = self.document;
        let offset = array.attribute("offset").unwrap_or("0");
        let part = offset
            .parse()
            .ok()
            .and_then(|offset: usize| document.appended.get(offset..));
        let part = part.ok_or_else(|| {
            let found = document.appended.len();
            let what = format!("'{offset}' is not a place in {found} bytes");
            document.wrong("DataArray offset", what, AGAIN)
        })?;
        let element = document.child(self.root, "AppendedData")?;
        match element.attribute("encoding").unwrap_or("base64") {
            "raw" => self.binary(part, part.len(), layout),
            "base64" => {
                let end = part.iter().position(|&byte| byte == b'<');
                let text = &part[..end.unwrap_or(part.len())];
                self.binary(Base64::new(text), text.len(), layout)
            }
            other => {
                let what = format!("there is no encoding '{other}'");
                let remedy = "Save the image as raw or base64.";
                Err(document.wrong("AppendedData encoding", what, remedy))
            }
        }
    }

    /// Reads whole numbers that say how long the array is, then the samples, packed or not. There are at most `most`
    /// bytes.
    fn binary(&self, source: impl Read, most: usize, layout: &Layout) -> Result<Vec<f32>> {
        // For numbers in ASCII the compressor does not matter.
        let is_packed = is_packed(self.document, self.root)?;
        let mut source = Counted { source, read: 0 };
        let result = if is_packed {
            self.packed(&mut source, most, layout)
        } else {
            self.plain(&mut source, most, layout)
        };
        result.map_err(|fault| match fault {
            Fault::Io(error) if error.kind() == io::ErrorKind::UnexpectedEof => {
                let what = format!("it ends after {} bytes", source.read);
                self.document.wrong("DataArray", what, AGAIN)
            }
            Fault::Io(error) => self.document.wrong("DataArray", error.to_string(), AGAIN),
            Fault::Samples(what, remedy) => self.document.wrong("DataArray", what, remedy),
        })
    }

    fn plain(
        &self,
        source: &mut impl Read,
        most: usize,
        layout: &Layout,
    ) -> Result<Vec<f32>, Fault> {
        let said = self.number(source)?;
        let mut source = source.take(said);
        let mut samples = Vec::new();
        if most < layout.bytes() {
            // So few bytes cannot hold the samples. The message says how many there are.
            let found = io::copy(&mut source, &mut io::sink())?;
            layout.expect(found as usize)?;
        }
        make_room(&mut samples, layout.count())?;
        let read = layout.read(source, &mut samples)?;
        layout.expect(read)?;
        Ok(samples)
    }

    /// The head of packed data: the number of blocks, the unpacked bytes of a block, those of the last block if it is
    /// shorter, then the packed bytes of each block.
    fn packed(
        &self,
        source: &mut impl Read,
        most: usize,
        layout: &Layout,
    ) -> Result<Vec<f32>, Fault> {
        let count = self.number(source)?;
        let block = self.number(source)?;
        self.number(source)?;
        let mut lengths = Vec::new();
        for _ in 0..count {
            lengths.push(self.number(source)?);
        }
        if !gzip::can_hold(most as u64, layout.bytes() as u64) {
            layout.expect(0)?;
        }
        let mut samples = Vec::new();
        make_room(&mut samples, layout.count())?;
        let mut blocks = Blocks {
            source,
            lengths: lengths.into_iter(),
            size: block,
            packed: Vec::new(),
            block: Vec::new(),
            read: 0,
            number: 0,
            left: layout.bytes() as u64,
        };
        let read = layout.read(&mut blocks, &mut samples)?;
        layout.expect(read)?;
        Ok(samples)
    }

    fn number(&self, source: &mut impl Read) -> io::Result<u64> {
        let mut bytes = [0; 8];
        let bytes = &mut bytes[..self.width];
        source.read_exact(bytes)?;
        let digits = bytes.iter().map(|&byte| u64::from(byte));
        Ok(match self.endian {
            Endian::Big => digits.fold(0, |number, digit| number << 8 | digit),
            Endian::Little => digits.rev().fold(0, |number, digit| number << 8 | digit),
        })
    }
}

/// The error for an array's bytes.
enum Fault {
    Io(io::Error),
    Samples(String, &'static str),
}

impl From<io::Error> for Fault {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<(String, &'static str)> for Fault {
    fn from((what, remedy): (String, &'static str)) -> Self {
        Self::Samples(what, remedy)
    }
}

/// A reader that counts the bytes it has read.
struct Counted<R> {
    source: R,
    read: usize,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.source.read(buffer)?;
        self.read += read;
        Ok(read)
    }
}

/// A reader that unpacks blocks one after the other.
struct Blocks<'a, R> {
    source: &'a mut R,
    lengths: std::vec::IntoIter<u64>,
    /// The number of unpacked bytes of a block.
    size: u64,
    packed: Vec<u8>,
    block: Vec<u8>,
    /// The number of bytes of the block that have been read.
    read: usize,
    number: usize,
    /// The number of bytes that are still wanted.
    left: u64,
}

impl<R: Read> Blocks<'_, R> {
    /// The buffer grows with the bytes that are really there. A length in the file is not trusted.
    fn unpack(&mut self, length: u64) -> io::Result<()> {
        self.packed.clear();
        let mut packed = self.source.by_ref().take(length);
        let found = packed.read_to_end(&mut self.packed)?;
        if (found as u64) < length {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        self.block.clear();
        self.read = 0;
        let room = self.size.min(self.left);
        let unpacked = gzip::unpack_zlib(&self.packed)
            .take(room)
            .read_to_end(&mut self.block);
        let unpacked = unpacked.map_err(|error| {
            io::Error::other(format!("block {} does not unpack: {error}", self.number))
        })?;
        self.left -= unpacked as u64;
        self.number += 1;
        Ok(())
    }
}

impl<R: Read> Read for Blocks<'_, R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.read == self.block.len() {
            let Some(length) = self.lengths.next() else {
                return Ok(0);
            };
            self.unpack(length)?;
        }
        let rest = &self.block[self.read..];
        let length = rest.len().min(buffer.len());
        buffer[..length].copy_from_slice(&rest[..length]);
        self.read += length;
        Ok(length)
    }
}

fn endian(document: &Document, root: Node) -> Result<Endian> {
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

fn width(document: &Document, root: Node) -> Result<usize> {
    match root.attribute("header_type") {
        Some("UInt32") | None => Ok(4),
        Some("UInt64") => Ok(8),
        Some(other) => {
            let what = format!("there is no header type '{other}'");
            Err(document.wrong("header_type", what, "Write UInt32 or UInt64."))
        }
    }
}

fn is_packed(document: &Document, root: Node) -> Result<bool> {
    let name = match root.attribute("compressor") {
        None | Some("") => return Ok(false),
        Some("vtkZLibDataCompressor") => return Ok(true),
        Some(name) => name,
    };
    let known = [
        ("vtkLZ4DataCompressor", "LZ4"),
        ("vtkLZMADataCompressor", "LZMA"),
    ];
    let known = known.iter().find(|(compressor, _)| *compressor == name);
    let shown = known.map_or(name.to_owned(), |(_, short)| format!("{short} ({name})"));
    let version = root.attribute("version").unwrap_or("(none)");
    Err(document.wrong(
        "compressor",
        format!("this VTK file of version {version} is packed by {shown}, which is not read"),
        "Save the image with VTK's zlib compressor or without compression.",
    ))
}

fn stored(name: &str) -> Option<SampleType> {
    Some(match name {
        "Int8" => SampleType::I8,
        "UInt8" => SampleType::U8,
        "Int16" => SampleType::I16,
        "UInt16" => SampleType::U16,
        "Int32" => SampleType::I32,
        "UInt32" => SampleType::U32,
        "Int64" => SampleType::I64,
        "UInt64" => SampleType::U64,
        "Float32" => SampleType::F32,
        "Float64" => SampleType::F64,
        _ => return None,
    })
}
