//! What the tests of volume files share: files written byte by byte.

use std::io::Write;

use base64::Engine;
use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};
use onionskin::{Error, Result, Scene, Volume};

use super::scene::{Folder, Refused, refused};

/// The scene of a volume: the first file is the one that is named, the others lie beside it.
pub fn load_scene(files: &[(&str, &[u8])]) -> Result<Scene, Error> {
    load_scene_with("", files)
}

/// The same with more keys of the volume.
pub fn load_scene_with(keys: &str, files: &[(&str, &[u8])]) -> Result<Scene, Error> {
    let scene = format!(
        "[[volume]]\n{keys}\nfile = \"{}\"\ntransfer = [{{ value = 0, color = [1, 1, 1], density = 1 }}]\n",
        files[0].0
    );
    let mut folder = Folder::new().with("scene.toml", scene);
    for (name, content) in files {
        folder = folder.with(name, content);
    }
    folder.load("scene.toml")
}

/// The volume of these files.
pub fn load(files: &[(&str, &[u8])]) -> Result<Volume, Error> {
    load_scene(files).map(|mut scene| scene.volumes.remove(0))
}

/// The volume of a file that must be good.
#[track_caller]
pub fn read(name: &str, bytes: &[u8]) -> Volume {
    load(&[(name, bytes)]).unwrap_or_else(|error| panic!("{error}"))
}

/// The error of a file that must be bad, which names the file.
#[track_caller]
pub fn bad(name: &str, bytes: &[u8]) -> Refused {
    let error = refused(load(&[(name, bytes)]));
    assert_eq!(error.file, name, "{error:?}");
    error
}

pub fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// The same of a head and so many zeros, which are never all there.
pub fn gzip_with_zeros(head: &[u8], zeros: usize) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(head).unwrap();
    let mut left = zeros;
    while left > 0 {
        let piece = left.min(1 << 14);
        encoder.write_all(&[0; 1 << 14][..piece]).unwrap();
        left -= piece;
    }
    encoder.finish().unwrap()
}

pub fn base64(bytes: &[u8]) -> String {
    base64::engine::general_purpose::STANDARD.encode(bytes)
}

/// A header of 2 x 3 x 4 samples, without the empty line at its end.
pub fn nrrd_head(kind: &str, encoding: &str, endian: &str, more: &str) -> String {
    format!(
        "NRRD0005\ntype: {kind}\ndimension: 3\nsizes: 2 3 4\nencoding: {encoding}\nendian: {endian}\n{more}"
    )
}

/// The fields of a NIfTI-1 header that matter here, of 2 x 3 x 4 samples.
#[derive(Clone)]
pub struct Nifti {
    pub is_big: bool,
    pub dim: [u16; 8],
    pub datatype: i16,
    pub pixdim: [f32; 4],
    pub offset: f32,
    pub scale: [f32; 2],
    /// Quaternion b, c, d and the origin.
    pub qform: Option<[f32; 6]>,
    pub sform: Option<[[f32; 4]; 3]>,
    pub magic: [u8; 4],
}

impl Default for Nifti {
    fn default() -> Self {
        Self {
            is_big: false,
            dim: [3, 2, 3, 4, 1, 1, 1, 1],
            datatype: 2,
            pixdim: [1.0; 4],
            offset: 352.0,
            scale: [0.0; 2],
            qform: None,
            sform: None,
            magic: *b"n+1\0",
        }
    }
}

impl Nifti {
    /// The header and the four bytes that say that there are no extensions. Places after the standard's nifti1.h.
    pub fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; 352];
        let mut put = |at: usize, little: &[u8]| {
            let mut value = little.to_vec();
            if self.is_big {
                value.reverse();
            }
            bytes[at..at + value.len()].copy_from_slice(&value);
        };
        put(0, &348_i32.to_le_bytes());
        for (i, length) in self.dim.iter().enumerate() {
            put(40 + 2 * i, &length.to_le_bytes());
        }
        put(70, &self.datatype.to_le_bytes());
        for (i, size) in self.pixdim.iter().enumerate() {
            put(76 + 4 * i, &size.to_le_bytes());
        }
        put(108, &self.offset.to_le_bytes());
        put(112, &self.scale[0].to_le_bytes());
        put(116, &self.scale[1].to_le_bytes());
        if let Some(numbers) = self.qform {
            put(252, &1_i16.to_le_bytes());
            for (i, number) in numbers.iter().enumerate() {
                put(256 + 4 * i, &number.to_le_bytes());
            }
        }
        if let Some(rows) = self.sform {
            put(254, &1_i16.to_le_bytes());
            for (i, number) in rows.as_flattened().iter().enumerate() {
                put(280 + 4 * i, &number.to_le_bytes());
            }
        }
        bytes[344..348].copy_from_slice(&self.magic);
        bytes
    }

    /// The same as NIfTI-2, the samples behind it. Places after the standard's nifti2.h.
    pub fn bytes_of_version_2(&self) -> Vec<u8> {
        let mut bytes = vec![0; 544];
        let mut put = |at: usize, little: &[u8]| {
            let mut value = little.to_vec();
            if self.is_big {
                value.reverse();
            }
            bytes[at..at + value.len()].copy_from_slice(&value);
        };
        let wide = |number: f32| f64::from(number).to_le_bytes();
        put(0, &540_i32.to_le_bytes());
        put(12, &self.datatype.to_le_bytes());
        for (i, length) in self.dim.iter().enumerate() {
            put(16 + 8 * i, &i64::from(*length).to_le_bytes());
        }
        for (i, size) in self.pixdim.iter().enumerate() {
            put(104 + 8 * i, &wide(*size));
        }
        put(168, &544_i64.to_le_bytes());
        put(176, &wide(self.scale[0]));
        put(184, &wide(self.scale[1]));
        if let Some(numbers) = self.qform {
            put(344, &1_i32.to_le_bytes());
            for (i, number) in numbers.iter().enumerate() {
                put(352 + 8 * i, &wide(*number));
            }
        }
        if let Some(rows) = self.sform {
            put(348, &1_i32.to_le_bytes());
            for (i, number) in rows.as_flattened().iter().enumerate() {
                put(400 + 8 * i, &wide(*number));
            }
        }
        bytes[4..12].copy_from_slice(b"n+2\0\r\n\x1a\n");
        bytes
    }
}

/// A VTK image of 2 x 3 x 4 points.
#[derive(Clone)]
pub struct Vti {
    pub name: &'static str,
    pub order: &'static str,
    /// Bytes of a number of the head, 4 or 8.
    pub width: usize,
    pub packed: bool,
    pub image: &'static str,
    /// More attributes of the array.
    pub array: &'static str,
}

impl Default for Vti {
    fn default() -> Self {
        Self {
            name: "UInt8",
            order: "LittleEndian",
            width: 4,
            packed: false,
            image: r#"WholeExtent="0 1 0 2 0 3""#,
            array: "",
        }
    }
}

impl Vti {
    fn number(&self, number: usize) -> Vec<u8> {
        let mut bytes = (number as u64).to_le_bytes()[..self.width].to_vec();
        if self.order == "BigEndian" {
            bytes.reverse();
        }
        bytes
    }

    /// The samples after their number of bytes.
    pub fn counted(&self, bytes: &[u8]) -> Vec<u8> {
        [self.number(bytes.len()), bytes.to_vec()].concat()
    }

    /// The samples packed in blocks.
    pub fn packed(&self, bytes: &[u8], block: usize) -> Vec<u8> {
        let blocks: Vec<Vec<u8>> = bytes
            .chunks(block)
            .map(|block| {
                let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
                encoder.write_all(block).unwrap();
                encoder.finish().unwrap()
            })
            .collect();
        let numbers = [blocks.len(), block, bytes.len() % block];
        let lengths = blocks.iter().map(Vec::len);
        let head = numbers
            .into_iter()
            .chain(lengths)
            .flat_map(|n| self.number(n));
        head.chain(blocks.concat()).collect()
    }

    fn head(&self, format: &str) -> String {
        let Self {
            name,
            order,
            width,
            image,
            array,
            ..
        } = self;
        let compressor = if self.packed {
            r#" compressor="vtkZLibDataCompressor""#
        } else {
            ""
        };
        format!(
            r#"<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="{order}" header_type="UInt{}"{compressor}>
  <ImageData {image}>
    <Piece>
      <PointData Scalars="density">
        <DataArray type="Float32" Name="other" format="ascii">1 2 3</DataArray>
        <DataArray type="{name}" Name="density" format="{format}" {array}>"#,
            width * 8
        )
    }

    pub fn inline(&self, format: &str, content: &str) -> Vec<u8> {
        let end = "</DataArray></PointData></Piece></ImageData></VTKFile>";
        format!("{}{content}{end}", self.head(format)).into_bytes()
    }

    pub fn appended(&self, encoding: &str, content: &[u8]) -> Vec<u8> {
        let middle = format!(
            "</DataArray></PointData></Piece></ImageData>\n<AppendedData encoding=\"{encoding}\">\n _"
        );
        let head = self.head("appended");
        [
            head.as_bytes(),
            middle.as_bytes(),
            content,
            b"\n</AppendedData></VTKFile>",
        ]
        .concat()
    }
}
