//! Decoding base64 text while it is read.

use std::io::{self, Read};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

/// A reader of the bytes of a base64 text. White space has no meaning. Several texts may follow one another, each with
/// its padding, because VTK encodes an array's head and its samples separately.
pub(super) struct Base64<'a> {
    text: &'a [u8],
    decoded: Vec<u8>,
    /// The number of digits that have been read.
    read: usize,
}

/// The number of digits that are decoded at a time, a multiple of 4.
const PIECE: usize = 1 << 14;

impl<'a> Base64<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self {
            text,
            decoded: Vec::new(),
            read: 0,
        }
    }

    /// Decodes the next digits, up to a limit or to the padding that ends a text. Each call takes at least one digit,
    /// unless the text is at its end.
    fn decode(&mut self) -> io::Result<()> {
        let mut digits = Vec::with_capacity(PIECE);
        let mut is_padded = false;
        while let Some((&digit, rest)) = self.text.split_first() {
            let ends = digits.len() == PIECE || is_padded && digits.len() % 4 == 0;
            if ends && !digit.is_ascii_whitespace() {
                break;
            }
            self.text = rest;
            if !digit.is_ascii_whitespace() {
                is_padded |= digit == b'=';
                digits.push(digit);
            }
        }
        self.decoded.clear();
        self.read = 0;
        let decoded = STANDARD.decode_vec(&digits, &mut self.decoded);
        decoded.map_err(|error| io::Error::other(format!("this is not base64: {error}")))
    }
}

impl Read for Base64<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while self.read == self.decoded.len() {
            if self.text.is_empty() {
                return Ok(0);
            }
            self.decode()?;
        }
        let rest = &self.decoded[self.read..];
        let length = rest.len().min(buffer.len());
        buffer[..length].copy_from_slice(&rest[..length]);
        self.read += length;
        Ok(length)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decoded(text: &str) -> Result<Vec<u8>, String> {
        let mut bytes = Vec::new();
        let read = Base64::new(text.as_bytes()).read_to_end(&mut bytes);
        read.map(|_| bytes).map_err(|error| error.to_string())
    }

    #[test]
    fn texts_follow_one_another() {
        assert_eq!(decoded("").unwrap(), b"");
        assert_eq!(decoded(" aG\nk= \n").unwrap(), b"hi");
        assert_eq!(decoded("aGk=aA==aGlo").unwrap(), b"hihhih");
        let long = STANDARD.encode(vec![7; 100_000]);
        assert_eq!(decoded(&format!("{long}{long}")).unwrap(), [7; 200_000]);
    }

    #[test]
    fn wherever_padding_stands_there_is_an_end() {
        for text in [
            "=", "====", "=AAA", "A=", "AA=", "AAA", "AA=A", "AAAA=", "AAAA====", "AA===",
        ] {
            assert!(decoded(text).unwrap_err().contains("base64"), "{text}");
        }
    }
}
