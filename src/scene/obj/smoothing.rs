//! `s`: which faces share normals where the file gives none.

use std::collections::HashMap;

use super::words;

/// The group that a face belongs to, as the place of a texture coordinate: `tobj` makes vertices of their own of
/// corners that name different ones, and nothing else here uses them.
pub(super) struct Smoothing {
    /// Whether the file has any `s`. If not, a mesh is smooth throughout.
    grouped: bool,
    /// `None`: facets, which is how a file starts.
    current: Option<usize>,
    groups: HashMap<Vec<u8>, usize>,
    written: usize,
}

impl Smoothing {
    /// For a file with or without `s`.
    pub(super) fn new(grouped: bool) -> Self {
        Self {
            grouped,
            current: None,
            groups: HashMap::new(),
            written: 0,
        }
    }

    /// `s 1`, `s off` and the like.
    pub(super) fn switch(&mut self, rest: &[u8], out: &mut String) {
        let group = words::words(rest)
            .next()
            .unwrap_or_default()
            .to_ascii_lowercase();
        if group.iter().all(|&byte| byte == b'0') || group == b"off" {
            self.current = None;
            return;
        }
        let written = &mut self.written;
        let group = self
            .groups
            .entry(group)
            .or_insert_with(|| write(written, out));
        self.current = Some(*group);
    }

    /// The group of the next face; `None` if the file knows no groups.
    pub(super) fn of_face(&mut self, out: &mut String) -> Option<usize> {
        let facet = || write(&mut self.written, out);
        self.grouped.then(|| self.current.unwrap_or_else(facet))
    }
}

/// One texture coordinate more; its index.
fn write(written: &mut usize, out: &mut String) -> usize {
    out.push_str("vt 0 0\n");
    *written += 1;
    *written
}
