//! VTK ImageData (`.vti`): one piece, one scalar per point.
//!
//! After VTK's description of its XML formats, <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>.
//! Read are the formats `ascii`, `binary` and `appended` (`raw` or `base64`), plain or packed by VTK's zlib compressor.
//! The XML is `roxmltree`'s business; raw appended data is not XML, and is cut off before.

mod data;
mod document;

use std::path::Path;

use glam::{DAffine3, DMat3, DVec3};
use roxmltree::Node;

use super::check;
use super::load::{Layout, Loaded, finish};
use super::samples::SampleType;
use crate::error::Result;
use document::Document;

pub(super) fn read(path: &Path, bytes: &[u8]) -> Result<Loaded> {
    let document = Document::split(path, bytes)?;
    let tree = document.parse()?;
    let root = tree.root_element();
    let wrong = |field: &str, what: String, remedy: &str| document.wrong(field, what, remedy);
    let kind = root.attribute("type").unwrap_or_default();
    if root.tag_name().name() != "VTKFile" || kind != "ImageData" {
        let what = format!("this is a <{} type=\"{kind}\">", root.tag_name().name());
        let remedy = "Give a <VTKFile type=\"ImageData\">.";
        return Err(wrong("VTKFile", what, remedy));
    }
    let image = document.child(root, "ImageData")?;
    let piece = only_piece(&document, image)?;
    let extent = extent(&document, image)?;
    let array = scalars(&document, piece)?;
    let stored = array.attribute("type").and_then(stored).ok_or_else(|| {
        let what = "this is not a type of samples that can be read".into();
        wrong(
            "DataArray type",
            what,
            "Known are Int8 to UInt64, Float32 and Float64.",
        )
    })?;
    let dims = dims(&document, extent)?;
    let endian = data::endian(&document, root)?;
    let layout = Layout {
        dims,
        stored,
        endian,
    };
    let samples = data::samples(&document, root, array, &layout)?;
    let affine = placement(&document, image, extent)?;
    let places = ["DataArray", "Spacing"].map(|field| document.place(field));
    let volume = finish(path, dims, samples, affine, places)?;
    Ok(Loaded {
        volume,
        notices: Vec::new(),
    })
}

/// A file of several pieces would have to be put together.
fn only_piece<'a>(document: &Document, image: Node<'a, 'a>) -> Result<Node<'a, 'a>> {
    let piece = document.child(image, "Piece")?;
    let whole = image.attribute("WholeExtent").unwrap_or_default();
    let own = piece.attribute("Extent").unwrap_or(whole);
    if own.split_whitespace().eq(whole.split_whitespace()) {
        return Ok(piece);
    }
    let what = format!("the first piece is {own}, the whole {whole}");
    Err(document.wrong("Piece Extent", what, "Save the image as one piece."))
}

/// First and last index of x, y and z.
fn extent(document: &Document, image: Node) -> Result<[i64; 6]> {
    let read = |word: &str| word.parse::<i32>().ok().map(i64::from);
    let numbers = document.numbers(image, "WholeExtent", read)?;
    numbers.ok_or_else(|| {
        let what = "it is missing".to_owned();
        document.wrong(
            "WholeExtent",
            what,
            "Give first and last index of x, y and z.",
        )
    })
}

fn dims(document: &Document, [x0, x1, y0, y1, z0, z1]: [i64; 6]) -> Result<[usize; 3]> {
    let counts = [x1 - x0 + 1, y1 - y0 + 1, z1 - z0 + 1];
    let dims = counts.map(|count| usize::try_from(count).unwrap_or(0));
    check::dims(dims).map_err(|(what, remedy)| document.wrong("WholeExtent", what, remedy))?;
    Ok(dims)
}

/// The array that the points' data name as their scalars, or else their first one.
fn scalars<'a>(document: &Document, piece: Node<'a, 'a>) -> Result<Node<'a, 'a>> {
    let points = document.child(piece, "PointData")?;
    let name = points.attribute("Scalars");
    let mut arrays = points
        .children()
        .filter(|node| node.has_tag_name("DataArray"));
    let array = match name {
        Some(name) => arrays.find(|array| array.attribute("Name") == Some(name)),
        None => arrays.next(),
    };
    let array = array.ok_or_else(|| {
        let what = format!("there is no array '{}'", name.unwrap_or_default());
        document.wrong("PointData", what, "Save the scalars as data of the points.")
    })?;
    match array.attribute("NumberOfComponents").unwrap_or("1") {
        "1" | "0" => Ok(array),
        count => Err(document.wrong(
            "NumberOfComponents",
            format!("each sample has {count} components"),
            "Save one scalar per point.",
        )),
    }
}

fn placement(
    document: &Document,
    image: Node,
    [x0, _, y0, _, z0, _]: [i64; 6],
) -> Result<DAffine3> {
    let number = |word: &str| word.parse::<f64>().ok();
    let vector = |key: &str, default: DVec3| -> Result<DVec3> {
        let numbers = document.numbers(image, key, number)?;
        Ok(numbers.map_or(default, DVec3::from_array))
    };
    let origin = vector("Origin", DVec3::ZERO)?;
    let spacing = vector("Spacing", DVec3::ONE)?;
    let rows: Option<[f64; 9]> = document.numbers(image, "Direction", number)?;
    let direction = rows.map_or(DMat3::IDENTITY, |rows| {
        DMat3::from_cols_array(&rows).transpose()
    });
    let axes = direction * DMat3::from_diagonal(spacing);
    let first = DVec3::new(x0 as f64, y0 as f64, z0 as f64);
    Ok(DAffine3::from_mat3_translation(axes, origin + axes * first))
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
