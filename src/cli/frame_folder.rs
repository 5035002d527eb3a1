//! The folder that `animate` fills. Several commands may fill it at once. Every file belongs to one frame and appears
//! whole, except two files that belong to all frames, whose content does not depend on the command that writes them
//! last.

use std::fs::{self, File};
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use onionskin::low_level::image::UNFINISHED;
use onionskin::report::save_text;
use onionskin::{Encoding, Error, Image, Result};

/// The file of the folder's identity: the scene, the method and so on.
const IDENTITY: &str = "animation.txt";
/// The file of all frames' rows.
const TABLE: &str = "frames.csv";

/// A folder of frames that belong together.
pub(super) struct FrameFolder {
    path: PathBuf,
    /// The identity, with a shared lock while this command may write. A command that gets an exclusive lock is the last
    /// one. The system ends the lock of a killed command.
    held: File,
}

impl FrameFolder {
    /// Makes the folder, or takes an existing one if its frames are of the same scene, method and size.
    ///
    /// # Errors
    /// If the folder cannot be written, or its frames are of something else.
    pub(super) fn open(path: &Path, identity: &[(&'static str, String)]) -> Result<Self> {
        match fs::create_dir(path) {
            Err(error) if error.kind() != ErrorKind::AlreadyExists || !path.is_dir() => {
                return Err(unwritable(path, error));
            }
            _ => {}
        }
        let kept = path.join(IDENTITY);
        let hold = || -> std::io::Result<File> {
            if !kept.exists() {
                found(&kept, identity)?;
            }
            let held = File::open(&kept)?;
            // On a file system without locks, files of killed commands stay. Everything else works as elsewhere.
            let _ = held.lock_shared();
            Ok(held)
        };
        let folder = Self {
            path: path.to_owned(),
            held: hold().map_err(|error| unwritable(path, error))?,
        };
        folder.expect(&kept, identity)?;
        Ok(folder)
    }

    fn expect(&self, kept: &Path, identity: &[(&'static str, String)]) -> Result<()> {
        let there = fs::read_to_string(kept).map_err(|error| unwritable(kept, error))?;
        let lines: Vec<&str> = there.lines().collect();
        for (key, value) in identity {
            let wanted = format!("{key} = {value}");
            if !lines.contains(&wanted.as_str()) {
                let found = lines
                    .iter()
                    .find(|line| line.starts_with(&format!("{key} = ")));
                let found = found.copied().unwrap_or("nothing of it");
                return Err(Error::usage(
                    format!(
                        "{} has frames of another {key}: {found}, not {value}",
                        self.path.display()
                    ),
                    "Give another folder, or empty this one.",
                ));
            }
        }
        Ok(())
    }

    /// Whether a frame is whole. Its row is written last.
    pub(super) fn has(&self, number: u32) -> bool {
        self.picture(number).is_file() && self.row(number).is_file()
    }

    /// Writes a frame.
    pub(super) fn add(
        &self,
        number: u32,
        image: &Image,
        encoding: Encoding,
        row: &str,
    ) -> Result<()> {
        image.save_as(self.picture(number), encoding)?;
        save_text(&self.row(number), row)
    }

    /// Joins the existing rows. Returns their file and their number. The command that ends last joins all rows, and
    /// removes unfinished files of killed commands.
    pub(super) fn join(self, frames: u32) -> Result<(PathBuf, u32)> {
        let (mut table, mut rows) = (String::new(), 0);
        for number in (0..frames).filter(|&number| self.has(number)) {
            let path = self.row(number);
            let row = fs::read_to_string(&path).map_err(|error| unwritable(&path, error))?;
            let skipped = usize::from(!table.is_empty());
            for line in row.lines().skip(skipped) {
                table += line;
                table.push('\n');
            }
            rows += 1;
        }
        let path = self.path.join(TABLE);
        save_text(&path, &table)?;
        self.tidy();
        Ok((path, rows))
    }

    fn tidy(&self) {
        if self.held.unlock().is_err() || self.held.try_lock().is_err() {
            return;
        }
        let entries = fs::read_dir(&self.path).into_iter().flatten().flatten();
        for entry in entries.filter(|e| e.file_name().to_string_lossy().starts_with(UNFINISHED)) {
            // A file that cannot be removed does no harm.
            let _ = fs::remove_file(entry.path());
        }
    }

    fn picture(&self, number: u32) -> PathBuf {
        self.path.join(format!("frame-{number:05}.png"))
    }

    fn row(&self, number: u32) -> PathBuf {
        self.path.join(format!("frame-{number:05}.csv"))
    }
}

/// Writes the identity, whole or not at all, and never over another command's.
fn found(kept: &Path, identity: &[(&'static str, String)]) -> std::io::Result<()> {
    let text: String = identity
        .iter()
        .map(|(k, v)| format!("{k} = {v}\n"))
        .collect();
    let mut file = tempfile::Builder::new()
        .prefix(UNFINISHED)
        .tempfile_in(kept.parent().unwrap_or(Path::new(".")))?;
    file.write_all(text.as_bytes())?;
    match file.persist_noclobber(kept) {
        // Another command was faster, and may have removed this one's file.
        Err(_) if kept.exists() => Ok(()),
        Err(error) => Err(error.error),
        Ok(_) => Ok(()),
    }
}

fn unwritable(path: &Path, error: std::io::Error) -> Error {
    Error::Output {
        path: path.to_owned(),
        what: error.to_string(),
        remedy: "Name a folder that can be written to, in one that is there.".into(),
        source: Some(error),
    }
}
