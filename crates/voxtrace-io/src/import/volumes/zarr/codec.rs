//! What chunks are compressed with: gzip and zlib (`flate2`), Zstandard (`ruzstd`), LZ4 (`lz4_flex`), bzip2 (`bzip2`) and Blosc around them. Every
//! decoder knows how many bytes there are to be and refuses more.

use super::blosc;
use super::metadata::Fault;
use crate::import::source::guard::guarded;
use crate::import::source::zstd::zstd;
use serde_json::Value;
use std::io::Read;

/// One step from samples to what is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Codec {
    Gzip,
    Zlib,
    Zstd,
    /// A block with its size in front.
    Lz4,
    /// Blocks with a header each, as the Java library writes them.
    Lz4Blocks,
    Bzip2,
    Blosc,
    /// Four bytes at the end, which are not looked at.
    Checksum,
}

impl Codec {
    pub fn of_second(json: &Value) -> Result<Self, Fault> {
        Ok(match json["id"].as_str().unwrap_or_default() {
            "gzip" => Self::Gzip,
            "zlib" => Self::Zlib,
            "zstd" => Self::Zstd,
            "lz4" => Self::Lz4,
            "bz2" => Self::Bzip2,
            "blosc" => Self::Blosc,
            other => return Err(Fault::Foreign(format!("chunks compressed by {other:?}"))),
        })
    }

    pub fn of_third(json: &Value) -> Result<Self, Fault> {
        Ok(match json["name"].as_str().unwrap_or_default() {
            "gzip" => Self::Gzip,
            "numcodecs.zlib" => Self::Zlib,
            "numcodecs.bz2" => Self::Bzip2,
            "zstd" => Self::Zstd,
            "blosc" => Self::Blosc,
            "crc32c" => Self::Checksum,
            other => return Err(Fault::Foreign(format!("chunks packed by {other:?}"))),
        })
    }

    /// Undoes the step; the result has at most `most` bytes.
    ///
    /// # Errors
    /// One sentence about what is wrong.
    pub fn undo(self, bytes: Vec<u8>, most: usize) -> Result<Vec<u8>, String> {
        match self {
            Self::Gzip => read(flate2::read::MultiGzDecoder::new(&*bytes), most),
            Self::Zlib => read(flate2::read::ZlibDecoder::new(&*bytes), most),
            Self::Zstd => guarded(|| zstd(&bytes, most)),
            Self::Lz4 => {
                let (size, block) = bytes.split_first_chunk().ok_or("a block of LZ4 without its size")?;
                let size = u32::from_le_bytes(*size) as usize;
                if size > most {
                    return Err(too_long(most));
                }
                lz4(block, size)
            }
            Self::Lz4Blocks => lz4_blocks(&bytes, most),
            Self::Bzip2 => guarded(|| read(bzip2::read::MultiBzDecoder::new(&*bytes), most)),
            Self::Blosc => blosc::unpack(&bytes, most),
            Self::Checksum => {
                let length = bytes.len().checked_sub(4).ok_or("a chunk without its checksum")?;
                Ok(bytes[..length].to_vec())
            }
        }
    }
}

/// Blocks of LZ4Block (net.jpountz.lz4.LZ4BlockOutputStream): a sign, a byte of the method, the lengths packed and unpacked, a checksum
/// that is not looked at, and the block.
fn lz4_blocks(mut bytes: &[u8], most: usize) -> Result<Vec<u8>, String> {
    const SIGN: &[u8] = b"LZ4Block";
    const HEAD: usize = 21;
    let mut all = Vec::new();
    while !bytes.is_empty() {
        let head = bytes.get(..HEAD).filter(|head| head.starts_with(SIGN)).ok_or("a block of LZ4 without its head")?;
        let length = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]) as usize;
        let (packed, size) = (length(9), length(13));
        let block = bytes.get(HEAD..HEAD.saturating_add(packed)).ok_or("a block of LZ4 beyond its chunk")?;
        if size > most - all.len() {
            return Err(too_long(most));
        }
        match head[8] & 0xf0 {
            0x10 if packed == size => all.extend_from_slice(block),
            0x20 => all.extend(lz4(block, size)?),
            _ => return Err("a block of LZ4 by another method".into()),
        }
        bytes = &bytes[HEAD + packed..];
    }
    Ok(all)
}

fn too_long(most: usize) -> String {
    format!("a chunk of more than its {most} bytes")
}

/// All bytes of a decoder.
pub(super) fn read(decoder: impl Read, most: usize) -> Result<Vec<u8>, String> {
    let mut bytes = Vec::new();
    decoder.take(most as u64 + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() > most { Err(too_long(most)) } else { Ok(bytes) }
}

/// A bare block of LZ4 that becomes `size` bytes.
pub(super) fn lz4(block: &[u8], size: usize) -> Result<Vec<u8>, String> {
    // A byte becomes at most 255.
    if size / 256 > block.len() {
        return Err("a block of LZ4 that is too short".into());
    }
    let mut bytes = vec![0; size];
    let found = guarded(|| lz4_flex::block::decompress_into(block, &mut bytes).map_err(|error| error.to_string()))?;
    if found == size { Ok(bytes) } else { Err("a block of LZ4 of another size than it says".into()) }
}
