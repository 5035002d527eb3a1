//! Reading a file that a person named: once, whole, and never more than [`MAX_BYTES`] of it.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

use crate::error::{Error, Place, Result, with_slashes};
use crate::memory::MemoryLimit;

/// The largest file that is read: 2 GiB, some thirty million triangles of OBJ. A larger file is refused by its size,
/// before a byte of it is read.
pub const MAX_BYTES: u64 = 2 << 30;

/// The number of bytes that are examined before the rest is read: enough to tell a picture or an archive from a text.
const HEAD: u64 = 4096;

/// The bytes of a text file: one without a NUL in its first bytes.
pub(super) fn read(path: &Path, memory: &MemoryLimit) -> Result<Vec<u8>> {
    expect_readable(path, memory)?;
    read_text(path).map_err(|error| unreadable(path, error))?
}

/// The bytes of any file.
pub(super) fn read_bytes(path: &Path, memory: &MemoryLimit) -> Result<Vec<u8>> {
    expect_readable(path, memory)?;
    let read = || -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        File::open(path)?.take(MAX_BYTES).read_to_end(&mut bytes)?;
        Ok(bytes)
    };
    read().map_err(|error| unreadable(path, error))
}

pub(super) fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default();
    stem.to_string_lossy().into_owned()
}

fn expect_readable(path: &Path, memory: &MemoryLimit) -> Result<()> {
    let metadata = fs::metadata(path).map_err(|error| unreadable(path, error))?;
    if metadata.is_dir() {
        let what = "this is a directory, not a file";
        return Err(refused(path, what, "Name the file in it that you mean."));
    }
    if !metadata.is_file() {
        let what = "this is a device or a pipe, not a file";
        return Err(refused(path, what, "Write its content to a file first."));
    }
    if metadata.len() > MAX_BYTES {
        let what = format!(
            "the file has {} bytes; at most {MAX_BYTES} (2 GiB) are read",
            metadata.len()
        );
        return Err(refused(
            path,
            &what,
            "Split it into several files, or simplify the model.",
        ));
    }
    let bytes = format!("this file's {} bytes", metadata.len());
    let room = memory.check(metadata.len());
    room.map_err(|shortage| shortage.at(Place::file(path), bytes))
}

/// The outer error comes from the system, the inner one from here.
fn read_text(path: &Path) -> io::Result<Result<Vec<u8>>> {
    let mut file = File::open(path)?;
    let mut bytes = Vec::new();
    file.by_ref().take(HEAD).read_to_end(&mut bytes)?;
    if let Some(encoding) = encoding(&bytes) {
        let what = format!("this is text in {encoding}");
        return Ok(Err(refused(path, &what, "Save it as UTF-8.")));
    }
    if let Some(at) = bytes.iter().position(|&byte| byte == 0) {
        let line = 1 + bytes[..at].iter().filter(|&&byte| byte == b'\n').count();
        return Ok(Err(Error::input(
            Place::line(path, line),
            "this is a binary file (or UTF-16): it has a zero byte",
            "Give a text file; if it is one, save it as UTF-8.",
        )));
    }
    // The size may have changed since it was asked for, so the limit is checked here as well.
    file.take(MAX_BYTES).read_to_end(&mut bytes)?;
    Ok(Ok(bytes))
}

/// The name of the encoding if the first bytes show one that is not read here: by its byte order mark, or because every
/// other byte of text in Latin letters is 0.
fn encoding(head: &[u8]) -> Option<&'static str> {
    let zeros = |first: usize| {
        let every_other = head.iter().skip(first).step_by(2);
        every_other.clone().count() > 1 && every_other.clone().all(|&byte| byte == 0)
    };
    let is_text = |first: usize| !head.iter().skip(first).step_by(2).any(|&byte| byte == 0);
    match head {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => Some("UTF-32"),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => Some("UTF-16"),
        _ if zeros(1) && is_text(0) || zeros(0) && is_text(1) => Some("UTF-16"),
        _ => None,
    }
}

fn unreadable(path: &Path, error: io::Error) -> Error {
    let (what, remedy) = match (with_slashes(path), error.kind()) {
        (Some(meant), _) => ("there is no such file".into(), meant),
        (None, ErrorKind::NotFound) => (
            "there is no such file".into(),
            "Check the spelling. Paths in a scene file start at the scene file's folder.".into(),
        ),
        (None, ErrorKind::PermissionDenied) => (
            "the file may not be read".into(),
            "Check its permissions and those of its folders.".into(),
        ),
        _ => (
            format!("the file cannot be read: {error}"),
            "Check that the path names a readable file.".into(),
        ),
    };
    Error::input(Place::file(path), what, remedy).caused_by(error)
}

fn refused(path: &Path, what: &str, remedy: &str) -> Error {
    Error::input(Place::file(path), what, remedy)
}
