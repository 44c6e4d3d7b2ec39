//! Samples that are read from their file layer by layer: from anywhere where they are plain, and from the front on where they are packed.

use super::Layout;
use super::stored::PackedFile;
use crate::import::source::inflate::{Decoder, Packing};
use crate::import::source::opened;
use std::fs::File;
use std::io::{self, BufReader, ErrorKind, Read, Seek, SeekFrom};
use std::ops::Range;
use voxtrace_voxelize::volume::Volume;
use voxtrace_voxelize::volume::large::{Block, Coding, SampleSource};
use voxtrace_voxelize::{ImportError, ImportErrorKind};

/// Bytes that are read at once where they come out of a decoder.
const WINDOW: usize = 1 << 18;

/// A file of samples.
pub(crate) struct FileSamples {
    file: PackedFile,
    /// Bytes of the unpacked stream before the first sample.
    first: u64,
    layout: Layout,
    frame: Volume,
    /// What comes out of the file, and how much has come.
    stream: Option<(Decoder<BufReader<File>>, u64)>,
    bytes: Vec<u8>,
}

impl FileSamples {
    pub fn new(file: PackedFile, first: u64, layout: Layout, frame: Volume) -> Self {
        Self { file, first, layout, frame, stream: None, bytes: Vec::new() }
    }

    /// Goes to a byte of the unpacked stream: a packed one begins anew where that lies behind.
    fn seek(&mut self, to: u64) -> io::Result<()> {
        let is_plain = self.file.packing == Packing::Plain;
        if self.stream.as_ref().is_none_or(|(_, at)| *at > to && !is_plain) {
            opened::note(&self.file.path);
            let mut file = File::open(&self.file.path)?;
            file.seek(SeekFrom::Start(self.file.start))?;
            self.stream = Some((self.file.packing.decoder(BufReader::with_capacity(WINDOW, file)), 0));
        }
        let Some((stream, at)) = &mut self.stream else { return Ok(()) };
        match stream {
            Decoder::Plain(file) if *at != to => {
                file.seek(SeekFrom::Start(self.file.start + to))?;
            }
            Decoder::Plain(_) => {}
            packed => {
                let skip = to - *at;
                if io::copy(&mut packed.take(skip), &mut io::sink())? < skip {
                    return Err(ErrorKind::UnexpectedEof.into());
                }
            }
        }
        *at = to;
        Ok(())
    }

    fn fill(&mut self, from: u64, bytes: &mut [u8]) -> io::Result<()> {
        self.seek(from)?;
        if let Some((stream, at)) = &mut self.stream {
            stream.read_exact(bytes)?;
            *at += bytes.len() as u64;
        }
        Ok(())
    }

    /// Reads the samples from a byte of the stream on; those of 8 and 16 bits just where they go.
    fn read_from(&mut self, from: u64, block: &mut Block) -> io::Result<()> {
        match block {
            Block::Bytes(codes) => {
                self.fill(from, codes)?;
                self.layout.encode_bytes(codes);
            }
            Block::Words(codes) => {
                self.fill(from, bytemuck::cast_slice_mut(codes))?;
                self.layout.encode_words(codes);
            }
            Block::Reals(values) => {
                let mut bytes = std::mem::take(&mut self.bytes);
                bytes.resize(values.len() * self.layout.sample.size(), 0);
                let read = self.fill(from, &mut bytes);
                self.bytes = bytes;
                read?;
                self.layout.convert_all(&self.bytes, values);
            }
        }
        Ok(())
    }

    fn failure(&self, from: u64, error: io::Error) -> ImportError {
        let path = &self.file.path;
        if error.kind() == ErrorKind::UnexpectedEof {
            return ImportError::truncated(path, from, "its samples");
        }
        if self.file.packing == Packing::Plain {
            return ImportError::io(path, error);
        }
        ImportError::at(path, from, ImportErrorKind::Malformed(format!("compressed data: {error}")))
    }
}

impl SampleSource for FileSamples {
    fn frame(&self) -> &Volume {
        &self.frame
    }

    fn frame_mut(&mut self) -> &mut Volume {
        &mut self.frame
    }

    fn bytes_of_row(&self) -> u64 {
        match self.coding() {
            Coding::Reals => (self.frame.size[0] * self.layout.sample.size()) as u64,
            _ => 0,
        }
    }

    fn coding(&self) -> Coding {
        self.layout.coding()
    }

    fn read(&mut self, layer: usize, rows: Range<usize>, block: &mut Block) -> Result<(), ImportError> {
        let size = self.layout.sample.size();
        let [width, depth, _] = self.frame.size.map(|size| size as u64);
        let from = self.first + (layer as u64 * depth + rows.start as u64) * width * size as u64;
        self.read_from(from, block).map_err(|error| {
            self.stream = None;
            self.failure(from, error)
        })
    }
}
