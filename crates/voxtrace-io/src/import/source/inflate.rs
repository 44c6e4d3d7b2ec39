//! Compressed bytes, read through a limit. Deflate cannot make more than 1,032 bytes of one, so that what comes out is bounded by the file
//! (bzip2 has no such bound, but what it makes is taken piece by piece);
//! how much of it there is to be, headers say, and their readers hold that against [`Limits`] before they ask for it.

use crate::import::source::input::Input;
use flate2::bufread::GzDecoder;
use flate2::read::{DeflateDecoder, ZlibDecoder};
use std::io::{BufRead, BufReader, Error, Read, Result};
use voxtrace_voxelize::Limits;

/// First bytes of a gzip file (RFC 1952).
pub(crate) const GZIP: [u8; 2] = [0x1f, 0x8b];

/// How a stream is packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Packing {
    /// Not at all.
    Plain,
    /// RFC 1952.
    Gzip,
    /// RFC 1950.
    Zlib,
    /// bzip2.
    #[cfg(feature = "volumes")]
    Bzip2,
}

/// What comes out of a packed stream.
pub(crate) enum Decoder<R: Read> {
    Plain(R),
    Gzip(Box<Members<R>>),
    Zlib(Box<ZlibDecoder<R>>),
    #[cfg(feature = "volumes")]
    Bzip2(Box<bzip2::read::MultiBzDecoder<R>>),
}

impl Packing {
    /// What comes out of a stream.
    pub fn decoder<R: Read>(self, stream: R) -> Decoder<R> {
        match self {
            Self::Plain => Decoder::Plain(stream),
            Self::Gzip => Decoder::Gzip(Box::new(Members(Some(GzDecoder::new(BufReader::new(stream)))))),
            Self::Zlib => Decoder::Zlib(Box::new(ZlibDecoder::new(stream))),
            #[cfg(feature = "volumes")]
            Self::Bzip2 => Decoder::Bzip2(Box::new(bzip2::read::MultiBzDecoder::new(stream))),
        }
    }

    /// The bytes that come out of an input, as an input of its own.
    pub fn unpack<'a>(self, input: Input<'a>, limits: &Limits) -> Input<'a> {
        let path = input.path();
        match self {
            Self::Plain => input,
            _ => Input::of_decoder(Box::new(self.decoder(Packed(input))), path, limits),
        }
    }
}

impl<R: Read> Read for Decoder<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        match self {
            Self::Plain(stream) => stream.read(buffer),
            Self::Gzip(stream) => stream.read(buffer),
            Self::Zlib(stream) => stream.read(buffer),
            #[cfg(feature = "volumes")]
            Self::Bzip2(stream) => stream.read(buffer),
        }
    }
}

/// The members of a gzip file, one after the other; `None` behind the last. Zeros behind a member only pad the file, as for gzip itself.
pub(crate) struct Members<R: Read>(Option<GzDecoder<BufReader<R>>>);

impl<R: Read> Read for Members<R> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        while let Some(member) = &mut self.0 {
            let count = member.read(buffer)?;
            if count > 0 || buffer.is_empty() {
                return Ok(count);
            }
            let Some(mut rest) = self.0.take().map(GzDecoder::into_inner) else { break };
            loop {
                let bytes = rest.fill_buf()?;
                let (zeros, all) = (bytes.iter().take_while(|&&byte| byte == 0).count(), bytes.len());
                rest.consume(zeros);
                if all == 0 {
                    return Ok(0);
                }
                if zeros < all {
                    break;
                }
            }
            self.0 = Some(GzDecoder::new(rest));
        }
        Ok(0)
    }
}

/// The bytes of a gzip stream, as an input of its own.
pub(crate) fn gunzip<'a>(input: Input<'a>, limits: &Limits) -> Input<'a> {
    Packing::Gzip.unpack(input, limits)
}

/// The bytes of a zlib stream (RFC 1950), as an input of its own.
pub(crate) fn unzlib<'a>(input: Input<'a>, limits: &Limits) -> Input<'a> {
    Packing::Zlib.unpack(input, limits)
}

/// The bytes of a bare deflate stream (RFC 1951), as an input of its own.
pub(crate) fn inflate<'a>(input: Input<'a>, limits: &Limits) -> Input<'a> {
    let path = input.path();
    Input::of_decoder(Box::new(DeflateDecoder::new(Packed(input))), path, limits)
}

/// What is still packed.
struct Packed<'a>(Input<'a>);

impl Read for Packed<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        self.0.copy_into(buffer).map_err(Error::other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, write::GzEncoder};
    use std::io::Write;
    use std::path::Path;
    use voxtrace_voxelize::ImportErrorKind;

    fn zipped(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn members_follow_each_other_and_zeros_behind_them_only_pad_the_file() {
        let (limits, one, two) = (Limits::default(), zipped(b"one"), zipped(b"two"));
        let read = |parts: &[&[u8]]| {
            let bytes = parts.concat();
            gunzip(Input::of_bytes(&bytes, Path::new("a.gz"), &limits).unwrap(), &limits).rest()
        };
        assert_eq!(read(&[&one, &two]).unwrap(), b"onetwo");
        assert_eq!(read(&[&one, &two, &[0; 20_000]]).unwrap(), b"onetwo");
        assert!(read(&[&one, b"other"]).is_err() && read(&[&one, &[0; 3], &two[..9]]).is_err());
        assert!(read(&[&one[..one.len() - 1]]).is_err());
    }

    #[test]
    fn what_is_alike_all_over_is_read_and_what_is_more_than_bytes_may_be_is_refused() {
        let limits = Limits::default();
        let modest: Vec<u8> = (0..20u32 << 20).map(|i| (i.wrapping_mul(2_654_435_761) >> 29) as u8).collect();
        for whole in [modest, vec![0; 40 << 20]] {
            let bytes = zipped(&whole);
            let input = || Input::of_bytes(&bytes, Path::new("a.gz"), &limits).unwrap();
            assert!(gunzip(input(), &limits).rest().unwrap() == whole);
            let few = Limits { bytes: 19 << 20, ..limits };
            let error = gunzip(input(), &few).rest().unwrap_err();
            assert!(matches!(error.kind, ImportErrorKind::Limit { .. }), "{error}");
        }
        // More than a thousand of one, which was beyond any limit once.
        assert!((40 << 20) / zipped(&vec![0; 40 << 20]).len() > 1000);
    }
}
