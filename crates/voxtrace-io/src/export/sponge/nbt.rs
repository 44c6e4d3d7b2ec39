//! Named binary tags as they are written (big-endian; wiki.vg, "NBT").

use std::io::{self, Write};

const END: u8 = 0;
const SHORT: u8 = 2;
const INT: u8 = 3;
const BYTES: u8 = 7;
const TEXT: u8 = 8;
const LIST: u8 = 9;
const COMPOUND: u8 = 10;
const INTS: u8 = 11;

/// Writes tags, one after the other.
pub struct Writer<W> {
    writer: W,
}

impl<W: Write> Writer<W> {
    pub fn new(writer: W) -> Self {
        Self { writer }
    }

    pub fn begin_compound(&mut self, name: &str) -> io::Result<()> {
        self.head(COMPOUND, name)
    }

    pub fn end_compound(&mut self) -> io::Result<()> {
        self.writer.write_all(&[END])
    }

    pub fn short(&mut self, name: &str, value: u16) -> io::Result<()> {
        self.head(SHORT, name)?;
        self.writer.write_all(&value.to_be_bytes())
    }

    pub fn int(&mut self, name: &str, value: i32) -> io::Result<()> {
        self.head(INT, name)?;
        self.writer.write_all(&value.to_be_bytes())
    }

    pub fn ints(&mut self, name: &str, values: &[i32]) -> io::Result<()> {
        self.head(INTS, name)?;
        self.length(values.len())?;
        values.iter().try_for_each(|value| self.writer.write_all(&value.to_be_bytes()))
    }

    /// So many bytes, which `write` writes.
    pub fn bytes(&mut self, name: &str, length: usize, write: impl FnOnce(&mut W) -> io::Result<()>) -> io::Result<()> {
        self.head(BYTES, name)?;
        self.length(length)?;
        write(&mut self.writer)
    }

    pub fn text(&mut self, name: &str, value: &str) -> io::Result<()> {
        self.head(TEXT, name)?;
        self.short_text(value)
    }

    /// An empty list of compounds.
    pub fn no_compounds(&mut self, name: &str) -> io::Result<()> {
        self.head(LIST, name)?;
        self.writer.write_all(&[COMPOUND])?;
        self.length(0)
    }

    pub fn finish(self) -> W {
        self.writer
    }

    fn head(&mut self, kind: u8, name: &str) -> io::Result<()> {
        self.writer.write_all(&[kind])?;
        self.short_text(name)
    }

    fn length(&mut self, length: usize) -> io::Result<()> {
        let length = i32::try_from(length).map_err(|_| io::Error::other("an array of more than 2³¹ entries"))?;
        self.writer.write_all(&length.to_be_bytes())
    }

    /// A text behind its length in 16 bits; Java's form of UTF-8 has other bytes for zeros and rare signs, which become spaces.
    fn short_text(&mut self, text: &str) -> io::Result<()> {
        let text: String =
            text.chars().take(1000).map(|c| if c == '\0' || c.len_utf8() > 3 { ' ' } else { c }).collect();
        self.writer.write_all(&(text.len() as u16).to_be_bytes())?;
        self.writer.write_all(text.as_bytes())
    }
}
