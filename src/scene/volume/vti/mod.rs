//! VTK's images: `.vti` files, of one piece or several, and `.pvti` files, whose pieces are other files.
//!
//! Source: VTK's description of its XML formats,
//! <https://docs.vtk.org/en/latest/vtk_file_formats/vtkxml_file_format.html>. Scalars of points and of cells can be
//! read; samples of cells are in the cells' middles. Formats are `ascii`, `binary` and `appended` (`raw` or `base64`),
//! plain or packed by VTK's zlib compressor. `roxmltree` reads the XML. Raw appended data is not XML, and is separated
//! first. The format names no anatomical space, so its own space is the world.

mod arrays;
mod assembly;
mod base64;
mod block;
mod data;
mod document;
mod image;

use std::collections::HashSet;
use std::path::Path;

use roxmltree::Node;

use super::check;
use super::reading::{Loaded, Parts, Stored, Wish, beside};
use crate::error::Result;
use arrays::{Choice, children};
use assembly::Assembly;
use block::Block;
use data::Form;
use document::Document;
use image::{Extent, Image};

/// Reads an image in one file.
pub(super) fn read(path: &Path, bytes: &[u8], wish: &Wish) -> Result<Loaded> {
    let document = Document::split(path, bytes)?;
    let tree = document.parse()?;
    let root = tree.root_element();
    let element = element(&document, root, "ImageData")?;
    let image = Image::read(&document, element)?;
    let first = first_piece(&document, element, &image)?;
    let (choice, notice) = arrays::choose(&document, first, "", wish)?;
    let whole = image.block(&document, choice.kind, wish, Stored::of(bytes))?;
    let mut assembly = Assembly::of(whole);
    add_pieces(&document, root, &choice, &mut assembly)?;
    finish(&document, &image, whole, &choice, assembly, notice, wish)
}

/// Reads an image whose pieces are in files of their own.
pub(super) fn read_parallel(path: &Path, bytes: &[u8], wish: &Wish) -> Result<Loaded> {
    let document = Document::split(path, bytes)?;
    let tree = document.parse()?;
    let root = tree.root_element();
    let element = element(&document, root, "PImageData")?;
    let image = Image::read(&document, element)?;
    let (choice, notice) = arrays::choose(&document, element, "P", wish)?;
    let whole = image.block(
        &document,
        choice.kind,
        wish,
        stored_in_pieces(path, element),
    )?;
    let mut assembly = Assembly::of(whole);
    let mut named = HashSet::new();
    for piece in children(element, "Piece") {
        if is_empty(&document, piece, &image)? {
            continue;
        }
        let Some(source) = piece.attribute("Source") else {
            let what = "a piece does not say in which file it is".to_owned();
            return Err(document.wrong("Piece Source", what, "Save the image again."));
        };
        if !named.insert(source) {
            let what = format!("two pieces are in the file '{source}'");
            return Err(document.wrong("Piece Source", what, "Save the image again."));
        }
        add_file(&beside(path, source), &choice, &mut assembly, wish)?;
    }
    finish(&document, &image, whole, &choice, assembly, notice, wish)
}

/// The sizes of the files that pieces name.
fn stored_in_pieces(path: &Path, element: Node) -> Stored {
    let sources = children(element, "Piece").filter_map(|piece| piece.attribute("Source"));
    Stored::default().and(sources.map(|source| beside(path, source)))
}

fn add_file(path: &Path, choice: &Choice, assembly: &mut Assembly, wish: &Wish) -> Result<()> {
    let bytes = wish.read(path)?;
    let document = Document::split(path, &bytes)?;
    let tree = document.parse()?;
    add_pieces(&document, tree.root_element(), choice, assembly)
}

/// The image's element, if the file has the right type.
fn element<'a>(document: &Document, root: Node<'a, 'a>, wanted: &str) -> Result<Node<'a, 'a>> {
    let kind = root.attribute("type").unwrap_or_default();
    if root.tag_name().name() != "VTKFile" || kind != wanted {
        let what = format!("this is a <{} type=\"{kind}\">", root.tag_name().name());
        let remedy = match (kind, wanted) {
            ("ImageData", _) => "Name the file .vti.".to_owned(),
            ("PImageData", _) => "Name the file .pvti.".to_owned(),
            _ => format!("Give a <VTKFile type=\"{wanted}\">."),
        };
        return Err(document.wrong("VTKFile", what, &remedy));
    }
    document.child(root, wanted)
}

fn extent_of(document: &Document, piece: Node, image: &Image) -> Result<Extent> {
    Ok(image::extent(document, piece, "Extent")?.unwrap_or(image.extent))
}

/// Whether a piece has no points, because its writer had nothing to write.
fn is_empty(document: &Document, piece: Node, image: &Image) -> Result<bool> {
    let extent = extent_of(document, piece, image)?;
    Ok(block::Kind::Points.block(extent).is_empty())
}

/// The first piece that is not empty. The other pieces have the same arrays.
fn first_piece<'a>(
    document: &Document,
    element: Node<'a, 'a>,
    image: &Image,
) -> Result<Node<'a, 'a>> {
    for piece in children(element, "Piece") {
        if !is_empty(document, piece, image)? {
            return Ok(piece);
        }
    }
    document.child(element, "Piece")
}

/// Reads all pieces of a file that are not empty.
fn add_pieces(
    document: &Document,
    root: Node,
    choice: &Choice,
    assembly: &mut Assembly,
) -> Result<()> {
    let element = element(document, root, "ImageData")?;
    let image = Image::read(document, element)?;
    let form = Form::read(document, root)?;
    for piece in children(element, "Piece") {
        let block = choice.kind.block(extent_of(document, piece, &image)?);
        if block.is_empty() {
            continue;
        }
        let wrong = |(what, remedy): check::Fault| document.wrong("Piece Extent", what, remedy);
        check::count_of(block.dims()).map_err(wrong)?;
        assembly.expect(&block).map_err(wrong)?;
        let array = arrays::find(document, piece, choice)?;
        assembly.add(block, form.samples(array, block.dims())?);
    }
    Ok(())
}

fn finish(
    document: &Document,
    image: &Image,
    whole: Block,
    choice: &Choice,
    assembly: Assembly,
    notice: Option<String>,
    wish: &Wish,
) -> Result<Loaded> {
    let samples = assembly.finish().map_err(|missing| {
        let all: usize = whole.dims().iter().product();
        let what = format!("its pieces leave out {missing} of the whole extent's {all} samples");
        let remedy = "Give all pieces, or save the image as one piece.";
        document.wrong("Piece Extent", what, remedy)
    })?;
    Parts {
        path: document.path(),
        dims: whole.dims(),
        samples,
        index_to_world: image.index_to_world(&whole, choice.kind),
        placed_by: document.place("Spacing"),
        notices: notice.into_iter().collect(),
    }
    .finish(wish)
}
