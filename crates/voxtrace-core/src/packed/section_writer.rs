//! Writing the sections of a native file one after the other, without knowing beforehand how long they will be: the header
//! and the table, which come first in the file, are written last.

use super::file::{ALIGNMENT, Header, MAGIC, TableEntry};
use bytemuck::Pod;
use std::fs::File;
use std::io::{self, BufWriter, Seek, SeekFrom, Write};
use xxhash_rust::xxh3::{Xxh3, xxh3_64};

/// A native file in the making.
pub(super) struct SectionWriter {
    out: BufWriter<File>,
    table: Vec<TableEntry>,
    /// Bytes so far.
    at: u64,
    hash: Xxh3,
    sections: usize,
}

impl SectionWriter {
    /// Leaves room for the table of so many sections, or fewer, at the start of an empty file.
    pub fn new(mut file: File, sections: usize) -> io::Result<Self> {
        file.rewind()?;
        let mut out = BufWriter::with_capacity(1 << 20, file);
        let head = size_of::<Header>() + sections * size_of::<TableEntry>();
        out.write_all(&vec![0; head])?;
        Ok(Self { out, table: Vec::new(), at: head as u64, hash: Xxh3::new(), sections })
    }

    /// Begins a section of records of type `T`.
    pub fn begin<T: Pod>(&mut self, tag: &[u8; 4]) -> io::Result<()> {
        let start = self.at.next_multiple_of(ALIGNMENT as u64);
        self.out.write_all(&[0; ALIGNMENT][..(start - self.at) as usize])?;
        self.at = start;
        self.hash = Xxh3::new();
        let record_size = size_of::<T>() as u32;
        self.table.push(TableEntry { tag: *tag, record_size, offset: start, size: 0, checksum: self.hash.digest() });
        Ok(())
    }

    /// Adds bytes to the section that was begun last.
    pub fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.out.write_all(bytes)?;
        self.hash.update(bytes);
        self.at += bytes.len() as u64;
        if let Some(entry) = self.table.last_mut() {
            entry.size = self.at - entry.offset;
            entry.checksum = self.hash.digest();
        }
        Ok(())
    }

    /// A whole section.
    pub fn section<T: Pod>(&mut self, tag: &[u8; 4], records: &[T]) -> io::Result<()> {
        self.begin::<T>(tag)?;
        self.write(bytemuck::cast_slice(records))
    }

    /// Where a section begins and ends, once what was written is in the file.
    pub fn flushed_range(&mut self, tag: &[u8; 4]) -> io::Result<Option<(usize, usize)>> {
        self.out.flush()?;
        let entry = self.table.iter().find(|entry| entry.tag == *tag);
        Ok(entry.map(|entry| (entry.offset as usize, (entry.offset + entry.size) as usize)))
    }

    /// Writes header and table of a version.
    pub fn finish(mut self, version: u32) -> io::Result<()> {
        assert!(self.table.len() <= self.sections, "room was left for fewer sections");
        let table = bytemuck::cast_slice(&self.table);
        let header = Header {
            magic: MAGIC,
            version,
            section_count: self.table.len() as u32,
            table_checksum: xxh3_64(table),
            reserved: [0; 5],
        };
        self.out.seek(SeekFrom::Start(0))?;
        self.out.write_all(bytemuck::bytes_of(&header))?;
        self.out.write_all(table)?;
        self.out.flush()
    }
}
