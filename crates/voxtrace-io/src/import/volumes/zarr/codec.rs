//! What chunks are compressed with: gzip and zlib (`flate2`), Zstandard (`ruzstd`), LZ4 (`lz4_flex`) and Blosc around them. Every
//! decoder knows how many bytes there are to be and refuses more.

use super::blosc;
use super::metadata::Fault;
use crate::import::source::guard::guarded;
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
            "blosc" => Self::Blosc,
            other => return Err(Fault::Foreign(format!("chunks compressed by {other:?}"))),
        })
    }

    pub fn of_third(json: &Value) -> Result<Self, Fault> {
        Ok(match json["name"].as_str().unwrap_or_default() {
            "gzip" => Self::Gzip,
            "numcodecs.zlib" => Self::Zlib,
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
            Self::Blosc => blosc::unpack(&bytes, most),
            Self::Checksum => {
                let length = bytes.len().checked_sub(4).ok_or("a chunk without its checksum")?;
                Ok(bytes[..length].to_vec())
            }
        }
    }
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

/// A stream of Zstandard.
pub(super) fn zstd(bytes: &[u8], most: usize) -> Result<Vec<u8>, String> {
    let decoder = ruzstd::decoding::StreamingDecoder::new(bytes).map_err(|error| error.to_string())?;
    read(decoder, most)
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
