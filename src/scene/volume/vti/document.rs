//! The two parts of a file: XML for a parser, and appended data.

use std::path::Path;

use roxmltree::Node;

use crate::error::{Error, Place, Result};

/// A `.vti` file.
pub(super) struct Document<'a> {
    path: &'a Path,
    /// The XML. It is closed where the appended data was.
    text: String,
    /// The bytes after the underscore.
    pub(super) appended: &'a [u8],
}

const START: &[u8] = b"<AppendedData";

impl<'a> Document<'a> {
    /// Separates the appended data from the XML.
    pub(super) fn split(path: &'a Path, bytes: &'a [u8]) -> Result<Self> {
        let start = bytes.windows(START.len()).position(|part| part == START);
        let (xml, close, appended) = match start {
            None => (bytes, "", &[][..]),
            Some(start) => {
                let end = bytes[start..].iter().position(|&byte| byte == b'>');
                let end = start + end.unwrap_or(bytes.len() - start);
                let rest = &bytes[end..];
                let data = rest.iter().position(|&byte| byte == b'_');
                let data = data.map_or(&[][..], |data| &rest[data + 1..]);
                let open = bytes[..end].strip_suffix(b"/").unwrap_or(&bytes[..end]);
                (open, "/></VTKFile>", data)
            }
        };
        let Ok(xml) = str::from_utf8(xml) else {
            let remedy = "Check that this is a VTK XML file.";
            return Err(Error::input(
                Place::file(path),
                "its XML is not UTF-8 text",
                remedy,
            ));
        };
        Ok(Self {
            path,
            text: format!("{xml}{close}"),
            appended,
        })
    }

    pub(super) fn parse(&self) -> Result<roxmltree::Document<'_>> {
        roxmltree::Document::parse(&self.text).map_err(|error| {
            let place = Place::line(self.path, error.pos().row as usize);
            Error::input(
                place,
                format!("this is not XML: {error}"),
                "Save the image again.",
            )
        })
    }

    /// The file.
    pub(super) fn path(&self) -> &'a Path {
        self.path
    }

    /// The place of a field, as far as it is known.
    pub(super) fn place(&self, field: &str) -> Place {
        Place::file(self.path).token(field)
    }

    /// The error for an element or an attribute.
    pub(super) fn wrong(&self, field: &str, what: String, remedy: &str) -> Error {
        Error::input(self.place(field), what, remedy)
    }

    /// The first child element of that name.
    pub(super) fn child<'b>(&self, parent: Node<'b, 'b>, name: &str) -> Result<Node<'b, 'b>> {
        let mut children = parent.children();
        children
            .find(|node| node.has_tag_name(name))
            .ok_or_else(|| {
                let what = format!("there is none in <{}>", parent.tag_name().name());
                self.wrong(name, what, "Save the image again.")
            })
    }

    /// The `N` numbers of an attribute, or `None` if the attribute is missing.
    pub(super) fn numbers<T, const N: usize>(
        &self,
        node: Node,
        key: &str,
        read: impl Fn(&str) -> Option<T>,
    ) -> Result<Option<[T; N]>> {
        let Some(text) = node.attribute(key) else {
            return Ok(None);
        };
        let numbers: Option<Vec<T>> = text.split_whitespace().map(read).collect();
        let numbers = numbers.and_then(|numbers| numbers.try_into().ok());
        numbers.map(Some).ok_or_else(|| {
            self.wrong(
                key,
                format!("'{text}' is not {N} numbers"),
                "Correct the attribute.",
            )
        })
    }
}
