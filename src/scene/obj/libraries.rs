//! Finding the material files that a model names.

use std::collections::{HashMap, HashSet};
use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};

use super::notes::{Note, Notes};
use super::words;

/// The most names that are looked for. Each name takes several accesses to the disk.
const MAX_LOOKS: usize = 512;

/// Finds files by the names that programs write.
pub(super) struct Libraries<'a> {
    folder: &'a Path,
    /// The names in the folders that were searched, by their lower-case forms.
    listings: HashMap<PathBuf, HashMap<String, OsString>>,
    /// The names that were looked for. Each has its file, and whether the file has exactly this name.
    looked: HashMap<Vec<u8>, Option<(PathBuf, bool)>>,
    taken: HashSet<PathBuf>,
    found: Vec<PathBuf>,
}

impl<'a> Libraries<'a> {
    /// The files that the `mtllib` lines name, each once, in the order in which they are searched for materials.
    pub(super) fn find(
        model: &'a Path,
        lines: &[(Vec<u8>, usize)],
        notes: &mut Notes,
    ) -> Vec<PathBuf> {
        let mut libraries = Self {
            folder: model.parent().unwrap_or(Path::new("")),
            listings: HashMap::new(),
            looked: HashMap::new(),
            taken: HashSet::new(),
            found: Vec::new(),
        };
        for (rest, line) in lines {
            libraries.line(rest, *line, notes);
        }
        libraries.found
    }

    /// The rest of a line is one name, which may have spaces, or several names.
    fn line(&mut self, rest: &[u8], line: usize, notes: &mut Notes) {
        let whole = unquoted(rest);
        if whole.is_empty() || self.take(whole, line, notes) {
            return;
        }
        for name in names(rest) {
            if self.take(name, line, notes) {
                continue;
            }
            let parts = || words::words(name).take(MAX_LOOKS);
            if parts().count() > 1 && parts().any(|part| self.look(part).is_some()) {
                for part in parts() {
                    if !self.take(part, line, notes) {
                        self.missing(part, line, notes);
                    }
                }
            } else {
                self.missing(name, line, notes);
            }
        }
    }

    fn missing(&self, name: &[u8], line: usize, notes: &mut Notes) {
        let note = match self.looked.contains_key(name) {
            true => Note::LibraryMissing,
            false => Note::TooManyLibraries,
        };
        notes.count(note, line, name);
    }

    /// Adds the file of this name if it exists.
    fn take(&mut self, name: &[u8], line: usize, notes: &mut Notes) -> bool {
        let Some((path, as_named)) = self.look(name) else {
            return false;
        };
        // A file may have many names.
        let real = fs::canonicalize(&path).unwrap_or_else(|_| path.clone());
        if self.taken.insert(real) {
            if !as_named {
                notes.count(Note::LibraryElsewhere, line, name);
            }
            self.found.push(path);
        }
        true
    }

    /// Looks for a name, each only once, and for a limited number of names.
    fn look(&mut self, name: &[u8]) -> Option<(PathBuf, bool)> {
        if let Some(known) = self.looked.get(name) {
            return known.clone();
        }
        if self.looked.len() >= MAX_LOOKS {
            return None;
        }
        let found = self.locate(name);
        self.looked.insert(name.to_owned(), found.clone());
        found
    }

    /// The file of this name, and whether its name is exactly this. The file's name may also have the other system's
    /// slashes, no folders, or another case.
    fn locate(&mut self, name: &[u8]) -> Option<(PathBuf, bool)> {
        let mut spellings = vec![os_name(name)];
        if std::str::from_utf8(name).is_err() {
            // Read as Latin-1, in which each byte is the character of that number.
            let decoded: String = name.iter().map(|&byte| char::from(byte)).collect();
            spellings.push(OsString::from(decoded));
        }
        for (i, spelling) in spellings.iter().enumerate() {
            let path = self.folder.join(spelling);
            if path.is_file() {
                return Some((path, i == 0));
            }
        }
        let text = spellings.pop()?.to_string_lossy().replace('\\', "/");
        let last = text.rsplit('/').next().unwrap_or_default();
        let paths = [self.folder.join(&text), self.folder.join(last)];
        for path in &paths {
            if path.is_file() {
                return Some((path.clone(), false));
            }
        }
        paths
            .iter()
            .find_map(|path| Some((self.in_another_case(path)?, false)))
    }

    /// The file in the same folder whose name differs only in case.
    fn in_another_case(&mut self, path: &Path) -> Option<PathBuf> {
        let wanted = path.file_name()?.to_string_lossy().to_lowercase();
        let folder = path.parent()?;
        let names = self.listings.entry(folder.to_owned());
        let names = names.or_insert_with(|| listing(folder));
        let path = folder.join(names.get(&wanted)?);
        path.is_file().then_some(path)
    }
}

/// The names in a folder, the first of those that differ only in case. The list is empty if the folder cannot be read.
fn listing(folder: &Path) -> HashMap<String, OsString> {
    let folder = match folder.as_os_str().is_empty() {
        true => Path::new("."),
        false => folder,
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<OsString> = entries.map(|entry| entry.file_name()).collect();
    names.sort();
    let mut listing = HashMap::new();
    for name in names {
        let lower = name.to_string_lossy().to_lowercase();
        listing.entry(lower).or_insert(name);
    }
    listing
}

/// The names in a line: names in quotes, names that end in `.mtl`, or the rest of the line.
fn names(rest: &[u8]) -> Vec<&[u8]> {
    let mut names = Vec::new();
    let mut rest = words::trim(rest);
    while !rest.is_empty() {
        let (name, after) = match quoted(rest) {
            Some(split) => split,
            None => rest.split_at(end_of_name(rest)),
        };
        names.push(words::trim(name));
        rest = words::trim(after);
    }
    names.retain(|name| !name.is_empty());
    names
}

/// The end of a name: after `.mtl` and before a space.
fn end_of_name(rest: &[u8]) -> usize {
    let ends = rest.windows(4).enumerate().find(|(at, window)| {
        let after = rest.get(at + 4);
        window.eq_ignore_ascii_case(b".mtl") && after.is_none_or(|byte| byte.is_ascii_whitespace())
    });
    ends.map_or(rest.len(), |(at, _)| at + 4)
}

/// The text in quotes at the beginning, and the text after it.
fn quoted(rest: &[u8]) -> Option<(&[u8], &[u8])> {
    let (&quote, inside) = rest.split_first()?;
    if quote != b'"' && quote != b'\'' {
        return None;
    }
    let end = inside.iter().position(|&byte| byte == quote)?;
    Some((&inside[..end], &inside[end + 1..]))
}

/// The text without the quotes around it.
fn unquoted(rest: &[u8]) -> &[u8] {
    match quoted(rest) {
        Some((inside, [])) => words::trim(inside),
        _ => rest,
    }
}

#[cfg(unix)]
fn os_name(name: &[u8]) -> OsString {
    use std::os::unix::ffi::OsStrExt;
    OsStr::from_bytes(name).to_owned()
}

#[cfg(not(unix))]
fn os_name(name: &[u8]) -> OsString {
    let text = String::from_utf8_lossy(name);
    OsStr::new(text.as_ref()).to_owned()
}
