//! Files that appear whole or not at all.
//!
//! A symbolic link is followed: its target is replaced, and the link stays. Pipes and devices are refused. They cannot
//! be written whole or not at all, and writing to a pipe that nobody reads would wait for ever.
//!
//! On Linux a file has no name until it is whole (`O_TMPFILE`), so a killed program leaves nothing behind. If a file of
//! the name exists already, the new file has another name for the moment between two system calls. On file systems that
//! do not support files without names, and on other systems, it has another name while it is written. If the program is
//! killed at such a moment, the next program that asks for the folder removes the file ([`check_writable`]).

use std::fs::{self, File, TryLockError};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Duration;

use crate::error::{Error, Result};

/// The prefix of the names of files that are not whole yet, or not yet at their place.
pub const UNFINISHED: &str = ".onionskin-";

/// Another program locks a file as soon as it has made it. A file older than this that is not locked will not be locked
/// any more.
const SETTLED: Duration = Duration::from_secs(2);

/// The longest chain of links, as on Linux.
const MOST_LINKS: usize = 40;

/// Writes a file whole or not at all. Until the new file is whole, the old one is still there.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    let wrong = |error: io::Error| refused_by_system(path, error);
    let place = destination(path)?;
    let mut file = Unfinished::beside(&place).map_err(wrong)?;
    file.write_all(bytes).map_err(wrong)?;
    file.appear_at(&place).map_err(wrong)
}

/// Checks, before a long computation, that its result could be written to `path`.
///
/// # Errors
/// If it could not.
pub fn check_writable(path: &Path) -> Result<()> {
    let place = destination(path)?;
    sweep(folder_of(&place));
    Unfinished::beside(&place).map_err(|error| refused_by_system(path, error))?;
    Ok(())
}

/// The path at which a file of this name will appear: behind all links, in a folder that exists.
fn destination(path: &Path) -> Result<PathBuf> {
    let place = followed(path).map_err(|what| unwritable(path, what))?;
    match fs::metadata(&place) {
        Ok(there) if there.is_dir() => {
            return Err(unwritable(path, "there is a folder of that name".into()));
        }
        Ok(there) if !there.is_file() => return Err(special(path)),
        _ => {}
    }
    let folder = folder_of(&place);
    if !folder.is_dir() {
        let what = format!("there is no folder {}", folder.display());
        return Err(unwritable(path, what));
    }
    Ok(place)
}

/// The end of a chain of links. It need not exist.
fn followed(path: &Path) -> Result<PathBuf, String> {
    let mut place = path.to_owned();
    for _ in 0..MOST_LINKS {
        match fs::read_link(&place) {
            Ok(target) => place = folder_of(&place).join(target),
            Err(_) => return Ok(place),
        }
    }
    Err("its symbolic links lead in a circle".into())
}

fn folder_of(place: &Path) -> &Path {
    match place.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Removes files that killed programs have left. A file that is being written is locked.
fn sweep(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let is_ours = entry.file_name().to_string_lossy().starts_with(UNFINISHED);
        if is_ours && is_abandoned(&entry) {
            // A file that cannot be removed does no harm.
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn is_abandoned(entry: &fs::DirEntry) -> bool {
    // Links are not followed, and a pipe of that name is not opened.
    let there = entry.metadata();
    let settled = there.is_ok_and(|there| {
        let age = there
            .modified()
            .map(|time| time.elapsed().unwrap_or_default());
        there.is_file() && age.is_ok_and(|age| age > SETTLED)
    });
    settled
        && File::open(entry.path())
            .is_ok_and(|file| !matches!(file.try_lock(), Err(TryLockError::WouldBlock)))
}

/// A file that is not at its place yet. If it is dropped, the file is removed.
enum Unfinished {
    /// A file without a name.
    #[cfg(target_os = "linux")]
    Nameless(File),
    /// A file with a temporary name, where files without names are not supported.
    Named(tempfile::NamedTempFile),
}

impl Unfinished {
    /// The file is locked, as a sign that its program lives. Where locks are not supported, only this sign is missing.
    fn beside(place: &Path) -> io::Result<Self> {
        let folder = folder_of(place);
        #[cfg(target_os = "linux")]
        if let Ok(file) = nameless::create(folder) {
            let _ = file.lock();
            return Ok(Self::Nameless(file));
        }
        let mut builder = tempfile::Builder::new();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // A temporary file is private by default. A result is as public as the user's umask allows.
            builder.permissions(fs::Permissions::from_mode(0o666));
        }
        let file = builder.prefix(UNFINISHED).tempfile_in(folder)?;
        let _ = file.as_file().lock();
        Ok(Self::Named(file))
    }

    fn write_all(&mut self, bytes: &[u8]) -> io::Result<()> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Nameless(file) => file.write_all(bytes),
            Self::Named(file) => file.write_all(bytes),
        }
    }

    fn appear_at(self, place: &Path) -> io::Result<()> {
        match self {
            #[cfg(target_os = "linux")]
            Self::Nameless(file) => nameless::appear(&file, place),
            Self::Named(file) => file.persist(place).map(drop).map_err(|error| error.error),
        }
    }
}

/// Files that have no name until they are whole.
#[cfg(target_os = "linux")]
mod nameless {
    use std::fs::{self, File};
    use std::io;
    use std::os::fd::AsRawFd;
    use std::path::Path;
    use std::sync::atomic::{AtomicU32, Ordering};

    use rustix::fs::{AtFlags, CWD, Mode, OFlags, linkat, open};

    use super::{UNFINISHED, folder_of};

    /// The number that makes names of this process differ.
    static COUNT: AtomicU32 = AtomicU32::new(0);

    /// As public as the user's umask allows.
    pub(super) fn create(folder: &Path) -> io::Result<File> {
        let flags = OFlags::TMPFILE | OFlags::WRONLY | OFlags::CLOEXEC;
        let file = open(folder, flags, Mode::from_raw_mode(0o666))?;
        // The file gets its name through /proc, so it can get one only if /proc has it.
        let file = File::from(file);
        fs::metadata(own_name(&file))?;
        Ok(file)
    }

    /// Gives the file its place. A new link cannot replace an existing file. In that case the file first gets another
    /// name, and is then renamed.
    pub(super) fn appear(file: &File, place: &Path) -> io::Result<()> {
        match link(file, place) {
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => replace(file, place),
            done => done,
        }
    }

    fn replace(file: &File, place: &Path) -> io::Result<()> {
        loop {
            let (process, count) = (std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
            let other = folder_of(place).join(format!("{UNFINISHED}{process}-{count}"));
            match link(file, &other) {
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
                Ok(()) => {
                    return fs::rename(&other, place).inspect_err(|_| {
                        let _ = fs::remove_file(&other);
                    });
                }
            }
        }
    }

    fn link(file: &File, place: &Path) -> io::Result<()> {
        Ok(linkat(
            CWD,
            own_name(file),
            CWD,
            place,
            AtFlags::SYMLINK_FOLLOW,
        )?)
    }

    fn own_name(file: &File) -> String {
        format!("/proc/self/fd/{}", file.as_raw_fd())
    }
}

fn special(path: &Path) -> Error {
    Error::Output {
        path: path.to_owned(),
        what: "there is a pipe or a device of that name, not a file".into(),
        remedy: "name a file; results are written whole or not at all".into(),
        source: None,
    }
}

fn refused_by_system(path: &Path, error: io::Error) -> Error {
    unwritable(path, error.to_string()).caused_by(error)
}

fn unwritable(path: &Path, what: String) -> Error {
    Error::Output {
        path: path.to_owned(),
        what,
        remedy:
            "check that the folder exists, that you may write there, and that the disk has room"
                .into(),
        source: None,
    }
}

#[cfg(test)]
mod tests {
    use std::time::SystemTime;

    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        let mut names: Vec<String> = entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    /// An unfinished file of another program, of two minutes ago.
    fn left_behind(folder: &Path) -> File {
        let file = File::create(folder.join(".onionskin-a1B2c3")).unwrap();
        let long_ago = SystemTime::now() - Duration::from_secs(120);
        file.set_modified(long_ago).unwrap();
        file
    }

    #[test]
    fn a_file_appears_with_its_content_and_replaces_what_was_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        for content in ["one", "another"] {
            write_whole(&path, content.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), content);
            assert_eq!(names(folder.path()), ["a.txt"]);
        }
    }

    #[test]
    fn asking_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        check_writable(&folder.path().join("a.txt")).unwrap();
        assert!(names(folder.path()).is_empty());
    }

    #[test]
    fn a_file_that_is_not_whole_has_no_name_and_dropped_is_gone() {
        let folder = tempfile::tempdir().unwrap();
        let place = folder.path().join("a.txt");
        let mut file = Unfinished::beside(&place).unwrap();
        file.write_all(b"half").unwrap();
        if matches!(file, Unfinished::Named(_)) {
            println!("this file system has no files without names");
        } else {
            assert!(names(folder.path()).is_empty());
        }
        drop(file);
        assert!(names(folder.path()).is_empty());
    }

    #[test]
    fn what_a_killed_program_left_is_swept_away_and_what_a_living_one_writes_is_not() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.txt");
        let living = left_behind(folder.path());
        living.lock().unwrap();
        check_writable(&path).unwrap();
        assert_eq!(names(folder.path()), [".onionskin-a1B2c3"]);
        drop(living);
        check_writable(&path).unwrap();
        assert!(names(folder.path()).is_empty());
        // One that has just been made may be about to be locked.
        File::create(folder.path().join(".onionskin-d4E5f6")).unwrap();
        check_writable(&path).unwrap();
        assert_eq!(names(folder.path()), [".onionskin-d4E5f6"]);
    }

    #[test]
    #[cfg(unix)]
    fn a_link_is_followed_and_stays() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("deep")).unwrap();
        symlink("deep/second", at("first")).unwrap();
        symlink("target.txt", at("deep/second")).unwrap();
        for content in ["to nothing yet", "to what is there"] {
            write_whole(&at("first"), content.as_bytes()).unwrap();
            assert_eq!(fs::read_to_string(at("deep/target.txt")).unwrap(), content);
            assert!(at("first").is_symlink() && at("deep/second").is_symlink());
        }
        assert_eq!(names(&at("deep")), ["second", "target.txt"]);
        symlink("round", at("round")).unwrap();
        let error = write_whole(&at("round"), b"").unwrap_err().to_string();
        assert!(error.contains("in a circle"), "{error}");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_device_is_refused_and_stays_one() {
        use std::os::unix::fs::{FileTypeExt, symlink};
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("null.txt");
        symlink("/dev/null", &link).unwrap();
        for path in [Path::new("/dev/null"), Path::new("/dev/full"), &link] {
            for result in [write_whole(path, b"x"), check_writable(path)] {
                let error = result.unwrap_err().to_string();
                assert!(error.contains("a pipe or a device"), "{error}");
            }
        }
        let kind = fs::metadata("/dev/null").unwrap().file_type();
        assert!(kind.is_char_device() && link.is_symlink());
    }
}
