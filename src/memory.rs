//! Limits of memory. Callers ask before they allocate, so that a request that is too large is refused with a message,
//! and the program is not killed without one.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use crate::error::{Error, Place};

/// A limit of memory, and the part of it that is taken. Copies share that part.
///
/// ```
/// use onionskin::MemoryLimit;
///
/// let memory: MemoryLimit = "2G".parse()?;
/// memory.take(3 << 29).expect("1.5 GiB of 2");
/// assert_eq!(memory.left(), 1 << 29);
/// assert!(memory.take(1 << 30).is_err());
/// # Ok::<(), onionskin::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct MemoryLimit {
    bytes: u64,
    taken: Arc<Taken>,
    /// Whether a person has set the limit.
    given: bool,
}

/// What copies of a limit share, in bytes.
#[derive(Debug, Default)]
struct Taken {
    all: AtomicU64,
    /// The part that was unpacked from files.
    from_files: AtomicU64,
    /// The sizes of these files.
    on_disk: AtomicU64,
}

/// The error that more memory was wanted than is left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shortage {
    /// The number of bytes that were wanted.
    pub wanted: u64,
    /// The number of bytes that are left.
    pub left: u64,
}

/// The part of the available memory that is kept for the rest of the program and for other programs: an eighth.
const RESERVE: u64 = 8;

/// The memory in bytes that small files may take together: 44 Mi samples, such as 512 x 512 x 176. A renderer on the
/// processor holds them twice, and both copies must stay under 500 MB.
const OF_A_SMALL_FILE: u64 = 176 << 20;

/// The number of bytes in memory that a byte of a file may become beyond [`OF_A_SMALL_FILE`]. Measured data packs 2 to
/// 10 times, and bytes become 32-bit samples. Masks of large volumes pack better than this, and need the owner's
/// permission.
const MOST_FOR_A_BYTE: u64 = 176;

impl Default for MemoryLimit {
    fn default() -> Self {
        Self::of_machine()
    }
}

impl MemoryLimit {
    /// A limit of so many bytes, as a person has set it.
    pub fn of(bytes: u64) -> Self {
        Self {
            bytes,
            taken: Arc::default(),
            given: true,
        }
    }

    /// Seven eighths of the memory that is available now, within the limits of the control group (container) in which
    /// the process runs. If the system does not say how much that is, there is no limit.
    pub fn of_machine() -> Self {
        let available = available().unwrap_or(u64::MAX);
        Self {
            given: false,
            ..Self::of(available - available / RESERVE)
        }
    }

    /// The number of bytes that are left.
    pub fn left(&self) -> u64 {
        let taken = self.taken.all.load(Ordering::Relaxed);
        self.bytes.saturating_sub(taken)
    }

    /// Takes so many bytes for good. Callers call it before they allocate memory that they keep.
    ///
    /// # Errors
    /// If fewer bytes are left. Nothing is taken then.
    pub fn take(&self, bytes: u64) -> Result<(), Shortage> {
        self.check(bytes)?;
        self.taken.all.fetch_add(bytes, Ordering::Relaxed);
        Ok(())
    }

    /// Takes so many bytes for what is unpacked from files of `on_disk` bytes. Unless a person has set the limit, all files
    /// together get at most [`OF_A_SMALL_FILE`], or [`MOST_FOR_A_BYTE`] for each of their bytes if that is more. So a few
    /// hundred kilobytes cannot take all memory of the machine.
    ///
    /// # Errors
    /// Fewer are left, or the files are too small for them. Nothing is taken then.
    pub(crate) fn take_from_files(&self, bytes: u64, on_disk: u64) -> Result<(), Shortage> {
        let Taken {
            from_files,
            on_disk: files,
            ..
        } = &*self.taken;
        let size = files.load(Ordering::Relaxed).saturating_add(on_disk);
        let most = OF_A_SMALL_FILE.max(size.saturating_mul(MOST_FOR_A_BYTE));
        let left = most.saturating_sub(from_files.load(Ordering::Relaxed));
        if !self.given && bytes > left {
            return Err(Shortage {
                wanted: bytes,
                left: left.min(self.left()),
            });
        }
        self.take(bytes)?;
        from_files.fetch_add(bytes, Ordering::Relaxed);
        files.fetch_add(on_disk, Ordering::Relaxed);
        Ok(())
    }

    /// Asks for so many bytes for a while. Callers call it before they allocate memory that they will free soon.
    ///
    /// # Errors
    /// Fewer are left.
    pub fn check(&self, bytes: u64) -> Result<(), Shortage> {
        let left = self.left();
        if bytes <= left {
            return Ok(());
        }
        Err(Shortage {
            wanted: bytes,
            left,
        })
    }
}

impl Shortage {
    /// The error at a place in a file. `what` is in the plural, as in '20 triangles'.
    pub fn at(self, place: Place, what: impl fmt::Display) -> Error {
        self.error(Some(place), what)
    }

    /// The error for something that is in no file.
    pub fn of(self, what: impl fmt::Display) -> Error {
        self.error(None, what)
    }

    fn error(self, place: Option<Place>, what: impl fmt::Display) -> Error {
        let Self { wanted, left } = self;
        let what = self.sentence(what);
        Error::Memory {
            place,
            what,
            wanted,
            left,
        }
    }

    fn sentence(self, what: impl fmt::Display) -> String {
        let (wanted, left) = (Bytes(self.wanted), Bytes(self.left));
        format!("{what} take {wanted} of memory, and no more than {left} may be taken")
    }
}

/// A number of bytes, as a person writes it.
struct Bytes(u64);

/// Units, from the largest to the smallest.
const UNITS: [(char, u64); 4] = [
    ('T', 1 << 40),
    ('G', 1 << 30),
    ('M', 1 << 20),
    ('K', 1 << 10),
];

impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match UNITS.iter().find(|(_, size)| self.0 >= *size) {
            Some((letter, size)) => write!(f, "{:.1} {letter}iB", self.0 as f64 / *size as f64),
            None => write!(f, "{} bytes", self.0),
        }
    }
}

impl FromStr for MemoryLimit {
    type Err = Error;

    /// `8G`, `500M`, `1.5GiB`, or a number of bytes. Letters are powers of 1024.
    fn from_str(text: &str) -> Result<Self, Error> {
        let wrong = || {
            Error::usage(
                format!("'{text}' is not an amount of memory"),
                "write a number with K, M, G or T, such as 8G or 500M",
            )
        };
        let upper = text.trim().to_ascii_uppercase();
        let short = upper.strip_suffix("IB").or(upper.strip_suffix('B'));
        let short = short.unwrap_or(&upper);
        let of_unit = |(letter, size): &(char, u64)| Some((short.strip_suffix(*letter)?, *size));
        let (number, unit) = UNITS.iter().find_map(of_unit).unwrap_or((short, 1));
        let number: f64 = number.trim_end().parse().map_err(|_| wrong())?;
        let bytes = number * unit as f64;
        // 2^63 bytes, which no machine has.
        if !(1.0..9.2e18).contains(&bytes) {
            return Err(wrong());
        }
        Ok(Self::of(bytes as u64))
    }
}

/// The number of bytes that this process may still take before others suffer. `None` if the system does not say.
fn available() -> Option<u64> {
    if !sysinfo::IS_SUPPORTED_SYSTEM {
        return None;
    }
    let mut system = sysinfo::System::new();
    system.refresh_memory();
    let of_machine = system.available_memory();
    // A group's used memory includes files that the system keeps in memory and gives up on demand.
    let of_group = system.cgroup_limits();
    let of_group = of_group.map(|group| group.total_memory.saturating_sub(group.rss));
    let available = of_group.map_or(of_machine, |group| group.min(of_machine));
    (available > 0).then_some(available)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_read_as_they_are_written() {
        for (text, bytes) in [
            ("8G", 8 << 30),
            ("8g", 8 << 30),
            ("500M", 500 << 20),
            ("500MiB", 500 << 20),
            ("500 MB", 500 << 20),
            ("1.5K", 1536),
            ("2T", 2 << 40),
            ("12345", 12345),
            ("12345B", 12345),
        ] {
            assert_eq!(text.parse::<MemoryLimit>().unwrap().left(), bytes, "{text}");
        }
    }

    #[test]
    fn what_is_no_amount_is_refused() {
        for text in [
            "", "G", "-1G", "nan", "inf", "0", "0G", "1Q", "1GG", "1e99", "8 000M", "0x10",
        ] {
            let error = text.parse::<MemoryLimit>().unwrap_err().to_string();
            assert!(error.contains("such as 8G"), "{text}: {error}");
        }
    }

    #[test]
    fn copies_share_what_is_taken_and_a_refusal_takes_nothing() {
        let memory = MemoryLimit::of(100);
        let copy = memory.clone();
        memory.take(60).unwrap();
        copy.check(40).unwrap();
        assert_eq!(
            copy.take(41),
            Err(Shortage {
                wanted: 41,
                left: 40
            })
        );
        copy.take(40).unwrap();
        assert_eq!(memory.left(), 0);
        assert!(memory.take(u64::MAX).is_err());
    }

    #[test]
    fn small_files_together_get_what_a_person_allows_or_little() {
        let most = OF_A_SMALL_FILE;
        let default = || MemoryLimit {
            given: false,
            ..MemoryLimit::of(1 << 40)
        };
        let memory = default();
        memory.take_from_files(most - 5, 1).unwrap();
        let shortage = memory.take_from_files(6, 1).unwrap_err();
        assert_eq!(shortage.left, 5, "of all files together");
        assert_eq!(
            memory.left(),
            (1 << 40) - (most - 5),
            "a refusal takes nothing"
        );
        memory.take_from_files(5, 1).unwrap();
        // A larger file gets more, and not for the small ones before it.
        let large = 3 * most / MOST_FOR_A_BYTE;
        memory.take_from_files(2 * most, large).unwrap();
        assert!(default().take_from_files(3 * most + 1, large).is_err());
        let given = MemoryLimit::of(1 << 40);
        given.take_from_files(1 << 40, 1).unwrap();
        assert!(
            given.take_from_files(1, u64::MAX).is_err(),
            "nothing is left"
        );
    }

    #[test]
    fn the_machine_has_some() {
        let left = MemoryLimit::of_machine().left();
        assert!(left > 1 << 20, "{left}");
    }

    #[test]
    fn a_shortage_says_how_much_is_wanted_and_how_much_there_is() {
        let memory = MemoryLimit::of(3 << 29);
        let error = memory.take(3 << 30).unwrap_err().of("20 triangles");
        let text = error.to_string();
        assert!(text.contains("20 triangles take 3.0 GiB"), "{text}");
        assert!(text.contains("1.5 GiB"), "{text}");
        assert!(text.contains("allow more memory"), "{text}");
        assert!(
            matches!(error, Error::Memory { wanted, left, .. } if wanted == 3 << 30 && left == 3 << 29)
        );
    }
}
