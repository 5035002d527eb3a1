//! Lines and their words. Both are bytes, because a name may be in any encoding. Only names may have bytes other than
//! ASCII.

use std::borrow::Cow;

/// The lines with their numbers and without their ends, which are LF, CR LF or CR. A continued line is joined with the
/// next and has the number of the first.
pub(super) fn lines(bytes: &[u8]) -> impl Iterator<Item = (usize, Cow<'_, [u8]>)> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let mut raw = Raw(Some(bytes)).zip(1..);
    std::iter::from_fn(move || {
        let (line, number) = raw.next()?;
        let mut line = Cow::Borrowed(trim(line));
        let named = holds_a_name(split(&line).0);
        let mut piece = 0;
        // Only the newest piece is examined, so that a file of nothing but continued lines takes linear time.
        while is_continued(&line[piece..], named) {
            let end = line.len() - 1;
            line.to_mut()[end] = b' ';
            piece = line.len();
            let Some((next, _)) = raw.next() else { break };
            line.to_mut().extend_from_slice(trim(next));
        }
        Some((number, line))
    })
}

/// Whether a statement that ends like this continues in the next line. A comment does not, whatever its end: nobody
/// means the Windows path at its end as a continuation. A name that ends in a backslash is such a path, too, unless the
/// backslash is a word of its own.
fn is_continued(piece: &[u8], named: bool) -> bool {
    let Some(before) = piece.strip_suffix(b"\\") else {
        return false;
    };
    let alone = before.last().is_none_or(is_space);
    (alone || !named) && !before.contains(&b'#')
}

/// Whether a name or a path follows this keyword.
fn holds_a_name(keyword: &[u8]) -> bool {
    matches!(keyword, b"o" | b"g" | b"usemtl" | b"mtllib" | b"newmtl")
        || keyword.starts_with(b"map_")
}

/// The keyword, and the rest of the line.
pub(super) fn split(line: &[u8]) -> (&[u8], &[u8]) {
    let end = line.iter().position(is_space).unwrap_or(line.len());
    (&line[..end], trim(&line[end..]))
}

/// The words before a comment. A `#` after a point does not start a comment, because some programs write `1.#INF`.
pub(super) fn words(rest: &[u8]) -> impl Iterator<Item = &[u8]> {
    let starts = |at: &usize| rest[*at] == b'#' && !rest[..*at].ends_with(b".");
    let end = (0..rest.len()).find(starts).unwrap_or(rest.len());
    rest[..end].split(is_space).filter(|word| !word.is_empty())
}

/// The name before a comment that a space separates from it, or `None` if there is no such comment.
pub(super) fn before_comment(name: &[u8]) -> Option<&[u8]> {
    let pairs = name.windows(2);
    let at = pairs
        .enumerate()
        .find(|(_, pair)| is_space(&pair[0]) && pair[1] == b'#')?;
    Some(trim(&name[..at.0]))
}

/// A word for messages. It is cut, because a word of a binary file may have a megabyte. Signs replace bytes that are
/// not UTF-8.
pub(super) fn shown(word: &[u8]) -> String {
    const MOST: usize = 60;
    // A character has at most four bytes.
    let head = &word[..word.len().min(4 * MOST)];
    let text = String::from_utf8_lossy(head);
    let mut shown: String = text.chars().take(MOST).collect();
    if head.len() < word.len() || shown.len() < text.len() {
        shown.push('…');
    }
    shown
}

/// Keeps a comment at a file's beginning, in lower case, up to a limit. Programs write their names early in a file.
pub(super) fn keep_head(comment: &[u8], head: &mut Vec<u8>) {
    const MOST: usize = 4096;
    if head.len() < MOST {
        head.extend(comment.iter().take(MOST).map(u8::to_ascii_lowercase));
    }
}

/// The text without the space around it.
pub(super) fn trim(mut bytes: &[u8]) -> &[u8] {
    while let [first, rest @ ..] = bytes
        && is_space(first)
    {
        bytes = rest;
    }
    while let [rest @ .., last] = bytes
        && is_space(last)
    {
        bytes = rest;
    }
    bytes
}

/// Space within a line. The control character with which DOS ended a file counts as space, too.
fn is_space(byte: &u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\x0b' | b'\x0c' | b'\x1a')
}

/// The lines as they stand, with `None` after the last.
struct Raw<'a>(Option<&'a [u8]>);

impl<'a> Iterator for Raw<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        let bytes = self.0?;
        let end = bytes.iter().position(|&byte| matches!(byte, b'\n' | b'\r'));
        let Some(end) = end else {
            self.0 = None;
            return Some(bytes);
        };
        let after = &bytes[end..];
        let mark = if after.starts_with(b"\r\n") { 2 } else { 1 };
        self.0 = Some(&after[mark..]);
        Some(&bytes[..end])
    }
}
