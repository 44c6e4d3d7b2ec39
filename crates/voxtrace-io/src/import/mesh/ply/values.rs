//! The values after a PLY header, one after the other, whatever their encoding.

use super::header::{Element, Encoding, Kind};
use crate::import::source::input::Input;
use voxtrace_voxelize::ImportError;

/// Values to read from the front.
pub(crate) struct Values<'a> {
    input: Input<'a>,
    encoding: Encoding,
    /// The current line of a text file and how much of it is read.
    line: Vec<u8>,
    at: usize,
    /// Where the current line began.
    line_start: u64,
}

impl<'a> Values<'a> {
    pub fn new(input: Input<'a>, encoding: Encoding) -> Self {
        let line_start = input.offset();
        Self { input, encoding, line: Vec::new(), at: 0, line_start }
    }

    /// Position in the file, of the line in a text.
    pub fn offset(&self) -> u64 {
        if self.encoding == Encoding::Text { self.line_start } else { self.input.offset() }
    }

    pub fn malformed(&self, what: impl Into<String>) -> ImportError {
        ImportError::malformed(self.input.path(), self.offset(), what)
    }

    pub fn limit(&self, what: &str, value: u64, limit: u64) -> ImportError {
        ImportError::limit(self.input.path(), Some(self.offset()), what, value, limit)
    }

    /// Whether the length of the file is known: that of a pipe is not.
    pub fn has_length(&self) -> bool {
        self.input.remaining().is_some()
    }

    /// Checks that an element's items can be in the rest of the file.
    pub fn check_count(&self, element: &Element) -> Result<(), ImportError> {
        let smallest = |property: &super::header::Property| property.list.unwrap_or(property.kind).size() as u64;
        let least = match self.encoding {
            Encoding::Text => 2 * element.properties.len() as u64,
            _ => element.properties.iter().map(smallest).sum(),
        };
        let needed = element.count.saturating_mul(least);
        // The last line of a text needs no end.
        if self.input.remaining().is_some_and(|remaining| remaining + 1 < needed) {
            let end = self.input.offset() + self.input.remaining().unwrap_or(0);
            let what = format!("the {} items of element {}", element.count, element.name);
            return Err(ImportError::truncated(self.input.path(), end, what));
        }
        Ok(())
    }

    /// The fixed-size items of a binary element, as bytes, `None` for a text.
    pub fn records(&mut self, size: usize, count: usize) -> Result<Option<&[u8]>, ImportError> {
        if self.encoding == Encoding::Text {
            return Ok(None);
        }
        self.input.take(size * count, "an element").map(Some)
    }

    /// How values are written.
    pub fn encoding(&self) -> Encoding {
        self.encoding
    }

    /// The next number.
    pub fn number(&mut self, kind: Kind) -> Result<f64, ImportError> {
        if self.encoding == Encoding::Text {
            return self.word();
        }
        let encoding = self.encoding;
        Ok(number_of(self.input.take(kind.size(), "a value")?, kind, encoding))
    }

    /// The next number as the length of a list.
    pub fn count(&mut self, kind: Kind) -> Result<usize, ImportError> {
        let count = self.number(kind)?;
        if !(0.0..=1e7).contains(&count) || count.fract() != 0.0 {
            return Err(self.malformed(format!("a list of {count} values")));
        }
        Ok(count as usize)
    }

    /// Ends the line of a text file; what is left of it is not read.
    pub fn end_of_item(&mut self) -> Result<(), ImportError> {
        self.line.clear();
        self.at = 0;
        Ok(())
    }

    fn word(&mut self) -> Result<f64, ImportError> {
        loop {
            let rest = &self.line[self.at..];
            let skipped = rest.iter().take_while(|byte| byte.is_ascii_whitespace()).count();
            let word = &rest[skipped..];
            let length = word.iter().take_while(|byte| !byte.is_ascii_whitespace()).count();
            if length > 0 {
                self.at += skipped + length;
                let text = std::str::from_utf8(&word[..length]).ok();
                let number = text.and_then(|text| text.parse::<f64>().ok());
                return number.ok_or_else(|| self.malformed("a word that is no number"));
            }
            self.line_start = self.input.offset();
            let Some(line) = self.input.line()? else {
                return Err(ImportError::truncated(self.input.path(), self.line_start, "an element"));
            };
            self.line.clear();
            self.line.extend_from_slice(line);
            self.at = 0;
        }
    }
}

/// A number from its bytes.
pub(crate) fn number_of(bytes: &[u8], kind: Kind, encoding: Encoding) -> f64 {
    fn order<const N: usize>(bytes: &[u8], encoding: Encoding) -> [u8; N] {
        let mut array = [0; N];
        array.copy_from_slice(&bytes[..N]);
        if encoding == Encoding::Big {
            array.reverse();
        }
        array
    }
    match kind {
        Kind::I8 => f64::from(bytes[0] as i8),
        Kind::U8 => f64::from(bytes[0]),
        Kind::I16 => f64::from(i16::from_le_bytes(order(bytes, encoding))),
        Kind::U16 => f64::from(u16::from_le_bytes(order(bytes, encoding))),
        Kind::I32 => f64::from(i32::from_le_bytes(order(bytes, encoding))),
        Kind::U32 => f64::from(u32::from_le_bytes(order(bytes, encoding))),
        Kind::F32 => f64::from(f32::from_le_bytes(order(bytes, encoding))),
        Kind::F64 => f64::from_le_bytes(order(bytes, encoding)),
    }
}
