//! LAZ files, written by the crate that others write them with; for tests and for the benchmark of scans.

use std::io::Cursor;

/// The points of an uncompressed LAS file, whose records have `format` and nothing besides, as LAZ in chunks of so many.
///
/// # Panics
/// If the bytes are no such file.
pub fn compressed(plain: &[u8], format: u8, chunk: u32) -> Vec<u8> {
    let head = usize::from(u16::from_le_bytes([plain[94], plain[95]]));
    let items = laz::LazItemRecordBuilder::default_for_point_format_id(format, 0).unwrap();
    let description = laz::laszip::LazVlrBuilder::new(items).with_fixed_chunk_size(chunk).build();
    let mut content = Vec::new();
    description.write_to(&mut content).unwrap();
    let mut bytes = plain[..head].to_vec();
    let data = (head + 54 + content.len()) as u32;
    bytes[96..100].copy_from_slice(&data.to_le_bytes());
    bytes[100] = 1;
    bytes[104] |= 0x80;
    let mut record = [0; 54];
    record[2..16].copy_from_slice(b"laszip encoded");
    record[18..20].copy_from_slice(&22204u16.to_le_bytes());
    record[20..22].copy_from_slice(&(content.len() as u16).to_le_bytes());
    bytes.extend(record);
    bytes.extend(content);
    let mut out = Cursor::new(bytes);
    out.set_position(u64::from(data));
    let mut compressor = laz::LasZipCompressor::new(&mut out, description).unwrap();
    compressor.compress_many(&plain[head..]).unwrap();
    compressor.done().unwrap();
    drop(compressor);
    out.into_inner()
}
