//! Zstandard (RFC 8878), by the crate `ruzstd`.

use std::io::Read;

/// The bytes of a stream, of which there may be at most so many.
///
/// # Errors
/// What the decoder says, or that there are more.
#[cfg(feature = "volumes")]
pub(crate) fn zstd(bytes: &[u8], most: usize) -> Result<Vec<u8>, String> {
    let found = zstd_start(bytes, most as u64 + 1)?;
    if found.len() > most { Err(format!("a chunk of more than its {most} bytes")) } else { Ok(found) }
}

/// The first bytes of a stream, as many as there are and at most so many.
///
/// # Errors
/// What the decoder says.
pub(crate) fn zstd_start(bytes: &[u8], most: u64) -> Result<Vec<u8>, String> {
    let decoder = ruzstd::decoding::StreamingDecoder::new(bytes).map_err(|error| error.to_string())?;
    let mut found = Vec::new();
    decoder.take(most).read_to_end(&mut found).map_err(|error| error.to_string())?;
    Ok(found)
}
