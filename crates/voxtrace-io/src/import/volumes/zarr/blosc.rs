//! Blosc 1 (Alted, "Why modern CPUs are starving and what can be done about it", 2010; c-blosc, README_CHUNK_FORMAT): blocks,
//! whose bytes or bits may have been sorted by significance, compressed by another codec.

use super::codec;
use crate::import::source::guard::guarded;
use crate::import::source::zstd::zstd;

/// Bytes of the header.
const HEAD: usize = 16;
/// Blocks are compressed in as many parts as a number has bytes, up to this many, if the parts have so many bytes.
const MOST_PARTS: usize = 16;
const LEAST_PART: usize = 128;

/// Unpacks a buffer to at most `most` bytes.
///
/// # Errors
/// One sentence about what is wrong.
pub(in crate::import::volumes) fn unpack(bytes: &[u8], most: usize) -> Result<Vec<u8>, String> {
    let short = || "a buffer of Blosc that is too short".to_owned();
    let word = |at: usize| -> Result<usize, String> {
        let bytes = bytes.get(at..at + 4).and_then(|bytes| bytes.first_chunk()).ok_or_else(short)?;
        Ok(u32::from_le_bytes(*bytes) as usize)
    };
    let &[_, _, flags, type_size, ..] = bytes else { return Err(short()) };
    let (size, block_size, type_size) = (word(4)?, word(8)?, usize::from(type_size).max(1));
    if size > most {
        return Err(format!("a chunk of more than its {most} bytes"));
    }
    if flags & 2 != 0 {
        return bytes.get(HEAD..HEAD + size).map(<[u8]>::to_vec).ok_or_else(short);
    }
    if size == 0 {
        return Ok(Vec::new());
    }
    let count = size.div_ceil(block_size.max(1));
    if block_size == 0 || count > bytes.len() / 4 {
        return Err("a buffer of Blosc with impossible blocks".into());
    }
    let mut unpacked = Vec::new();
    for block in 0..count {
        let is_rest = block + 1 == count && size % block_size != 0;
        let length = if is_rest { size % block_size } else { block_size };
        let is_split = flags & 0x10 == 0 && !is_rest && type_size <= MOST_PARTS && block_size / type_size >= LEAST_PART;
        let parts = if is_split { type_size } else { 1 };
        let mut at = word(HEAD + 4 * block)?;
        let mut plain = Vec::new();
        for _ in 0..parts {
            let packed = word(at)?;
            let data = bytes.get(at + 4..).and_then(|rest| rest.get(..packed)).ok_or_else(short)?;
            let part = length / parts;
            plain.extend(if packed == part { data.to_vec() } else { part_of(data, part, flags >> 5)? });
            at += 4 + packed;
        }
        if plain.len() != length {
            return Err("a block of Blosc of another size than it says".into());
        }
        match (flags & 1 != 0, flags & 4 != 0) {
            (true, _) if type_size > 1 => unshuffle(&plain, type_size, &mut unpacked),
            (_, true) => unshuffle_bits(&plain, type_size, &mut unpacked),
            _ => unpacked.extend_from_slice(&plain),
        }
    }
    Ok(unpacked)
}

fn part_of(data: &[u8], size: usize, codec: u8) -> Result<Vec<u8>, String> {
    match codec {
        1 => codec::lz4(data, size),
        3 => codec::read(flate2::read::ZlibDecoder::new(data), size),
        4 => guarded(|| zstd(data, size)),
        0 => Err("not supported: BloscLZ, the first codec of Blosc".into()),
        2 => Err("not supported: Snappy in Blosc".into()),
        other => Err(format!("codec {other} in Blosc, which nobody knows")),
    }
}

/// From all first bytes, then all second bytes, back to numbers.
fn unshuffle(plain: &[u8], size: usize, out: &mut Vec<u8>) {
    let count = plain.len() / size;
    for n in 0..count {
        out.extend((0..size).map(|byte| plain[byte * count + n]));
    }
    out.extend_from_slice(&plain[count * size..]);
}

/// From all lowest bits, then all second bits, back to numbers; numbers in eights, the rest as it is.
fn unshuffle_bits(plain: &[u8], size: usize, out: &mut Vec<u8>) {
    let count = plain.len() / size / 8 * 8;
    for n in 0..count {
        for byte in 0..size {
            let bit = |bit: usize| (plain[(byte * 8 + bit) * (count / 8) + n / 8] >> (n % 8) & 1) << bit;
            out.push((0..8).fold(0, |value, at| value | bit(at)));
        }
    }
    out.extend_from_slice(&plain[count * size..]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_sorted_by_significance_come_back() {
        let numbers: Vec<u8> = (0..40u16).flat_map(|n| (n * 300).to_le_bytes()).collect();
        let shuffled: Vec<u8> = (0..2).flat_map(|byte| numbers.iter().skip(byte).step_by(2).copied()).collect();
        let mut out = Vec::new();
        unshuffle(&shuffled, 2, &mut out);
        assert_eq!(out, numbers);
        let bit = |bit: usize, n: usize| numbers[2 * n + bit / 8] >> (bit % 8) & 1;
        let pack = |at: usize| (0..8).fold(0, |byte, k| byte | bit(at / 5, at % 5 * 8 + k) << k);
        let sorted: Vec<u8> = (0..80).map(pack).collect();
        out.clear();
        unshuffle_bits(&sorted, 2, &mut out);
        assert_eq!(out, numbers);
    }

    #[test]
    fn buffers_that_contradict_themselves_are_refused() {
        let plain =
            [&[2, 1, 2, 1][..], &3u32.to_le_bytes(), &3u32.to_le_bytes(), &19u32.to_le_bytes(), b"abc"].concat();
        assert_eq!(unpack(&plain, 3).unwrap(), b"abc");
        assert!(unpack(&plain, 2).is_err() && unpack(&plain[..18], 3).is_err() && unpack(&[], 3).is_err());
        let mut random = 1u32;
        for _ in 0..20_000 {
            let mut bytes: Vec<u8> = plain.clone();
            bytes.resize(60, 0);
            for _ in 0..4 {
                random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                bytes[(random >> 24) as usize % 60] = (random >> 16) as u8;
            }
            let _ = unpack(&bytes, 1 << 16);
        }
    }
}
