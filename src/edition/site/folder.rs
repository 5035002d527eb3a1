//! The folder that gets the site. Every file in it appears whole or not at all.

use std::fs;
use std::io::{Error as IoError, ErrorKind};
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};
use crate::image::{UNFINISHED, check_writable, write_whole};

/// The file that says which edition the folder has. It is written first.
pub(super) const IDENTITY: &str = "edition.txt";
/// The folder of the figures' files.
pub(super) const FIGURES: &str = "figures";

pub(super) struct Folder {
    path: PathBuf,
}

impl Folder {
    /// Makes the folder, or takes an existing one. `names` are the files of the site, `keys` those of its figures.
    pub(super) fn open(
        path: &Path,
        identity: &str,
        names: &[String],
        keys: &[&str],
    ) -> Result<Self> {
        let wrong = |error| unwritable(path, error);
        match fs::create_dir(path) {
            Err(error) if error.kind() != ErrorKind::AlreadyExists || !path.is_dir() => {
                return Err(wrong(error));
            }
            Err(_) => check(path, identity, names, keys)?,
            Ok(()) => {}
        }
        let folder = Self { path: path.into() };
        check_writable(&path.join(IDENTITY))?;
        match fs::create_dir(path.join(FIGURES)) {
            Err(error) if error.kind() != ErrorKind::AlreadyExists => return Err(wrong(error)),
            _ => check_writable(&path.join(FIGURES).join(IDENTITY))?,
        }
        folder.write(IDENTITY, identity.as_bytes())?;
        Ok(folder)
    }

    pub(super) fn write(&self, name: &str, bytes: &[u8]) -> Result<()> {
        write_whole(&self.path.join(name), bytes)
    }

    pub(super) fn has(&self, name: &str) -> bool {
        self.path.join(name).is_file()
    }

    pub(super) fn read(&self, name: &str) -> Option<String> {
        fs::read_to_string(self.path.join(name)).ok()
    }

    /// Removes unfinished files of killed programs. One that is being written is left alone.
    pub(super) fn tidy(&self) {
        for folder in [self.path.clone(), self.path.join(FIGURES)] {
            // Everything was written, so what is asked here is only to sweep.
            let _ = check_writable(&folder.join(IDENTITY));
        }
    }
}

/// Refuses a folder that has something else than a part of this edition.
fn check(path: &Path, identity: &str, names: &[String], keys: &[&str]) -> Result<()> {
    let wrong = |error| unwritable(path, error);
    let mut there = names_in(path).map_err(wrong)?;
    there.retain(|name| !name.starts_with(UNFINISHED));
    if there.is_empty() {
        return Ok(());
    }
    let mut foreign: Vec<String> = there
        .iter()
        .filter(|name| *name != FIGURES && *name != IDENTITY && !names.contains(name))
        .cloned()
        .collect();
    if there.iter().any(|name| name == FIGURES) {
        let inside = names_in(&path.join(FIGURES)).map_err(wrong)?;
        let others = inside.iter().filter(|name| !is_of_a_figure(name, keys));
        foreign.extend(others.map(|name| format!("{FIGURES}/{name}")));
    }
    if let Some(first) = foreign.first() {
        return Err(refused(
            path,
            format!("it has files that are not the edition's, such as {first}"),
        ));
    }
    match fs::read_to_string(path.join(IDENTITY)) {
        Ok(other) if other == identity => Ok(()),
        Ok(other) => {
            let (here, there) = (one_line(&other), one_line(identity));
            Err(refused(
                path,
                format!("it has another edition ({here}), and not this one ({there})"),
            ))
        }
        Err(_) => Err(refused(
            path,
            format!("it has files, and no {IDENTITY} that says that they are the edition's"),
        )),
    }
}

fn one_line(identity: &str) -> String {
    identity.trim_end().replace('\n', "; ")
}

/// Whether a file of this name may be a figure's: `KEY.json`, or `KEY-NAME.png`.
fn is_of_a_figure(name: &str, keys: &[&str]) -> bool {
    let is_ours = |key: &&str| {
        name.strip_prefix(key).is_some_and(|rest| {
            rest == ".json" || (rest.starts_with('-') && rest.ends_with(".png"))
        })
    };
    name.starts_with(UNFINISHED) || keys.iter().any(is_ours)
}

fn names_in(folder: &Path) -> Result<Vec<String>, IoError> {
    let entries = fs::read_dir(folder)?;
    let mut names = entries
        .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
        .collect::<Result<Vec<_>, IoError>>()?;
    names.sort();
    Ok(names)
}

fn refused(path: &Path, what: String) -> Error {
    Error::Output {
        path: path.to_owned(),
        what,
        remedy: "Name another folder, or empty this one.".into(),
        source: None,
    }
}

fn unwritable(path: &Path, error: IoError) -> Error {
    Error::Output {
        path: path.to_owned(),
        what: error.to_string(),
        remedy: "Name a folder that can be written to, in one that is there.".into(),
        source: Some(error),
    }
}
