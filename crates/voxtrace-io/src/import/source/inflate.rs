//! Compressed bytes, read through a limit: what becomes far larger than it was is refused before memory is gone.

use crate::import::source::input::Input;
use flate2::read::{DeflateDecoder, MultiGzDecoder, ZlibDecoder};
use std::cell::Cell;
use std::io::{Error, ErrorKind, Read, Result};
use std::rc::Rc;
use voxtrace_voxelize::Limits;

/// First bytes of a gzip file (RFC 1952).
pub(crate) const GZIP: [u8; 2] = [0x1f, 0x8b];
/// Bytes that may come out of anything.
const FREE: u64 = 16 << 20;

/// The bytes of a gzip stream, as an input of its own.
pub(crate) fn gunzip<'a>(input: Input<'a>, limits: &Limits) -> Input<'a> {
    through(input, limits, |counted| Box::new(MultiGzDecoder::new(counted)))
}

/// The bytes of a zlib stream (RFC 1950), as an input of its own.
pub(crate) fn unzlib<'a>(input: Input<'a>, limits: &Limits) -> Input<'a> {
    through(input, limits, |counted| Box::new(ZlibDecoder::new(counted)))
}

/// The bytes of a bare deflate stream (RFC 1951), as an input of its own.
pub(crate) fn inflate<'a>(input: Input<'a>, limits: &Limits) -> Input<'a> {
    through(input, limits, |counted| Box::new(DeflateDecoder::new(counted)))
}

fn through<'a>(
    input: Input<'a>,
    limits: &Limits,
    decoder: impl FnOnce(Counted<'a>) -> Box<dyn Read + 'a>,
) -> Input<'a> {
    let path = input.path();
    let taken = Rc::new(Cell::new(0));
    let source = decoder(Counted { source: input, taken: Rc::clone(&taken) });
    Input::of_decoder(Box::new(Limited { source, taken, given: 0, ratio: limits.ratio }), path, limits)
}

/// Counts what is read.
struct Counted<'a> {
    source: Input<'a>,
    taken: Rc<Cell<u64>>,
}

impl Read for Counted<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.source.copy_into(buffer).map_err(Error::other)?;
        self.taken.set(self.taken.get() + count as u64);
        Ok(count)
    }
}

/// Ends with an error where more comes out than may.
struct Limited<R> {
    source: R,
    taken: Rc<Cell<u64>>,
    given: u64,
    ratio: u64,
}

impl<R: Read> Read for Limited<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let count = self.source.read(buffer)?;
        self.given += count as u64;
        if self.given > self.taken.get().saturating_mul(self.ratio).saturating_add(FREE) {
            let what = format!("more than {} bytes come out of each compressed one", self.ratio);
            return Err(Error::new(ErrorKind::InvalidData, what));
        }
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, write::GzEncoder};
    use std::io::Write;
    use std::path::Path;

    fn zipped(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn what_grows_beyond_all_measure_is_refused() {
        let limits = Limits::default();
        let modest: Vec<u8> = (0..20u32 << 20).map(|i| (i.wrapping_mul(2_654_435_761) >> 29) as u8).collect();
        let bytes = zipped(&modest);
        let input = Input::of_bytes(&bytes, Path::new("a.gz"), &limits).unwrap();
        assert!(gunzip(input, &limits).rest().unwrap() == modest);
        let bytes = zipped(&vec![0; 40 << 20]);
        let input = Input::of_bytes(&bytes, Path::new("a.gz"), &limits).unwrap();
        let error = gunzip(input, &limits).rest().unwrap_err().to_string();
        assert!(error.contains("more than 200 bytes"), "{error}");
        let trusting = Limits { ratio: u64::MAX, ..limits };
        let input = Input::of_bytes(&bytes, Path::new("a.gz"), &trusting).unwrap();
        assert_eq!(gunzip(input, &trusting).rest().unwrap().len(), 40 << 20);
    }
}
