//! The framing that Minecraft puts around LZ4 (that of lz4-java's streams): blocks, each with a head of 21 bytes.

use voxtrace_voxelize::Limits;

const MAGIC: &[u8] = b"LZ4Block";
/// Bytes of a head: magic, method, packed length, unpacked length, checksum.
const HEAD: usize = 21;
/// Largest block that such streams write.
const LARGEST: usize = 32 << 20;

/// The bytes of a stream.
pub(super) fn unpacked(mut bytes: &[u8], limits: &Limits) -> Result<Vec<u8>, String> {
    let mut all = Vec::new();
    while !bytes.is_empty() {
        let (head, rest) = bytes.split_at_checked(HEAD).ok_or("the file ends inside a block of LZ4")?;
        if !head.starts_with(MAGIC) {
            return Err("a block of LZ4 without its head".into());
        }
        let number = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]) as usize;
        let (packed, length) = (number(9), number(13));
        if length == 0 {
            break;
        }
        let (data, rest) = rest.split_at_checked(packed).ok_or("the file ends inside a block of LZ4")?;
        if length > LARGEST || all.len() as u64 + length as u64 > limits.bytes {
            return Err("a block of LZ4 that is too large".into());
        }
        match head[8] & 0xf0 {
            0x10 if packed == length => all.extend_from_slice(data),
            0x20 => {
                let block = lz4_flex::block::decompress(data, length).map_err(|error| format!("LZ4: {error}"))?;
                if block.len() != length {
                    return Err("a block of LZ4 that is too short".into());
                }
                all.extend(block);
            }
            _ => return Err("a block of LZ4 of an unknown kind".into()),
        }
        bytes = rest;
    }
    Ok(all)
}
