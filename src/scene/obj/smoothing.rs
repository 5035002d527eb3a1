//! `s`: the faces that share normals where the file gives no normals.

use std::collections::HashMap;

use super::words;

/// Smoothing groups, in the form of texture coordinates. `tobj` makes separate vertices of corners that name different
/// texture coordinates, and nothing else here uses them.
pub(super) struct Smoothing {
    /// Whether the file has any `s`. If it has none, a mesh is smooth throughout.
    grouped: bool,
    /// The current group. `None` means facets, with which a file starts.
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

    /// The group of the next face, or `None` if the file has no groups.
    pub(super) fn of_face(&mut self, out: &mut String) -> Option<usize> {
        let facet = || write(&mut self.written, out);
        self.grouped.then(|| self.current.unwrap_or_else(facet))
    }
}

/// Adds a texture coordinate and returns its index.
fn write(written: &mut usize, out: &mut String) -> usize {
    out.push_str("vt 0 0\n");
    *written += 1;
    *written
}
